// Layout of the legend and the search for a free corner.
#include "charts/legend.hpp"

#include <algorithm>
#include <cmath>

#include "charts/axis.hpp"

namespace stiction::postproc {

namespace {

double const sample = points(17), spacing = points(4), padding = points(3);

/// Whether the segment ab comes into the box, looked at every two pixels.
bool crosses(Box const& box, Point a, Point b) {
  if (std::max(a.x, b.x) < box.left || std::min(a.x, b.x) > box.right() || std::max(a.y, b.y) < box.bottom ||
      std::min(a.y, b.y) > box.top())
    return false;
  int const parts = 1 + static_cast<int>(std::min(1e4, std::hypot(b.x - a.x, b.y - a.y) / 2));
  for (int i = 0; i <= parts; ++i) {
    double const t = static_cast<double>(i) / parts;
    if (box.contains({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)}))
      return true;
  }
  return false;
}

bool touches(Box const& box, std::vector<Point> const& line) {
  for (std::size_t i = 0; i < line.size(); ++i)
    if (crosses(box, line[i == 0 ? 0 : i - 1], line[i]))
      return true;
  return false;
}

} // namespace

Legend::Legend(std::vector<Curve> const& curves) {
  for (auto const& curve : curves) {
    if (curve.label.empty())
      continue;
    entries_.push_back(&curve);
    cell_.width = std::max(cell_.width, sample + spacing + measure(curve.label, legend_size).width);
  }
  cell_.height = line_height(legend_size) + points(2);
}

Legend::Legend(std::vector<Curve> const& curves, double width) : Legend(curves) {
  cell_.width =
      std::min(cell_.width, 0.97 * (width - 2 * padding)); // smaller letters where labels are longer
  double const fitting = (width - 2 * padding + 3 * spacing) / (cell_.width + 3 * spacing);
  auto const most = static_cast<std::size_t>(std::max(1.0, std::floor(fitting)));
  std::size_t const rows = (entries_.size() + most - 1) / most;
  columns_ = rows == 0 ? 1 : (entries_.size() + rows - 1) / rows;
}

Size Legend::size() const {
  if (entries_.empty())
    return {};
  std::size_t const rows = (entries_.size() + columns_ - 1) / columns_;
  auto const columns = static_cast<double>(columns_);
  return {columns * cell_.width + (columns - 1) * 3 * spacing + 2 * padding,
          static_cast<double>(rows) * cell_.height + 2 * padding};
}

void Legend::draw(Canvas& canvas, Point lower_left, bool boxed) const {
  if (entries_.empty())
    return;
  Box const box{lower_left.x, lower_left.y, size().width, size().height};
  if (boxed) {
    canvas.fill(box, white);
    canvas.frame(box, {grid_grey, points(grid_width), Dash::solid});
  }
  Lettering lettering;
  lettering.size = legend_size;
  for (auto const* entry : entries_)
    lettering.size =
        std::min(lettering.size, fitting_size(entry->label, legend_size, cell_.width - sample - spacing));
  lettering.along = Along::centre;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    std::size_t const column = i % columns_, row = i / columns_;
    double const left = box.left + padding + static_cast<double>(column) * (cell_.width + 3 * spacing);
    double const middle = box.top() - padding - (static_cast<double>(row) + 0.5) * cell_.height;
    auto const& pen = entries_[i]->pen;
    auto const& below = entries_[i]->at_most;
    bool const all_below = !below.empty() && std::count(below.begin(), below.end(), false) == 0;
    if (pen.dash == Dash::points)
      canvas.marker({left + sample / 2, middle}, pen, all_below ? Marker::down : Marker::disc);
    else
      canvas.stroke({{left, middle}, {left + sample, middle}}, pen);
    canvas.text(entries_[i]->label, {left + sample + spacing, middle}, lettering);
  }
}

Box Legend::in_corner(std::string const& corner, Box const& plot) const {
  Size const own = size();
  double const inset = points(4);
  bool const right = corner.ends_with("right"), top = corner.starts_with("top");
  return {right ? plot.right() - own.width - inset : plot.left + inset,
          top ? plot.top() - own.height - inset : plot.bottom + inset, own.width, own.height};
}

std::optional<Box> Legend::free_corner(Box const& plot, std::vector<std::vector<Point>> const& lines) const {
  for (auto const* corner : {"top right", "top left", "bottom right", "bottom left"}) {
    Box const box = in_corner(corner, plot);
    Box const wide{box.left - spacing, box.bottom - spacing, box.width + 2 * spacing,
                   box.height + 2 * spacing};
    bool const fits = box.left > plot.left && box.bottom > plot.bottom && box.right() < plot.right() &&
                      box.top() < plot.top();
    bool const hidden = std::any_of(lines.begin(), lines.end(),
                                    [&](std::vector<Point> const& line) { return touches(wide, line); });
    if (fits && !hidden)
      return box;
  }
  return {};
}

} // namespace stiction::postproc
