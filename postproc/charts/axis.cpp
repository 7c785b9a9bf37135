// Ticks along an edge, spaced so that labels keep apart.
#include "charts/axis.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::postproc {

namespace {

double extent(std::string const& label, Direction direction) {
  Size const size = measure(label, tick_size);
  return direction == Direction::across ? size.width : size.height;
}

bool labels_fit(Ticks const& ticks, Scale const& scale, double length, Direction direction) {
  double const gap = points(direction == Direction::across ? 5 : 4);
  double end = -1e9;
  for (auto const& tick : ticks.ticks) {
    if (tick.label.empty())
      continue;
    double const middle = scale.fraction(tick.value) * length, half = extent(tick.label, direction) / 2;
    if (middle - half < end + gap)
      return false;
    end = middle + half;
  }
  return true;
}

} // namespace

Ticks fitting_ticks(Scale const& scale, double length, Direction direction) {
  for (int wanted = 7; wanted > 1; --wanted)
    if (auto ticks = ticks_for(scale, wanted); labels_fit(ticks, scale, length, direction))
      return ticks;
  return ticks_for(scale, 1);
}

Size label_extent(Ticks const& ticks) {
  Size largest;
  for (auto const& tick : ticks.ticks) {
    Size const size = measure(tick.label, tick_size);
    largest = {std::max(largest.width, size.width), std::max(largest.height, size.height)};
  }
  return largest;
}

void draw_ticks(Canvas& canvas, Ticks const& ticks, Scale const& scale, Box const& box, Direction direction) {
  bool const across = direction == Direction::across;
  Lettering lettering;
  lettering.across = across ? Across::centre : Across::right;
  lettering.along = across ? Along::top : Along::centre;
  for (auto const& tick : ticks.ticks) {
    double const fraction = scale.fraction(tick.value);
    double const mark = points(tick.label.empty() ? tick_length / 2 : tick_length);
    double const text = points(tick_length + tick_gap);
    if (across) {
      double const x = box.left + fraction * box.width;
      canvas.stroke({{x, box.bottom}, {x, box.bottom - mark}}, {});
      canvas.text(tick.label, {x, box.bottom - text}, lettering);
    } else {
      double const y = box.bottom + fraction * box.height;
      canvas.stroke({{box.left, y}, {box.left - mark, y}}, {});
      canvas.text(tick.label, {box.left - text, y}, lettering);
    }
  }
}

double line_height(double size) {
  return measure("Åg", size).height;
}

double heading_height(std::string const& heading) {
  return heading.empty() ? 0 : line_height(title_size) + points(3);
}

void draw_heading(Canvas& canvas, std::string const& heading, Size const& picture, std::string const& aside) {
  Lettering lettering;
  lettering.along = Along::top;
  lettering.across = Across::right;
  lettering.size = tick_size;
  canvas.text(aside, {picture.width - points(edge), picture.height - points(edge)}, lettering);
  double const taken = aside.empty() ? 0 : measure(aside, tick_size).width + points(6);
  double const room = picture.width - 2 * points(edge) - taken;
  lettering.across = Across::left;
  lettering.size = fitting_size(heading, title_size, 0.97 * room); // drawn a little wider than measured
  canvas.text(heading, {points(edge), picture.height - points(edge)}, lettering);
}

} // namespace stiction::postproc
