// Keyword lines and their data lines, one after the other; names of sets count without regard to case.
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <set>
#include <sstream>

#include "core/error.hpp"
#include "mesh/mesher/file_mesh.hpp"

namespace stiction::mesher {

namespace {

constexpr char const* known_types =
    "triangles and quadrilaterals of 3, 6, 4 and 8 nodes (CPS, CPE, CAX), C3D4, C3D10, C3D8 and C3D20";

std::string upper(std::string text) {
  for (char& c : text)
    c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string trimmed(std::string_view text) {
  auto const first = text.find_first_not_of(" \t\r\""), last = text.find_last_not_of(" \t\r\"");
  return first == std::string_view::npos ? "" : std::string(text.substr(first, last - first + 1));
}

std::vector<std::string> words_of(std::string const& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');)
    words.push_back(trimmed(word));
  while (!words.empty() && words.back().empty())
    words.pop_back();
  return words;
}

/// What an element of the file is here: cells, sides (of solids or of plane cells), or nothing known.
struct ElementType {
  int dim = 0;
  std::size_t nodes = 0;
};

std::size_t number_after(std::string const& type, std::size_t at) {
  std::size_t value = 0;
  std::from_chars(type.data() + at, type.data() + type.size(), value);
  return value;
}

std::optional<ElementType> element_type(std::string const& type) {
  static constexpr char const* solids[] = {"C3D", "DC3D"};
  static constexpr char const* planes[] = {"CPEG", "CPS",   "CPE", "CGAX", "CAX",  "DCAX", "DC2D",
                                           "M3D",  "SFM3D", "R3D", "RAX",  "STRI", "S"};
  static constexpr char const* lines[] = {"T2D", "T3D", "R2D"};
  for (auto const* prefix : solids)
    if (type.starts_with(prefix))
      return ElementType{3, number_after(type, std::string_view(prefix).size())};
  for (auto const* prefix : planes)
    if (auto const count = number_after(type, std::string_view(prefix).size());
        type.starts_with(prefix) && count > 0)
      return ElementType{2, count == 65 ? 6 : count};
  for (auto const* prefix : lines)
    if (type.starts_with(prefix))
      return ElementType{1, number_after(type, std::string_view(prefix).size())};
  if (type.starts_with("B2") || type.starts_with("B3")) // beams: dimension, then order
    return ElementType{1, number_after(type, 2) % 10 + 1};
  return std::nullopt;
}

std::optional<mesh::CellKind> kind_of(ElementType type) {
  for (auto const& cell : mesh::cell_table())
    if (cell.dim == type.dim && static_cast<std::size_t>(cell.nodes) == type.nodes)
      return cell.kind;
  return std::nullopt;
}

struct Element {
  ElementType type;
  Tags nodes;
};

class InpParser {
public:
  FileMesh parse(std::string const& content) {
    std::istringstream stream(content);
    for (std::string line; std::getline(stream, line);) {
      ++line_;
      line = trimmed(line);
      if (line.empty() || line.starts_with("**"))
        continue;
      if (line.front() == '*' || keyword_goes_on_)
        read_keyword(line);
      else
        read_data(line);
    }
    finish_element();
    return assembled();
  }

private:
  [[noreturn]] void refuse(std::string const& words) const {
    throw core::InputError(fmt::format("line {}: {}", line_, words));
  }

  std::size_t number(std::string const& word, char const* what) const {
    std::size_t value = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
      refuse(fmt::format("\"{}\" is no {}; a whole number is wanted", word, what));
    return value;
  }

  double coordinate(std::string word) const {
    for (char& c : word)
      c = c == 'd' || c == 'D' ? 'e' : c;
    if (word.starts_with('+'))
      word.erase(0, 1);
    double value = 0;
    auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      refuse(fmt::format("\"{}\" is no coordinate; a finite number is wanted", word));
    return value;
  }

  void read_keyword(std::string const& line) {
    if (!keyword_goes_on_) {
      finish_element();
      parameters_.clear();
      keyword_ = upper(trimmed(line.substr(1, line.find(',') - 1)));
    }
    for (auto const& word : words_of(keyword_goes_on_ ? "," + line : line)) {
      auto const equals = word.find('=');
      parameters_[upper(trimmed(word.substr(0, equals)))] =
          equals == std::string::npos ? "" : trimmed(word.substr(equals + 1));
    }
    keyword_goes_on_ = line.back() == ',';
    if (!keyword_goes_on_)
      begin();
  }

  std::string parameter(char const* name) const {
    auto const found = parameters_.find(name);
    return found == parameters_.end() ? "" : found->second;
  }

  std::string wanted(char const* name) const {
    auto const value = parameter(name);
    if (value.empty())
      refuse(fmt::format("*{} has no {}=", keyword_, name));
    return value;
  }

  void begin() {
    static std::set<std::string> const made{"NGEN", "NFILL", "NCOPY", "ELGEN", "ELCOPY", "SYSTEM", "NMAP"};
    if (made.contains(keyword_))
      refuse(fmt::format("*{} makes nodes or cells that do not stand in the file; write them out", keyword_));
    if (keyword_ == "INCLUDE")
      refuse("*INCLUDE names another file; write one file");
    if (keyword_ == "INSTANCE" && ++instances_ > 1)
      refuse("a second *INSTANCE begins; write one file for each body");
    if (keyword_ == "ELEMENT")
      begin_elements();
    if (keyword_ == "NSET" || keyword_ == "ELSET")
      set_ = wanted(keyword_.c_str());
    if (keyword_ == "SURFACE")
      set_ = wanted("NAME");
    if (keyword_ == "SURFACE" && !parameter("TYPE").empty() && upper(parameter("TYPE")) != "ELEMENT" &&
        upper(parameter("TYPE")) != "NODE")
      refuse(fmt::format("*SURFACE of TYPE={}; ELEMENT and NODE are read", parameter("TYPE")));
  }

  void begin_elements() {
    auto const word = upper(wanted("TYPE"));
    auto const type = element_type(word);
    if (type && ((type->dim == 2 && type->nodes == 9) || (type->dim == 3 && type->nodes == 27)))
      refuse(fmt::format(
          "elements of type {} have nodes in the middle of their {}; write them without ({}), or of "
          "first order",
          word, type->dim == 2 ? "faces" : "faces and of themselves",
          type->dim == 2 ? "8 nodes" : "20 nodes"));
    if (!type || (type->dim > 1 && !kind_of(*type)))
      refuse(fmt::format("elements of type {}; known are {}", word, known_types));
    type_ = *type;
  }

  void read_data(std::string const& line) {
    auto const words = words_of(line);
    if (words.empty())
      return;
    if (keyword_ == "NODE")
      read_node(words);
    else if (keyword_ == "ELEMENT")
      read_element(words);
    else if (keyword_ == "NSET" || keyword_ == "ELSET")
      read_set(words, keyword_ == "NSET" ? node_sets_ : element_sets_);
    else if (keyword_ == "SURFACE")
      read_surface(words);
    else if (keyword_ == "INSTANCE")
      read_place(words);
  }

  void read_place(std::vector<std::string> const& words) const {
    for (auto const& word : words)
      if (coordinate(word) != 0)
        refuse("*INSTANCE moves its part, which is not done here; write the nodes where they are");
  }

  void read_node(std::vector<std::string> const& words) {
    if (words.size() < 3 || words.size() > 4)
      refuse(
          fmt::format("a node has {} entries; its number and 2 or 3 coordinates are wanted", words.size()));
    auto const tag = number(words[0], "node number");
    std::array<double, 3> place{};
    for (std::size_t i = 1; i < words.size(); ++i)
      place[i - 1] = coordinate(words[i]);
    if (tag == 0 || !mesh_.nodes.emplace(tag, place).second)
      refuse(fmt::format("node {} {}", tag, tag == 0 ? "is no number from 1" : "is there twice"));
    if (auto const set = parameter("NSET"); !set.empty())
      node_sets_[set].push_back(tag);
  }

  /// The nodes of an element may go on in further lines.
  void read_element(std::vector<std::string> const& words) {
    for (auto const& word : words) {
      auto const value = number(word, "number");
      if (pending_.empty() && elements_.contains(value))
        refuse(fmt::format("element {} is there twice", value));
      pending_.push_back(value);
    }
    if (pending_.size() > type_.nodes + 1)
      refuse(fmt::format("element {} has {} nodes, those of its type have {}", pending_[0],
                         pending_.size() - 1, type_.nodes));
    if (pending_.size() == type_.nodes + 1)
      take_element();
  }

  void take_element() {
    auto const tag = pending_[0];
    for (std::size_t i = 1; i < pending_.size(); ++i)
      lines_of_.try_emplace(pending_[i], line_);
    elements_[tag] = {type_, Tags(pending_.begin() + 1, pending_.end())};
    if (auto const set = parameter("ELSET"); !set.empty())
      element_sets_[set].push_back(tag);
    pending_.clear();
  }

  void finish_element() {
    if (!pending_.empty())
      refuse(fmt::format("element {} ends after {} nodes, those of its type have {}", pending_[0],
                         pending_.size() - 1, type_.nodes));
  }

  void read_set(std::vector<std::string> const& words, std::map<std::string, Tags>& sets) {
    auto& set = sets[set_];
    if (parameters_.contains("GENERATE")) {
      auto const first = number(words.at(0), "number"),
                 last = number(words.at(words.size() > 1 ? 1 : 0), "number");
      auto const step = words.size() > 2 ? number(words[2], "step") : 1;
      if (step == 0 || last < first || (last - first) / step > 100000000)
        refuse("GENERATE wants first, last and a step from 1");
      for (auto tag = first; tag <= last; tag += step)
        set.push_back(tag);
      return;
    }
    for (auto const& word : words) {
      if (std::isdigit(static_cast<unsigned char>(word.empty() ? ' ' : word[0])) != 0) {
        set.push_back(number(word, "number"));
        continue;
      }
      auto const* other = find(sets, word);
      if (other == nullptr)
        refuse(fmt::format("set {} names the set \"{}\", which does not stand above it", set_, word));
      auto const copy = *other;
      set.insert(set.end(), copy.begin(), copy.end());
    }
  }

  /// The set of this name, whatever its case.
  static Tags const* find(std::map<std::string, Tags> const& sets, std::string const& name) {
    for (auto const& [own, tags] : sets)
      if (upper(own) == upper(name))
        return &tags;
    return nullptr;
  }

  void read_surface(std::vector<std::string> const& words) {
    bool const is_number =
        std::isdigit(static_cast<unsigned char>(words[0].empty() ? ' ' : words[0][0])) != 0;
    bool const of_nodes = upper(parameter("TYPE")) == "NODE";
    auto const* set = is_number ? nullptr : find(of_nodes ? node_sets_ : element_sets_, words[0]);
    if (!is_number && set == nullptr)
      refuse(fmt::format("surface {} names the set \"{}\", which does not stand above it", set_, words[0]));
    Tags const tags = is_number ? Tags{number(words[0], "number")} : *set;
    if (of_nodes) {
      auto& own = node_sets_[set_];
      own.insert(own.end(), tags.begin(), tags.end());
      return;
    }
    std::string const face = words.size() > 1 ? upper(words[1]) : "";
    if (face.size() != 2 || face[0] != 'S' || face[1] < '1' || face[1] > '6')
      refuse(
          fmt::format("surface {}: \"{}\" is no face; S1 to S6 are", set_, words.size() > 1 ? words[1] : ""));
    for (auto const tag : tags)
      add_face(tag, static_cast<std::size_t>(face[1] - '1'));
  }

  void add_face(std::size_t tag, std::size_t face) {
    auto const found = elements_.find(tag);
    if (found == elements_.end())
      refuse(fmt::format("surface {} names element {}, which does not stand above it", set_, tag));
    auto const kind = kind_of(found->second.type);
    if (!kind || face >= mesh::info(*kind).facets.size())
      refuse(fmt::format("surface {}: element {} has no face S{}", set_, tag, face + 1));
    Tags nodes;
    for (int const local : mesh::info(*kind).facets[face])
      nodes.push_back(found->second.nodes[static_cast<std::size_t>(local)]);
    mesh_.side_sets[set_].push_back(nodes);
  }

  void check_nodes() const {
    for (auto const& [tag, line] : lines_of_)
      if (!mesh_.nodes.contains(tag))
        throw core::InputError(
            fmt::format("line {}: an element has node {}, which is not in the file", line, tag));
    for (auto const& [name, tags] : node_sets_)
      for (auto const tag : tags)
        if (!mesh_.nodes.contains(tag))
          throw core::InputError(fmt::format("node set {} has node {}, which is not in the file", name, tag));
  }

  /// Cells are the elements of the highest dimension; sets of those one lower are sides.
  FileMesh assembled() {
    int dim = 0;
    for (auto const& [tag, element] : elements_)
      dim = std::max(dim, element.type.dim);
    if (dim < 2)
      throw core::InputError(fmt::format("the file has no cells; known are {}", known_types));
    check_nodes();
    for (auto const& [tag, element] : elements_)
      if (element.type.dim == dim)
        mesh_.cells[tag] = {*kind_of(element.type), element.nodes};
    mesh_.node_sets = node_sets_;
    for (auto const& [name, tags] : element_sets_)
      if (!name.starts_with('_'))
        add_element_set(name, tags, dim);
    for (auto& [name, tags] : mesh_.node_sets) {
      std::sort(tags.begin(), tags.end());
      tags.erase(std::unique(tags.begin(), tags.end()), tags.end());
    }
    std::erase_if(mesh_.node_sets,
                  [](auto const& set) { return set.first.starts_with('_') || set.second.empty(); });
    return std::move(mesh_);
  }

  /// Sides of a name that nodes or sides have already are left out.
  void add_element_set(std::string const& name, Tags const& tags, int dim) {
    bool const taken = mesh_.side_sets.contains(name) || mesh_.node_sets.contains(name);
    for (auto const tag : tags) {
      auto const found = elements_.find(tag);
      if (found == elements_.end())
        throw core::InputError(
            fmt::format("element set {} has element {}, which is not in the file", name, tag));
      auto const& [type, nodes] = found->second;
      if (type.dim == dim) {
        mesh_.cell_sets[name].push_back(tag);
      } else if (type.dim == dim - 1 && !taken) {
        mesh_.side_sets[name].push_back(nodes);
      }
    }
  }

  int line_ = 0, instances_ = 0;
  std::string keyword_, set_;
  bool keyword_goes_on_ = false;
  std::map<std::string, std::string> parameters_;
  ElementType type_;
  Tags pending_; ///< the number of an element and its nodes so far
  std::map<std::size_t, Element> elements_;
  std::map<std::size_t, int> lines_of_; ///< the first line that names a node
  std::map<std::string, Tags> node_sets_, element_sets_;
  FileMesh mesh_;
};

} // namespace

FileMesh parse_inp(std::string const& content) {
  return InpParser().parse(content);
}

} // namespace stiction::mesher
