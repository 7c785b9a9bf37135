// The frame of a view in degrees, and extents seen in it.
#include "fields/view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stiction::postproc {

Vector Frame::in_space(Point at, double depth) const {
  Vector result;
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = at.x * right[i] + at.y * up[i] + depth * toward[i];
  return result;
}

Frame frame_of(std::optional<ViewSpec> const& view) {
  if (!view)
    return {};
  constexpr double degree = std::numbers::pi / 180;
  double const ca = std::cos(view->azimuth * degree), sa = std::sin(view->azimuth * degree);
  double const ce = std::cos(view->elevation * degree), se = std::sin(view->elevation * degree);
  return {{ca, sa, 0}, {-se * sa, se * ca, ce}, {ce * sa, -ce * ca, se}};
}

Extent::Extent() {
  constexpr double far = std::numeric_limits<double>::infinity();
  for (double* range : {x, y, depth}) {
    range[0] = far;
    range[1] = -far;
  }
}

void Extent::include(Frame const& frame, Vector const& point, double radius) {
  auto stretch = [radius](double* range, double value) {
    range[0] = std::min(range[0], value - radius);
    range[1] = std::max(range[1], value + radius);
  };
  auto const at = frame.project(point);
  stretch(x, at.x);
  stretch(y, at.y);
  stretch(depth, dot(point, frame.toward));
}

} // namespace stiction::postproc
