// The springs of a model together: nodal forces, work, dissipation, entries of the effective stiffness.
#pragma once
#include "dynamics/model/model.hpp"
#include "linear/pattern.hpp"

namespace stiction::dynamics {

/// Displacements and velocities at a time.
struct Instant {
  Vector const& u;
  Vector const& v;
  double t = 0; ///< s
};

/// Parts of a work or of a force, by spring and by dashpot.
struct SpringWork {
  double elastic = 0, viscous = 0; ///< J
};

class Springs {
public:
  explicit Springs(Model const& model);
  [[nodiscard]] bool empty() const { return members_.empty(); }
  [[nodiscard]] bool damped() const { return damped_; }
  [[nodiscard]] bool linear() const { return linear_; }

  /// Adds the gradient of the energy, N; returns the energy, J.
  double add_force(Vector const& u, double t, Vector& force) const;
  /// Adds the dashpots' part of the internal force, N.
  void add_damping(Instant const& now, Vector& force) const;
  /// What one spring does, its nodes' shares together; with its dashpot.
  [[nodiscard]] SpringPull pull(std::size_t spring, Instant const& now) const;

  /// Work of the ends that follow paths, from one moment to another, by the mean of the forces: `later` is
  /// the part of those at the end.
  [[nodiscard]] SpringWork path_work(Instant const& from, Instant const& to, double later) const;
  /// What dashpots take, J: the work of the mean of their forces, of each never less than nothing.
  [[nodiscard]] double damping_loss(Instant const& from, Instant const& to, double later) const;

  /// The unknowns that springs couple, group by group.
  void add_cliques(Indices const& unknown_of, std::vector<Indices>& cliques) const;
  /// place(dof, dof): where an entry is among the values.
  template<class Place> void map_entries(Place const& place) {
    for (auto& block : blocks_)
      for (std::size_t i = 0; i < block.dofs.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
          block.map.push_back(place(block.dofs[i], block.dofs[j]));
  }
  /// visit(degrees of freedom) that one spring couples.
  template<class Visit> void each_block(Visit const& visit) const {
    for (auto const& block : blocks_)
      visit(block.dofs);
  }
  void add_stiffness(Vector const& u, double t, double factor, std::span<double> values) const;
  /// Of the dashpots; the change of their directions with u is left out.
  void add_damping_stiffness(Vector const& u, double t, double factor, std::span<double> values) const;
  /// Largest eigenvalue that the springs add to that of M^-1 K, at most, 1/s^2; inverse_mass: [dim nodes].
  [[nodiscard]] double stiffest(Vector const& u, double t, Vector const& inverse_mass) const;

private:
  /// A spring, or one node's share of it.
  struct Member {
    std::size_t spring;
    double share;                ///< of stiffness and damping
    Indices nodes;               ///< of both ends
    std::vector<double> weights; ///< [nodes] of their displacements in the way from end to end
  };
  /// Degrees of freedom of a member that are coupled, and where their entries are, row by row.
  struct Block {
    std::size_t member;
    Indices dofs, components;
    std::vector<double> weights;
    Indices map;
  };
  void add_blocks(std::size_t member);
  [[nodiscard]] Eigen::Vector3d apart(Member const& member, Vector const& u, double t) const;
  [[nodiscard]] Eigen::Vector3d rate(Member const& member, Vector const& v, double t) const;
  [[nodiscard]] SpringPull pull(Member const& member, Instant const& now) const;
  void add_at(Member const& member, Eigen::Vector3d const& force, Vector& sum) const;
  template<class Tangent> void add_entries(Tangent const& tangent, std::span<double> values) const;

  Model const* model_;
  std::vector<Member> members_;
  std::vector<Block> blocks_;
  bool damped_ = false, linear_ = true;
};

} // namespace stiction::dynamics
