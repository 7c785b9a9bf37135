// Feet, gaps and their second derivatives, shape by shape: what the views of obstacles are made of.
#pragma once
#include "contact/obstacle/obstacle_shapes.hpp"

namespace stiction::contact {

/// A shape of the plane from a point near it. The tangent is right_of(normal).
struct View2d {
  double gap = 0; ///< m
  Vec2 normal = Vec2::Zero();
  Vec2 slip_by_x = Vec2::Zero();
  Mat<2> gap_by_xx = Mat<2>::Zero(), slip_by_xx = Mat<2>::Zero(); ///< 1/m
};

/// A shape of space from a point near it.
struct View3d {
  int segment = -1; ///< of the foot, where to start looking next time; -1: no counterpart
  double gap = 0;   ///< m
  Vec3 normal = Vec3::Zero();
  Mat<3> normal_by_x = Mat<3>::Zero(); ///< 1/m
};

/// t of a normal n in the plane: (t, n) is right-handed.
[[nodiscard]] inline Vec2 right_of(Vec2 const& n) {
  return {n.y(), -n.x()};
}

/// 1 outside, -1 inside.
[[nodiscard]] inline double sign_of(Side side) {
  return side == Side::outside ? 1 : -1;
}

} // namespace stiction::contact
