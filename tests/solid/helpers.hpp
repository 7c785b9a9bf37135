// Small distorted bodies of every cell kind and dense assembly, for the tests of solid.
#pragma once
#include <random>

#include "material/samples.hpp"
#include "mesh/generators.hpp"
#include "solid/cells.hpp"

namespace stiction::test {

/// Moves every mid-side node to the middle of its side.
inline void straighten(mesh::Mesh& mesh) {
  for (auto const& block : mesh.blocks) {
    auto const& info = mesh::info(block.kind);
    for (std::size_t c = 0; c < block.nodes.size(); c += static_cast<std::size_t>(info.nodes))
      for (auto const& side : info.facets)
        if (side.size() == 3) {
          auto const node = [&](std::size_t k) { return block.nodes[c + static_cast<std::size_t>(side[k])]; };
          mesh.nodes.row(node(2)) = 0.5 * (mesh.nodes.row(node(0)) + mesh.nodes.row(node(1)));
        }
  }
}

/// A block [1, 3] x [0, 1.5] m of nx x ny cells whose inner corners are shifted at random; sides stay
/// straight.
inline mesh::Mesh distorted(mesh::CellKind kind, int nx, int ny) {
  mesh::BlockOptions options;
  options.origin = {1, 0};
  options.size = {2, 1.5};
  options.cells = {static_cast<double>(nx), static_cast<double>(ny)};
  options.kind = kind;
  auto mesh = mesh::block(options);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  for (Index i = 0; i < mesh.node_count(); ++i) {
    double const x = mesh.nodes(i, 0), y = mesh.nodes(i, 1);
    bool const inner = x > 1 + 1e-9 && x < 3 - 1e-9 && y > 1e-9 && y < 1.5 - 1e-9;
    Eigen::RowVector2d const shift(uniform(random) * 2 / nx, uniform(random) * 1.5 / ny);
    if (inner)
      mesh.nodes.row(i).head<2>() += shift;
  }
  straighten(mesh);
  return mesh;
}

inline std::vector<bool> inner_nodes(mesh::Mesh const& mesh) {
  std::vector<bool> inner(ix(mesh.node_count()), true);
  for (auto const& facet : mesh::boundary(mesh))
    for (Index const node : facet.nodes)
      inner[ix(node)] = false;
  return inner;
}

/// u(X) at every node, [2 nodes].
template<class Field> Vector nodal(mesh::Mesh const& mesh, Field const& field) {
  Vector u(2 * mesh.node_count());
  for (Index i = 0; i < mesh.node_count(); ++i)
    u.segment<2>(2 * i) = field(Eigen::Vector2d(mesh.nodes.row(i).transpose()));
  return u;
}

inline Vector force(solid::Cells const& cells, Vector const& u) {
  Vector f = Vector::Zero(u.size());
  auto const pass = cells.add_force({u.data(), static_cast<std::size_t>(u.size())},
                                    {f.data(), static_cast<std::size_t>(f.size())});
  return pass.sound() ? f : Vector::Constant(u.size(), std::numeric_limits<double>::quiet_NaN()).eval();
}

inline double energy(solid::Cells const& cells, Vector const& u) {
  Vector f = Vector::Zero(u.size());
  return cells
      .add_force({u.data(), static_cast<std::size_t>(u.size())},
                 {f.data(), static_cast<std::size_t>(f.size())})
      .energy;
}

/// Where each cell's lower triangle goes in a dense matrix of n x n values: entry row n + column, row >=
/// column.
inline solid::ScatterMap dense_map(solid::Cells const& cells, Index n) {
  solid::ScatterMap map;
  cells.each_cell([&](std::span<Index const> nodes) {
    Indices dofs;
    for (Index const node : nodes)
      dofs.insert(dofs.end(), {2 * node, 2 * node + 1});
    for (std::size_t i = 0; i < dofs.size(); ++i)
      for (std::size_t j = 0; j <= i; ++j)
        map.push_back(std::max(dofs[i], dofs[j]) * n + std::min(dofs[i], dofs[j]));
  });
  return map;
}

/// K(u), full and symmetric, N/m.
inline Dense stiffness(solid::Cells const& cells, Vector const& u) {
  auto const n = static_cast<Index>(u.size());
  std::vector<double> values(ix(n) * ix(n), 0.0);
  cells.add_stiffness({u.data(), ix(n)}, 1, dense_map(cells, n), values);
  Eigen::Map<Dense const> const upper(values.data(), n, n); // columns of the map are our rows
  return upper.selfadjointView<Eigen::Upper>();
}

constexpr solid::Kinematics kinematics_list[] = {solid::Kinematics::plane_strain,
                                                 solid::Kinematics::axisymmetric};

} // namespace stiction::test
