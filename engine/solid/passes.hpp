// The passes over a block, for one kinematics and number of nodes; each kinematics has its file.
#pragma once
#include <tuple>

#include "core/error.hpp"
#include "solid/cell.hpp"

namespace stiction::solid {

template<Kinematics kinematics, int Nodes> class Passes final : public BlockPasses {
  using Group = CellGroup<kinematics, Nodes>;
  static constexpr int dim = Group::dim;

public:
  static constexpr int nodes = Nodes;

  Index add_force(Deformed const& at, std::span<double> force, double& energy) const override {
    Group group(at);
    for (Index g = 0; g < at.block.groups(); ++g) {
      if (int const bad = group.deform(g, at.u); bad >= 0)
        return at.block.cell(g, bad);
      add_lanes(group, group.template respond<material::Wanted::stress>(), energy);
      scatter(group, group.force(), force);
    }
    return -1;
  }

  void add_stiffness(Deformed const& at, StiffnessTarget const& target) const override {
    add_matrices(at, target, [](Group& group) { group.template respond<material::Wanted::tangent>(); });
  }

  double add_damping(Deformed const& at, std::span<double const> v, std::span<double> force) const override {
    Group group(at);
    double power = 0;
    for (Index g = 0; g < at.block.groups(); ++g) {
      group.deform(g, at.u);
      add_lanes(group, group.flow(v), power);
      scatter(group, group.force(), force);
    }
    return power;
  }

  void add_damping_stiffness(Deformed const& at, StiffnessTarget const& target) const override {
    add_matrices(at, target, [](Group& group) { group.be_viscous(); });
  }

  void add_stress(Deformed const& at, StressSums& sums) const override {
    Group group(at);
    for (Index g = 0; g < at.block.groups(); ++g) {
      group.deform(g, at.u);
      group.template respond<material::Wanted::stress>();
      for (int q = 0; q < group.points(); ++q)
        add_stress_of(group, q, sums);
    }
  }

  material::NetworkEnergy<double> relax(Deformed const& at, Remembered const& memory) const override {
    Group group(at);
    material::NetworkEnergy<double> sum;
    for (Index g = 0; g < at.block.groups(); ++g) {
      group.deform(g, at.u);
      auto const of_cells = group.relax(memory);
      add_lanes(group, of_cells.stored, sum.stored);
      add_lanes(group, of_cells.dissipated, sum.dissipated);
    }
    return sum;
  }

private:
  static void add_lanes(Group const& group, Pack const& of_cells, double& sum) {
    for (int lane = 0; lane < group.cells(); ++lane)
      sum += of_cells[lane];
  }

  static void add_stress_of(Group const& group, int q, StressSums& sums) {
    auto const cauchy = material::stress_vector<Group::voigt>(group.cauchy(q));
    for (int lane = 0; lane < group.cells(); ++lane)
      for (int a = 0; a < Nodes && group.sound(lane); ++a) {
        Index const node = group.connectivity(lane)[a];
        double const volume = group.volume(q)[lane];
        sums.volume[node] += volume;
        for (int i = 0; i < Group::voigt; ++i)
          sums.cauchy(node, i) += volume * cauchy[i][lane];
      }
  }

  static void scatter(Group const& group, typename Group::Nodal const& f, std::span<double> force) {
    for (int lane = 0; lane < group.cells(); ++lane) {
      Index const* node = group.connectivity(lane);
      for (int a = 0; a < Nodes; ++a)
        for (int i = 0; i < dim; ++i)
          force[ix(dim * node[a] + i)] += f(a, i)[lane];
    }
  }

  template<class Respond>
  static void add_matrices(Deformed const& at, StiffnessTarget const& target, Respond const& respond) {
    Group group(at);
    typename Group::Stiffness K;
    Index const* map = target.map;
    for (Index g = 0; g < at.block.groups(); ++g) {
      group.deform(g, at.u);
      respond(group);
      group.stiffness(target.factor, K);
      for (int lane = 0; lane < group.cells(); ++lane)
        for (int a = 0; a < Nodes; ++a)
          for (int i = 0; i < dim; ++i) {
            scatter_row(K, {a, i, lane}, {1, map, target.values});
            map += dim * a + i + 1;
          }
    }
  }
  struct Row {
    int node, component, lane;
  };
  /// Row of the lower triangle.
  static void scatter_row(typename Group::Stiffness const& K, Row const& row, StiffnessTarget const& to) {
    auto const [a, i, lane] = row;
    Index const* map = to.map;
    for (int b = 0; b <= a; ++b)
      for (int j = 0; j < (b < a ? dim : i + 1); ++j, ++map)
        if (*map >= 0)
          to.values[ix(*map)] += (i >= j ? K[pair(i, j)](a, b) : K[pair(j, i)](b, a))[lane];
  }
  static constexpr std::size_t pair(int i, int j) { return static_cast<std::size_t>(Group::G::pair(i, j)); }
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
