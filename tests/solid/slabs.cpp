// Many cells in slabs: which share no nodes, that every cell counts once, and the same bits whatever the
// threads.
#include "solid/slabs.hpp"

#include <algorithm>
#include <set>

#include "solid/helpers.hpp"
#include "threads.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

/// 2304 hexahedra.
mesh::Mesh many_cells() {
  return grid(mesh::CellKind::hex8, {16, 12, 12},
              [](Point const& at) { return Point(2 * at.x(), at.y(), at.z()); });
}

/// Nodes of the cells of each slab.
std::vector<std::set<Index>> nodes_of(Indices const& slab, Indices const& connectivity) {
  std::vector<std::set<Index>> nodes(ix(*std::ranges::max_element(slab) + 1));
  for (std::size_t k = 0; k < connectivity.size(); ++k)
    nodes[ix(slab[k / 8])].insert(connectivity[k]);
  return nodes;
}

bool apart(std::set<Index> const& a, std::set<Index> const& b) {
  return std::ranges::none_of(a, [&](Index node) { return b.contains(node); });
}

} // namespace

TEST_SUITE("solid") {
  TEST_CASE("slabs that are not neighbours share no node, however nodes and cells are numbered") {
    auto connectivity = many_cells().blocks.front().nodes;
    for (Index const stride : {1, 1009}) { // prime to the number of nodes
      Index const n = 17 * 13 * 13;
      for (Index& node : connectivity)
        node = static_cast<Index>(std::int64_t{node} * stride % n);
      auto const nodes = nodes_of(solid::slabs(connectivity, 8), connectivity);
      CHECK(nodes.size() >= 3);
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t j = i + 2; j < nodes.size(); ++j)
          CHECK(apart(nodes[i], nodes[j]));
    }
    CHECK(solid::slabs({0, 1, 2, 1, 2, 3}, 3) == Indices{0, 0});
    CHECK(solid::slabs({}, 4).empty());
  }

  TEST_CASE("every cell in its slab counts once, and the number of threads changes no bit") {
    solid::Body const body{"b", many_cells(), material::NeoHookean{1e6, 0.4}, 1};
    Index const dofs = 3 * body.mesh.node_count();
    Vector const u = nodal(body.mesh, [](Point const& X) {
      return Point(0.1 * X.x() + 0.02 * X.y(), 0.05 * X.z() - 0.1 * X.y(), 0.03 * X.x());
    });
    auto const made = [&] {
      solid::Cells const cells(body, Kinematics::three_dimensional);
      Vector all = Vector::Zero(dofs + 3);
      auto const pass = cells.add_force({u.data(), ix(dofs)}, {all.data(), ix(dofs)});
      solid::ScatterMap map;
      cells.each_cell([&](std::span<Index const> nodes) {
        for (Index row = 0; row < 3 * static_cast<Index>(nodes.size()); ++row)
          for (Index column = 0; column <= row; ++column) // the diagonal alone
            map.push_back(row == column ? 3 * nodes[ix(row / 3)] + row % 3 : -1);
      });
      Vector K = Vector::Zero(dofs);
      cells.add_stiffness({u.data(), ix(dofs)}, 1, map, {K.data(), ix(dofs)});
      all.head(dofs) += K;
      all[dofs] = pass.energy;
      all[dofs + 1] = cells.stress({u.data(), ix(dofs)}).von_mises.sum();
      all[dofs + 2] = cells.count();
      return all;
    };
    same_by_threads(made);
    CHECK(made()[dofs + 2] == 2304);
    solid::Cells const cells(body, Kinematics::three_dimensional);
    Vector f = Vector::Zero(dofs);
    static_cast<void>(cells.add_force({u.data(), ix(dofs)}, {f.data(), ix(dofs)}));
    double most = 0; // of the forces on inner nodes, which a homogeneous strain leaves in balance
    auto const inner = inner_nodes(body.mesh);
    for (Index node = 0; node < body.mesh.node_count(); ++node)
      most = std::max(most, inner[ix(node)] ? f.segment<3>(3 * node).norm() : 0.0);
    CHECK(most < 1e-12 * f.lpNorm<Eigen::Infinity>());
  }

  TEST_CASE("of several inverted cells in slabs the first is told, as the mesh numbers them") {
    solid::Body const body{"b", many_cells(), material::NeoHookean{1e6, 0.4}, 1};
    solid::Cells const cells(body, Kinematics::three_dimensional);
    auto const inverted = [&](std::vector<Index> const& numbers) {
      Vector u = Vector::Zero(3 * body.mesh.node_count()), f = u;
      for (Index const number : numbers)
        u[3 * cells.nodes_of(number)[0]] += 1; // beyond the cell's other side
      return cells
          .add_force({u.data(), ix(static_cast<Index>(u.size()))},
                     {f.data(), ix(static_cast<Index>(f.size()))})
          .inverted_cell;
    };
    CHECK(inverted({}) == -1);
    Index const lone = inverted({2000}), other = inverted({700});
    CHECK(lone <= 2000); // the node's other cells are inverted as well
    CHECK(other < lone);
    CHECK(inverted({2000, 700}) == other);
  }
}
