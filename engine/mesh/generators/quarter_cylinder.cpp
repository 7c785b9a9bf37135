// The quarter cylinder: a quarter disc, fine up to a radius, extruded along lines that are fine at the top.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/generators/butterfly.hpp"
#include "mesh/generators/generators.hpp"
#include "mesh/topology/numbers.hpp"

namespace stiction::mesh {

namespace {

constexpr double ring_thickness = 0.4; // between inner square and first circle over its radius, mean

void check(QuarterCylinderOptions const& options, Grading const& grading) {
  core::Complaints complaints;
  check_numbers(complaints, {"quarter_cylinder.centre", options.centre, "m", core::any_number, 3});
  bool const radius =
      check_numbers(complaints, {"quarter_cylinder.radius", {options.radius}, "m", core::positive, 1});
  bool const height =
      check_numbers(complaints, {"quarter_cylinder.height", {options.height}, "m", core::positive, 1});
  if (radius && height)
    check_grading(complaints, {"quarter_cylinder", options.fine, {options.radius, options.height}}, grading);
  if (complaints.empty() && options.fine[0] < options.fine_size)
    complaints.push_back(
        {"", "quarter_cylinder.fine", "begins with a radius below fine_size; make it larger"});
  if (!complaints.empty())
    throw core::InputError(complaints);
}

/// The quarter disc about the origin, cells of the fine size up to the fine radius, then growing.
Quads disc(QuarterCylinderOptions const& options, Grading const& grading) {
  bool const all_fine = options.fine[0] > options.radius - options.fine_size / 2;
  double const inner = all_fine ? options.radius : options.fine[0];
  auto const cells_of = [&](double length) {
    return static_cast<Index>(std::ceil(length / options.fine_size - 1e-9));
  };
  Index const along = cells_of(std::numbers::pi / 4 * inner);
  Index const layers = cells_of(ring_thickness * inner);
  std::vector<Ring> rings;
  for (Index i = 1; i <= layers; ++i)
    rings.push_back({static_cast<double>(i) / layers, inner});
  if (!all_fine)
    for (double const beyond : graded_lines(options.radius - inner, 0, grading))
      if (beyond > 0)
        rings.push_back({1, inner + beyond});
  rings.back().radius = options.radius;
  Lines const shares = grid_lines(0, 1, along, 1);
  return quarter_disc_net(shares, shares, rings);
}

} // namespace

core::Schema const& QuarterCylinderOptions::schema() {
  using core::Need;
  static auto const result =
      core::Describe<QuarterCylinderOptions>(
          "quarter_cylinder",
          "quarter x, y >= centre of a cylinder along z, fine near the middle of its top; "
          "sets top, bottom, side, symmetry_x, symmetry_y, all")
          .numbers("centre", &QuarterCylinderOptions::centre, "m", Need::optional,
                   "middle of the top {x, y, z}")
          .number("radius", &QuarterCylinderOptions::radius, "m", core::positive, Need::required, "radius")
          .number("height", &QuarterCylinderOptions::height, "m", core::positive, Need::required, "height")
          .numbers("fine", &QuarterCylinderOptions::fine, "m", Need::required,
                   "zone of fine cells {radius, depth from the top}")
          .number("fine_size", &QuarterCylinderOptions::fine_size, "m", core::positive, Need::required,
                  "cell size in the fine zone")
          .number("coarse_size", &QuarterCylinderOptions::coarse_size, "m", core::positive, Need::required,
                  "largest cell size along radius and depth")
          .number("growth", &QuarterCylinderOptions::growth, "1", {1.05, 2}, Need::optional,
                  "size of a cell over that of the one before outside the fine zone")
          .choice("kind", &QuarterCylinderOptions::kind, cell_choices(3), Need::optional,
                  "kind of cells; tetrahedra are six a hexahedron")
          .build();
  return result;
}

Mesh quarter_cylinder(QuarterCylinderOptions const& options) {
  Grading const grading{options.fine_size, options.coarse_size, options.growth};
  check(options, grading);
  Quads const section = disc(options, grading);
  Lines heights = graded_lines(options.height, options.fine[1], grading);
  check_cell_count("quarter_cylinder",
                   static_cast<double>(section.cells.size()) * static_cast<double>(heights.size() - 1),
                   most_cells_3d);
  std::reverse(heights.begin(), heights.end());
  for (double& depth : heights)
    depth = 0.0 - depth;
  Hexes hexes = extrude(section, heights);
  Position<3> const top(options.centre[0], options.centre[1], options.centre[2]);
  for (auto& position : hexes.nodes)
    position += top;
  double const radius = options.radius, bottom = top[2] - options.height;
  auto const on_side = [&](auto const& p) {
    return std::abs(std::hypot(p[0] - top[0], p[1] - top[1]) - radius) < 1e-9 * radius;
  };
  Mesh mesh = to_mesh(hexes, options.kind, [&](Position<3> const& a, Position<3> const& b) {
    Position<3> middle = straight_middle_3d(a, b);
    if (on_side(a) && on_side(b))
      middle.head<2>() = top.head<2>() + (middle.head<2>() - top.head<2>()).normalized() * radius;
    return middle;
  });
  mesh.sets["side"] = boundary_where(mesh, on_side);
  mesh.sets["top"] = boundary_where(mesh, [&](auto const& p) { return p[2] == top[2]; });
  mesh.sets["bottom"] = boundary_where(mesh, [&](auto const& p) { return p[2] == bottom; });
  mesh.sets["symmetry_x"] = boundary_where(mesh, [&](auto const& p) { return p[0] == top[0]; });
  mesh.sets["symmetry_y"] = boundary_where(mesh, [&](auto const& p) { return p[1] == top[1]; });
  mesh.sets["all"] = all_nodes(mesh);
  return mesh;
}

} // namespace stiction::mesh
