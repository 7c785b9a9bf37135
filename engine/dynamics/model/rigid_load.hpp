// What contact points do to the rigid body that they press on.
#pragma once
#include <Eigen/Geometry>

#include "dynamics/model/state.hpp"

namespace stiction::dynamics {

/// Adds the reverse of the forces H^T force on the nodes of deformable bodies, those below `bodies_end`, at
/// the positions x.
template<int D>
void add_load(contact::PointKinematics<D> const& point, interface::Local<D> const& force,
              std::span<double const> x, Index bodies_end, RigidLoad& load) {
  for (int a = 0; a < point.count; ++a) {
    Index const node = point.nodes[ix(a)];
    if (node >= bodies_end)
      continue;
    contact::Vec3 pull = contact::Vec3::Zero(), position = contact::Vec3::Zero();
    pull.head<D>() = -point.H.template middleCols<D>(D * a).transpose() * force;
    position.head<D>() = Eigen::Map<contact::Vec<D> const>(&x[ix(D * node)]);
    load.force += pull;
    load.moment += position.cross(pull);
  }
}

} // namespace stiction::dynamics
