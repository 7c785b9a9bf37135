// What of a line lies within a box.
#pragma once
#include <vector>

#include "page/canvas.hpp"

namespace stiction::postproc {

/// The pieces of a polyline within the box, cut at its sides.
[[nodiscard]] std::vector<std::vector<Point>> pieces_within(Box const& box, std::vector<Point> const& line);

} // namespace stiction::postproc
