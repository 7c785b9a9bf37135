// A bare quadrilateral net, and its conversion into a mesh of any 2D kind.
#pragma once
#include <array>
#include <vector>

#include "mesh/generators/second_order.hpp"

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

using MidPoint = Middle<2>;
[[nodiscard]] Eigen::RowVector2d straight_middle(Eigen::RowVector2d const& a, Eigen::RowVector2d const& b);

/// Cells of `kind` without sets; triangles split each quadrilateral along its shorter diagonal.
[[nodiscard]] Mesh to_mesh(Quads const& quads, CellKind kind, MidPoint const& middle = straight_middle);

/// The net of a grid, lines ascending.
[[nodiscard]] Quads grid(std::vector<double> const& xs, std::vector<double> const& ys);
/// The mesh of a grid with the sets left, right, bottom, top and all.
[[nodiscard]] Mesh rectangle(std::vector<double> const& xs, std::vector<double> const& ys, CellKind kind);

/// The set of all nodes, without facets.
[[nodiscard]] Set all_nodes(Mesh const& mesh);

} // namespace stiction::mesh
