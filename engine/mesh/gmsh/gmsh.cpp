// Checks a geometry, writes the mesher's request and returns its answer.
#include "mesh/gmsh/gmsh.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "mesh/files/mesh_file.hpp"
#include "mesh/gmsh/mesh_cache.hpp"
#include "mesh/gmsh/outline_polygon.hpp"
#include "mesh/topology/numbers.hpp"
#include "mesh/topology/quality.hpp"

namespace stiction::mesh {

namespace {

using Json = nlohmann::json;
using core::Complaints;

/// Where an edge begins and ends.
struct Ends {
  core::Numbers const& from;
  core::Numbers const& to;
};

double distance(core::Numbers const& a, core::Numbers const& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1]);
}

void check_arc(Complaints& complaints, std::string const& path, Edge const& edge, Ends ends) {
  if (!check_numbers(complaints, {path + ".centre", edge.centre, "m", core::any_number}))
    return;
  double const r0 = distance(edge.centre, ends.from), r1 = distance(edge.centre, ends.to);
  if (std::abs(r0 - r1) > 1e-6 * std::max(r0, r1))
    complaints.push_back({"", path + ".centre",
                          fmt::format("is {:g} m from the start of the arc and {:g} m from its end; the two "
                                      "must be equal",
                                      r0, r1)});
  else if (distance(ends.from, ends.to) > 1.999 * r0)
    complaints.push_back({"", path, "is an arc of half a turn; split it into two"});
}

void check_edge(Complaints& complaints, std::string const& path, Edge const& edge, Ends ends) {
  if (distance(ends.from, ends.to) == 0)
    complaints.push_back({"", path + ".to", "is where the edge starts; an edge needs a length"});
  if (!edge.centre.empty() && !edge.through.empty())
    complaints.push_back({"", path, "has both centre (an arc) and through (a spline); give one of them"});
  else if (!edge.centre.empty())
    check_arc(complaints, path, edge, ends);
  else if (edge.through.size() % 2 != 0)
    complaints.push_back(
        {"", path + ".through",
         fmt::format("has {} numbers; pairs {{x1, y1, x2, y2, ...}} are wanted", edge.through.size())});
}

void check_outline(Complaints& complaints, std::string const& path, Outline const& outline) {
  if (!check_numbers(complaints, {path + ".start", outline.start, "m", core::any_number}))
    return;
  if (outline.edges.size() < 2) {
    complaints.push_back(
        {"", path + ".edges",
         fmt::format("has {} edges; a closed outline needs two or more", outline.edges.size())});
    return;
  }
  core::Numbers from = outline.start;
  double extent = 0;
  for (std::size_t i = 0; i < outline.edges.size(); ++i) {
    Edge const& edge = outline.edges[i];
    std::string const at = fmt::format("{}.edges[{}]", path, i + 1);
    if (!check_numbers(complaints, {at + ".to", edge.to, "m", core::any_number}))
      return;
    check_edge(complaints, at, edge, {from, edge.to});
    extent = std::max(extent, distance(outline.start, edge.to));
    from = edge.to;
  }
  if (distance(from, outline.start) > 1e-9 * extent)
    complaints.push_back({"", path + ".edges",
                          fmt::format("end at {} m, not at the start {} m; the outline must be closed",
                                      core::to_string(from), core::to_string(outline.start))});
}

/// The outer outline, then the holes.
std::vector<Outline> outlines(GmshGeometry const& geometry) {
  std::vector<Outline> all{{geometry.start, geometry.edges}};
  all.insert(all.end(), geometry.holes.begin(), geometry.holes.end());
  return all;
}

std::vector<std::string> names_of(GmshGeometry const& geometry) {
  std::vector<std::string> names;
  for (auto const& outline : outlines(geometry))
    for (auto const& edge : outline.edges)
      if (!edge.name.empty())
        names.push_back(edge.name);
  return names;
}

void check_refinement(Complaints& complaints, std::string const& path, GmshGeometry const& geometry,
                      Refinement const& refinement) {
  auto const names = names_of(geometry);
  if (std::find(names.begin(), names.end(), refinement.near) == names.end()) {
    auto const meant = core::nearest(refinement.near, names);
    complaints.push_back({"", path + ".near",
                          fmt::format("is \"{}\"; no edge has that name{}", refinement.near,
                                      meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant))});
  }
  check_numbers(complaints, {path + ".size", {refinement.size}, "m", {0, geometry.size, true, false}, 1});
  if (!(refinement.until > refinement.within))
    complaints.push_back(
        {"", path + ".beyond",
         fmt::format("is {:g} m; it must be > within = {:g} m", refinement.until, refinement.within)});
}

void check_sizes(Complaints& complaints, GmshGeometry const& geometry) {
  auto const& sizes = geometry.sizes;
  if (sizes.size() % 3 != 0)
    complaints.push_back(
        {"", "gmsh.sizes",
         fmt::format("has {} numbers; {{x1, y1, size1, x2, ...}} are wanted", sizes.size())});
  for (std::size_t i = 2; i < sizes.size(); i += 3)
    if (!(sizes[i] > 0))
      return complaints.push_back(
          {"", "gmsh.sizes", fmt::format("asks for a size of {:g} m; it must be > 0 m", sizes[i])});
}

