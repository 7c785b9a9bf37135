// The structured box.
#include <cmath>
#include <fmt/format.h>

#include "mesh/generators/generators.hpp"
#include "mesh/generators/hexes.hpp"
#include "mesh/topology/numbers.hpp"

namespace stiction::mesh {

namespace {

void check(BoxOptions const& options) {
  core::Complaints complaints;
  check_numbers(complaints, {"box.origin", options.origin, "m", core::any_number, 3});
  check_numbers(complaints, {"box.size", options.size, "m", core::positive, 3});
  check_numbers(complaints, {"box.grading", options.grading, "1", {1e-3, 1e3}, 3});
  if (check_numbers(complaints, {"box.cells", options.cells, "1", {1, most_cells_3d}, 3}))
    for (double const count : options.cells)
      if (!core::whole_number(count)) {
        complaints.push_back(
            {"", "box.cells",
             fmt::format("is {}; three whole numbers are wanted", core::to_string(options.cells))});
        break;
      }
  if (!complaints.empty())
    throw core::InputError(complaints);
  check_cell_count("box.cells", options.cells[0] * options.cells[1] * options.cells[2], most_cells_3d);
}

} // namespace

core::Schema const& BoxOptions::schema() {
  using core::Need;
  static auto const result =
      core::Describe<BoxOptions>(
          "box", "box of nx x ny x nz cells; sets left, right (x), front, back (y), bottom, top (z), all")
          .numbers("origin", &BoxOptions::origin, "m", Need::optional,
                   "corner of least coordinates {x, y, z}")
          .numbers("size", &BoxOptions::size, "m", Need::required, "lengths {x, y, z}")
          .numbers("cells", &BoxOptions::cells, "1", Need::required, "number of cells {nx, ny, nz}")
          .numbers("grading", &BoxOptions::grading, "1", Need::optional,
                   "size of the last cell over that of the first {x, y, z}, each in [0.001, 1000]")
          .choice("kind", &BoxOptions::kind, cell_choices(3), Need::optional,
                  "kind of cells; tetrahedra are six a hexahedron")
          .build();
  return result;
}

Mesh box(BoxOptions const& options) {
  check(options);
  std::array<Lines, 3> lines;
  for (std::size_t d = 0; d < 3; ++d)
    lines[d] = grid_lines(options.origin[d], options.size[d],
                          static_cast<Index>(std::round(options.cells[d])), options.grading[d]);
  Mesh mesh = to_mesh(extrude(grid(lines[0], lines[1]), lines[2]), options.kind);
  constexpr std::array<std::array<char const*, 2>, 3> names{
      {{"left", "right"}, {"front", "back"}, {"bottom", "top"}}};
  for (std::size_t d = 0; d < 3; ++d) {
    auto const axis = static_cast<Eigen::Index>(d);
    mesh.sets[names[d][0]] = boundary_where(mesh, [&](auto const& x) { return x[axis] == lines[d].front(); });
    mesh.sets[names[d][1]] = boundary_where(mesh, [&](auto const& x) { return x[axis] == lines[d].back(); });
  }
  mesh.sets["all"] = all_nodes(mesh);
  return mesh;
}

} // namespace stiction::mesh
