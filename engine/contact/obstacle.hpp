// Rigid obstacles in closed form, in the frame in which they are described: no mesh and no unknowns.
#pragma once
#include <variant>

#include "contact/foot.hpp"
#include "core/schema.hpp"
#include "interface/cone.hpp"

namespace stiction::contact {

using interface::Local;

/// Half-space below the line or plane through `point` with outward `normal`.
struct RigidPlane {
  core::Numbers point;  ///< {x, y [, z]}, m; default the origin
  core::Numbers normal; ///< need not be of unit length; default the last axis
  [[nodiscard]] static core::Schema const& schema();
};

/// Disc of `radius` about `centre` in the plane; touched from outside.
struct RigidCircle {
  core::Numbers centre{0, 0}; ///< m
  double radius = 0;          ///< m
  [[nodiscard]] static core::Schema const& schema();
};

using Obstacle = std::variant<RigidPlane, RigidCircle>;

/// What a point sees of an obstacle, in the obstacle's frame.
template<int D> struct ObstacleView {
  bool found = false;
  Foot foot;                     ///< the next step's start
  double gap = 0;                ///< m
  Mat<D> frame = Mat<D>::Zero(); ///< columns n, t1 [, t2]: unit; (t1, n) or (t1, t2, n) right-handed
  Local<D - 1> slip = Local<D - 1>::Zero(); ///< since `start`, m; 0 if there was none
  Mat<D> by_x = Mat<D>::Zero();             ///< rows: derivatives of gap and slip by the point's place
};

/// `direction`: t1 is its part along the surface (3D only). `guess`: where to start looking.
template<int D>
[[nodiscard]] ObstacleView<D> view(Obstacle const& obstacle, Vec<D> const& point, Foot start, Foot guess,
                                   Vec3 const& direction);

/// Derivative of by_x^T force by the point's place, N/m. `seen` is the view from there.
template<int D>
[[nodiscard]] Mat<D> curvature_stiffness(Obstacle const& obstacle, ObstacleView<D> const& seen,
                                         Vec<D> const& point, Local<D> const& force, Vec3 const& direction);

} // namespace stiction::contact
