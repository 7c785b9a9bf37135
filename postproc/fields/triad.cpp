// Axes that point at the eye or away from it are left out: they have no direction in the picture.
#include "fields/triad.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::postproc {

namespace {

double const arm = points(14), letter = points(4.5), shortest = 0.2;

/// Where an axis of the model points in the picture, by the unit length.
Point direction(Frame const& frame, std::size_t axis) {
  return {frame.right[axis], frame.up[axis]};
}

bool is_seen(Point d) {
  return std::hypot(d.x, d.y) >= shortest;
}

Point end_of(Point d, double beyond) {
  double const length = arm + beyond / std::hypot(d.x, d.y);
  return {length * d.x, length * d.y};
}

} // namespace

Box triad_box(Frame const& frame) {
  double left = 0, right = 0, bottom = 0, top = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto const d = direction(frame, axis);
    if (!is_seen(d))
      continue;
    auto const end = end_of(d, letter);
    left = std::min(left, end.x - letter);
    right = std::max(right, end.x + letter);
    bottom = std::min(bottom, end.y - letter);
    top = std::max(top, end.y + letter);
  }
  return {left, bottom, right - left, top - bottom};
}

void draw_triad(Canvas& canvas, Frame const& frame, Point origin) {
  Lettering lettering;
  lettering.across = Across::centre;
  lettering.along = Along::centre;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto const d = direction(frame, axis);
    if (!is_seen(d))
      continue;
    auto const tip = end_of(d, 0), word = end_of(d, letter);
    canvas.stroke({origin, {origin.x + tip.x, origin.y + tip.y}}, {ink, points(0.9), Dash::solid});
    canvas.text(std::string(1, "xyz"[axis]), {origin.x + word.x, origin.y + word.y}, lettering);
  }
}

} // namespace stiction::postproc
