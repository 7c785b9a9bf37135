// Rigid obstacles in closed form: plane and circle, moved along a path without mesh or unknowns.
#pragma once
#include <variant>

#include "contact/curve.hpp"
#include "core/schema.hpp"

namespace stiction::contact {

/// Half-plane below the line through `point` with outward `normal`.
struct RigidPlane {
  core::Numbers point{0, 0};  ///< m
  core::Numbers normal{0, 1}; ///< need not be of unit length
  [[nodiscard]] static core::Schema const& schema();
};

/// Disc of `radius` about `centre`; touched from outside.
struct RigidCircle {
  core::Numbers centre{0, 0}; ///< m
  double radius = 0;          ///< m
  [[nodiscard]] static core::Schema const& schema();
};

using Obstacle = std::variant<RigidPlane, RigidCircle>;

/// What a point sees of an obstacle displaced by `offset`.
struct ObstacleView {
  double gap = 0;
  Vec2 normal, tangent;      ///< unit; (tangent, normal) right-handed
  double coordinate = 0;     ///< material arc length along the surface in the direction of `tangent`, m
  Vec2 coordinate_by_x;      ///< derivative of `coordinate`
  Eigen::Matrix2d gap_by_xx; ///< second derivatives
  Eigen::Matrix2d coordinate_by_xx;
};
[[nodiscard]] ObstacleView view(Obstacle const& obstacle, Vec2 const& point, Vec2 const& offset);

/// Difference of two coordinates, the short way round on closed obstacles.
[[nodiscard]] double coordinate_difference(Obstacle const& obstacle, double to, double from);

} // namespace stiction::contact
