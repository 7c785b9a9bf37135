// The closest point of a fixed curve and its derivatives by the position of the point.
#include "contact/obstacle/obstacle_polyline.hpp"

#include <numeric>

#include "core/error.hpp"

namespace stiction::contact {

using core::Need;

namespace {

FixedCurve const& fixed(RigidPolyline const& line) {
  core::expect(line.prepared != nullptr, "the polyline was prepared");
  return *line.prepared;
}

} // namespace

core::Schema const& RigidPolyline::schema() {
  static auto const made =
      core::Describe<RigidPolyline>{"polyline", "rigid profile through points, in the plane", ""}
          .numbers("points", &RigidPolyline::points, "m", Need::required,
                   "{x1, y1, x2, y2, ...}, the solid to the left when walking")
          .flag("closed", &RigidPolyline::closed, "whether the last point is followed by the first")
          .choice("smoothing", &RigidPolyline::smoothing, {"spline", "polyline"}, Need::optional,
                  "how it runs between its points")
          .build();
  return made;
}

std::string unfit(RigidPolyline const& line, int dim, bool /*axisymmetric*/) {
  if (dim == 3)
    return "a polyline is a shape of the plane; in 3D use a surface";
  auto const& p = line.points;
  std::size_t const count = p.size() / 2, least = line.closed ? 3 : 2;
  if (p.size() % 2 != 0)
    return "points has " + std::to_string(p.size()) + " numbers; give an even number, {x1, y1, x2, y2, ...}";
  if (count < least)
    return "points is " + core::to_string(core::Value{p}) + "; give at least " + std::to_string(least) +
           " points";
  for (std::size_t i = 0; i < (line.closed ? count : count - 1); ++i) {
    std::size_t const next = (i + 1) % count;
    if (p[2 * i] == p[2 * next] && p[2 * i + 1] == p[2 * next + 1])
      return "points " + std::to_string(i + 1) + " and " + std::to_string(next + 1) +
             " are the same; leave one out";
  }
  return "";
}

void prepare(RigidPolyline& line) {
  auto const count = static_cast<Index>(line.points.size() / 2);
  Chain chain{Indices(ix(count)), line.closed};
  std::iota(chain.nodes.begin(), chain.nodes.end(), 0);
  Matrix const nodes = Eigen::Map<Matrix const>(line.points.data(), count, 2);
  line.prepared =
      std::make_shared<FixedCurve const>(FixedCurve{line.points, Curve({chain}, nodes, line.smoothing)});
}

Foot foot_2d(RigidPolyline const& line, Vec2 const& x, Foot guess) {
  auto const& [positions, curve] = fixed(line);
  return curve.project(x, guess, positions);
}

double slip_2d(RigidPolyline const& line, Foot from, Foot to) {
  auto const& [positions, curve] = fixed(line);
  return -curve.path_length(from, to, positions); // the tangent points against the walk
}

View2d view_2d(RigidPolyline const& line, Vec2 const& x, Foot foot) {
  auto const& [positions, curve] = fixed(line);
  return view_from(curve.evaluate(foot, positions), x);
}

View2d view_from(CurvePoint const& foot, Vec2 const& x) {
  auto const& [c, a, aa, aaa] = foot.by_xi;
  double const length = a.norm();
  Vec2 const walk = a / length, n = right_of(walk);
  double const gap = n.dot(x - c), bend = n.dot(aa), q = length * length - gap * bend;
  Vec2 const xi = a / q; // d xi = xi . dx
  View2d seen;
  seen.gap = gap;
  seen.normal = n;
  seen.slip_by_x = -length * xi;
  seen.gap_by_xx = -bend / q * walk * walk.transpose();
  // d(a / q) with dq = 2 |a| d|a| - bend dgap - gap dbend; n turns by -walk bend d xi / |a|
  Vec2 const dl = walk.dot(aa) * xi;
  Vec2 const dbend = (n.dot(aaa) - walk.dot(aa) * bend / length) * xi;
  Vec2 const dq = 2 * length * dl - bend * n - gap * dbend;
  Mat<2> const dxi = (aa * xi.transpose() - xi * dq.transpose()) / q;
  seen.slip_by_xx = -(xi * dl.transpose() + length * dxi);
  return seen;
}

} // namespace stiction::contact
