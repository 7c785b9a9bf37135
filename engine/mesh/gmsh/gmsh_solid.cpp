// Checks a solid, asks the mesher for it about the origin in units of its size, and moves it into place.
#include "mesh/gmsh/gmsh_solid.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "mesh/generators/lines.hpp"
#include "mesh/gmsh/mesh_cache.hpp"
#include "mesh/topology/numbers.hpp"
#include "mesh/topology/quality.hpp"

namespace stiction::mesh {

namespace {

constexpr double most_tetrahedra = 5e6;

std::vector<std::string> const& shapes() {
  static std::vector<std::string> const names{"box", "cylinder", "ball", "half_ball"};
  return names;
}

std::size_t extents_of(SolidShape shape) {
  return shape == SolidShape::box ? 3 : shape == SolidShape::cylinder ? 2 : 1;
}

core::Numbers near_of(GmshSolid const& solid) {
  if (!solid.near.empty())
    return solid.near;
  auto near = solid.at;
  if (solid.shape == SolidShape::half_ball)
    near[2] -= solid.extent[0];
  return near;
}

void check_fine(core::Complaints& complaints, GmshSolid const& solid) {
  check_numbers(complaints,
                {"gmsh_solid.fine_size", {solid.fine_size}, "m", {0, solid.size, true, false}, 1});
  if (!solid.near.empty())
    check_numbers(complaints, {"gmsh_solid.near", solid.near, "m", core::any_number, 3});
  if (!(solid.until > solid.within))
    complaints.push_back({"", "gmsh_solid.beyond",
                          fmt::format("is {:g} m; it must be > within = {:g} m", solid.until, solid.within)});
}

/// Tetrahedra of a space filled evenly have about a ninth of the cube of their size.
double cells_about(GmshSolid const& solid) {
  double const least = *std::min_element(solid.extent.begin(), solid.extent.end());
  double volume = 8 * std::pow(solid.extent[0], 3);
  if (solid.shape == SolidShape::box)
    volume = solid.extent[0] * solid.extent[1] * solid.extent[2];
  else if (solid.shape == SolidShape::cylinder)
    volume = 4 * solid.extent[0] * solid.extent[0] * solid.extent[1];
  double const fine = solid.fine_size > 0 ? solid.fine_size : solid.size;
  double const zone = std::min(volume, std::pow(std::min(2 * solid.within, 2 * least), 3));
  return 9 * (volume / std::pow(solid.size, 3) + zone / std::pow(fine, 3)) / (solid.quarter ? 4 : 1);
}

void check(GmshSolid const& solid) {
  core::Complaints complaints;
  check_numbers(complaints, {"gmsh_solid.at", solid.at, "m", core::any_number, 3});
  check_numbers(complaints, {"gmsh_solid.size", {solid.size}, "m", core::positive, 1});
  check_numbers(complaints,
                {"gmsh_solid.extent", solid.extent, "m", core::positive, extents_of(solid.shape)});
  if (complaints.empty() && solid.fine_size != 0)
    check_fine(complaints, solid);
  if (!complaints.empty())
    throw core::InputError(complaints);
  check_cell_count("gmsh_solid", cells_about(solid), most_tetrahedra);
}

/// The solid about the origin, lengths over `unit`.
nlohmann::json request_for(GmshSolid const& solid, double unit) {
  auto near = near_of(solid);
  for (std::size_t i = 0; i < 3; ++i)
    near[i] -= solid.at[i];
  bool const fine = solid.fine_size > 0;
  return {{"task", "solid"},
          {"shape", shapes()[static_cast<std::size_t>(solid.shape)]},
          {"extent", over(solid.extent, unit)},
          {"quarter", solid.quarter},
          {"size", over(solid.size, unit)},
          {"fine_size", over(fine ? solid.fine_size : solid.size, unit)},
          {"near", over(near, unit)},
          {"within", fine ? over(solid.within, unit) : 0.0},
          {"until", fine ? over(solid.until, unit) : 1.0},
          {"kind", info(solid.kind).name},
          {"scale", unit}};
}

} // namespace

core::Schema const& GmshSolid::schema() {
  using core::Need;
  static auto const result =
      core::Describe<GmshSolid>(
          "gmsh_solid", "box, cylinder, ball or half ball meshed with tetrahedra by gmsh; sets as the "
                        "names of its faces, symmetry_x, symmetry_y, all")
          .choice("shape", &GmshSolid::shape, shapes(), Need::required, "what it is")
          .numbers("extent", &GmshSolid::extent, "m", Need::required,
                   "of the whole: box {x, y, z}, cylinder {radius, height}, balls {radius}")
          .numbers("at", &GmshSolid::at, "m", Need::optional,
                   "middle of the top, of a ball its centre {x, y, z}")
          .flag("quarter", &GmshSolid::quarter, "only the part x, y >= at")
          .number("size", &GmshSolid::size, "m", core::positive, Need::required, "cell size")
          .number("fine_size", &GmshSolid::fine_size, "m", core::non_negative, Need::optional,
                  "cell size near a point; 0 for one size everywhere")
          .numbers("near", &GmshSolid::near, "m", Need::optional,
                   "that point {x, y, z}; the middle of the top, of a half ball its pole, when not given")
          .number("within", &GmshSolid::within, "m", core::non_negative, Need::optional,
                  "distance up to which fine_size holds")
          .number("beyond", &GmshSolid::until, "m", core::non_negative, Need::optional,
                  "distance at which size is reached")
          .choice("kind", &GmshSolid::kind, core::Choices<CellKind>{CellKind::tet4, {"tet4", "tet10"}},
                  Need::optional, "kind of cells")
          .build();
  return result;
}

Mesh gmsh_solid(GmshSolid const& solid) {
  check(solid);
  double const unit = *std::max_element(solid.extent.begin(), solid.extent.end());
  Mesh mesh = mesh_for_request(request_for(solid, unit).dump(1), "gmsh_solid");
  mesh.nodes.rowwise() += Eigen::RowVector3d(solid.at[0], solid.at[1], solid.at[2]);
  check(mesh, "gmsh_solid");
  return mesh;
}

} // namespace stiction::mesh
