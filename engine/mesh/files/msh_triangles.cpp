// Triangles of .msh text files, read without gmsh.
#include <fmt/format.h>
#include <map>
#include <sstream>

#include "mesh/files/surface_weld.hpp"

namespace stiction::mesh {

namespace {

/// Reads the sections of a .msh text file word by word.
class MshText {
public:
  MshText(std::string const& content, std::string path)
      : in_(content), path_(std::move(path)), size_(content.size()) {}

  Triangles read() {
    double version = 0;
    bool elements = false;
    for (std::string word; in_ >> word;)
      if (word == "$MeshFormat")
        version = read_format();
      else if (word == "$Nodes")
        version < 3 ? read_nodes_2() : read_nodes_4();
      else if (word == "$Elements") {
        version < 3 ? read_elements_2() : read_elements_4();
        if (next<std::string>() != "$EndElements")
          refuse_surface(path_, "is truncated: its cells do not end in $EndElements; write it anew");
        elements = true;
      }
    if (!elements)
      refuse_surface(path_, "has no $Elements section; it may be truncated");
    return std::move(triangles_);
  }

private:
  template<class T> T next() {
    T value{};
    if (!(in_ >> value))
      refuse_surface(path_, "is truncated, or has words where numbers belong; write it anew");
    return value;
  }
  /// A number of things that follow; each takes a byte at least.
  std::size_t count() {
    auto const announced = next<std::size_t>();
    if (announced > size_)
      refuse_surface(path_,
                     fmt::format("announces {} nodes, cells or tags, more than it has bytes", announced));
    return announced;
  }
  double read_format() {
    double const version = next<double>();
    bool const known = (version >= 2 && version < 3) || version == 4.1;
    if (!known || next<int>() != 0)
      refuse_surface(path_, "is not a text file of version 2 or 4.1; save it as one of these without binary");
    return version;
  }
  void read_position(std::size_t tag) {
    if (!read_vertex(in_, nodes_[tag]))
      refuse_surface(path_, fmt::format("node {} lacks a coordinate; the file may be truncated", tag));
  }
  void read_nodes_2() {
    for (auto left = count(); left > 0; --left)
      read_position(next<std::size_t>());
  }
  void read_nodes_4() {
    auto blocks = count();
    skip(3);
    for (; blocks > 0; --blocks) {
      skip(3); // dimension, tag, parametric: no parameters are written for such files by default
      std::vector<std::size_t> tags(count());
      for (auto& tag : tags)
        tag = next<std::size_t>();
      for (auto const tag : tags)
        read_position(tag);
    }
  }
  void read_elements_2() {
    std::string line;
    auto left = count();
    std::getline(in_, line);
    for (; left > 0; --left) {
      if (!std::getline(in_, line))
        refuse_surface(path_, fmt::format("is truncated: {} cells are missing", left));
      std::istringstream words(line);
      std::size_t number = 0, tags = 0, ignored = 0;
      int type = 0;
      words >> number >> type >> tags;
      for (std::size_t i = 0; i < tags && words; ++i)
        words >> ignored;
      add(type, words);
    }
  }
  void read_elements_4() {
    auto blocks = count();
    skip(3);
    for (; blocks > 0; --blocks) {
      skip(2);
      int const type = next<int>();
      auto left = count();
      std::string line;
      std::getline(in_, line);
      for (; left > 0; --left) {
        if (!std::getline(in_, line))
          refuse_surface(path_, fmt::format("is truncated: {} cells are missing", left));
        std::istringstream words(line);
        std::size_t number = 0;
        words >> number;
        add(type, words);
      }
    }
  }
  /// A triangle by its corners; other types are passed over.
  void add(int type, std::istream& words) {
    if (type != info(CellKind::tri3).gmsh_type && type != info(CellKind::tri6).gmsh_type)
      return;
    Triangle triangle;
    for (auto& vertex : triangle) {
      std::size_t tag = 0;
      auto const found = words >> tag ? nodes_.find(tag) : nodes_.end();
      if (found == nodes_.end())
        refuse_surface(path_,
                       fmt::format("triangle {} names a node that is not there; the file may be truncated",
                                   triangles_.size() + 1));
      vertex = found->second;
    }
    triangles_.push_back(triangle);
  }
  void skip(int count) {
    for (int i = 0; i < count; ++i)
      (void)next<std::string>();
  }

  std::istringstream in_;
  std::string path_;
  std::size_t size_; ///< bytes
  std::map<std::size_t, Eigen::RowVector3d> nodes_;
  Triangles triangles_;
};

} // namespace

SurfaceMesh read_msh_triangles(std::string const& path, double scale) {
  std::string const content = read_surface_file(path);
  if (!content.starts_with("$"))
    refuse_surface(path, "is not a gmsh mesh file: it does not begin with $MeshFormat");
  return weld(MshText(content, path).read(), scale, path);
}

} // namespace stiction::mesh
