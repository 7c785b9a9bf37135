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

/// Force, diagonal of the stiffness, then energy and the number of a cell inside out.
Vector passes_of(solid::Cells const& cells, Vector const& u) {
  Vector f = Vector::Zero(u.size()), K = f;
  auto const pass = cells.add_force(view(u), view(f));
  solid::ScatterMap map;
  cells.each_part([&](std::span<Index const> nodes) {
    for (Index row = 0; row < 3 * static_cast<Index>(nodes.size()); ++row)
      for (Index column = 0; column <= row; ++column)
        map.push_back(row == column ? 3 * nodes[ix(row / 3)] + row % 3 : -1);
  });
  if (pass.sound())
    cells.add_stiffness(view(u), 1, map, view(K));
  Vector all(2 * u.size() + 2);
  all << f, K, pass.energy, pass.inverted_cell;
  return all;
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

  TEST_CASE("processes that share cells have the whole of their own nodes, and energy counts once") {
    solid::Body const body{"b", many_cells(), material::NeoHookean{1e6, 0.4}, 1};
    Index const dofs = 3 * body.mesh.node_count();
    Vector u = 1e-3 * random_vector(dofs, 1);
    auto const is_first = [&](Index node) { return node_position(body.mesh, node).x() < 1.8; };
    auto const part_of = [&](bool first) {
      return [&, first](std::span<Index const> nodes) {
        auto const own = [&](Index node) { return is_first(node) == first; };
        bool const any = std::ranges::any_of(nodes, own);
        return own(nodes.front()) ? solid::CellPart::all
               : any              ? solid::CellPart::forces
                                  : solid::CellPart::none;
      };
    };
    solid::Cells const whole(body, Kinematics::three_dimensional);
    solid::Cells const parts[] = {{body, Kinematics::three_dimensional, part_of(true)},
                                  {body, Kinematics::three_dimensional, part_of(false)}};
    auto const wanted = passes_of(whole, u), a = passes_of(parts[0], u), b = passes_of(parts[1], u);
    Vector together(2 * dofs);
    for (Index k = 0; k < 2 * dofs; ++k)
      together[k] = (is_first(k % dofs / 3) ? a : b)[k];
    CHECK((together.head(dofs) - wanted.head(dofs)).norm() < 1e-12 * wanted.head(dofs).norm());
    CHECK((together.tail(dofs) - wanted.segment(dofs, dofs)).norm() <
          1e-12 * wanted.segment(dofs, dofs).norm());
    CHECK(a[2 * dofs] + b[2 * dofs] == doctest::Approx(wanted[2 * dofs]).epsilon(1e-12));
    double mass = 0, mass_of_part = 0;
    whole.each_mass([&](auto const&, Dense const& m) { mass += m.sum(); });
    parts[1].each_mass([&](auto const&, Dense const& m) { mass_of_part += m.sum(); });
    CHECK(mass_of_part == doctest::Approx(mass).epsilon(1e-12));
    CHECK(parts[1].count() == 2304);
    Vector const stress = whole.stress(view(u)).von_mises;
    CHECK(parts[1].stress(view(u)).von_mises == stress);
    u[3 * whole.nodes_of(2000)[0]] += 1;
    auto const number = passes_of(whole, u)[2 * dofs + 1];
    double const of_a = passes_of(parts[0], u)[2 * dofs + 1], of_b = passes_of(parts[1], u)[2 * dofs + 1];
    CHECK(number >= 0);
    CHECK((of_a == number || of_b == number));
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
