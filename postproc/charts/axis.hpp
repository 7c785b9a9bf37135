// The parts that every kind of figure shares: ticks that do not collide, axes along an edge, the heading.
#pragma once
#include <string>

#include "charts/ticks.hpp"
#include "page/canvas.hpp"

namespace stiction::postproc {

/// Length of a tick mark and space between it and its label, in points.
inline constexpr double tick_length = 2, tick_gap = 1.5;

enum class Direction { across, up };

/// As many ticks as have room for their labels on `length` pixels.
[[nodiscard]] Ticks fitting_ticks(Scale const& scale, double length, Direction direction);
/// The largest label, in pixels.
[[nodiscard]] Size label_extent(Ticks const& ticks);

/// Tick marks and labels under the lower edge of `box` (across) or left of it (up); tick marks point inwards
/// by `tick_length` points when `inward`, else outwards.
void draw_ticks(Canvas& canvas, Ticks const& ticks, Scale const& scale, Box const& box, Direction direction);

/// Height in pixels of a line of text `size` points high.
[[nodiscard]] double line_height(double size);

/// "(a) title" along the top of a picture; nothing when both are empty.
[[nodiscard]] double heading_height(std::string const& heading);
/// On the left of the picture's top; `aside` stands on the right.
void draw_heading(Canvas& canvas, std::string const& heading, Size const& picture,
                  std::string const& aside = "");

} // namespace stiction::postproc
