// The directions of x, y and z in a picture of a solid, as a small cross of axes.
#pragma once
#include "fields/view.hpp"

namespace stiction::postproc {

/// What the triad covers, its origin at (0, 0), in pixels.
[[nodiscard]] Box triad_box(Frame const& frame);
void draw_triad(Canvas& canvas, Frame const& frame, Point origin);

} // namespace stiction::postproc
