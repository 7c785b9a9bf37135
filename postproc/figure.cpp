// Choosing by kind; panels put their parts side by side.
#include "figure.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "charts/axis.hpp"
#include "charts/lines.hpp"
#include "charts/map.hpp"
#include "fields/field.hpp"
#include "fields/field_data.hpp"

namespace stiction::postproc {

namespace {

double title_height(FigureSpec const& figure) {
  return figure.title.empty() ? 0 : std::round(heading_height(figure.title) + points(edge));
}

/// A strip with the title alone, as wide as the pictures below it.
Drawing draw_title(FigureSpec const& figure, double width) {
  Size const size{width, title_height(figure)};
  return {size, [&figure, size](Canvas& canvas) { draw_heading(canvas, figure.title, size); }, {}};
}

void widen(double& margin, double other) {
  margin = std::max(margin, other);
}

/// Plots of a panel get the same room around them: left and right all of them, below and above those of a
/// row.
void align(std::vector<FigureSpec>& parts, int columns) {
  Margins across;
  std::vector<Margins> rows(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto const* lines = std::get_if<LinesSpec>(&parts[i].content);
    if (lines == nullptr)
      continue;
    auto const margins = margins_of(parts[i], *lines);
    auto& row = rows[i / static_cast<std::size_t>(columns)];
    widen(across.left, margins.left);
    widen(across.right, margins.right);
    widen(row.bottom, margins.bottom);
    widen(row.top, margins.top);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto const& row = rows[i / static_cast<std::size_t>(columns)];
    parts[i].margins = {across.left, across.right, row.bottom, row.top};
  }
}

/// The field of a part that leaves its range open, null if it is none.
FieldSpec* open_field(FigureSpec& part) {
  auto* field = std::get_if<FieldSpec>(&part.content);
  return field != nullptr && !field->range ? field : nullptr;
}

/// Gives the fields of one array and unit that leave their range open the one which holds the values of all.
void share_ranges(std::vector<FigureSpec>& parts) {
  auto const key = [](FieldSpec const& field) {
    return std::tuple(field.array, field.component.value_or(-1), field.unit.word);
  };
  std::map<decltype(key(FieldSpec{})), std::pair<double, double>> ranges;
  for (auto& part : parts)
    if (auto const* field = open_field(part)) {
      auto const data = load_field(*field);
      auto& [low, high] = ranges.try_emplace(key(*field), data.low, data.high).first->second;
      low = std::min(low, data.low);
      high = std::max(high, data.high);
    }
  for (auto& part : parts)
    if (auto* field = open_field(part)) {
      auto const& [low, high] = ranges.at(key(*field));
      field->range = colour_range(low, high);
    }
}

Drawing draw_panel(FigureSpec const& figure, PanelSpec const& panel) {
  auto const gap = static_cast<int>(std::lround(points(6)));
  int const width = (figure.width - (panel.columns - 1) * gap) / panel.columns;
  int const rows = (static_cast<int>(panel.figures.size()) + panel.columns - 1) / panel.columns;
  auto parts = panel.figures;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    auto& part = parts[i];
    part.width = width;
    part.dpi = figure.dpi;
    if (part.height == 0 && figure.height > 0)
      part.height = (figure.height - title_height(figure) - (rows - 1) * gap) / rows;
    part.letter = std::string{'(', static_cast<char>('a' + i % 26), ')'};
  }
  align(parts, panel.columns);
  if (panel.common_range)
    share_ranges(parts);
  std::vector<Drawing> drawings;
  drawings.reserve(parts.size());
  for (auto const& part : parts)
    drawings.push_back(draw(part));
  auto together = tile(std::move(drawings), panel.columns, gap);
  if (figure.title.empty())
    return together;
  std::vector<Drawing> stack{draw_title(figure, together.size.width)};
  stack.push_back(std::move(together));
  return tile(std::move(stack), 1, 0);
}

Drawing draw_kind(FigureSpec const& figure) {
  if (auto const* lines = std::get_if<LinesSpec>(&figure.content))
    return draw_lines(figure, *lines);
  if (auto const* field = std::get_if<FieldSpec>(&figure.content))
    return draw_field(figure, *field);
  if (auto const* map = std::get_if<MapSpec>(&figure.content))
    return draw_map(figure, *map);
  return draw_panel(figure, std::get<PanelSpec>(figure.content));
}

} // namespace

Drawing draw(FigureSpec const& figure) {
  auto const kept = std::make_shared<FigureSpec const>(figure); // drawings refer to it until they are painted
  auto drawing = draw_kind(*kept);
  if (drawing.paint)
    drawing.paint = [kept, paint = std::move(drawing.paint)](Canvas& canvas) { paint(canvas); };
  for (auto& [at, part] : drawing.parts)
    if (part.paint)
      part.paint = [kept, paint = std::move(part.paint)](Canvas& canvas) { paint(canvas); };
  return drawing;
}

} // namespace stiction::postproc
