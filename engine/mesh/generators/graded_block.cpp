// The rectangle with a fine zone at its top left.
#include <algorithm>

#include "mesh/generators/generators.hpp"
#include "mesh/generators/lines.hpp"
#include "mesh/generators/quads.hpp"
#include "mesh/topology/numbers.hpp"

namespace stiction::mesh {

namespace {

void check(GradedBlockOptions const& options, Grading const& grading) {
  core::Complaints complaints;
  check_numbers(complaints, {"graded_block.origin", options.origin, "m", core::any_number});
  if (check_numbers(complaints, {"graded_block.size", options.size, "m", core::positive}))
    check_grading(complaints, {"graded_block", options.fine, options.size}, grading);
  if (!complaints.empty())
    throw core::InputError(complaints);
}

} // namespace

core::Schema const& GradedBlockOptions::schema() {
  using core::Need;
  using Options = GradedBlockOptions;
  static auto const result =
      core::Describe<Options>(
          "graded_block", "rectangle with fine cells at the top left, growing to the right and downwards; "
                          "sets left, right, bottom, top, all")
          .numbers("origin", &Options::origin, "m", Need::optional, "lower left corner {x, y}")
          .numbers("size", &Options::size, "m", Need::required, "width and height {x, y}")
          .numbers("fine", &Options::fine, "m", Need::required,
                   "zone of fine cells {width from the left, depth from the top}")
          .number("fine_size", &Options::fine_size, "m", core::positive, Need::required,
                  "cell size in the fine zone")
          .number("coarse_size", &Options::coarse_size, "m", core::positive, Need::required,
                  "largest cell size")
          .number("growth", &Options::growth, "1", {1.05, 2}, Need::optional,
                  "size of a cell over that of the one before outside the fine zone")
          .choice("kind", &Options::kind, cell_choices(2), Need::optional, "kind of cells")
          .build();
  return result;
}

Mesh graded_block(GradedBlockOptions const& options) {
  Grading const grading{options.fine_size, options.coarse_size, options.growth};
  check(options, grading);
  double const x0 = options.origin[0], y0 = options.origin[1], height = options.size[1];
  Lines xs = graded_lines(options.size[0], options.fine[0], grading);
  Lines ys = graded_lines(height, options.fine[1], grading);
  check_cell_count("graded_block", static_cast<double>(xs.size() - 1) * static_cast<double>(ys.size() - 1),
                   most_cells_2d);
  for (double& x : xs)
    x += x0;
  for (double& depth : ys)
    depth = depth == height ? y0 : y0 + height - depth;
  std::reverse(ys.begin(), ys.end());
  return rectangle(xs, ys, options.kind);
}

} // namespace stiction::mesh
