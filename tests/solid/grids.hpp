// Structured meshes of every cell kind over the unit square or cube, mapped to where a test wants them.
#pragma once
#include <functional>
#include <map>

#include "mesh/generators/generators.hpp"

namespace stiction::test {

using Map = std::function<Point(Point const&)>; ///< from the unit square or cube, m

/// Where a node is.
inline Point node_position(mesh::Mesh const& mesh, Index node) {
  Point X = Point::Zero();
  for (int d = 0; d < mesh.dim; ++d)
    X[d] = mesh.nodes(node, d);
  return X;
}

namespace detail {
using Lattice = std::array<int, 3>; ///< twice the position in cells, so that mid-side nodes have one too

inline std::vector<std::vector<Lattice>> corners_in_box(mesh::CellInfo const& cell) {
  if (cell.corners == 8)
    return {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, 0, 2}, {2, 0, 2}, {2, 2, 2}, {0, 2, 2}}};
  std::vector<std::vector<Lattice>> tetrahedra; // six around the diagonal
  Lattice axis{0, 1, 2};
  do {
    std::vector<Lattice> corner(4, Lattice{0, 0, 0});
    for (std::size_t k = 1; k < 4; ++k) {
      corner[k] = corner[k - 1];
      corner[k][static_cast<std::size_t>(axis[k - 1])] += 2;
    }
    bool const even = (axis[1] - axis[0] + 3) % 3 == 1;
    if (!even)
      std::swap(corner[1], corner[2]);
    tetrahedra.push_back(corner);
  } while (std::next_permutation(axis.begin(), axis.end()));
  return tetrahedra;
}

inline Lattice plus(Lattice const& a, Lattice const& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Lattice middle(Lattice const& a, Lattice const& b) {
  return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
}

/// The cells of one box of the lattice, as lattice points in the order of the kind's nodes.
inline std::vector<std::vector<Lattice>> cells_in_box(mesh::CellInfo const& cell, Lattice const& origin) {
  auto cells = corners_in_box(cell);
  for (auto& nodes : cells) {
    for (auto& node : nodes)
      node = plus(node, origin);
    if (cell.nodes > cell.corners)
      for (auto const& [a, b] : cell.edges)
        nodes.push_back(middle(nodes[static_cast<std::size_t>(a)], nodes[static_cast<std::size_t>(b)]));
  }
  return cells;
}
} // namespace detail

/// nx x ny x nz boxes over [0, 1]^3, each one hexahedron or six tetrahedra.
inline mesh::Mesh cube(mesh::CellKind kind, std::array<int, 3> const& n) {
  mesh::Mesh mesh;
  mesh.dim = 3;
  mesh.blocks = {{kind, {}}};
  std::map<detail::Lattice, Index> known;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        for (auto const& cell : detail::cells_in_box(mesh::info(kind), {2 * i, 2 * j, 2 * k}))
          for (auto const& node : cell)
            mesh.blocks[0].nodes.push_back(
                known.try_emplace(node, static_cast<Index>(known.size())).first->second);
  mesh.nodes.resize(static_cast<Eigen::Index>(known.size()), 3);
  for (auto const& [at, node] : known)
    mesh.nodes.row(node) << 0.5 * at[0] / n[0], 0.5 * at[1] / n[1], 0.5 * at[2] / n[2];
  return mesh;
}

inline mesh::Mesh square(mesh::CellKind kind, int nx, int ny) {
  mesh::BlockOptions options;
  options.size = {1, 1};
  options.cells = {static_cast<double>(nx), static_cast<double>(ny)};
  options.kind = kind;
  mesh::Mesh mesh = mesh::block(options);
  mesh.sets.clear();
  return mesh;
}

/// The unit square or cube, mapped.
inline mesh::Mesh grid(mesh::CellKind kind, std::array<int, 3> const& n, Map const& map) {
  auto mesh = mesh::info(kind).dim == 3 ? cube(kind, n) : square(kind, n[0], n[1]);
  for (Index i = 0; i < mesh.node_count(); ++i) {
    Point const at = map(node_position(mesh, i));
    for (int d = 0; d < mesh.dim; ++d)
      mesh.nodes(i, d) = at[d];
  }
  return mesh;
}

/// Moves every mid-side node to the middle of its side.
inline void straighten(mesh::Mesh& mesh) {
  for (auto const& block : mesh.blocks) {
    auto const& info = mesh::info(block.kind);
    auto const nodes = static_cast<std::size_t>(info.nodes), corners = static_cast<std::size_t>(info.corners);
    if (nodes == corners)
      continue;
    for (std::size_t c = 0; c < block.nodes.size(); c += nodes)
      for (std::size_t e = 0; e < info.edges.size(); ++e) {
        auto const corner = [&](int k) {
          return mesh.nodes.row(block.nodes[c + static_cast<std::size_t>(k)]);
        };
        mesh.nodes.row(block.nodes[c + corners + e]) =
            0.5 * (corner(info.edges[e][0]) + corner(info.edges[e][1]));
      }
  }
}

} // namespace stiction::test
