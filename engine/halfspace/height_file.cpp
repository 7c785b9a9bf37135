// Text and .npy files of heights, and what every file of heights owes.
#include "halfspace/height_file.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <set>
#include <string_view>

#include "core/error.hpp"
#include "core/unit.hpp"

namespace stiction::halfspace {

namespace detail {

void refuse_heights(std::string const& path, std::string const& why, char const* key) {
  throw core::InputError(core::Complaints{{"", key, fmt::format("{}: {}", path, why)}});
}

constexpr double most_heights = 8192.0 * 8192.0;

void check_count(std::string const& path, double nx, double ny) {
  if (!(nx >= 1 && ny >= 1))
    refuse_heights(path, "holds no heights");
  if (nx * ny > most_heights)
    refuse_heights(
        path, fmt::format("has {:g} x {:g} heights; at most {:g} are read (8192 x 8192): crop it, or thin it",
                          nx, ny, most_heights));
}

} // namespace detail

namespace {

using detail::refuse_heights;
using std::string_view;

constexpr string_view blanks = " \t\r";
constexpr string_view byte_order = "\xef\xbb\xbf"; // as some editors put first

string_view trimmed(string_view text) {
  auto const first = text.find_first_not_of(blanks);
  return first == string_view::npos ? string_view{}
                                    : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// The whole word as a number; holes are NaN.
std::optional<double> number(string_view word) {
  if (word.starts_with('+'))
    word.remove_prefix(1);
  double value = 0;
  auto const [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::result_out_of_range)
    return std::numeric_limits<double>::infinity();
  if (error != std::errc{} || end != word.data() + word.size())
    return {};
  return value;
}

/// Rows of numbers, and comments that say what they are.
class TextReader {
public:
  TextReader(std::string const& path, string_view text) : path_(path), text_(text) {}

  HeightFile read() {
    while (!text_.empty()) {
      auto const end = std::min(text_.find('\n'), text_.size());
      line(trimmed(text_.substr(0, end)));
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
    }
    detail::check_count(path_, file_.nx, file_.ny);
    refuse_tables();
    return std::move(file_);
  }

private:
  void line(string_view text) {
    if (text.empty())
      return;
    bool const remark = text.front() == '#' || (file_.ny == 0 && !first_is_number(text));
    if (remark)
      comment(trimmed(text.substr(text.front() == '#' ? 1 : 0)));
    else
      row(text);
  }

  [[nodiscard]] bool separates(char c) const { return c == ',' || c == ';' || c == '\t' || c == ' '; }

  [[nodiscard]] bool first_is_number(string_view text) const {
    auto const end = std::ranges::find_if(text, [&](char c) { return separates(c); });
    return end == text.begin() || number({text.begin(), end}).has_value();
  }

  /// One of the keys before : or =, and its value.
  void comment(string_view text) {
    auto const at = text.find_first_of(":=");
    if (at == string_view::npos)
      return;
    auto const key = trimmed(text.substr(0, at)), value = trimmed(text.substr(at + 1));
    if (key == "Width" || key == "x-length")
      file_.length_x = length(value);
    else if (key == "Height" || key == "y-length")
      file_.length_y = length(value);
    else if (key == "Value units" || key == "z-unit")
      file_.unit = std::string(value);
  }

  [[nodiscard]] double length(string_view text) const {
    auto const end = std::min(text.find_first_of(blanks), text.size());
    auto const value = number(text.substr(0, end));
    auto const unit = length_unit(std::string(trimmed(text.substr(end))));
    if (!value || !unit || !(*value > 0) || !std::isfinite(*value))
      refuse_heights(
          path_, fmt::format("line {}: '{}' is no length > 0 with its unit, such as \"10 um\"", line_, text));
    return *value * *unit;
  }

  void row(string_view text) {
    Index column = 0;
    bool const cells = text.find_first_of(",;\t") != string_view::npos; // between which nothing is a hole
    char const between = text.find(';') != string_view::npos   ? ';'
                         : text.find(',') != string_view::npos ? ','
                                                               : '\t';
    while (!text.empty()) {
      auto const end = std::min(cells ? text.find(between) : text.find(' '), text.size());
      take(trimmed(text.substr(0, end)), ++column);
      text.remove_prefix(std::min(end + 1, text.size()));
      text = cells ? text : trimmed(text);
    }
    if (file_.ny > 0 && column != file_.nx)
      refuse_heights(path_,
                     fmt::format("row {} (line {}) has {} heights, those before it {}; give all rows as many",
                                 file_.ny + 1, line_, column, file_.nx));
    file_.nx = column;
    ++file_.ny;
    detail::check_count(path_, file_.nx, file_.ny);
  }

  [[nodiscard]] double at(Index row, Index column) const {
    return file_.heights[ix(row) * ix(file_.nx) + ix(column)];
  }
  /// Do the numbers at(k), k < count, go up by one each?
  static bool counts(Index count, auto const& at) {
    for (Index k = 1; k < count; ++k)
      if (at(k) - at(k - 1) != 1)
        return false;
    return true;
  }
  [[nodiscard]] std::size_t different(Index column) const {
    std::set<double> values;
    for (Index row = 0; row < file_.ny; ++row)
      values.insert(at(row, column));
    return values.size();
  }

  /// What would be taken for heights: names of rows and columns, and places.
  void refuse_tables() const {
    Index const nx = file_.nx, ny = file_.ny;
    auto const row = [this](Index j) { return [this, j](Index i) { return at(j, i); }; };
    auto const column = [this](Index i) { return [this, i](Index j) { return at(j, i); }; };
    if (nx > 2 && ny > 2 && (at(0, 0) == 0 || at(0, 0) == 1)) {
      if (counts(nx, row(0)) && !counts(nx, row(1)))
        refuse_heights(path_, "the first row counts the columns; heights alone are wanted: leave it out");
      if (counts(ny, column(0)) && !counts(ny, column(1)))
        refuse_heights(path_, "the first column counts the rows; heights alone are wanted: leave it out");
    }
    auto const lines = nx == 3 && ny > 8 ? different(0) : 0, points = lines > 1 ? different(1) : 0;
    if (points > 1 && lines * points == ix(ny))
      refuse_heights(path_, fmt::format("is a list of {} x {} places with their heights; a row of heights "
                                        "for each y is wanted: reshape it",
                                        lines, points));
  }

  void take(string_view word, Index column) {
    auto const value = number(word);
    auto const place = [&] {
      return fmt::format("row {}, column {} (line {})", file_.ny + 1, column, line_);
    };
    if (!value && !word.empty() && word != "--" && word != "Bad" && word != "BAD")
      refuse_heights(path_,
                     fmt::format("{}: '{}' is no number; between numbers stand blanks, tabs, commas or "
                                 "semicolons, and their points are '.'",
                                 place(), word.substr(0, 40)));
    if (!value || !std::isfinite(*value))
      refuse_heights(path_, fmt::format("{}: '{}' is a hole; fill holes first, e.g. by interpolation",
                                        place(), word.substr(0, 40)));
    file_.heights.push_back(*value);
  }

  std::string const& path_;
  string_view text_;
  HeightFile file_;
  long line_ = 1;
};

/// What stands in a Python dictionary after 'key':, up to a comma or ) that ends it.
string_view entry(string_view header, string_view key, char end) {
  auto const at = header.find(key);
  if (at == string_view::npos)
    return {};
  auto const rest = header.substr(at + key.size());
  return trimmed(rest.substr(0, rest.find(end)));
}

template<class T> void copy(std::string const& bytes, std::size_t first, std::vector<double>& to) {
  for (std::size_t i = 0; i < to.size(); ++i) {
    T value{};
    std::memcpy(&value, bytes.data() + first + i * sizeof(T), sizeof(T));
    to[i] = static_cast<double>(value);
  }
}

std::vector<double> shape_of(string_view words) {
  std::vector<double> shape;
  while (!words.empty()) {
    auto const end = std::min(words.find(','), words.size());
    if (auto const count = number(trimmed(words.substr(0, end))))
      shape.push_back(*count);
    words.remove_prefix(std::min(end + 1, words.size()));
  }
  return shape;
}

/// numpy.lib.format, versions 1 to 3: magic, version, length of the header, a dictionary, the numbers.
HeightFile read_npy(std::string const& path, std::string const& bytes) {
  constexpr std::size_t magic = 8;
  bool const short_header = bytes.size() > magic && bytes[6] == 1;
  std::size_t const prefix = magic + (short_header ? 2 : 4);
  if (bytes.size() < prefix)
    refuse_heights(path, "is truncated; write it anew");
  std::uint32_t length = 0;
  std::memcpy(&length, bytes.data() + magic, short_header ? 2 : 4);
  if (bytes.size() - prefix < length)
    refuse_heights(path, "is truncated; write it anew");
  auto const header = string_view(bytes).substr(prefix, length);
  auto const type = entry(header, "'descr':", ',');
  if (std::endian::native != std::endian::little || (type != "'<f8'" && type != "'<f4'"))
    refuse_heights(path, fmt::format("holds numbers of type {}; save it as '<f8' or '<f4'", type));
  auto const open = header.find('(');
  auto const shape = open == string_view::npos
                         ? std::vector<double>{}
                         : shape_of(header.substr(open + 1, header.find(')', open) - open - 1));
  if (shape.empty() || shape.size() > 2)
    refuse_heights(path,
                   fmt::format("has {} dimensions; an array {{y, x}} is wanted, or a line", shape.size()));
  double const ny = shape.size() == 2 ? shape[0] : 1, nx = shape.back();
  detail::check_count(path, nx, ny);
  HeightFile file{static_cast<Index>(nx), static_cast<Index>(ny), {}, "", {}, {}};
  file.heights.resize(ix(file.nx) * ix(file.ny));
  std::size_t const first = prefix + length, size = type == "'<f8'" ? 8 : 4;
  if (bytes.size() - first < file.heights.size() * size)
    refuse_heights(path, fmt::format("is truncated: it announces {} heights and holds {}; write it anew",
                                     file.heights.size(), (bytes.size() - first) / size));
  size == 8 ? copy<double>(bytes, first, file.heights) : copy<float>(bytes, first, file.heights);
  if (entry(header, "'fortran_order':", ',') == "True") {
    auto const turned = file.heights;
    for (Index j = 0; j < file.ny; ++j)
      for (Index i = 0; i < file.nx; ++i)
        file.heights[ix(j) * ix(file.nx) + ix(i)] = turned[ix(i) * ix(file.ny) + ix(j)];
  }
  return file;
}

/// Binary files have holes as NaN.
void refuse_holes(std::string const& path, HeightFile const& file) {
  auto const hole = std::ranges::find_if(file.heights, [](double h) { return !std::isfinite(h); });
  if (hole == file.heights.end())
    return;
  auto const at = static_cast<std::size_t>(hole - file.heights.begin());
  auto const more = std::ranges::count_if(file.heights, [](double h) { return !std::isfinite(h); }) - 1;
  refuse_heights(
      path, fmt::format("row {}, column {}: {} is a hole ({} more); fill holes first, e.g. by interpolation",
                        at / ix(file.nx) + 1, at % ix(file.nx) + 1, *hole, more));
}

std::string content_of(std::string const& path) {
  constexpr std::uintmax_t most_bytes = 32 * std::uintmax_t{8192} * 8192; // of a number in a text
  std::error_code error;
  auto const size = std::filesystem::file_size(path, error);
  if (error || !std::filesystem::is_regular_file(path))
    refuse_heights(path, fmt::format("cannot be read ({}); file names stand from the study's folder on",
                                     error ? error.message() : "no file"));
  if (size > most_bytes)
    refuse_heights(path,
                   fmt::format("has {:.3g} bytes; at most 8192 x 8192 heights are read: crop it, or thin it",
                               static_cast<double>(size)));
  std::string bytes(size, '\0');
  std::ifstream in(path, std::ios::binary);
  if (!in.read(bytes.data(), static_cast<std::streamsize>(size)))
    refuse_heights(path, "cannot be read");
  return bytes;
}

} // namespace

std::optional<double> length_unit(std::string word) {
  for (auto const* micro : {"\xc2\xb5", "\xce\xbc", "\xb5"}) // UTF-8: micro sign, mu; Latin-1
    if (word.starts_with(micro))
      word = "u" + word.substr(std::strlen(micro));
  auto const unit = core::parse_unit(word);
  if (!unit || unit->dimension != core::Dimension{1, 0, 0})
    return {};
  return unit->value;
}

HeightFile read_heights(std::string const& path, std::string const& dataset) {
  auto const bytes = content_of(path);
  bool const hdf5 = bytes.starts_with("\x89HDF");
  if (!dataset.empty() && !hdf5)
    refuse_heights(path, "is no HDF5 file, and has no data sets; leave it out", "dataset");
  if (!hdf5 && !bytes.starts_with("\x93NUMPY"))
    return TextReader(path, string_view(bytes).substr(bytes.starts_with(byte_order) ? byte_order.size() : 0))
        .read();
  auto file = hdf5 ? detail::read_hdf5(path, dataset) : read_npy(path, bytes);
  refuse_holes(path, file);
  return file;
}

} // namespace stiction::halfspace
