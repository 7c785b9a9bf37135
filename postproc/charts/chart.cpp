// Layout from measured text: edges left and right, then the heights, then the legend.
#include "charts/chart.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"

namespace stiction::postproc {

namespace {

Scale scale_of(AxisSpec const& axis, std::vector<Curve> const& curves, double Point::*coordinate,
               bool tight) {
  if (axis.range)
    return {axis.range->first, axis.range->second, axis.log};
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (auto const& curve : curves)
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      double const middle = curve.points[i].*coordinate;
      double const error = curve.errors.empty() ? 0 : curve.errors[i].*coordinate;
      low = std::min(low, axis.log && error >= middle ? middle : middle - error);
      high = std::max(high, middle + error);
    }
  Scale const scale = padded_scale(low, high, axis.log);
  if (tight && high > low)
    return {scale.low == 0 ? 0 : low, high, axis.log};
  return scale;
}

/// An abscissa ends where its data end, unless there are markers to keep clear of the frame.
bool is_tight(std::vector<Curve> const& curves) {
  return std::none_of(curves.begin(), curves.end(),
                      [](Curve const& curve) { return curve.pen.dash == Dash::points; });
}

void check_visible(Chart const& chart) {
  Box const all{-1e-9, -1e-9, 1 + 2e-9, 1 + 2e-9};
  for (auto const& curve : chart.curves)
    for (auto const& point : curve.points)
      if (all.contains({chart.x.fraction(point.x), chart.y.fraction(point.y)}))
        return;
  throw core::RunError("no point of any curve lies within the ranges of the axes; widen \"range\"");
}

void lay_out_across(Chart& chart) {
  double const pad = points(edge);
  chart.y_ticks = fitting_ticks(chart.y, 0.6 * chart.figure.width, Direction::up);
  double const labels = points(tick_length + tick_gap) + label_extent(chart.y_ticks).width;
  auto const& margins = chart.figure.margins;
  chart.plot.left = std::max(margins.left, std::round(pad + line_height(label_size) + points(3) + labels));
  chart.plot.width = chart.figure.width - chart.plot.left - pad;
  chart.x_ticks = fitting_ticks(chart.x, chart.plot.width, Direction::across);
  double overhang = 0;
  for (auto const& tick : chart.x_ticks.ticks) {
    double const half = measure(tick.label, tick_size).width / 2;
    overhang = std::max(overhang, half - (1 - chart.x.fraction(tick.value)) * chart.plot.width);
  }
  chart.plot.width =
      std::round(std::min(chart.plot.width - overhang, chart.figure.width - chart.plot.left - margins.right));
  chart.picture.width = chart.figure.width;
}

void lay_out_marks(Chart& chart) {
  std::vector<double> row_ends; // right end of the last label in each row
  auto marks = chart.spec.marks;
  std::sort(marks.begin(), marks.end(), [](auto const& a, auto const& b) { return a.x < b.x; });
  for (auto const& mark : marks) {
    double const fraction = chart.x.fraction(mark.x);
    if (!(fraction >= 0 && fraction <= 1))
      throw core::InputError(fmt::format("the mark \"{}\" at {:g} lies outside the x axis ({:g} to {:g} {})",
                                         mark.label, mark.x, chart.x.low, chart.x.high,
                                         chart.spec.x.unit.word));
    double const x = chart.plot.left + fraction * chart.plot.width, pad = points(edge);
    double const width = measure(mark.label, tick_size).width;
    double const left = std::max(pad, std::min(x - width / 2, chart.picture.width - pad - width));
    std::size_t row = 0;
    while (row < row_ends.size() && row_ends[row] + points(4) > left)
      ++row;
    row_ends.resize(std::max(row_ends.size(), row + 1));
    row_ends[row] = left + width;
    chart.marks.push_back({x, left, static_cast<double>(row), mark.label});
    if (!mark.label.empty())
      chart.mark_rows = std::max(chart.mark_rows, static_cast<double>(row + 1));
  }
}

void lay_out_up(Chart& chart) {
  double const pad = points(edge);
  double const legend = chart.legend_below() ? chart.below.size().height : 0;
  double const labels = points(tick_length + tick_gap) + label_extent(chart.x_ticks).height;
  double const below = std::round(pad + legend + line_height(label_size) + points(2) + labels);
  chart.plot.bottom = std::max(chart.figure.margins.bottom, below);
  double const marks = chart.mark_rows * line_height(tick_size) + points(2);
  double const above = std::max(chart.figure.margins.top, pad + heading_height(heading(chart.figure)) +
                                                              std::max(marks, line_height(tick_size) / 2));
  double const given = chart.figure.height - chart.plot.bottom - above;
  if (chart.figure.height > 0 && given < points(30))
    throw core::InputError(fmt::format("a height of {:.0f} mm leaves no room for the plot; give more",
                                       chart.figure.height / millimetres(1)));
  chart.plot.height = std::round(chart.figure.height > 0 ? given : 0.7 * chart.plot.width);
  chart.picture.height = std::round(chart.plot.top() + above);
  chart.y_ticks = fitting_ticks(chart.y, chart.plot.height, Direction::up);
}

/// Inside where it hides nothing, else below; so the heights may change once more.
void settle_legend(Chart& chart) {
  auto const& wanted = chart.spec.legend;
  if (wanted == "below" || wanted == "none")
    return lay_out_up(chart);
  chart.legend_box = Box{};
  lay_out_up(chart);
  if (!wanted.empty()) {
    chart.legend_box = chart.inside.in_corner(wanted, chart.plot);
    return;
  }
  std::vector<std::vector<Point>> lines;
  for (auto const& curve : chart.curves)
    lines.push_back(chart.pixels(curve.points));
  for (auto const& mark : chart.marks)
    lines.push_back({{mark.x, chart.plot.bottom}, {mark.x, chart.plot.top()}});
  chart.legend_box = chart.inside.free_corner(chart.plot, lines);
  if (!chart.legend_box)
    lay_out_up(chart);
}

} // namespace

std::vector<Point> Chart::pixels(std::vector<Point> const& given) const {
  // far outside stays outside, within what single precision holds
  auto pixel = [](double fraction, double start, double length) {
    return start + std::clamp(fraction, -20.0, 20.0) * length;
  };
  std::vector<Point> line;
  line.reserve(given.size());
  for (auto const& point : given)
    line.push_back({pixel(x.fraction(point.x), plot.left, plot.width),
                    pixel(y.fraction(point.y), plot.bottom, plot.height)});
  return line;
}

Chart make_chart(FigureSpec const& figure, LinesSpec const& spec) {
  std::vector<Curve> curves;
  for (std::size_t i = 0; i < spec.curves.size(); ++i)
    curves.push_back(load_curve(spec.curves[i], i, spec));
  Legend inside(curves), below(curves, figure.width - 2 * points(edge));
  Scale const x = scale_of(spec.x, curves, &Point::x, is_tight(curves));
  Scale const y = scale_of(spec.y, curves, &Point::y, false);
  Chart chart{figure, spec, std::move(curves), inside, below, x, y, {}, {}, {}, {}, {}, 0, {}};
  check_visible(chart);
  lay_out_across(chart);
  lay_out_marks(chart);
  settle_legend(chart);
  return chart;
}

} // namespace stiction::postproc
