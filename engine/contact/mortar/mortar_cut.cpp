// Projection of primary corners on the reference domain of a secondary facet, clipping there, and quadrature.
#include "contact/mortar/mortar_cut.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace stiction::contact {

namespace {

/// Parts of a reference domain smaller than this are left out.
constexpr double sliver = 1e-12;

/// A secondary facet and its averaged normals at its corners.
template<int D> struct Ground {
  CellFacet const& facet;
  FacetNodes<D> nodes;
  FacetNodes<D> normals = FacetNodes<D>::Zero(); ///< of the corners
  FacetKind flat;                                ///< of the hats

  Ground(Faced<D> const& faced, int number)
      : facet(faced.secondary.facet(number)), nodes(faced.secondary.template positions<D>(number, faced.x)),
        flat(linear_kind(facet.kind)) {
    for (int k = 0; k < facet.corners(); ++k)
      normals.col(k) = faced.normals.unit[ix(facet.fan[ix(k)])];
  }

  /// The point whose ray goes through `point`: one linear step from the middle, then, where that converges,
  /// exactly; both are the same for all facets with this corner.
  [[nodiscard]] Vec2 project(Vec<D> const& point) const {
    Vec2 at = middle_coordinates(facet.kind);
    double distance = 0;
    step(point, at, distance);
    Vec2 const guess = at;
    double const rounding =
        0.01 * rounding_step(point.cwiseAbs().maxCoeff(), (nodes.col(1) - nodes.col(0)).norm());
    for (int iteration = 0; iteration < 12; ++iteration)
      if (step(point, at, distance) < rounding)
        return (at - guess).norm() < 0.5 * (1 + guess.norm()) ? at : guess;
    return guess;
  }

private:
  /// Newton's method for x1(at) + distance normals(at) = point; its step.
  double step(Vec<D> const& point, Vec2& at, double& distance) const {
    auto const shape = facet_shape(facet.kind, at), hats = facet_shape(flat, at);
    Mat<D> J;
    for (int a = 0; a < D - 1; ++a)
      J.col(a) = nodes * shape.by[ix(a)] + distance * normals * hats.by[ix(a)];
    J.col(D - 1) = normals * hats.N;
    Vec<D> const move = J.inverse() * (point - nodes * shape.N - distance * J.col(D - 1));
    double const size = move.template head<D - 1>().norm();
    if (!std::isfinite(size))
      return size;
    at.template head<D - 1>() += move.template head<D - 1>();
    distance += move[D - 1];
    return size;
  }
};

double cross(Vec2 const& a, Vec2 const& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// Positive if counter-clockwise; of an interval its length.
double signed_area(std::vector<Vec2> const& polygon) {
  if (polygon.size() == 2)
    return polygon[1].x() - polygon[0].x();
  double area = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    area += 0.5 * cross(polygon[k], polygon[(k + 1) % polygon.size()]);
  return area;
}

Vec2 middle(std::vector<Vec2> const& polygon) {
  Vec2 sum = Vec2::Zero();
  for (auto const& corner : polygon)
    sum += corner / static_cast<double>(polygon.size());
  return sum;
}

bool contains(std::vector<Vec2> const& polygon, Vec2 const& point) {
  if (polygon.size() == 2)
    return polygon[0].x() < point.x() && point.x() < polygon[1].x();
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if (cross(polygon[(k + 1) % polygon.size()] - polygon[k], point - polygon[k]) <= 0)
      return false;
  return true;
}

/// The part of a facet's domain that faces one primary facet.
struct Part {
  int primary = 0;
  std::vector<Vec2> polygon;
  double gap = 0; ///< in its middle, m
};

/// Part of the domain that faces a primary facet; no polygon if there is none.
template<int D> Part facing_part(Faced<D> const& faced, int number, Ground<D> const& ground, int primary) {
  auto const& other = faced.primary.facet(primary);
  auto const nodes = faced.primary.template positions<D>(primary, faced.x);
  Part part{primary, {}, 0};
  for (int k = other.corners() - 1; k >= 0; --k) // facing surfaces run against each other
    part.polygon.push_back(ground.project(nodes.col(k)));
  part.polygon =
      signed_area(part.polygon) > 0 ? clip_to_domain(ground.facet.kind, part.polygon) : std::vector<Vec2>{};
  if (part.polygon.empty())
    return part;
  auto const ray = ray_of(faced, make_sample(faced.secondary, number, middle(part.polygon), 1, false));
  Vec2 at = middle_coordinates(other.kind);
  if (!meet_facet<D>(other.kind, nodes, ray, at, part.gap))
    part.polygon.clear();
  return part;
}

/// Without corners that rounding alone makes, so that a part and its mirror image have as many.
std::vector<Vec2> without_flat_corners(std::vector<Vec2> const& polygon) {
  std::vector<Vec2> apart, kept;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    if ((polygon[(k + 1) % polygon.size()] - polygon[k]).norm() > sliver)
      apart.push_back(polygon[k]);
  for (std::size_t k = 0, n = apart.size(); k < n; ++k)
    if (std::abs(cross(apart[k] - apart[(k + n - 1) % n], apart[(k + 1) % n] - apart[k])) > sliver)
      kept.push_back(apart[k]);
  return kept;
}

/// Of the area, so that corners that come up close to each other do not move it.
Vec2 centroid(std::vector<Vec2> const& polygon) {
  Vec2 sum = Vec2::Zero();
  double area = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    double const part = 0.5 * cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
    sum += part / 3 * (polygon[0] + polygon[k] + polygon[k + 1]);
    area += part;
  }
  return sum / area;
}

/// `fine`: so that the nodal forces of uniform tractions are exact for quadratic facets too. Polygons fall
/// into triangles about their middle: mirrored surfaces have mirrored points, and what these weigh changes
/// steadily as corners come and go.
void add_points(Part const& part, bool fine, std::vector<CutPoint>& points) {
  auto const& rule = facet_rule(part.polygon.size() == 2 ? 2 : 3, fine);
  if (part.polygon.size() == 2) {
    Vec2 const centre = middle(part.polygon), half = 0.5 * (part.polygon[1] - part.polygon[0]);
    for (std::size_t q = 0; q < rule.points.size(); ++q)
      points.push_back({centre + rule.points[q].x() * half, rule.weights[q] * half.x(), part.primary});
    return;
  }
  auto const polygon = without_flat_corners(part.polygon);
  Vec2 const centre = centroid(polygon);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    Vec2 const u = polygon[k] - centre, v = polygon[(k + 1) % polygon.size()] - centre;
    for (std::size_t q = 0; q < rule.points.size(); ++q)
      points.push_back({centre + rule.points[q].x() * u + rule.points[q].y() * v,
                        rule.weights[q] * cross(u, v), part.primary});
  }
}

} // namespace

