// The passes over a block, for one kinematics and number of nodes; each kinematics has its file.
#pragma once
#include <tuple>

#include "core/error.hpp"
#include "solid/cell.hpp"

namespace stiction::solid {

template<Kinematics kinematics, int Nodes> class Passes final : public BlockPasses {
  using Element = Cell<kinematics, Nodes>;
  static constexpr int dim = Element::dim;

public:
  static constexpr int nodes = Nodes;

  Index add_force(Deformed const& at, std::span<double> force, double& energy) const override {
    Element cell(at.block, at.body);
    for (Index c = 0; c < at.block.cells(); ++c) {
      if (!cell.deform(c, at.u))
        return c;
      energy += cell.template respond<material::Wanted::stress>();
      scatter(cell, cell.force(), force);
    }
    return -1;
  }

  void add_stiffness(Deformed const& at, StiffnessTarget const& target) const override {
    add_matrices(at, target, [](Element& cell) { cell.template respond<material::Wanted::tangent>(); });
  }

  double add_damping(Deformed const& at, std::span<double const> v, std::span<double> force) const override {
    Element cell(at.block, at.body);
    double power = 0;
    for (Index c = 0; c < at.block.cells(); ++c) {
      cell.deform(c, at.u);
      power += cell.flow(v);
      scatter(cell, cell.force(), force);
    }
    return power;
  }

  void add_damping_stiffness(Deformed const& at, StiffnessTarget const& target) const override {
    add_matrices(at, target, [](Element& cell) { cell.be_viscous(); });
  }

  void add_stress(Deformed const& at, StressSums& sums) const override {
    Element cell(at.block, at.body);
    for (Index c = 0; c < at.block.cells(); ++c) {
      if (!cell.deform(c, at.u))
        continue;
      cell.template respond<material::Wanted::stress>();
      for (int q = 0; q < cell.points(); ++q)
        add_stress_of(cell, q, sums);
    }
  }

private:
  static void add_stress_of(Element const& cell, int q, StressSums& sums) {
    auto const cauchy = material::stress_vector<Element::voigt>(cell.cauchy(q));
    for (int a = 0; a < Nodes; ++a) {
      Index const node = cell.connectivity()[a];
      sums.cauchy.row(node) += cell.volume(q) * cauchy.transpose();
      sums.volume[node] += cell.volume(q);
    }
  }

  static void scatter(Element const& cell, typename Element::Nodal const& f, std::span<double> force) {
    for (int a = 0; a < Nodes; ++a)
      for (int i = 0; i < dim; ++i)
        force[ix(dim * cell.connectivity()[a] + i)] += f(a, i);
  }

  template<class Respond>
  static void add_matrices(Deformed const& at, StiffnessTarget const& target, Respond const& respond) {
    Element cell(at.block, at.body);
    typename Element::Stiffness K;
    Index const* map = target.map;
    for (Index c = 0; c < at.block.cells(); ++c) {
      cell.deform(c, at.u);
      respond(cell);
      cell.stiffness(target.factor, K);
      for (int a = 0; a < Nodes; ++a)
        for (int i = 0; i < dim; ++i) {
          scatter_row(K, a, i, {1, map, target.values});
          map += dim * a + i + 1;
        }
    }
  }
  /// Row (a, i) of the lower triangle.
  static void scatter_row(typename Element::Stiffness const& K, int a, int i, StiffnessTarget const& to) {
    Index const* map = to.map;
    for (int b = 0; b <= a; ++b)
      for (int j = 0; j < (b < a ? dim : i + 1); ++j, ++map)
        if (*map >= 0)
          to.values[ix(*map)] += i >= j ? K[pair(i, j)](a, b) : K[pair(j, i)](b, a);
  }
  static constexpr std::size_t pair(int i, int j) { return static_cast<std::size_t>(Element::G::pair(i, j)); }
};

/// The one of Passes<kinematics, Nodes>... with so many nodes.
template<Kinematics kinematics, int... Nodes> BlockPasses const& passes_among(int nodes) {
  static std::tuple<Passes<kinematics, Nodes>...> const all;
  BlockPasses const* found = nullptr;
  std::apply([&](auto const&... each) { ((each.nodes == nodes ? found = &each : nullptr), ...); }, all);
  core::expect(found != nullptr, "passes for every kind of cell");
  return *found;
}

[[nodiscard]] BlockPasses const& plane_strain_passes(int nodes);
[[nodiscard]] BlockPasses const& axisymmetric_passes(int nodes);
[[nodiscard]] BlockPasses const& three_dimensional_passes(int nodes);

} // namespace stiction::solid
