// Where a contact point meets its counterpart: points of surfaces, and vectors and matrices by dimension.
#pragma once
#include <algorithm>
#include <limits>
#include <optional>

#include "core/types.hpp"

namespace stiction::contact {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
template<int D> using Vec = Eigen::Matrix<double, D, 1>;
template<int D> using Mat = Eigen::Matrix<double, D, D>;

/// Below this a step in local coordinates that no longer falls is rounding, of facets of this size as far
/// from the origin as this, m.
[[nodiscard]] inline double rounding_step(double distance, double size) {
  return std::max(1e-10, 16 * std::numeric_limits<double>::epsilon() * distance / size);
}

/// A point of a primary surface: segment or facet with local coordinates; it moves with the surface. On an
/// obstacle the coordinates are whatever the shape measures slip by.
struct Foot {
  int segment = -1; ///< -1: no counterpart
  double xi = 0, eta = 0, zeta = 0;
  [[nodiscard]] bool found() const { return segment >= 0; }
};

/// How far beyond the borders of a surface, on the plane in which it ends, a foot may lie: a little, so that
/// a corner flush with one does not lose its counterpart to rounding or to the turning of an iterate; farther
/// where a point had one when the step began, or it would come and go within the step as bodies bulge; and as
/// far as the mesh tells apart where a bond holds the point, whose other end is the border.
enum class Overhang { found, kept, bonded };
/// In parts of a facet.
[[nodiscard]] constexpr double reaches(Overhang overhang) {
  return overhang == Overhang::bonded ? 1 : overhang == Overhang::kept ? 0.05 : 0.01;
}

/// Where a step found a point.
struct Start {
  Foot foot;
  std::optional<Vec3> normal;          ///< in 3D, of the obstacle there; none: it is looked up
  Overhang overhang = Overhang::found; ///< from here on, over the borders of a surface
  Start() = default;
  Start(Foot at) : foot(at), overhang(at.found() ? Overhang::kept : Overhang::found) {}
};

/// Most nodes that the force and the stiffness of one node-to-segment point may reach: the secondary node,
/// then those of the primary.
template<int D> inline constexpr int max_nodes = D == 2 ? 5 : 48;

} // namespace stiction::contact
