// Choosing by kind; panels put their parts side by side.
#include "figure.hpp"

#include <cmath>

#include "field.hpp"
#include "lines.hpp"
#include "map.hpp"

namespace stiction::postproc {

namespace {

Picture draw_panel(FigureSpec const& figure, PanelSpec const& panel) {
  auto const gap = static_cast<int>(std::lround(points(6)));
  int const width = (figure.width - (panel.columns - 1) * gap) / panel.columns;
  std::vector<Picture> parts;
  for (auto part : panel.figures) {
    part.width = width;
    part.letter = std::string{'(', static_cast<char>('a' + parts.size() % 26), ')'};
    parts.push_back(draw(part));
  }
  return tile(parts, panel.columns, gap);
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
