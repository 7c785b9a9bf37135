// Laying out the blocks of a map side by side and painting their cells.
#include "charts/map.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include "charts/chart.hpp"

namespace stiction::postproc {

namespace {

constexpr double row_height = 8.6, column_width = 9.4; // points
constexpr double map_space = 3, block_space = 9;       // points
constexpr double letter_size = 6, row_size = 6.2;      // points

/// One line of a block: a group's heading, or a row of cells.
struct Line {
  MapRow const* row = nullptr;
  std::string words;
};

/// Sizes in pixels.
struct Layout {
  Size picture;
  std::vector<std::vector<Line>> blocks;
  double labels = 0, block = 0, head = 0, top = 0, legend = 0;
};

std::vector<std::vector<Line>> split(MapSpec const& map) {
  std::vector<std::vector<Line>> groups;
  for (auto const& row : map.rows) {
    if (groups.empty() || groups.back().front().words != row.group)
      groups.push_back({{nullptr, row.group}});
    groups.back().push_back({&row, row.label});
  }
  std::size_t total = 0;
  for (auto const& group : groups)
    total += group.size();
  std::size_t const most =
      (total + static_cast<std::size_t>(map.blocks) - 1) / static_cast<std::size_t>(map.blocks);
  std::vector<std::vector<Line>> blocks(1);
  for (auto const& group : groups) {
    if (!blocks.back().empty() && blocks.back().size() + group.size() / 2 > most &&
        blocks.size() < static_cast<std::size_t>(map.blocks))
      blocks.emplace_back();
    blocks.back().insert(blocks.back().end(), group.begin(), group.end());
  }
  return blocks;
}

Layout lay_out(FigureSpec const& figure, MapSpec const& map) {
  Layout layout;
  layout.blocks = split(map);
  auto const blocks = static_cast<double>(layout.blocks.size());
  double const around = 2 * points(edge) + (blocks - 1) * points(block_space);
  double const cells = static_cast<double>(map.columns.size()) * points(column_width);
  layout.labels = (figure.width - around) / blocks - cells;
  for (auto const& row : map.rows)
    layout.labels = std::max(layout.labels, measure(row.label, row_size).width + points(map_space));
  layout.block = layout.labels + cells;
  layout.picture.width = std::ceil(around + blocks * layout.block);
  for (auto const& column : map.columns)
    layout.head = std::max(layout.head, measure(column, row_size).width + points(map_space));
  std::size_t lines = 0;
  for (auto const& block : layout.blocks)
    lines = std::max(lines, block.size());
  layout.legend = points(row_height + 2 * map_space);
  double const title = figure.title.empty() ? 0 : line_height(title_size) + points(map_space);
  layout.picture.height = std::round(2 * points(edge) + title + layout.head + layout.legend +
                                     static_cast<double>(lines) * points(row_height));
  layout.top = layout.picture.height - points(edge) - title - layout.head;
  return layout;
}

void draw_cell(Canvas& canvas, Box const& box, char letter, MapSpec const& map) {
  auto const kind = std::find_if(map.kinds.begin(), map.kinds.end(),
                                 [letter](MapKind const& k) { return k.letter[0] == letter; });
  if (kind == map.kinds.end())
    return;
  double const rim = points(0.35);
  canvas.fill({box.left + rim, box.bottom + rim, box.width - 2 * rim, box.height - 2 * rim},
              palette(kind->colour));
  Lettering lettering;
  lettering.size = letter_size;
  lettering.across = Across::centre;
  lettering.along = Along::centre;
  lettering.colour = white;
  canvas.text(kind->letter, {box.left + box.width / 2, box.bottom + box.height / 2}, lettering);
}

void draw_heads(Canvas& canvas, Layout const& layout, double left, MapSpec const& map) {
  Lettering lettering;
  lettering.size = row_size;
  lettering.upright = true;
  lettering.across = Across::left;
  lettering.along = Along::centre;
  double x = left + layout.labels + points(column_width) / 2;
  for (auto const& column : map.columns) {
    canvas.text(column, {x, layout.top + points(map_space)}, lettering);
    x += points(column_width);
  }
}

void draw_block(Canvas& canvas, Layout const& layout, std::size_t number, MapSpec const& map) {
  double const left = points(edge) + static_cast<double>(number) * (layout.block + points(block_space));
  double bottom = layout.top;
  draw_heads(canvas, layout, left, map);
  for (auto const& line : layout.blocks[number]) {
    bottom -= points(row_height);
    Lettering lettering;
    lettering.along = Along::centre;
    lettering.across = line.row == nullptr ? Across::left : Across::right;
    double const room = line.row == nullptr ? layout.block : layout.labels - points(map_space);
    lettering.size = fitting_size(line.words, line.row == nullptr ? tick_size : row_size, room);
    lettering.colour = line.row == nullptr ? ink : mark_grey;
    canvas.text(line.words, {line.row == nullptr ? left : left + room, bottom + points(row_height) / 2},
                lettering);
    if (line.row == nullptr)
      continue;
    Box box{left + layout.labels, bottom, points(column_width), points(row_height)};
    for (char const letter : line.row->cells) {
      draw_cell(canvas, box, letter, map);
      box.left += box.width;
    }
  }
}

void draw_key(Canvas& canvas, MapSpec const& map) {
  double x = points(edge);
  Lettering lettering;
  lettering.along = Along::centre;
  for (auto const& kind : map.kinds) {
    Box const box{x, points(edge), points(column_width), points(row_height)};
    draw_cell(canvas, box, kind.letter[0], map);
    canvas.text(kind.label, {box.right() + points(map_space), box.bottom + box.height / 2}, lettering);
    x = box.right() + measure(kind.label, lettering.size).width + points(4 * map_space);
  }
}

} // namespace

Drawing draw_map(FigureSpec const& figure, MapSpec const& map) {
  auto const layout = std::make_shared<Layout const>(lay_out(figure, map));
  auto const paint = [layout, &figure, &map](Canvas& canvas) {
    for (std::size_t block = 0; block < layout->blocks.size(); ++block)
      draw_block(canvas, *layout, block, map);
    draw_key(canvas, map);
    draw_heading(canvas, heading(figure), layout->picture);
  };
  return {layout->picture, paint, {}};
}

} // namespace stiction::postproc
