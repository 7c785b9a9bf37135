// Points on edges, and an even-odd rule with a tolerance.
#include "mesh/gmsh/outline_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace stiction::mesh {

namespace {

constexpr int arc_parts = 64;
constexpr double off_arcs = 1e-3, off_splines = 0.1; // of the extent: polygons stay that near the edges

void add_arc(Edge const& edge, PlanePoint from, std::vector<PlanePoint>& points) {
  double const x = edge.centre[0], y = edge.centre[1];
  double const radius = std::hypot(from[0] - x, from[1] - y);
  double const start = std::atan2(from[1] - y, from[0] - x);
  double const turn =
      std::remainder(std::atan2(edge.to[1] - y, edge.to[0] - x) - start, 2 * std::numbers::pi);
  for (int k = 1; k < arc_parts; ++k) {
    double const angle = start + turn * k / arc_parts;
    points.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
}

double distance(PlanePoint p, PlanePoint a, PlanePoint b) {
  double const dx = b[0] - a[0], dy = b[1] - a[1], length2 = dx * dx + dy * dy;
  double const t =
      length2 > 0 ? std::clamp(((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / length2, 0.0, 1.0) : 0.0;
  return std::hypot(p[0] - a[0] - t * dx, p[1] - a[1] - t * dy);
}

/// How far outside of the polygon, m; 0 inside.
double off(std::vector<PlanePoint> const& polygon, PlanePoint p) {
  bool inside = false;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    auto const &a = polygon[i], &b = polygon[j];
    nearest = std::min(nearest, distance(p, a, b));
    if ((a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      inside = !inside;
  }
  return inside ? 0 : nearest;
}

} // namespace

std::vector<PlanePoint> polygon_of(Outline const& outline) {
  std::vector<PlanePoint> points;
  points.reserve(outline.edges.size() * arc_parts);
  PlanePoint from{outline.start[0], outline.start[1]};
  for (auto const& edge : outline.edges) {
    if (!edge.centre.empty())
      add_arc(edge, from, points);
    for (std::size_t k = 0; k + 1 < edge.through.size(); k += 2)
      points.push_back({edge.through[k], edge.through[k + 1]});
    from = {edge.to[0], edge.to[1]};
    points.push_back(from);
  }
  return points;
}

std::optional<PlanePoint> outside(Outline const& region, Outline const& hole) {
  auto const polygon = polygon_of(region);
  PlanePoint low = polygon.front(), high = low;
  for (auto const& p : polygon)
    for (std::size_t c = 0; c < 2; ++c) {
      low[c] = std::min(low[c], p[c]);
      high[c] = std::max(high[c], p[c]);
    }
  auto const is_spline = [](Edge const& edge) { return !edge.through.empty(); };
  bool const splines =
      std::ranges::any_of(region.edges, is_spline) || std::ranges::any_of(hole.edges, is_spline);
  double const least = (splines ? off_splines : off_arcs) * std::hypot(high[0] - low[0], high[1] - low[1]);
  for (auto const& p : polygon_of(hole))
    if (off(polygon, p) > least)
      return p;
  return {};
}

} // namespace stiction::mesh
