// A rigid surface of given heights: rough, measured, or any function.
#pragma once
#include <memory>

#include "contact/obstacle/height_field.hpp"
#include "contact/obstacle/obstacle_view.hpp"

namespace stiction::contact {

/// A height field that does not move, and where it lies.
struct FixedHeights {
  HeightField field;
  Vec3 point;              ///< its middle, m
  Mat<3> axes;             ///< columns: along u, along v, outward
  Vec3 middle;             ///< of the field's own coordinates, m
  std::vector<double> arc; ///< in the plane: length along the surface to each cell's start and the end, m
  [[nodiscard]] Vec3 local(Vec3 const& x) const { return axes.transpose() * (x - point) + middle; }
};

/// Half-space below the plane through `point` with outward `normal`, from which its surface stands back by
/// the heights: a bicubic spline through them (cubic in the plane). Feet are the nearest points of all of it.
struct RigidHeights {
  enum class Rim { periodic, free };
  core::Numbers size, points;   ///< {x [, y]}: m, 1
  Rim boundary = Rim::periodic; ///< free: no counterpart past the rim
  core::Numbers point;          ///< the middle of the map, m; default the origin
  core::Numbers normal;         ///< need not be of unit length; default the last axis
  core::Numbers along;          ///< in space: the map's x; default the first axis across `normal`
  core::Numbers heights;        ///< of the middles of its rectangles, along x first, m
  std::shared_ptr<FixedHeights const> prepared; ///< by prepare(), from the above
  /// Without `heights`, which who builds a scene makes of the nested `surface`.
  [[nodiscard]] static core::Schema const& schema();
};

[[nodiscard]] std::string unfit(RigidHeights const& map, int dim, bool axisymmetric);
void prepare(RigidHeights& map);

/// The smallest radius of its peaks, of the spline at the given heights, m; infinite where it has none.
[[nodiscard]] double sharpest_peak(RigidHeights const& map);

/// Of a map of the plane, at the given heights: {x1, y1, x2, y2, ...}, m.
[[nodiscard]] core::Numbers profile(RigidHeights const& map);

/// xi is the place along the map.
[[nodiscard]] Foot foot_2d(RigidHeights const& map, Vec2 const& x, Foot guess);
/// Along the surface.
[[nodiscard]] double slip_2d(RigidHeights const& map, Foot from, Foot to);
[[nodiscard]] View2d view_2d(RigidHeights const& map, Vec2 const& x, Foot foot);
[[nodiscard]] View3d view_3d(RigidHeights const& map, Vec3 const& x, Foot guess);

} // namespace stiction::contact
