// Rigid obstacles, in the frame in which they are described: no mesh and no unknowns.
#pragma once
#include <optional>
#include <variant>

#include "contact/obstacle/obstacle_heights.hpp"
#include "contact/obstacle/obstacle_polyline.hpp"
#include "contact/obstacle/obstacle_shapes.hpp"
#include "contact/obstacle/obstacle_surface.hpp"
#include "contact/surface/foot.hpp"
#include "interface/cone.hpp"

namespace stiction::contact {

using interface::Local;

using Obstacle = std::variant<RigidPlane, RigidCircle, RigidSphere, RigidCylinder, RigidTorus, RigidPolyline,
                              RigidSurface, RigidHeights>;

/// What a point sees of an obstacle, in the obstacle's frame.
template<int D> struct ObstacleView {
  /// Not where the nearest point is not unique (the centre of a sphere) or does not exist (past an open end).
  bool found = false;
  Foot foot;      ///< the next step's start; in 3D (xi, eta, zeta) is the position of the point
  double gap = 0; ///< m
  Mat<D> frame = Mat<D>::Zero(); ///< columns n, t1 [, t2]: unit; (t1, n) or (t1, t2, n) right-handed
  /// Since `start`, m; 0 if there was none: the way along the surface. In 3D the point's, laid round the
  /// circle that turns as the normal does: all of it round spheres and cylinders, else but for the third
  /// order.
  Local<D - 1> slip = Local<D - 1>::Zero();
  /// Rows of the forces: derivatives of gap and slip by the point's position. In 3D the rows of slip are t1
  /// and t2, which a short way's are; motion_by_x() has those of any.
  Mat<D> by_x = Mat<D>::Zero();
};

/// "" or, in words, what keeps the obstacle from use in a scene of `dim` dimensions and what to give instead.
[[nodiscard]] std::string unfit(Obstacle const& obstacle, int dim, bool axisymmetric);

/// Makes what a shape is looked up in; once, after unfit() had nothing to say and before the first view().
void prepare(Obstacle& obstacle);

/// `direction`: t1 is its part along the surface (3D only); where that vanishes, of the next axis. `guess`:
/// where to start looking. The obstacle must fit D dimensions.
template<int D>
[[nodiscard]] ObstacleView<D> view(Obstacle const& obstacle, Vec<D> const& point, Start const& start,
                                   Foot guess, Vec3 const& direction);

/// Derivative of by_x^T force by the point's position, N/m. `foot` is that of the view from there.
template<int D>
[[nodiscard]] Mat<D> curvature_stiffness(Obstacle const& obstacle, Foot foot, Vec<D> const& point,
                                         Local<D> const& force, Vec3 const& direction);

/// The derivatives of gap and slip by the point's position. `foot` is that of the view from there.
[[nodiscard]] Mat<3> motion_by_x(Obstacle const& obstacle, Foot foot, Vec3 const& point, Start const& start,
                                 Vec3 const& direction);

/// Of an obstacle in space where a step found a point; none if it found none.
[[nodiscard]] std::optional<Vec3> normal_at(Obstacle const& obstacle, Foot start);

template<> ObstacleView<2> view(Obstacle const&, Vec2 const&, Start const&, Foot, Vec3 const&);
template<> ObstacleView<3> view(Obstacle const&, Vec3 const&, Start const&, Foot, Vec3 const&);
template<> Mat<2> curvature_stiffness(Obstacle const&, Foot, Vec2 const&, Local<2> const&, Vec3 const&);
template<> Mat<3> curvature_stiffness(Obstacle const&, Foot, Vec3 const&, Local<3> const&, Vec3 const&);

} // namespace stiction::contact
