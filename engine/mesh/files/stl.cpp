// STL files, text and binary.
#include <cstring>
#include <fmt/format.h>
#include <sstream>

#include "mesh/files/surface_weld.hpp"

namespace stiction::mesh {

namespace {

Triangles text_triangles(std::string const& content, std::string const& path) {
  std::istringstream in(content);
  Triangles triangles;
  std::vector<Eigen::RowVector3d> loop;
  bool ended = false;
  for (std::string word; in >> word;) {
    ended = word == "endsolid" || (ended && word != "solid");
    if (word == "vertex") {
      loop.emplace_back();
      if (!read_vertex(in, loop.back()))
        refuse_surface(
            path, fmt::format("triangle {} lacks a coordinate or has one that is not a number; the file may "
                              "be truncated",
                              triangles.size() + 1));
    } else if (word == "endloop") {
      if (loop.size() != 3)
        refuse_surface(path, fmt::format("triangle {} has {} vertices", triangles.size() + 1, loop.size()));
      triangles.push_back({loop[0], loop[1], loop[2]});
      loop.clear();
    }
  }
  if (!ended || !loop.empty())
    refuse_surface(path,
                   fmt::format("is truncated: it ends after {} triangles without endsolid; write it anew",
                               triangles.size()));
  return triangles;
}

constexpr std::size_t stl_header = 80, stl_record = 50; // bytes

std::size_t binary_count(std::string const& content) {
  std::uint32_t count = 0;
  std::memcpy(&count, content.data() + stl_header, sizeof count);
  return count;
}

Triangles binary_triangles(std::string const& content, std::string const& path) {
  std::size_t const first = stl_header + 4;
  if (content.size() < first)
    refuse_surface(
        path, fmt::format("is truncated: {} bytes are less than the header of an STL file", content.size()));
  std::size_t const count = binary_count(content), held = (content.size() - first) / stl_record;
  if (held < count)
    refuse_surface(
        path, fmt::format("is truncated, or not STL: it announces {} triangles and holds {}; write it anew",
                          count, held));
  Triangles triangles(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 12> numbers{}; // normal, then three vertices
    std::memcpy(numbers.data(), content.data() + first + stl_record * i, sizeof numbers);
    for (std::size_t k = 0; k < 3; ++k)
      triangles[i][k] << static_cast<double>(numbers[3 + 3 * k]), static_cast<double>(numbers[4 + 3 * k]),
          static_cast<double>(numbers[5 + 3 * k]);
  }
  return triangles;
}

/// Binary files may begin with "solid" too; their length then fits the count of triangles.
bool is_text(std::string const& content) {
  if (!content.starts_with("solid"))
    return false;
  bool const fits = content.size() >= stl_header + 4 &&
                    content.size() == stl_header + 4 + stl_record * binary_count(content);
  return !fits;
}

} // namespace

SurfaceMesh read_stl(std::string const& path, double scale) {
  std::string const content = read_surface_file(path);
  return weld(is_text(content) ? text_triangles(content, path) : binary_triangles(content, path), scale,
              path);
}

} // namespace stiction::mesh