std::vector<Vec2> clip_to_domain(FacetKind kind, std::vector<Vec2> polygon) {
  bool const interval = polygon.size() == 2;
  for (int side = 0; side < corner_count(kind); ++side) { // Sutherland and Hodgman 1974
    std::vector<Vec2> kept;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      Vec2 const &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
      double const here = inside_of(kind, side, from), there = inside_of(kind, side, to);
      if (here >= 0)
        kept.push_back(from);
      if ((here < 0) != (there < 0) && !(interval && k == 1))
        kept.push_back(from + here / (here - there) * (to - from));
    }
    polygon = std::move(kept);
  }
  bool const whole = interval ? polygon.size() == 2 : polygon.size() > 2;
  return whole && signed_area(polygon) > sliver ? polygon : std::vector<Vec2>{};
}

template<int D>
std::vector<CutPoint> cut_facet(Faced<D> const& faced, int facet, std::vector<int> const& candidates,
                                GapRange range) {
  Ground<D> const ground(faced, facet);
  std::vector<Part> parts;
  for (int const primary : candidates)
    if (auto part = facing_part(faced, facet, ground, primary);
        !part.polygon.empty() && range.holds(part.gap))
      parts.push_back(std::move(part));
  std::stable_sort(parts.begin(), parts.end(),
                   [](Part const& a, Part const& b) { return std::abs(a.gap) < std::abs(b.gap); });
  std::vector<CutPoint> points;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    auto const before = parts.begin() + static_cast<std::ptrdiff_t>(k);
    Vec2 const centre = middle(parts[k].polygon);
    if (std::any_of(parts.begin(), before,
                    [&](Part const& part) { return contains(part.polygon, centre); })) {
      parts[k].polygon = {Vec2(0, 0), Vec2(0, 0)}; // hidden
      continue;
    }
    auto const kind = faced.primary.facet(parts[k].primary).kind;
    bool const quadratic = ground.flat != ground.facet.kind || linear_kind(kind) != kind;
    add_points(parts[k], quadratic, points);
  }
  return points;
}

template std::vector<CutPoint> cut_facet(Faced<2> const&, int, std::vector<int> const&, GapRange);
template std::vector<CutPoint> cut_facet(Faced<3> const&, int, std::vector<int> const&, GapRange);

} // namespace stiction::contact
