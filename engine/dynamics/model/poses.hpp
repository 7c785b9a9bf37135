// Where a rigid body is: on its path, or by its own unknowns.
#pragma once
#include <Eigen/Geometry>

#include "dynamics/model/model.hpp"
#include "dynamics/model/state.hpp"

namespace stiction::dynamics {

/// Rotation by the length of a vector about its direction.
[[nodiscard]] inline Eigen::Matrix3d rotation(Vec3 const& turn) {
  double const angle = turn.norm();
  if (angle == 0)
    return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

/// The turn of free body r. In space the unknowns are the sum of the steps' turns, so only what this step
/// adds to `old` may be taken for one.
template<int D>
[[nodiscard]] Eigen::Matrix3d turn_of_free(Model const& model, std::size_t r, Vector const& u,
                                           State const& old) {
  Index const first = D * (model.rigids[r].node + 1);
  if constexpr (D == 2)
    return rotation(u[first] * Vec3::UnitZ());
  else
    return rotation(u.segment<3>(first) - old.u.segment<3>(first)) * old.turned[r];
}

/// The pose of body r at time t, or where u has it if it is free; old: the step's start.
template<int D>
[[nodiscard]] contact::Pose<D> pose_of(Model const& model, std::size_t r, double t, Vector const& u,
                                       State const& old) {
  auto const& rigid = model.rigids[r];
  contact::Pose<D> pose;
  pose.pivot = rigid.pivot.head<D>();
  if (rigid.free()) {
    pose.translation = rigid.node;
    pose.turn = rigid.node + 1;
    pose.position = pose.pivot + u.segment<D>(D * pose.translation);
    pose.rotation = turn_of_free<D>(model, r, u, old).template topLeftCorner<D, D>();
  } else {
    pose.position = pose.pivot + rigid.offset(t).template head<D>();
    pose.rotation = rotation(rigid.angle.value(t) * rigid.axis).template topLeftCorner<D, D>();
  }
  return pose;
}

} // namespace stiction::dynamics
