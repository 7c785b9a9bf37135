// From outlines to a meshed model: points, curves, size fields, recombination, order.
#include <algorithm>
#include <cmath>
#include <gmsh.h>
#include <map>

#include "core/error.hpp"
#include "mesh/mesher/tasks.hpp"

namespace stiction::mesher {

namespace {

using Json = nlohmann::json;
using Names = std::map<std::string, std::vector<int>>; ///< curves of each name

int add_point(double x, double y) {
  return gmsh::model::geo::addPoint(x, y, 0);
}

/// Adds one edge between two points; returns its curve.
int add_edge(Json const& edge, int from, int to) {
  auto const centre = edge.at("centre").get<std::vector<double>>();
  auto const through = edge.at("through").get<std::vector<double>>();
  if (!centre.empty())
    return gmsh::model::geo::addCircleArc(from, add_point(centre[0], centre[1]), to);
  if (through.empty())
    return gmsh::model::geo::addLine(from, to);
  std::vector<int> points{from};
  for (std::size_t i = 0; i + 1 < through.size(); i += 2)
    points.push_back(add_point(through[i], through[i + 1]));
  points.push_back(to);
  return gmsh::model::geo::addSpline(points);
}

/// Adds a closed outline; returns its loop and notes the curves of each name.
int add_outline(Json const& outline, Names& names) {
  auto const start = outline.at("start").get<std::vector<double>>();
  int const first = add_point(start[0], start[1]);
  int from = first;
  std::vector<int> curves;
  auto const& edges = outline.at("edges");
  for (std::size_t i = 0; i < edges.size(); ++i) {
    auto const end = edges[i].at("to").get<std::vector<double>>();
    int const to = i + 1 == edges.size() ? first : add_point(end[0], end[1]);
    curves.push_back(add_edge(edges[i], from, to));
    if (auto const name = edges[i].at("name").get<std::string>(); !name.empty())
      names[name].push_back(curves.back());
    from = to;
  }
  return gmsh::model::geo::addCurveLoop(curves);
}

/// Sizes at points, growing with the distance from them.
void set_sizes_at_points(Json const& request) {
  if (!request.contains("sizes"))
    return;
  auto const sizes = request.at("sizes").get<std::vector<double>>();
  auto const growth = request.at("growth").get<double>(), most = request.at("size").get<double>();
  gmsh::model::mesh::setSizeCallback([=](int, int, double x, double y, double) {
    double least = most;
    for (std::size_t i = 0; i + 2 < sizes.size(); i += 3)
      least = std::min(least, sizes[i + 2] + growth * std::hypot(x - sizes[i], y - sizes[i + 1]));
    return least;
  });
}

/// Sizes that grow from near named edges, the smallest of all taken.
void set_sizes(Json const& request, Names const& names) {
  namespace field = gmsh::model::mesh::field;
  double const size = request.at("size").get<double>();
  std::vector<double> thresholds;
  for (auto const& refinement : request.at("refine")) {
    int const distance = field::add("Distance");
    auto const& curves = names.at(refinement.at("near").get<std::string>());
    field::setNumbers(distance, "EdgesList", {curves.begin(), curves.end()});
    field::setNumber(distance, "NNodesByEdge", 400);
    int const threshold = field::add("Threshold");
    field::setNumber(threshold, "IField", distance);
    field::setNumber(threshold, "LcMin", refinement.at("size").get<double>());
    field::setNumber(threshold, "LcMax", size);
    field::setNumber(threshold, "DistMin", refinement.at("within").get<double>());
    field::setNumber(threshold, "DistMax", refinement.at("until").get<double>());
    thresholds.push_back(threshold);
  }
  if (!thresholds.empty()) {
    int const least = field::add("Min");
    field::setNumbers(least, "FieldsList", thresholds);
    field::setAsBackgroundMesh(least);
  }
  gmsh::option::setNumber("Mesh.MeshSizeMax", size);
  gmsh::option::setNumber("Mesh.MeshSizeFromPoints", 0);
  gmsh::option::setNumber("Mesh.MeshSizeExtendFromBoundary", 0);
}

} // namespace

void build_geometry(Json const& request) {
  gmsh::model::add("geometry");
  Names names;
  std::vector<int> loops;
  for (auto const& outline : request.at("outlines"))
    loops.push_back(add_outline(outline, names));
  gmsh::model::geo::addPlaneSurface(loops);
  gmsh::model::geo::synchronize();
  for (auto const& [name, curves] : names)
    gmsh::model::setPhysicalName(1, gmsh::model::addPhysicalGroup(1, curves), name);
  set_sizes(request, names);
  set_sizes_at_points(request);

  auto const kind = mesh::kind_named(request.at("kind").get<std::string>());
  core::expect(kind.has_value(), "the engine to ask for a known kind of cells");
  auto const& cell = mesh::info(*kind);
  bool const quads = cell.corners == 4;
  gmsh::option::setNumber("Mesh.Algorithm", 6); // 8 crashes in 4.8.4
  gmsh::option::setNumber("Mesh.RecombineAll", quads ? 1 : 0);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", 3); // full quad: leaves no triangle
  gmsh::option::setNumber("Mesh.SecondOrderIncomplete", quads ? 1 : 0);
  gmsh::model::mesh::generate(2);
  if (cell.nodes > cell.corners)
    gmsh::model::mesh::setOrder(2);
}

} // namespace stiction::mesher
