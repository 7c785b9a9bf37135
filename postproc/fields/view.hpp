// Parallel projection: the plane of the picture in space, and what lies in it.
#pragma once
#include <optional>

#include "spec/spec.hpp"

namespace stiction::postproc {

[[nodiscard]] inline double dot(Vector const& a, Vector const& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Unit vectors: right and up in the picture, and from it to the eye.
struct Frame {
  Vector right{1, 0, 0}, up{0, 1, 0}, toward{0, 0, 1};

  [[nodiscard]] Point project(Vector const& p) const { return {dot(p, right), dot(p, up)}; }
  /// The point at (x, y) of the picture plane, `depth` toward the eye.
  [[nodiscard]] Vector in_space(Point at, double depth) const;
};

/// Without a view: seen along z.
[[nodiscard]] Frame frame_of(std::optional<ViewSpec> const& view);

/// What a picture shows, in m along the axes of its frame.
struct Extent {
  double x[2], y[2], depth[2];

  Extent();
  void include(Frame const& frame, Vector const& point, double radius = 0);
  [[nodiscard]] double width() const { return x[1] - x[0]; }
  [[nodiscard]] double height() const { return y[1] - y[0]; }
  [[nodiscard]] bool contains(Point p) const {
    return p.x >= x[0] && p.x <= x[1] && p.y >= y[0] && p.y <= y[1];
  }
};

} // namespace stiction::postproc
