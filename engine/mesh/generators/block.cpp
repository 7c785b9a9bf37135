// The structured rectangle.
#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"
#include "mesh/generators/generators.hpp"
#include "mesh/generators/lines.hpp"
#include "mesh/generators/quads.hpp"
#include "mesh/topology/numbers.hpp"

namespace stiction::mesh {

namespace {

void check(BlockOptions const& options) {
  core::Complaints complaints;
  check_numbers(complaints, {"block.origin", options.origin, "m", core::any_number});
  check_numbers(complaints, {"block.size", options.size, "m", core::positive});
  check_numbers(complaints, {"block.grading", options.grading, "1", {1e-3, 1e3}});
  if (check_numbers(complaints, {"block.cells", options.cells, "1", {1, most_cells_2d}})) {
    if (!core::whole_number(options.cells[0]) || !core::whole_number(options.cells[1]))
      complaints.push_back(
          {"", "block.cells",
           fmt::format("is {}; two whole numbers are wanted", core::to_string(options.cells))});
    else if (options.cells[0] * options.cells[1] > most_cells_2d)
      complaints.push_back({"", "block.cells",
                            fmt::format("makes {:g} cells; at most {:g} are allowed",
                                        options.cells[0] * options.cells[1], most_cells_2d)});
  }
  if (!complaints.empty())
    throw core::InputError(complaints);
}

} // namespace

core::Schema const& BlockOptions::schema() {
  using core::Need;
  static auto const result =
      core::Describe<BlockOptions>("block", "rectangle of nx x ny cells; sets left, right, bottom, top, all")
          .numbers("origin", &BlockOptions::origin, "m", Need::optional, "lower left corner {x, y}")
          .numbers("size", &BlockOptions::size, "m", Need::required, "width and height {x, y}")
          .numbers("cells", &BlockOptions::cells, "1", Need::required, "number of cells {nx, ny}")
          .numbers("grading", &BlockOptions::grading, "1", Need::optional,
                   "size of the last cell over that of the first {x, y}, each in [0.001, 1000]")
          .choice("kind", &BlockOptions::kind, cell_choices(2), Need::optional, "kind of cells")
          .build();
  return result;
}

Mesh block(BlockOptions const& options) {
  check(options);
  auto const nx = static_cast<Index>(std::round(options.cells[0])),
             ny = static_cast<Index>(std::round(options.cells[1]));
  return rectangle(grid_lines(options.origin[0], options.size[0], nx, options.grading[0]),
                   grid_lines(options.origin[1], options.size[1], ny, options.grading[1]), options.kind);
}

} // namespace stiction::mesh
