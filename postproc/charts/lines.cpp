// Drawing a laid-out chart: grid, curves, frame, words.
#include "charts/lines.hpp"

#include <vtkNew.h>

#include "charts/chart.hpp"
#include "page/window.hpp"

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

void draw_curves(Canvas& canvas, Chart const& chart) {
  double const half = points(curve_width) / 2; // a curve along the frame keeps its full width
  Box const& plot = chart.plot;
  Box const wide{plot.left - half, plot.bottom - half, plot.width + 2 * half, plot.height + 2 * half};
  auto const outside = [&wide](Point p) { return !wide.contains(p); };
  for (auto const& curve : chart.curves) {
    auto line = chart.pixels(curve.points);
    if (curve.pen.dash == Dash::points) { // whole discs, also on the frame
      std::erase_if(line, outside);
      canvas.stroke(line, curve.pen);
      continue;
    }
    canvas.clip(wide);
    canvas.stroke(line, curve.pen);
    canvas.unclip();
  }
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

Picture draw_lines(FigureSpec const& figure, LinesSpec const& lines) {
  auto const chart = make_chart(figure, lines);
  auto const window =
      make_window(static_cast<int>(chart.picture.width), static_cast<int>(chart.picture.height));
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  window->AddRenderer(renderer);
  paint_over(*renderer, [&chart](Canvas& canvas) { draw(canvas, chart); });
  return shoot(*window);
}

} // namespace stiction::postproc
