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
  [[nodiscard]] Index cells() const { return static_cast<Index>(connectivity.size()) / nodes; }
  /// Cells are computed in groups of four, one in each lane of a Pack.
  [[nodiscard]] Index groups() const { return (cells() + Pack::lanes - 1) / Pack::lanes; }
  /// Of a group; the last one may be short.
  [[nodiscard]] int cells_in(Index group) const {
    return std::min(Pack::lanes, cells() - Pack::lanes * group);
  }
  /// In a lane of a group; where none is left the block's last.
  [[nodiscard]] Index cell(Index group, int lane) const {
    return std::min(Pack::lanes * group + lane, cells() - 1);
  }
};

/// One block with its body and the displacement, dim * nodes of it.
struct Deformed {
  PreparedBlock const& block;
  Body const& body;
  std::span<double const> u;
};

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
};

/// The instance for cells of so many nodes; fails an expectation if there is none.
[[nodiscard]] BlockPasses const& passes(Kinematics kinematics, int nodes);

} // namespace stiction::solid