/// Longest way from the start to a corner of the outer outline, m.
double extent_of(GmshGeometry const& geometry) {
  double extent = 0;
  for (auto const& edge : geometry.edges)
    extent = std::max(extent, distance(geometry.start, edge.to));
  return extent;
}

constexpr double most_cells_across = 2000;

/// Refuses sizes that would keep the mesher busy for hours.
void check_cell_number(Complaints& complaints, GmshGeometry const& geometry) {
  double const extent = extent_of(geometry);
  double finest = geometry.size;
  for (auto const& refinement : geometry.refine)
    finest = std::min(finest, refinement.size);
  for (std::size_t i = 2; i < geometry.sizes.size(); i += 3)
    finest = std::min(finest, geometry.sizes[i]);
  if (finest * most_cells_across < extent)
    complaints.push_back(
        {"", "gmsh.size",
         fmt::format("is {:g} m where smallest; with an extent of {:g} m it must be >= {:g} m", finest,
                     extent, extent / most_cells_across)});
}

/// gmsh takes a hole round the region for its outline, and leaves out one beside it.
void check_holes(Complaints& complaints, GmshGeometry const& geometry) {
  for (std::size_t i = 0; i < geometry.holes.size(); ++i)
    if (auto const corner = outside({geometry.start, geometry.edges}, geometry.holes[i]))
      complaints.push_back(
          {"", fmt::format("gmsh.holes[{}]", i + 1),
           fmt::format("goes through ({:g}, {:g}) m, which is outside of the region; holes lie "
                       "within it: draw what they cut off into the outline",
                       (*corner)[0], (*corner)[1])});
}

void check(GmshGeometry const& geometry) {
  Complaints complaints;
  check_numbers(complaints, {"gmsh.size", {geometry.size}, "m", core::positive, 1});
  check_outline(complaints, "gmsh", {geometry.start, geometry.edges});
  for (std::size_t i = 0; i < geometry.holes.size(); ++i)
    check_outline(complaints, fmt::format("gmsh.holes[{}]", i + 1), geometry.holes[i]);
  if (complaints.empty())
    check_holes(complaints, geometry);
  for (std::size_t i = 0; i < geometry.refine.size(); ++i)
    check_refinement(complaints, fmt::format("gmsh.refine[{}]", i + 1), geometry, geometry.refine[i]);
  check_sizes(complaints, geometry);
  if (complaints.empty())
    check_cell_number(complaints, geometry);
  if (!complaints.empty())
    throw core::InputError(complaints);
}

template<class T> std::vector<T> read_list(core::Reader& reader, std::string_view key, core::Need need) {
  std::vector<T> all;
  for (auto& each : reader.children(key, need))
    all.push_back(each.template record<T>());
  return all;
}

Json to_json(Outline const& outline, double unit) {
  Json edges = Json::array();
  for (auto const& edge : outline.edges)
    edges.push_back({{"to", over(edge.to, unit)},
                     {"centre", over(edge.centre, unit)},
                     {"through", over(edge.through, unit)},
                     {"name", edge.name}});
  return {{"start", over(outline.start, unit)}, {"edges", edges}};
}

/// The geometry with lengths over its extent: gmsh's tolerances are absolute, and so every unit of length
/// gives one mesh.
Json request_for(GmshGeometry const& geometry) {
  double const unit = extent_of(geometry);
  Json curves = Json::array();
  for (auto const& outline : outlines(geometry))
    curves.push_back(to_json(outline, unit));
  Json refine = Json::array();
  for (auto const& r : geometry.refine)
    refine.push_back({{"near", r.near},
                      {"size", over(r.size, unit)},
                      {"within", over(r.within, unit)},
                      {"until", over(r.until, unit)}});
  Json request{{"task", "geometry"},
               {"kind", info(geometry.kind).name},
               {"size", over(geometry.size, unit)},
               {"outlines", curves},
               {"refine", refine},
               {"scale", unit}};
  if (!geometry.sizes.empty()) {
    request["sizes"] = over(geometry.sizes, unit);
    request["growth"] = geometry.growth;
  }
  return request;
}

} // namespace

core::Schema const& Edge::schema() {
  using core::Need;
  static auto const result =
      core::Describe<Edge>("edge",
                           "one edge of an outline, from where the last one ended; straight unless centre or "
                           "through is given")
          .numbers("to", &Edge::to, "m", Need::required, "end {x, y}")
          .numbers("centre", &Edge::centre, "m", Need::optional,
                   "centre {x, y} of an arc of less than half a turn")
          .numbers("through", &Edge::through, "m", Need::optional,
                   "points {x1, y1, x2, y2, ...} of a spline between its ends")
          .text("name", &Edge::name, Need::optional, "the set it belongs to; edges may share one")
          .build();
  return result;
}

core::Schema const& Outline::schema() {
  using core::Need;
  static auto const result = core::Describe<Outline>("outline", "a closed curve")
                                 .numbers("start", &Outline::start, "m", Need::required, "first point {x, y}")
                                 .nested("edges", "edge", Need::required, "list of edges, back to the start")
                                 .build();
  return result;
}

