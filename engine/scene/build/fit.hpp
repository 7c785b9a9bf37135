// The plane, circle or sphere that runs through given points, and how far it misses them.
#pragma once
#include "contact/surface/foot.hpp"

namespace stiction::scene {

using contact::Vec3;

/// In the plane a line or a circle; third components are 0.
struct ShapeFit {
  enum Kind { none, flat, round } kind = none;
  Vec3 centre = Vec3::Zero(); ///< of the circle or sphere; of a plane the middle of the points, m
  Vec3 normal = Vec3::Zero(); ///< of a plane, unit, either way
  double radius = 0;          ///< m
  double error = 0;           ///< largest distance of a point from the shape, m
};

/// points[n, dim]: the flat shape if it misses no point by more than 1/1000 of their extent, else the round
/// one if it misses none by more than 1/100 of its radius, else none.
[[nodiscard]] ShapeFit fit_shape(Matrix const& points);

} // namespace stiction::scene
