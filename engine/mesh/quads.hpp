// A bare quadrilateral net, and its conversion into a mesh of any 2D kind.
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "mesh/mesh.hpp"

namespace stiction::mesh {

/// Corner nodes (m) and counter-clockwise cells.
struct Quads {
  std::vector<std::array<double, 2>> nodes;
  std::vector<std::array<Index, 4>> cells;

  Index add(double x, double y) {
    nodes.push_back({x, y});
    return static_cast<Index>(nodes.size()) - 1;
  }
};

/// Mid-side node between two corners; given their coordinates (m), returns the place of the node.
using MidPoint = std::function<Eigen::RowVector2d(Eigen::RowVector2d const&, Eigen::RowVector2d const&)>;
[[nodiscard]] Eigen::RowVector2d straight_middle(Eigen::RowVector2d const& a, Eigen::RowVector2d const& b);

/// Cells of `kind` without sets; triangles split each quadrilateral along its shorter diagonal.
[[nodiscard]] Mesh to_mesh(Quads const& quads, CellKind kind, MidPoint const& middle = straight_middle);

/// The set of all nodes, without facets.
[[nodiscard]] Set all_nodes(Mesh const& mesh);

} // namespace stiction::mesh