void Outline::read_nested(core::Reader& reader) {
  edges = read_list<Edge>(reader, "edges", core::Need::required);
}

core::Schema const& Refinement::schema() {
  using core::Need;
  static auto const result =
      core::Describe<Refinement>("refinement", "smaller cells near a set")
          .text("near", &Refinement::near, Need::required, "name of edges")
          .number("size", &Refinement::size, "m", core::positive, Need::required, "cell size there")
          .number("within", &Refinement::within, "m", core::non_negative, Need::optional,
                  "distance up to which that size holds")
          .number("beyond", &Refinement::until, "m", core::positive, Need::required,
                  "distance at which the mesh's own size is reached")
          .build();
  return result;
}

core::Schema const& GmshGeometry::schema() {
  using core::Need;
  static auto const result =
      core::Describe<GmshGeometry>("gmsh",
                                   "plane region meshed by gmsh; sets are the names of its edges, and all")
          .number("size", &GmshGeometry::size, "m", core::positive, Need::required, "cell size")
          .choice("kind", &GmshGeometry::kind, cell_choices(2), Need::optional, "kind of cells")
          .numbers("start", &GmshGeometry::start, "m", Need::required, "first point of the outline {x, y}")
          .nested("edges", "edge", Need::required,
                  "list of edges {to=, centre=, through=, name=}, back to the start")
          .nested("holes", "outline", Need::optional, "list of outlines {start=, edges=} cut out")
          .nested("refine", "refinement", Need::optional, "list of {near=, size=, within=, beyond=}")
          .numbers("sizes", &GmshGeometry::sizes, "m", Need::optional,
                   "cells of these sizes at points, {x1, y1, size1, x2, ...}; larger away from them")
          .number("growth", &GmshGeometry::growth, "1", core::positive, Need::optional,
                  "of the cell size over the distance from such a point")
          .build();
  return result;
}

void GmshGeometry::read_nested(core::Reader& reader) {
  edges = read_list<Edge>(reader, "edges", core::Need::required);
  holes = read_list<Outline>(reader, "holes", core::Need::optional);
  refine = read_list<Refinement>(reader, "refine", core::Need::optional);
}

core::Schema const& MshFile::schema() {
  using core::Need;
  static auto const result =
      core::Describe<MshFile>(
          "msh_file",
          "mesh file of gmsh (.msh: sets are its physical groups), Abaqus or CalculiX (.inp: "
          "its surfaces, node and element sets), VTK (.vtu, legacy .vtk: NAME_VALUE of its arrays of "
          "whole numbers), or a closed surface to fill (.stl: sets surface, face_1, ... between "
          "creases); and all")
          .file("path", &MshFile::path, Need::required, "file name, ends in .msh, .inp, .vtu, .vtk or .stl")
          .number("scale", &MshFile::scale, "m", core::positive, Need::optional,
                  "length of the file's unit; default: it is in metres")
          .number("size", &MshFile::size, "m", core::non_negative, Need::optional,
                  "of the tetrahedra that fill an .stl")
          .build();
  return result;
}

void MshFile::read_nested(core::Reader& reader) {
  scaled = reader.has("scale");
}

double smallest_size(GmshGeometry const& geometry) {
  constexpr double beside_rounding = 1 + 1e-9;
  return beside_rounding * extent_of(geometry) / most_cells_across;
}

Mesh gmsh_geometry(GmshGeometry const& geometry) {
  check(geometry);
  Mesh mesh = mesh_for_request(request_for(geometry).dump(1), "gmsh");
  check(mesh, "gmsh");
  return mesh;
}

namespace {

void refuse_unless_readable(MshFile const& file, std::string const& what) {
  auto const& path = file.path;
  bool const stl = path.ends_with(".stl");
  if (!stl && !path.ends_with(".msh") && !path.ends_with(".inp") && !path.ends_with(".vtu") &&
      !path.ends_with(".vtk"))
    throw core::InputError(fmt::format("{}: the name must end in .msh, .inp, .vtu, .vtk or .stl", what));
  if (stl != (file.size > 0))
    throw core::InputError(stl ? fmt::format("{}: give the size of the cells that fill it, size = ...", what)
                               : fmt::format("{}: size is for .stl; the file has its cells", what));
}

} // namespace

Mesh msh_file(MshFile const& file) {
  std::string const what = fmt::format("mesh file {}", file.path);
  refuse_unless_readable(file, what);
  std::ifstream in(file.path, std::ios::binary);
  std::ostringstream content;
  if (!in || !(content << in.rdbuf()))
    throw core::InputError(fmt::format("{}: cannot be read, or is empty", what));
  Json request{{"task", "import"},
               {"path", std::filesystem::absolute(file.path).string()},
               {"content", content_hash(content.str())},
               {"scale", file.scale}};
  if (file.size > 0)
    request["size"] = file.size / file.scale;
  Mesh mesh = mesh_for_request(request.dump(1), what);
  check(mesh, what);
  return mesh;
}

} // namespace stiction::mesh
