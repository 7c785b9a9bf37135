// Drawing a laid-out chart: grid, curves, frame, words.
#include "charts/lines.hpp"

#include <algorithm>
#include <memory>

#include "charts/chart.hpp"
#include "charts/pieces.hpp"

namespace stiction::postproc {

namespace {

void draw_grid(Canvas& canvas, Chart const& chart) {
  Box const& plot = chart.plot;
  Pen const thin{grid_grey, points(grid_width), Dash::solid};
  for (auto const& tick : chart.x_ticks.ticks) {
    double const x = plot.left + chart.x.fraction(tick.value) * plot.width;
    if (!tick.label.empty())
      canvas.stroke({{x, plot.bottom}, {x, plot.top()}}, thin);
  }
  for (auto const& tick : chart.y_ticks.ticks) {
    double const y = plot.bottom + chart.y.fraction(tick.value) * plot.height;
    if (!tick.label.empty())
      canvas.stroke({{plot.left, y}, {plot.right(), y}}, thin);
  }
}

void draw_marks(Canvas& canvas, Chart const& chart) {
  Pen const pen{mark_grey, points(0.7), Dash::dash};
  Lettering lettering;
  lettering.colour = mark_grey;
  for (auto const& mark : chart.marks) {
    canvas.stroke({{mark.x, chart.plot.bottom}, {mark.x, chart.plot.top()}}, pen);
    double const bottom = chart.plot.top() + points(2) + mark.row * line_height(tick_size);
    canvas.text(mark.label, {mark.label_left, bottom}, lettering);
  }
}

/// A bar between two pixels, with a cap from -`cap` to `cap` at each end that lies within the plot.
void draw_bar(Canvas& canvas, Chart const& chart, std::vector<Point> const& ends, Point cap, Pen const& pen) {
  for (auto const& piece : pieces_within(chart.plot, ends))
    canvas.stroke(piece, pen);
  for (auto const& end : ends)
    if (chart.plot.contains(end))
      canvas.stroke({{end.x - cap.x, end.y - cap.y}, {end.x + cap.x, end.y + cap.y}}, pen);
}

/// The lower end of a bar: on an axis of logarithms, where it may be below zero, out of the plot.
double lower_end(Scale const& scale, double value, double error) {
  return scale.log ? std::max(value - error, 1e-3 * scale.low) : value - error;
}

/// Bars with caps, thinner than the curve, as far as the plot reaches.
void draw_errors(Canvas& canvas, Chart const& chart, Curve const& curve) {
  double const cap = 1.5 * curve.pen.width;
  Pen const pen{curve.pen.colour, points(error_width), Dash::solid};
  for (std::size_t i = 0; i < curve.errors.size(); ++i) {
    auto const [x, y] = curve.points[i];
    auto const error = curve.errors[i];
    if (error.x > 0)
      draw_bar(canvas, chart, chart.pixels({{lower_end(chart.x, x, error.x), y}, {x + error.x, y}}), {0, cap},
               pen);
    if (error.y > 0)
      draw_bar(canvas, chart, chart.pixels({{x, lower_end(chart.y, y, error.y)}, {x, y + error.y}}), {cap, 0},
               pen);
  }
}

/// Whole discs, also on the frame; triangles that point down for what lies there or below.
void draw_points(Canvas& canvas, Curve const& curve, std::vector<Point> const& line, Box const& plot) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (!plot.contains(line[i]))
      continue;
    bool const below = !curve.at_most.empty() && curve.at_most[i];
    canvas.marker(line[i], curve.pen, below ? Marker::down : Marker::disc);
  }
}

/// To the upper right of the points, or to the left where the plot ends.
void draw_names(Canvas& canvas, Curve const& curve, std::vector<Point> const& line, Box const& plot) {
  Lettering lettering;
  lettering.colour = curve.pen.colour;
  double const aside = 1.3 * curve.pen.width + points(0.8);
  for (std::size_t i = 0; i < std::min(line.size(), curve.names.size()); ++i) {
    if (!plot.contains(line[i]))
      continue;
    bool const room = line[i].x + aside + measure(curve.names[i], lettering.size).width < plot.right();
    lettering.across = room ? Across::left : Across::right;
    canvas.text(curve.names[i], {line[i].x + (room ? aside : -aside), line[i].y + points(0.5)}, lettering);
  }
}

void draw_curves(Canvas& canvas, Chart const& chart) {
  double const hair = 1e-6 * chart.plot.width;
  Box const& plot = chart.plot;
  Box const wide{plot.left - hair, plot.bottom - hair, plot.width + 2 * hair, plot.height + 2 * hair};
  for (auto const& curve : chart.curves) {
    auto line = chart.pixels(curve.points);
    draw_errors(canvas, chart, curve);
    if (curve.pen.dash == Dash::points)
      draw_points(canvas, curve, line, wide);
    else
      for (auto const& piece : pieces_within(wide, line))
        canvas.stroke(piece, curve.pen);
  }
  for (auto const& curve : chart.curves) // over all lines
    draw_names(canvas, curve, chart.pixels(curve.points), wide);
}

void draw_titles(Canvas& canvas, Chart const& chart) {
  Box const& plot = chart.plot;
  auto const& [x, y] = std::pair(chart.spec.x, chart.spec.y);
  std::string const x_title = axis_title(x.label, x.unit.word, chart.x_ticks.power);
  std::string const y_title = axis_title(y.label, y.unit.word, chart.y_ticks.power);
  double const labels = points(tick_length + tick_gap) + label_extent(chart.x_ticks).height + points(2);
  Lettering lettering;
  lettering.across = Across::centre;
  lettering.along = Along::top;
  lettering.size = fitting_size(x_title, label_size, chart.picture.width - 2 * points(edge));
  canvas.text(x_title, {plot.left + plot.width / 2, plot.bottom - labels}, lettering);
  lettering.upright = true;
  lettering.size = fitting_size(y_title, label_size, plot.height);
  canvas.text(y_title, {points(edge), plot.bottom + plot.height / 2}, lettering);
}

void draw_legend(Canvas& canvas, Chart const& chart) {
  if (chart.legend_box)
    chart.inside.draw(canvas, {chart.legend_box->left, chart.legend_box->bottom}, true);
  else if (chart.legend_below())
    chart.below.draw(canvas, {(chart.picture.width - chart.below.size().width) / 2, points(edge)}, false);
}

void draw(Canvas& canvas, Chart const& chart) {
  draw_grid(canvas, chart);
  draw_marks(canvas, chart);
  canvas.frame(chart.plot, {});
  draw_curves(canvas, chart);
  draw_ticks(canvas, chart.x_ticks, chart.x, chart.plot, Direction::across);
  draw_ticks(canvas, chart.y_ticks, chart.y, chart.plot, Direction::up);
  draw_titles(canvas, chart);
  draw_legend(canvas, chart);
  draw_heading(canvas, heading(chart.figure), chart.picture);
}

} // namespace

Drawing draw_lines(FigureSpec const& figure, LinesSpec const& lines) {
  auto const chart = std::make_shared<Chart const>(make_chart(figure, lines));
  return {chart->picture, [chart](Canvas& canvas) { draw(canvas, *chart); }, {}};
}

Margins margins_of(FigureSpec const& figure, LinesSpec const& lines) {
  auto const chart = make_chart(figure, lines);
  auto const& plot = chart.plot;
  return {plot.left, chart.picture.width - plot.right(), plot.bottom, chart.picture.height - plot.top()};
}

} // namespace stiction::postproc
