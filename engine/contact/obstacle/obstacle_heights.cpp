// Where a map of heights lies, and what a point sees of it.
#include "contact/obstacle/obstacle_heights.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "contact/obstacle/obstacle_polyline.hpp"
#include "core/error.hpp"
#include "mesh/cells/quadrature.hpp"

namespace stiction::contact {

using core::Need;

namespace {

constexpr int least_points = 4, most_points = 2048; ///< along an axis

FixedHeights const& fixed(RigidHeights const& map) {
  core::expect(map.prepared != nullptr, "the height map was prepared");
  return *map.prepared;
}

/// {x, y} as a vector in space; `fallback` where nothing is given.
Vec3 in_space(core::Numbers const& given, Vec3 fallback) {
  for (std::size_t k = 0; k < given.size(); ++k)
    fallback[static_cast<Eigen::Index>(k)] = given[k];
  return fallback;
}

/// The map's x and y are the axes across the normal, as far as they lie in its plane; where `along` is given
/// they are turned until x follows it.
Mat<3> axes_of(RigidHeights const& map) {
  bool const plane = map.size.size() == 1;
  Vec3 const n =
      in_space(map.normal, map.normal.empty() ? Vec3::Unit(plane ? 1 : 2) : Vec3(Vec3::Zero())).normalized();
  Eigen::Index nearest = 0;
  n.cwiseAbs().maxCoeff(&nearest);
  Vec3 const first = Vec3::Unit(nearest == 0 ? 1 : 0), second = Vec3::Unit(nearest == 2 ? 1 : 2);
  double const hand = n.dot(first.cross(second)) > 0 ? 1 : -1;
  Vec3 const lead = in_space(map.along, map.along.empty() ? first : Vec3(Vec3::Zero()));
  Vec3 const x = (lead - n * n.dot(lead)).normalized();
  Mat<3> axes;
  axes << x, hand * n.cross(x), n;
  return axes;
}

std::string wrong_axis(RigidHeights const& map, int dim) {
  if (map.along.empty())
    return "";
  if (dim == 2)
    return "along is for space; in the plane leave it out";
  if (auto wrong = wrong_direction("along", map.along, dim); !wrong.empty())
    return wrong;
  constexpr double least = 1e-6; // of its length
  Vec3 const n = unit_or_last_axis<3>(map.normal), a = unit_or_last_axis<3>(map.along);
  return (a - n * n.dot(a)).norm() > least ? "" : "along is the normal; give a direction across it";
}

std::string wrong_grid(RigidHeights const& map, int dim) {
  auto const wanted = static_cast<std::size_t>(dim - 1);
  for (auto const& [key, numbers] : {std::pair{"size", &map.size}, {"points", &map.points}})
    if (numbers->size() != wanted)
      return fmt::format("{} has {} numbers; give {}", key, numbers->size(),
                         dim == 2 ? "one, {x}" : "two, {x, y}");
  for (double const length : map.size)
    if (!(length > 0))
      return fmt::format("size has {:g} m; give lengths > 0 m", length);
  for (double const count : map.points)
    if (!(count >= least_points && count <= most_points) || count != std::round(count))
      return fmt::format("points has {:g}; give whole numbers in [{}, {}]", count, least_points, most_points);
  return "";
}

/// Normal of a surface over its map, of any length, and what turns it.
struct Slopes {
  Vec3 sum, by_u, by_v; ///< 1, 1/m, 1/m
};
Slopes slopes_of(HeightJet const& h) {
  return {{-h.u, -h.v, 1}, {-h.uu, -h.uv, 0}, {-h.uv, -h.vv, 0}};
}

/// How the map runs in the plane: against its own walk where that has the solid to the right.
double walk_of(FixedHeights const& map) {
  return map.axes.col(0).head<2>().dot(right_of(map.axes.col(2).head<2>())) > 0 ? -1 : 1;
}

/// Length of the curve between two places of one cell, by Gauss' points.
double length_within(HeightField const& field, double from, double to) {
  static auto const rule = mesh::cube_rule(1, 4);
  double const middle = 0.5 * (from + to), half = 0.5 * (to - from);
  double sum = 0;
  for (Index k = 0; k < rule.weights.size(); ++k)
    sum += rule.weights[k] * std::hypot(1.0, field.at(middle + rule.points(k, 0) * half, 0).u);
  return half * sum;
}

/// From the start of the field's first cell along the surface, m.
double arc_at(RigidHeights const& map, double u) {
  auto const& [field, point, axes, middle, arc] = fixed(map);
  double const step = map.size[0] / map.points[0], place = (u - field.start()) / step;
  double const cells = field.cells();
  bool const periodic = map.boundary == RigidHeights::Rim::periodic;
  double const rounds = periodic ? std::floor(place / cells) : 0;
  double const cell = std::clamp(std::floor(place) - rounds * cells, 0.0, cells - 1);
  return rounds * arc.back() + arc[static_cast<std::size_t>(cell)] +
         length_within(field, field.start() + (cell + rounds * cells) * step, u);
}

/// To the start of each cell of a curve and to its end, m.
std::vector<double> arcs_of(HeightField const& field, double step) {
  std::vector<double> arc{0};
  arc.reserve(ix(field.cells()) + 1);
  for (Index k = 0; k < field.cells(); ++k)
    arc.push_back(arc.back() +
                  length_within(field, field.start() + k * step, field.start() + (k + 1) * step));
  return arc;
}

} // namespace

core::Schema const& RigidHeights::schema() {
  static auto const made =
      core::Describe<RigidHeights>{
          "height_map",
          "rigid half-space whose surface stands back from its plane by heights: rough, measured, or any; "
          "smooth between its points",
          ""}
          .nested("surface", "surface", Need::required,
                  "its heights, as over a half space: peaks, where they are least, touch first")
          .numbers("size", &RigidHeights::size, "m", Need::required,
                   "extent of the map {x, y}, in the plane {x}")
          .numbers("points", &RigidHeights::points, "1", Need::required,
                   "how many heights {x, y}, in the plane {x}: each in the middle of its rectangle")
          .choice("boundary", &RigidHeights::boundary, {"periodic", "free"}, Need::optional,
                  "periodic: repeated for ever; free: nothing past its rim")
          .numbers("point", &RigidHeights::point, "m", Need::optional,
                   "where the middle of the map is, {x, y [, z]}; default the origin")
          .numbers("normal", &RigidHeights::normal, "1", Need::optional,
                   "outward normal {x, y [, z]}, of any length; default the last axis")
          .numbers("along", &RigidHeights::along, "1", Need::optional,
                   "3D: direction of the map's x {x, y, z}; default the first axis across the normal, y the "
                   "second")
          .build();
  return made;
}

std::string unfit(RigidHeights const& map, int dim, bool axisymmetric) {
  if (axisymmetric)
    return "a height map is not the same all around an axis; use a polyline for a profile, or 3D";
  return first_of({wrong_grid(map, dim), wrong_count("point", map.point, dim),
                   wrong_direction("normal", map.normal, dim), wrong_axis(map, dim)});
}

void prepare(RigidHeights& map) {
  auto const count = [&](std::size_t k) {
    return k < map.points.size() ? static_cast<Index>(map.points[k]) : 1;
  };
  auto const length = [&](std::size_t k) { return k < map.size.size() ? map.size[k] : map.size[0]; };
  HeightGrid const grid{count(0), count(1), length(0) / count(0), length(1) / count(1),
                        map.boundary == RigidHeights::Rim::periodic};
  core::expect(map.heights.size() == ix(grid.nx) * ix(grid.ny), "a height map has its heights");
  Vector const outward =
      -Eigen::Map<Vector const>(map.heights.data(), static_cast<Eigen::Index>(map.heights.size()));
  bool const line = map.points.size() == 1;
  HeightField field(grid, outward);
  auto arc = line ? arcs_of(field, grid.dx) : std::vector<double>{};
  map.prepared = std::make_shared<FixedHeights const>(
      FixedHeights{std::move(field), in_space(map.point, Vec3::Zero()), axes_of(map),
                   Vec3(0.5 * length(0), line ? 0 : 0.5 * length(1), 0), std::move(arc)});
}

double sharpest_peak(RigidHeights const& map) {
  auto const& field = fixed(map).field;
  auto const nx = static_cast<Index>(map.points[0]),
             ny = map.points.size() > 1 ? static_cast<Index>(map.points[1]) : Index{1};
  double most = 0; // principal curvature, convex
  for (Index b = 0; b < nx * ny; ++b) {
    Index const row = b / nx;
    double const v = ny > 1 ? (row + 0.5) * map.size[1] / ny : 0;
    auto const h = field.at((b % nx + 0.5) * map.size[0] / nx, v);
    double const s2 = 1 + h.u * h.u + h.v * h.v;
    double const mean =
        -((1 + h.v * h.v) * h.uu - 2 * h.u * h.v * h.uv + (1 + h.u * h.u) * h.vv) / (2 * s2 * std::sqrt(s2));
    double const product = (h.uu * h.vv - h.uv * h.uv) / (s2 * s2);
    most = std::max(most, mean + std::sqrt(std::max(0.0, mean * mean - product)));
  }
  return most > 0 ? 1 / most : std::numeric_limits<double>::infinity();
}

core::Numbers profile(RigidHeights const& map) {
  auto const& fixed_map = fixed(map);
  core::Numbers points;
  points.reserve(2 * map.heights.size());
  double const step = map.size[0] / map.points[0];
  for (std::size_t i = 0; i < map.heights.size(); ++i) {
    double const along = (static_cast<double>(i) + 0.5) * step - fixed_map.middle.x();
    Vec3 const at = fixed_map.point + along * fixed_map.axes.col(0) - map.heights[i] * fixed_map.axes.col(2);
    points.insert(points.end(), {at.x(), at.y()});
  }
  return points;
}

Foot foot_2d(RigidHeights const& map, Vec2 const& x, Foot /*guess*/) {
  auto const& fixed_map = fixed(map);
  auto const nearest = fixed_map.field.nearest(fixed_map.local({x.x(), x.y(), 0}));
  return {nearest.cell, nearest.u};
}

double slip_2d(RigidHeights const& map, Foot from, Foot to) {
  auto const& fixed_map = fixed(map);
  return -walk_of(fixed_map) *
         (arc_at(map, to.xi) - arc_at(map, from.xi)); // the tangent points against the walk
}

View2d view_2d(RigidHeights const& map, Vec2 const& x, Foot foot) {
  auto const& fixed_map = fixed(map);
  auto const h = fixed_map.field.at(foot.xi, 0);
  double const walk = walk_of(fixed_map);
  Vec2 const e = fixed_map.axes.col(0).head<2>(), n = fixed_map.axes.col(2).head<2>();
  Vec2 const place = fixed_map.point.head<2>() + (foot.xi - fixed_map.middle.x()) * e + h.h * n;
  return view_from({{place, walk * (e + h.u * n), h.uu * n, walk * h.uuu * n}}, x);
}

View3d view_3d(RigidHeights const& map, Vec3 const& x, Foot /*guess*/) {
  auto const& [field, point, axes, middle, arc] = fixed(map);
  Vec3 const local = fixed(map).local(x);
  auto const foot = field.nearest(local);
  if (foot.cell < 0)
    return {};
  auto const h = field.at(foot.u, foot.v);
  auto const [sum, by_u, by_v] = slopes_of(h);
  Vec3 const n = sum.normalized();
  double const gap = n.dot(local - Vec3(foot.u, foot.v, h.h));
  Mat<3> const across = (Mat<3>::Identity() - n * n.transpose()) / sum.norm();
  Mat<3> turn = Mat<3>::Zero(), J; // of n and of the point, by (u, v, gap)
  turn.col(0) = across * by_u;
  turn.col(1) = across * by_v;
  J << Vec3(1, 0, h.u), Vec3(0, 1, h.v), n;
  J += gap * turn;
  return {foot.cell, gap, axes * n, axes * turn * J.inverse() * axes.transpose()};
}

} // namespace stiction::contact
