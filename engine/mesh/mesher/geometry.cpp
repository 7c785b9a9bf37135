// From outlines to a meshed model: points, curves, size fields, recombination, order.
#include <algorithm>
#include <array>
#include <cmath>
#include <gmsh.h>
#include <limits>
#include <map>
#include <memory>
#include <utility>

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

/// Points with sizes in square bins, so that those far off and large are not looked at.
class SizesAtPoints {
public:
  SizesAtPoints(std::vector<double> sizes, double growth) : sizes_(std::move(sizes)), growth_(growth) {
    std::array<double, 2> top{-infinite, -infinite};
    each_point([&](std::size_t i) {
      smallest_ = std::min(smallest_, sizes_[i + 2]);
      for (std::size_t c = 0; c < 2; ++c) {
        low_[c] = std::min(low_[c], sizes_[i + c]);
        top[c] = std::max(top[c], sizes_[i + c]);
      }
    });
    double const area = std::max(top[0] - low_[0], 1e-300) * std::max(top[1] - low_[1], 1e-300);
    double const longest = std::max(top[0] - low_[0], top[1] - low_[1]);
    double const points = static_cast<double>(sizes_.size()) / 3;
    width_ = std::max({std::sqrt(area / points), longest / most_bins, 1e-300});
    for (std::size_t c = 0; c < 2; ++c)
      counts_[c] = 1 + static_cast<int>((top[c] - low_[c]) / width_);
    bins_.resize(static_cast<std::size_t>(counts_[0]) * static_cast<std::size_t>(counts_[1]));
    each_point([&](std::size_t i) { bin(place(sizes_[i], 0), place(sizes_[i + 1], 1)).push_back(i); });
  }

  /// The least of `most` and what the points ask for at {x, y}.
  [[nodiscard]] double at(double x, double y, double most) const {
    double least = most;
    int const i = place(x, 0), j = place(y, 1);
    auto const look = [&](int a, int b) {
      if (a >= 0 && b >= 0 && a < counts_[0] && b < counts_[1])
        for (auto const k : bins_[index(a, b)])
          least = std::min(least, sizes_[k + 2] + growth_ * std::hypot(x - sizes_[k], y - sizes_[k + 1]));
    };
    int const rings = std::max(counts_[0], counts_[1]);
    for (int ring = 0; ring < rings && smallest_ + growth_ * width_ * (ring - 1) < least; ++ring)
      for (int a = -ring; a <= ring; ++a)
        for (int b = -ring; b <= ring; b += std::abs(a) == ring ? 1 : std::max(2 * ring, 1))
          look(i + a, j + b);
    return least;
  }

private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double most_bins = 500; ///< along an axis

  template<class Visit> void each_point(Visit const& visit) const {
    for (std::size_t i = 0; i + 2 < sizes_.size(); i += 3)
      visit(i);
  }
  /// Of the bin along an axis, the first or the last for what is beyond.
  [[nodiscard]] int place(double x, std::size_t axis) const {
    return static_cast<int>(std::clamp((x - low_[axis]) / width_, 0.0, counts_[axis] - 1.0));
  }
  [[nodiscard]] std::size_t index(int a, int b) const {
    return static_cast<std::size_t>(a) * static_cast<std::size_t>(counts_[1]) + static_cast<std::size_t>(b);
  }
  std::vector<std::size_t>& bin(int a, int b) { return bins_[index(a, b)]; }

  std::vector<double> sizes_; ///< {x1, y1, size1, x2, ...}
  double growth_ = 0, smallest_ = infinite, width_ = 1;
  std::array<double, 2> low_{infinite, infinite};
  std::array<int, 2> counts_{1, 1};
  std::vector<std::vector<std::size_t>> bins_;
};

/// Sizes at points, growing with the distance from them.
void set_sizes_at_points(Json const& request) {
  if (!request.contains("sizes"))
    return;
  auto const most = request.at("size").get<double>();
  auto const points = std::make_shared<SizesAtPoints const>(request.at("sizes").get<std::vector<double>>(),
                                                            request.at("growth").get<double>());
  gmsh::model::mesh::setSizeCallback(
      [=](int, int, double x, double y, double) { return points->at(x, y, most); });
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
