// What is known of a block of cells before it deforms, and the passes that read it.
#pragma once
#include <algorithm>
#include <span>
#include <vector>

#include "core/pack.hpp"
#include "solid/body.hpp"

namespace stiction::solid {

class BlockPasses;

/// Cells of one kind and law, all of them or a slab, with everything that stays: gradients and volumes at the
/// quadrature points.
struct PreparedBlock {
  mesh::CellKind kind;
  int nodes, points;
  Indices connectivity;        ///< [cells, nodes]
  Indices number;              ///< [cells], of each in the body's mesh, from 0
  std::vector<Pack> gradients; ///< [groups, points, width, nodes], 1/m; width as in Geometry
  std::vector<Pack>
      volumes; ///< that the points stand for, [groups, points], m^2 (m^3 when axisymmetric or in 3D)
  BlockPasses const* passes;     ///< the code for this kind
  material::Material const* law; ///< of all its cells
  /// Points before its first in the order of Memory; where others share the cells, of the mesh, were all its
  /// cells of this kind.
  std::ptrdiff_t first_point;
  bool by_cell; ///< memory is in the order of the mesh
  [[nodiscard]] Index cells() const { return static_cast<Index>(connectivity.size()) / nodes; }
  /// Cells are computed in groups of four, one in each lane of a Pack.
  [[nodiscard]] Index groups() const { return (cells() + Pack::lanes - 1) / Pack::lanes; }
  /// Of a group; the last one may be short.
  [[nodiscard]] int cells_in(Index group) const {
    return std::min(Pack::lanes, cells() - Pack::lanes * group);
  }
  /// Where the numbers of point q begin that the cell in a lane of a group remembers, so many of each point,
  /// and how far they lie from each other.
  struct Place {
    std::size_t first, stride;
  };
  [[nodiscard]] Place remembered(Index group, int lane, int q, std::size_t each) const {
    if (by_cell)
      return {
          static_cast<std::size_t>(first_point + std::ptrdiff_t{number[ix(cell(group, lane))]} * points + q) *
              each,
          1};
    return {static_cast<std::size_t>(first_point + Pack::lanes * (std::ptrdiff_t{group} * points + q)) *
                    each +
                static_cast<std::size_t>(lane),
            Pack::lanes};
  }
  /// In a lane of a group; where none is left the block's last.
  [[nodiscard]] Index cell(Index group, int lane) const {
    return std::min(Pack::lanes * group + lane, cells() - 1);
  }
};

/// What networks that relax do at the points of a block within a step (material::add_networks).
struct BlockNetworks {
  double modulus = 0;         ///< m, Pa
  std::vector<Pack> pulls;    ///< P, [groups, points, stress components], Pa; empty without networks in shear
  double bulk_modulus = 0;    ///< m of volume networks, Pa
  std::vector<Pack> pressing; ///< their n, [groups, points], Pa; empty without them
};

/// One block with its body and the displacement, dim * nodes of it; networks: none.
struct Deformed {
  PreparedBlock const& block;
  Body const& body;
  std::span<double const> u;
  BlockNetworks const* networks = nullptr;
};

/// Numbers of a point of a group, from `skip` on of those that it remembers, so many of each point.
struct RememberedAt {
  Index group;
  int point;
  std::size_t each, skip;
};

/// The networks of a law in a step. A point remembers V of each in shear and W, then a of each in volume and
/// ln J; nothing of those that there are none of.
struct NetworkSteps {
  std::vector<material::NetworkStep> shear, volume;
  /// Numbers of the networks in shear, at a point of so many stress components.
  [[nodiscard]] std::size_t of_shear(std::size_t components) const {
    return shear.empty() ? 0 : (shear.size() + 1) * components;
  }
  /// And of all.
  [[nodiscard]] std::size_t each(std::size_t components) const {
    return of_shear(components) + (volume.empty() ? 0 : volume.size() + 1);
  }
};

/// A step of the networks of a block: what they remember of its start, and where its end goes.
struct Remembered {
  NetworkSteps const& steps;
  std::span<double const> before; ///< of all cells of the body
  std::span<double> after;
};

/// Of four cells side by side.
inline void recall(PreparedBlock const& block, std::span<double const> memory, RememberedAt const& at,
                   std::span<Pack> numbers) {
  if (!block.by_cell) {
    auto const [first, stride] = block.remembered(at.group, 0, at.point, at.each);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i] = Pack::load(&memory[first + (at.skip + i) * stride]);
    return;
  }
  for (int lane = 0; lane < Pack::lanes; ++lane) {
    auto const [first, stride] = block.remembered(at.group, lane, at.point, at.each);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i].set(lane, memory[first + (at.skip + i) * stride]);
  }
}
inline void keep(PreparedBlock const& block, std::span<double> memory, RememberedAt const& at,
                 std::span<Pack const> numbers) {
  if (!block.by_cell) {
    auto const [first, stride] = block.remembered(at.group, 0, at.point, at.each);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      numbers[i].store(&memory[first + (at.skip + i) * stride]);
    return;
  }
  for (int lane = 0; lane < block.cells_in(at.group); ++lane) {
    auto const [first, stride] = block.remembered(at.group, lane, at.point, at.each);
    for (std::size_t i = 0; i < numbers.size(); ++i)
      memory[first + (at.skip + i) * stride] = numbers[i][lane];
  }
}

/// Where a block's stiffness goes: `map` as in Cells::add_stiffness, from this block's first entry on.
struct StiffnessTarget {
  double factor;
  Index const* map;
  std::span<double> values;
};

/// Sums over points of volume and of volume times stress, [nodes] and [nodes, stress components].
struct StressSums {
  Vector volume;
  Matrix cauchy;
};

/// The passes over one block. A kind and kinematics each have one stateless instance.
class BlockPasses {
public:
  virtual ~BlockPasses() = default;
  /// Adds force and energy; the first cell with det F <= 0, where it stops, or -1.
  virtual Index add_force(Deformed const& at, std::span<double> force, double& energy) const = 0;
  virtual void add_stiffness(Deformed const& at, StiffnessTarget const& target) const = 0;
  /// A(u) v; returns v.A v.
  virtual double add_damping(Deformed const& at, std::span<double const> v,
                             std::span<double> force) const = 0;
  virtual void add_damping_stiffness(Deformed const& at, StiffnessTarget const& target) const = 0;
  virtual void add_stress(Deformed const& at, StressSums& sums) const = 0;
  /// Takes the networks through a step that ends at u; the energies of the block.
  virtual material::NetworkEnergy<double> relax(Deformed const& at, Remembered const& memory) const = 0;
};

/// The instance for cells of so many nodes; fails an expectation if there is none.
[[nodiscard]] BlockPasses const& passes(Kinematics kinematics, int nodes);

} // namespace stiction::solid
