// The cells of one body prepared for assembly, and the passes over them.
#pragma once
#include <array>
#include <functional>
#include <span>

#include "solid/block.hpp"

namespace stiction::solid {

/// Outcome of one pass over the cells.
struct Pass {
  double energy = 0;        ///< strain energy, J (J/m in plane strain)
  Index inverted_cell = -1; ///< a cell with det F <= 0, whose stress does not exist, as numbered in the mesh
  [[nodiscard]] bool sound() const { return inverted_cell < 0; }
};

/// Where a cell's stiffness goes: entry of the global values for each entry of its lower triangle, row by
/// row, -1 for driven unknowns.
using ScatterMap = std::vector<Index>;

/// Cauchy stress recovered at the nodes by volume-weighted averages over the quadrature points.
struct NodalStress {
  Matrix cauchy;    ///< [nodes, 4]: 11, 22, 33, 12, or in 3D [nodes, 6]: 11, 22, 33, 12, 23, 13, Pa
  Vector von_mises; ///< [nodes], Pa
};

/// What a process that shares a body with others does with a cell: nothing, or forces and stiffness; or these
/// and its energy, which one of them has to.
enum class CellPart { none, forces, all };

/// What the networks of a body that relaxes do within a step, [blocks of Cells].
using Networks = std::vector<BlockNetworks>;

/// Many cells are kept in slabs, of which every other one can be worked on at the same time: what is summed
/// at a node has an order that does not depend on the number of threads.
class Cells {
public:
  using PartOf = std::function<CellPart(std::span<Index const>)>;
  /// Throws nothing; the mesh must have passed mesh::check. part: of the cell with these nodes; without it
  /// all of each.
  Cells(Body const& body, Kinematics kinematics, PartOf const& part = {});

  /// force[dim * nodes] += F_int(u) of (35), N. u[dim * nodes] belongs to this body's nodes.
  /// networks: beside the law; none: the law alone.
  [[nodiscard]] Pass add_force(std::span<double const> u, std::span<double> force,
                               Networks const* networks = nullptr) const;
  /// values[map[k]] += factor * K(u) of (39). Call only where add_force was sound.
  void add_stiffness(std::span<double const> u, double factor, ScatterMap const& map,
                     std::span<double> values, Networks const* networks = nullptr) const;

  /// Has the body networks that relax? Without them the calls below are not for it.
  [[nodiscard]] bool relaxing() const { return !body_->relaxing.empty(); }
  /// Size of what they remember, all 0 at rest: [groups of four cells, points, numbers of NetworkSteps,
  /// lanes] block by block, or by_cell where others share the cells.
  [[nodiscard]] Eigen::Index memory_size() const;
  /// The same as [points of the cells in the order of the mesh, numbers of NetworkSteps].
  [[nodiscard]] Vector by_cell(std::span<double const> memory) const;
  /// And back.
  [[nodiscard]] Vector from_cells(std::span<double const> by_cell) const;
  /// What they do in a step of size dt, s (0: at present); an empty memory is one of rest.
  [[nodiscard]] Networks networks(std::span<double const> memory, double dt) const;
  /// The same, in memory that is there.
  void find_networks(std::span<double const> memory, double dt, Networks& all) const;
  /// The step of size dt that has ended at u: fills `after` for all cells of which all is the part here, and
  /// tells their energies, J.
  [[nodiscard]] material::NetworkEnergy<double>
  relax(std::span<double const> u, double dt, std::span<double const> before, std::span<double> after) const;

  /// Whether the body has viscous stress; without it the two passes below do nothing.
  [[nodiscard]] bool damped() const { return body_->damping.has_value(); }
  /// force += A(u) v of the viscous stress, A = int B^T D_v B; returns the dissipated power v.A v >= 0, W.
  [[nodiscard]] double add_damping(std::span<double const> u, std::span<double const> v,
                                   std::span<double> force) const;
  /// values[map[k]] += factor * A(u), symmetric and positive semidefinite, kg/s.
  void add_damping_stiffness(std::span<double const> u, double factor, ScatterMap const& map,
                             std::span<double> values) const;

  /// memory: of networks that relax; an empty one is of rest.
  [[nodiscard]] NodalStress stress(std::span<double const> u, std::span<double const> memory = {}) const;

  /// Visits each cell's consistent mass per component: nodes of the cell, m[nodes, nodes] in kg.
  void each_mass(std::function<void(std::span<Index const>, Dense const&)> const& visit) const;
  /// Visits the nodes of each cell; where none is of others, in the order of each_part.
  void each_cell(std::function<void(std::span<Index const>)> const& visit) const;
  /// Visits the nodes of each cell whose part is not none, in the order that add_stiffness reads its map.
  void each_part(std::function<void(std::span<Index const>)> const& visit) const;
  /// Of a cell as numbered in the mesh.
  [[nodiscard]] std::span<Index const> nodes_of(Index cell) const;
  /// Of all cells.
  [[nodiscard]] Index count() const;

private:
  /// Blocks that share no nodes: from `first` to before `last`.
  struct Wave {
    Index first, last;
  };
  /// Cells of one kind and law.
  struct Alike {
    Indices connectivity, number; ///< [cells, nodes]; [cells], in the mesh
  };
  void take(CellPart wanted, PartOf const& part);
  void divide(mesh::CellKind kind, material::Material const& law, Alike const& cells);
  void number_points();
  [[nodiscard]] std::size_t remembered_each() const;
  template<class Visit> void each_remembered(Visit const& visit) const;
  [[nodiscard]] NodalStress stress_of_whole(std::span<double const> u, std::span<double const> memory) const;
  void prepare(PreparedBlock& block) const;
  void prepare_point(std::array<Matrix, Pack::lanes> const& X, int q, PreparedBlock& prepared) const;
  [[nodiscard]] NetworkSteps network_steps(material::Material const& law, double dt) const;
  template<class Visit> void each_whole(Visit const& visit) const;
  template<class BlockPass> void each_block(BlockPass const& pass) const;
  template<class BlockPass>
  void each_target(ScatterMap const& map, StiffnessTarget target, BlockPass const& pass) const;

  Body const* body_;
  Kinematics kinematics_;
  std::vector<PreparedBlock> blocks_;
  bool shared_;                             ///< are some cells others' part?
  std::ptrdiff_t points_ = 0,               ///< quadrature points of all cells of the mesh, where they relax
      places_ = 0;                          ///< and those that there is memory for, lanes without cells too
  std::vector<std::ptrdiff_t> mesh_points_; ///< [blocks] as first_point by_cell
  Index whole_ = 0; ///< so many blocks, the first, have cells of which all is the part
  std::vector<std::ptrdiff_t> first_entry_; ///< [blocks], in the ScatterMap
  std::vector<Wave> waves_;
  mutable std::vector<Pass> parts_; ///< [blocks], of the present pass
};

/// Mass of the cells, kg (kg/m in plane strain), and where its centre is in the reference, m; about an axis
/// the mean of (r, z).
struct MassCentre {
  double mass = 0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
};
[[nodiscard]] MassCentre mass_centre(Body const& body, Cells const& cells);

} // namespace stiction::solid
