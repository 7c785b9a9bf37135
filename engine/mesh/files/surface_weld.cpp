// Welding equal vertices, and the checks that every surface file needs.
#include "mesh/files/surface_weld.hpp"

#include <cmath>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "core/error.hpp"

namespace stiction::mesh {

namespace {

constexpr double weld_distance = 1e-7; // over the extent

/// The axis-parallel box of all vertices.
struct Span {
  Eigen::RowVector3d low = Eigen::RowVector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  [[nodiscard]] double extent() const { return (high - low).maxCoeff(); }
};

/// Nodes by their cell in a grid as coarse as the weld distance, counted from the low corner; neighbouring
/// cells are looked through.
class Welder {
public:
  explicit Welder(Span const& span) : origin_(span.low), distance_(weld_distance * span.extent()) {}

  Index node(Eigen::RowVector3d const& position) {
    Key const key = key_of(position);
    for (int i = 0; i < 27; ++i) {
      auto const found = grid_.find({key[0] + i % 3 - 1, key[1] + i / 3 % 3 - 1, key[2] + i / 9 - 1});
      if (found != grid_.end() && (nodes_[ix(found->second)] - position).norm() <= distance_)
        return found->second;
    }
    nodes_.push_back(position);
    return grid_[key] = static_cast<Index>(nodes_.size()) - 1;
  }
  [[nodiscard]] Matrix nodes() const {
    Matrix all(static_cast<Eigen::Index>(nodes_.size()), 3);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      all.row(static_cast<Eigen::Index>(i)) = nodes_[i];
    return all;
  }

private:
  using Key = std::array<std::int64_t, 3>;
  [[nodiscard]] Key key_of(Eigen::RowVector3d const& position) const {
    Key key{};
    for (std::size_t d = 0; d < 3; ++d)
      key[d] = std::llround((position - origin_)[static_cast<Eigen::Index>(d)] / distance_);
    return key;
  }
  Eigen::RowVector3d origin_;
  double distance_;
  std::vector<Eigen::RowVector3d> nodes_;
  std::map<Key, Index> grid_;
};

/// Refuses numbers that are not finite and files without a triangle of a size.
Span checked_span(Triangles const& triangles, std::string const& path) {
  Span span;
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (auto const& vertex : triangles[i]) {
      if (!vertex.allFinite())
        refuse_surface(path, fmt::format("triangle {} has a coordinate that is not a finite number", i + 1));
      span.low = span.low.cwiseMin(vertex);
      span.high = span.high.cwiseMax(vertex);
    }
  if (triangles.empty())
    refuse_surface(path, "holds no triangle");
  if (!(span.extent() > 0))
    refuse_surface(path, "holds only triangles without an area");
  if (!(weld_distance * span.extent() >= std::numeric_limits<double>::min() && std::isfinite(span.extent())))
    refuse_surface(path, fmt::format("spans {:g} of its lengths, which no surface does", span.extent()));
  return span;
}

} // namespace

void refuse_surface(std::string const& path, std::string const& words) {
  throw core::InputError(fmt::format("surface file {}: {}", path, words));
}

std::string read_surface_file(std::string const& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream content;
  if (!in)
    refuse_surface(path, "cannot be read");
  content << in.rdbuf();
  auto text = content.str();
  if (text.empty())
    refuse_surface(path, "is empty");
  if (constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF"; text.starts_with(byte_order_mark))
    text.erase(0, byte_order_mark.size());
  return text;
}

bool read_vertex(std::istream& in, Eigen::RowVector3d& vertex) {
  for (int d = 0; d < 3; ++d) {
    std::string word;
    if (!(in >> word))
      return false;
    char* end = nullptr;
    vertex[d] = std::strtod(word.c_str(), &end);
    if (end == word.c_str() || *end != '\0')
      return false;
  }
  return true;
}

SurfaceMesh weld(Triangles const& triangles, double scale, std::string const& path) {
  Welder welder(checked_span(triangles, path));
  SurfaceMesh surface;
  for (auto const& triangle : triangles) {
    Indices nodes;
    for (auto const& vertex : triangle)
      nodes.push_back(welder.node(vertex));
    if (nodes[0] != nodes[1] && nodes[1] != nodes[2] && nodes[2] != nodes[0])
      surface.facets.push_back({nodes});
  }
  if (surface.facets.empty())
    refuse_surface(path, "holds only triangles without an area");
  surface.nodes = welder.nodes() * scale;
  return surface;
}

} // namespace stiction::mesh
