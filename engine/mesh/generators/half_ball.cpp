// The half ball: eighths with a bulged cube inside and layers below the cap, fine near the pole.
#include <cmath>

#include "mesh/generators/butterfly.hpp"
#include "mesh/generators/generators.hpp"
#include "mesh/topology/numbers.hpp"

namespace stiction::mesh {

namespace {

void check(HalfBallOptions const& options, Grading const& grading) {
  core::Complaints complaints;
  check_numbers(complaints, {"half_ball.centre", options.centre, "m", core::any_number, 3});
  if (check_numbers(complaints, {"half_ball.radius", {options.radius}, "m", core::positive, 1}))
    check_grading(complaints, {"half_ball", options.fine, {options.radius}}, grading);
  if (!complaints.empty())
    throw core::InputError(complaints);
}

/// The wanted part about the origin, pole on the positive z axis.
Hexes standing(HalfBallOptions const& options, Grading const& grading) {
  RoundLines const lines =
      round_lines({options.radius, options.fine[0], options.fine[1], cube_reach()}, grading);
  auto const polar = static_cast<double>(lines.polar.size()), rings = static_cast<double>(lines.rings.size()),
             equator = static_cast<double>(lines.equator.size());
  int const eighths = options.part == Part::quarter ? 1 : options.part == Part::half ? 2 : 4;
  check_cell_count("half_ball", eighths * polar * (polar * (equator + rings) + 2 * equator * rings),
                   most_cells_3d);
  Hexes hexes = eighth_ball_net({lines.polar, lines.polar, lines.equator}, lines.rings);
  if (options.part != Part::quarter)
    hexes = doubled(hexes, 0);
  return options.part == Part::full ? doubled(hexes, 1) : hexes;
}

} // namespace

core::Schema const& HalfBallOptions::schema() {
  using core::Need;
  static auto const result =
      core::Describe<HalfBallOptions>(
          "half_ball", "half ball hanging from its flat side, fine near its pole; sets flat, cap, all "
                       "and where it is cut symmetry_x, symmetry_y")
          .numbers("centre", &HalfBallOptions::centre, "m", Need::optional, "centre of the ball {x, y, z}")
          .number("radius", &HalfBallOptions::radius, "m", core::positive, Need::required, "radius")
          .numbers("fine", &HalfBallOptions::fine, "m", Need::required,
                   "zone of fine cells {length along the cap from the pole, depth}")
          .number("fine_size", &HalfBallOptions::fine_size, "m", core::positive, Need::required,
                  "cell size in the fine zone")
          .number("coarse_size", &HalfBallOptions::coarse_size, "m", core::positive, Need::required,
                  "largest cell size along the cap and in depth")
          .number("growth", &HalfBallOptions::growth, "1", {1.05, 2}, Need::optional,
                  "size of a cell over that of the one before outside the fine zone")
          .choice("part", &HalfBallOptions::part, {"quarter", "half", "full"}, Need::optional,
                  "quarter x, y >= centre, half y >= centre, or full")
          .flag("standing", &HalfBallOptions::standing, "flat side down, pole on top")
          .choice("kind", &HalfBallOptions::kind, cell_choices(3), Need::optional,
                  "kind of cells; tetrahedra are six a hexahedron")
          .build();
  return result;
}

Mesh half_ball(HalfBallOptions const& options) {
  Grading const grading{options.fine_size, options.coarse_size, options.growth};
  check(options, grading);
  Hexes hexes = standing(options, grading);
  if (!options.standing)
    hexes = reflected(std::move(hexes), 2);
  Position<3> const centre(options.centre[0], options.centre[1], options.centre[2]);
  for (auto& position : hexes.nodes)
    position += centre;
  double const radius = options.radius;
  auto const on_cap = [&](auto const& p) { return std::abs((p - centre).norm() - radius) < 1e-9 * radius; };
  Mesh mesh = to_mesh(hexes, options.kind, [&](Position<3> const& a, Position<3> const& b) {
    Position<3> const middle = straight_middle_3d(a, b);
    return on_cap(a) && on_cap(b) ? Position<3>(centre + (middle - centre).normalized() * radius) : middle;
  });
  mesh.sets["cap"] = boundary_where(mesh, on_cap);
  mesh.sets["flat"] = boundary_where(mesh, [&](auto const& p) { return p[2] == centre[2]; });
  if (options.part == Part::quarter)
    mesh.sets["symmetry_x"] = boundary_where(mesh, [&](auto const& p) { return p[0] == centre[0]; });
  if (options.part != Part::full)
    mesh.sets["symmetry_y"] = boundary_where(mesh, [&](auto const& p) { return p[1] == centre[1]; });
  mesh.sets["all"] = all_nodes(mesh);
  return mesh;
}

} // namespace stiction::mesh
