// Linear and angular momentum of a model's bodies, and the impulses that change them.
#pragma once
#include <vector>

#include "dynamics/model/model.hpp"

namespace stiction::dynamics {

/// Momentum, N s, with its moment about the origin, N m s; or a force, N, with its moment, N m. In plane
/// strain per metre of depth; components that the model has not are zero.
struct Screw {
  Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
  Screw& operator+=(Screw const& other) {
    linear += other.linear;
    angular += other.angular;
    return *this;
  }
  [[nodiscard]] friend Screw operator*(double factor, Screw const& s) {
    return {factor * s.linear, factor * s.angular};
  }
  [[nodiscard]] Vec3 about(Vec3 const& point) const { return angular - point.cross(linear); }
};

/// What a pair does to its two sides.
struct PairScrew {
  Screw secondary, primary; ///< primary: of an obstacle on its path nothing
};

/// Kept where the model is `tallied`. Impulses are sums since the start of the forces that the ledger's works
/// are found with, each with its moment where it acts: contact at the steps' ends, all else half-way.
struct Momenta {
  std::vector<Screw> bodies;    ///< [bodies + rigids] momentum, by the mass that the scheme moves
  std::vector<PairScrew> pairs; ///< [pairs] impulses
  Screw start;                  ///< momentum of all at the start
  Screw loads, motions;         ///< impulses of weight and loads, and of motions
  Screw springs; ///< impulses on their nodes: of those between two sets nothing, but for moments
  std::vector<PairScrew> forces; ///< [pairs] at the end of the last step
};

/// Sum of nodal forces or momenta over the nodes first ... last - 1, moments where the nodes are at u.
[[nodiscard]] Screw resultant(Model const& model, Vector const& u, Vector const& nodal, Index first,
                              Index last);
/// Of contact forces of one pair on either side.
[[nodiscard]] PairScrew resultants(Model const& model, Pair const& pair, Vector const& u,
                                   Vector const& nodal);

} // namespace stiction::dynamics
