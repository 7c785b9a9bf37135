// The quarter disc: a bulged square inside, layers below the arc, fine near the pole.
#include <cmath>
#include <numbers>

#include "mesh/generators/butterfly.hpp"
#include "mesh/generators/generators.hpp"
#include "mesh/topology/numbers.hpp"

namespace stiction::mesh {

namespace {

void check(QuarterDiscOptions const& options, Grading const& grading) {
  core::Complaints complaints;
  check_numbers(complaints, {"quarter_disc.centre", options.centre, "m", core::any_number});
  if (check_numbers(complaints, {"quarter_disc.radius", {options.radius}, "m", core::positive, 1}))
    check_grading(complaints, {"quarter_disc", options.fine, {options.radius}}, grading);
  if (!complaints.empty())
    throw core::InputError(complaints);
}

/// The quarter x, y >= 0 about the origin, pole on the y axis.
Quads net(QuarterDiscOptions const& options, Grading const& grading) {
  RoundLines const lines =
      round_lines({options.radius, options.fine[0], options.fine[1], square_reach()}, grading);
  check_cell_count("quarter_disc",
                   static_cast<double>(lines.polar.size()) *
                       static_cast<double>(lines.equator.size() + lines.rings.size()),
                   most_cells_2d);
  return quarter_disc_net(lines.polar, lines.equator, lines.rings);
}

} // namespace

core::Schema const& QuarterDiscOptions::schema() {
  using core::Need;
  using Options = QuarterDiscOptions;
  static auto const result =
      core::Describe<Options>(
          "quarter_disc", "right half of a half disc hanging from its flat side, fine near its pole; sets "
                          "flat, arc, axis, all")
          .numbers("centre", &Options::centre, "m", Need::optional, "middle of the full disc {x, y}")
          .number("radius", &Options::radius, "m", core::positive, Need::required, "radius")
          .numbers("fine", &Options::fine, "m", Need::required,
                   "zone of fine cells {length along the arc from the pole, depth}")
          .number("fine_size", &Options::fine_size, "m", core::positive, Need::required,
                  "cell size in the fine zone")
          .number("coarse_size", &Options::coarse_size, "m", core::positive, Need::required,
                  "largest cell size along the arc and in depth")
          .number("growth", &Options::growth, "1", {1.05, 2}, Need::optional,
                  "size of a cell over that of the one before outside the fine zone")
          .flag("standing", &Options::standing, "flat side down, pole on top")
          .choice("kind", &Options::kind, cell_choices(2), Need::optional, "kind of cells")
          .build();
  return result;
}

Mesh quarter_disc(QuarterDiscOptions const& options) {
  Grading const grading{options.fine_size, options.coarse_size, options.growth};
  check(options, grading);
  double const radius = options.radius, x0 = options.centre[0], y0 = options.centre[1];
  Quads quads = net(options, grading);
  for (auto& [x, y] : quads.nodes) {
    x = x0 + x;
    y = options.standing ? y0 + y : y0 - y;
  }
  for (auto& cell : quads.cells)
    if (!options.standing)
      std::swap(cell[1], cell[3]);
  Position<2> const centre(x0, y0);
  auto const on_arc = [&](auto const& p) { return std::abs((p - centre).norm() - radius) < 1e-9 * radius; };
  Mesh mesh = to_mesh(quads, options.kind, [&](auto const& a, auto const& b) -> Position<2> {
    Position<2> const middle = straight_middle(a, b);
    return on_arc(a) && on_arc(b) ? Position<2>(centre + (middle - centre).normalized() * radius) : middle;
  });
  mesh.sets["arc"] = boundary_where(mesh, on_arc);
  mesh.sets["flat"] = boundary_where(mesh, [&](auto const& p) { return p[1] == y0; });
  mesh.sets["axis"] = boundary_where(mesh, [&](auto const& p) { return p[0] == x0; });
  mesh.sets["all"] = all_nodes(mesh);
  return mesh;
}

} // namespace stiction::mesh
