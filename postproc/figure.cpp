// Choosing by kind; panels put their parts side by side.
#include "figure.hpp"

#include <cmath>

#include <vtkNew.h>
#include <vtkRenderer.h>

#include "charts/axis.hpp"
#include "charts/lines.hpp"
#include "charts/map.hpp"
#include "fields/field.hpp"
#include "page/window.hpp"

namespace stiction::postproc {

namespace {

double title_height(FigureSpec const& figure) {
  return figure.title.empty() ? 0 : std::round(heading_height(figure.title) + points(edge));
}

/// A strip with the title alone, as wide as the pictures below it.
Picture draw_title(FigureSpec const& figure, int width) {
  int const height = static_cast<int>(title_height(figure));
  auto const window = make_window(width, height);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1, 1, 1);
  window->AddRenderer(renderer);
  Size const size{static_cast<double>(width), static_cast<double>(height)};
  paint_over(*renderer, [&](Canvas& canvas) { draw_heading(canvas, figure.title, size); });
  return shoot(*window);
}

Picture draw_panel(FigureSpec const& figure, PanelSpec const& panel) {
  auto const gap = static_cast<int>(std::lround(points(6)));
  int const width = (figure.width - (panel.columns - 1) * gap) / panel.columns;
  int const rows = (static_cast<int>(panel.figures.size()) + panel.columns - 1) / panel.columns;
  std::vector<Picture> parts;
  for (auto part : panel.figures) {
    part.width = width;
    if (part.height == 0 && figure.height > 0)
      part.height = (figure.height - title_height(figure) - (rows - 1) * gap) / rows;
    part.letter = std::string{'(', static_cast<char>('a' + parts.size() % 26), ')'};
    parts.push_back(draw(part));
  }
  auto const together = tile(parts, panel.columns, gap);
  return figure.title.empty() ? together : tile({draw_title(figure, width_of(together)), together}, 1, 0);
}

} // namespace

Picture draw(FigureSpec const& figure) {
  if (auto const* lines = std::get_if<LinesSpec>(&figure.content))
    return draw_lines(figure, *lines);
  if (auto const* field = std::get_if<FieldSpec>(&figure.content))
    return draw_field(figure, *field);
  if (auto const* map = std::get_if<MapSpec>(&figure.content))
    return draw_map(figure, *map);
  return draw_panel(figure, std::get<PanelSpec>(figure.content));
}

} // namespace stiction::postproc
