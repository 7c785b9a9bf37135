// A rigid profile of the plane through given points.
#pragma once
#include <memory>

#include "contact/obstacle/obstacle_view.hpp"
#include "contact/surface/curve.hpp"

namespace stiction::contact {

/// A curve that does not move, with the positions of its nodes.
struct FixedCurve {
  std::vector<double> x; ///< [2 nodes], m
  Curve curve;
};

/// Profile through points, the solid to the left when walking. Corners of more than 40 degrees stay corners.
/// In the wedge outside a convex corner a point has its foot in the corner, its normal points from there, and
/// it slips round the corner at the distance that it has: normals turn steadily from one side to the other,
/// or a bond would pull now this way, now that. In a concave corner it meets one of the two sides.
struct RigidPolyline {
  core::Numbers points; ///< {x1, y1, x2, y2, ...}, m
  bool closed = false;  ///< the last point is followed by the first
  Smoothing smoothing = Smoothing::spline;
  std::shared_ptr<FixedCurve const> prepared; ///< by prepare(), from the above
  [[nodiscard]] static core::Schema const& schema();
};

[[nodiscard]] std::string unfit(RigidPolyline const& line, int dim, bool axisymmetric);
void prepare(RigidPolyline& line);

/// Not found past an open end. In a wedge `eta` is the angle from the normal of the segment before the
/// corner, rad, `zeta` the distance, m; both are 0 elsewhere.
[[nodiscard]] Foot foot_2d(RigidPolyline const& line, Vec2 const& x, Foot guess);
/// Along the curve, on closed ones the short way round, and round corners.
[[nodiscard]] double slip_2d(RigidPolyline const& line, Foot from, Foot to);
[[nodiscard]] View2d view_2d(RigidPolyline const& line, Vec2 const& x, Foot foot);
/// From a point whose nearest one on a curve this is; the solid to the left when walking.
[[nodiscard]] View2d view_from(CurvePoint const& foot, Vec2 const& x);

} // namespace stiction::contact
