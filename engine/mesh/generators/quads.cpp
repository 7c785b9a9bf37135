// Splitting quadrilaterals into triangles and adding mid-side nodes.
#include "mesh/generators/quads.hpp"

#include <numeric>

#include "core/error.hpp"

namespace stiction::mesh {

namespace {

double squared_distance(Quads const& quads, Index a, Index b) {
  auto const& p = quads.nodes[static_cast<std::size_t>(a)];
  auto const& q = quads.nodes[static_cast<std::size_t>(b)];
  return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]);
}

/// Corners of the cells, cell after cell.
Indices corner_cells(Quads const& quads, bool triangles) {
  Indices corners;
  for (auto const& c : quads.cells) {
    if (!triangles)
      corners.insert(corners.end(), c.begin(), c.end());
    else if (squared_distance(quads, c[0], c[2]) <= squared_distance(quads, c[1], c[3]))
      corners.insert(corners.end(), {c[0], c[1], c[2], c[0], c[2], c[3]});
    else
      corners.insert(corners.end(), {c[0], c[1], c[3], c[1], c[2], c[3]});
  }
  return corners;
}

} // namespace

Eigen::RowVector2d straight_middle(Eigen::RowVector2d const& a, Eigen::RowVector2d const& b) {
  return (a + b) / 2;
}

Mesh to_mesh(Quads const& quads, CellKind kind, MidPoint const& middle) {
  core::expect(info(kind).dim == 2, "a kind of cells of the plane");
  std::vector<Position<2>> nodes;
  for (auto const& node : quads.nodes)
    nodes.emplace_back(node[0], node[1]);
  return with_mid_nodes<2>(kind, std::move(nodes), corner_cells(quads, info(kind).corners == 3), middle);
}

Quads grid(std::vector<double> const& xs, std::vector<double> const& ys) {
  Quads quads;
  for (double const y : ys)
    for (double const x : xs)
      quads.add(x, y);
  auto const nx = static_cast<Index>(xs.size()), ny = static_cast<Index>(ys.size());
  for (Index j = 0; j + 1 < ny; ++j)
    for (Index i = 0; i + 1 < nx; ++i) {
      Index const a = i + j * nx, b = a + nx;
      quads.cells.push_back({a, a + 1, b + 1, b});
    }
  return quads;
}

Mesh rectangle(std::vector<double> const& xs, std::vector<double> const& ys, CellKind kind) {
  Mesh mesh = to_mesh(grid(xs, ys), kind);
  mesh.sets["left"] = boundary_where(mesh, [&](auto const& x) { return x[0] == xs.front(); });
  mesh.sets["right"] = boundary_where(mesh, [&](auto const& x) { return x[0] == xs.back(); });
  mesh.sets["bottom"] = boundary_where(mesh, [&](auto const& x) { return x[1] == ys.front(); });
  mesh.sets["top"] = boundary_where(mesh, [&](auto const& x) { return x[1] == ys.back(); });
  mesh.sets["all"] = all_nodes(mesh);
  return mesh;
}

Set all_nodes(Mesh const& mesh) {
  Set set;
  set.nodes.resize(static_cast<std::size_t>(mesh.node_count()));
  std::iota(set.nodes.begin(), set.nodes.end(), Index{0});
  return set;
}

} // namespace stiction::mesh
