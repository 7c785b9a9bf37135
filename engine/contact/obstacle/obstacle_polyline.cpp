// The closest point of a fixed curve and its derivatives by the position of the point.
#include "contact/obstacle/obstacle_polyline.hpp"

#include <cmath>
#include <numeric>
#include <optional>

#include "core/error.hpp"

namespace stiction::contact {

using core::Need;

namespace {

FixedCurve const& fixed(RigidPolyline const& line) {
  core::expect(line.prepared != nullptr, "the polyline was prepared");
  return *line.prepared;
}

constexpr double straight = 1e-6; ///< rad, no corner
constexpr double blunt = 1e-3;    ///< of a segment: the least radius of the turn about a corner

/// Where two segments meet, the first one walking in.
struct Corner {
  int in, out;
  Vec2 place, walk_in, walk_out;
  [[nodiscard]] double angle() const { return turn(walk_in, walk_out); } ///< > 0: convex
  /// From a to b, rad.
  static double turn(Vec2 const& a, Vec2 const& b) {
    return std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
};

/// The corner that a foot lies in, if it is the end of two segments.
std::optional<Corner> corner_of(FixedCurve const& line, Foot foot) {
  auto const& segments = line.curve.segments();
  int const in = foot.xi == 1 ? foot.segment : foot.xi == 0 ? segments[ix(foot.segment)].previous : -1;
  int const out = in >= 0 ? segments[ix(in)].next : -1;
  if (out < 0)
    return std::nullopt;
  auto const before = line.curve.evaluate({in, 1}, line.x).by_xi;
  return Corner{in, out, before[0], before[1], line.curve.evaluate({out, 0}, line.x).by_xi[1]};
}

bool in_wedge(Foot foot) {
  return foot.zeta > 0;
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
  auto const& made = fixed(line);
  Foot const foot = made.curve.project(x, {guess.segment, guess.xi}, made.x);
  auto const corner = foot.found() ? corner_of(made, foot) : std::nullopt;
  if (!corner || corner->angle() < straight)
    return foot;
  Vec2 const d = x - corner->place;
  if (d.dot(corner->walk_in) <= 0 || d.dot(corner->walk_out) >= 0)
    return foot;
  return {corner->in, 1, Corner::turn(right_of(corner->walk_in), d), d.norm()};
}

/// What lies between the corners' wedges is the curve; the tangent points against the walk.
double slip_2d(RigidPolyline const& line, Foot from, Foot to) {
  auto const& made = fixed(line);
  if (in_wedge(from) && in_wedge(to) && from.segment == to.segment)
    return -to.zeta * (to.eta - from.eta);
  double const path = made.curve.path_length(from, to, made.x);
  int const next = made.curve.segments()[ix(from.segment)].next;
  bool const ahead =
      path > 0 || (path == 0 && (to.segment == from.segment ? in_wedge(to) : to.segment == next));
  auto const round = [&](Foot foot, bool whole) { // to the side that the walk goes on, or comes from
    return in_wedge(foot) ? foot.zeta * (whole ? corner_of(made, foot)->angle() - foot.eta : -foot.eta) : 0;
  };
  return -(path + round(from, ahead) - round(to, !ahead));
}

View2d view_2d(RigidPolyline const& line, Vec2 const& x, Foot foot) {
  auto const& made = fixed(line);
  auto const at = made.curve.evaluate(foot, made.x);
  Vec2 const d = x - at.by_xi[0];
  if (!in_wedge(foot) || d.isZero(0))
    return view_from(at, x);
  View2d seen;
  seen.gap = d.norm();
  seen.normal = d / seen.gap;
  Vec2 const t = right_of(seen.normal);
  double const radius = std::max(seen.gap, blunt * at.by_xi[1].norm());
  seen.slip_by_x = t;
  seen.gap_by_xx = t * t.transpose() / radius;
  seen.slip_by_xx = -seen.normal * t.transpose() / radius;
  return seen;
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
