// Segment by segment, after Liang and Barsky (1984).
#include "charts/pieces.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace stiction::postproc {

namespace {

/// Parameters in [0, 1] between which the segment ab lies within the box.
std::optional<std::pair<double, double>> reach(Box const& box, Point a, Point b) {
  double const dx = b.x - a.x, dy = b.y - a.y;
  double const steps[] = {-dx, dx, -dy, dy};
  double const rooms[] = {a.x - box.left, box.right() - a.x, a.y - box.bottom, box.top() - a.y};
  double from = 0, to = 1;
  for (int side = 0; side < 4; ++side) {
    if (steps[side] == 0 && rooms[side] < 0)
      return {};
    if (steps[side] < 0)
      from = std::max(from, rooms[side] / steps[side]);
    else if (steps[side] > 0)
      to = std::min(to, rooms[side] / steps[side]);
  }
  if (from > to)
    return {};
  return std::pair{from, to};
}

} // namespace

std::vector<std::vector<Point>> pieces_within(Box const& box, std::vector<Point> const& line) {
  std::vector<std::vector<Point>> pieces;
  bool going = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    Point const a = line[i - 1], b = line[i];
    auto const part = reach(box, a, b);
    auto const at = [&](double t) { return Point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}; };
    if (part && !(going && part->first == 0))
      pieces.push_back({at(part->first)});
    if (part)
      pieces.back().push_back(at(part->second));
    going = part && part->second == 1;
  }
  return pieces;
}

} // namespace stiction::postproc
