// First and second derivatives of the closest-point projection onto a curve.
#include "contact/node_to_segment/kinematics.hpp"

#include <cmath>

namespace stiction::contact {

namespace {

/// Over (x, y) of the node and of up to four primary nodes.
using Row = Eigen::Matrix<double, 10, 1>;
using FullBlock = Eigen::Matrix<double, 10, 10>;

/// Everything about the foot that both derivative orders need. D du is the motion of P1 relative to the
/// material point at the foot; D' du the change of the curve's tangent there, D'' of its second derivative.
struct FootFrame {
  Vec2 a, aa, aaa;   // x', x'', x'''
  double length = 0; // |x'|
  Vec2 n, walk;      // outward normal, walking direction
  double gap = 0;
  double bend = 0; // n . x''
  double q = 0;    // |x'|^2 - gap * bend
  Eigen::Matrix<double, 2, 10> D, D1, D2;
  Row xi; // d xi = xi . du
};

Eigen::Matrix<double, 2, 10> relative(Eigen::Vector4d const& N, double own) {
  Eigen::Matrix<double, 2, 10> D = Eigen::Matrix<double, 2, 10>::Zero();
  D(0, 0) = D(1, 1) = own;
  for (int k = 0; k < 4; ++k)
    D(0, 2 + 2 * k) = D(1, 3 + 2 * k) = own > 0 ? -N[k] : N[k];
  return D;
}

FootFrame frame(Curve const& curve, Foot foot, Vec2 const& point, std::span<double const> x) {
  auto const at_foot = curve.evaluate(foot, x).by_xi;
  auto const N = curve.shape(foot);
  FootFrame f;
  f.a = at_foot[1];
  f.aa = at_foot[2];
  f.aaa = at_foot[3];
  f.length = f.a.norm();
  f.walk = f.a / f.length;
  f.n = Vec2(f.walk.y(), -f.walk.x()); // the body lies to the left
  f.gap = f.n.dot(point - at_foot[0]);
  f.bend = f.n.dot(f.aa);
  f.q = f.length * f.length - f.gap * f.bend;
  f.D = relative(N[0], 1);
  f.D1 = relative(N[1], 0);
  f.D2 = relative(N[2], 0);
  f.xi = (f.D.transpose() * f.a + f.gap * f.D1.transpose() * f.n) / f.q;
  return f;
}

Vec2 node_position(std::span<double const> x, Index node) {
  return {x[ix(2 * node)], x[ix(2 * node + 1)]};
}

} // namespace

namespace {

/// At a foot, or not found.
PointKinematics<2> kinematics_at(Curve const& curve, Index node, Foot start, Foot foot,
                                 std::span<double const> x) {
  PointKinematics<2> point;
  Vec2 const p1 = node_position(x, node);
  point.foot = foot;
  if (!point.foot.found())
    return point;
  auto const f = frame(curve, point.foot, p1, x);
  auto const& segment = curve.segments()[ix(point.foot.segment)];
  point.found = true;
  point.gap = f.gap;
  point.frame << f.n, -f.walk;
  point.slip[0] = start.found() ? -curve.path_length(start, point.foot, x) : 0.0;
  point.count = 1 + segment.count;
  point.nodes.assign(segment.nodes.begin(), segment.nodes.begin() + segment.count);
  point.nodes.insert(point.nodes.begin(), node);
  Row const normal = f.D.transpose() * f.n;
  point.H.resize(2, point.unknowns());
  point.H.row(0) = normal.head(point.unknowns()).transpose();
  point.H.row(1) = -f.length * f.xi.head(point.unknowns()).transpose();
  return point;
}

} // namespace

PointKinematics<2> kinematics(Curve const& curve, Index node, Foot start, Foot guess,
                              std::span<double const> x) {
  return kinematics_at(curve, node, start, curve.project(node_position(x, node), guess, x), x);
}

PointKinematics<2> kinematics(Search<2> const& search, Index node, Start const& start, Foot guess,
                              std::span<double const> x) {
  return kinematics_at(search.primary(), node, start.foot,
                       search.project(node, node_position(x, node), guess, x, start.overhang), x);
}

Block<2> geometric_stiffness(Curve const& curve, PointKinematics<2> const& point, std::span<double const> x,
                             Vec2 const& force_nt) {
  int const n = point.unknowns();
  auto const f = frame(curve, point.foot, node_position(x, point.nodes[0]), x);
  Row const turn = f.D1.transpose() * f.n;      // n . D' du
  Row const along = f.D.transpose() * f.walk;   // walk . D du
  Row const normal_turn = turn + f.bend * f.xi; // n . (D' du + x'' d xi)
  // d(n . D du): dn = - walk (n . da) / |x'|, dD = - D' d xi
  FullBlock gap2 = -along * normal_turn.transpose() / f.length - turn * f.xi.transpose();
  if (force_nt[1] == 0)
    return (force_nt[0] * gap2).topLeftCorner(n, n);

  // d(|x'| xi) with xi = (D^T a + g D'^T n) / q; columns are du
  Eigen::Matrix<double, 2, 10> const da = f.D1 + f.aa * f.xi.transpose();
  Eigen::Matrix<double, 2, 10> const dn = -f.walk * normal_turn.transpose() / f.length;
  Row const dl = da.transpose() * f.walk;
  Row const dg = f.D.transpose() * f.n;
  Row const dbend = dn.transpose() * f.aa + (f.D2 + f.aaa * f.xi.transpose()).transpose() * f.n;
  Row const dq = 2 * f.length * dl - f.bend * dg - f.gap * dbend;
  FullBlock dxi = f.D.transpose() * da - f.D1.transpose() * f.a * f.xi.transpose() + turn * dg.transpose() +
                  f.gap * (f.D1.transpose() * dn + f.D2.transpose() * f.n * f.xi.transpose()) -
                  f.xi * dq.transpose();
  dxi /= f.q;
  FullBlock const slip2 = -(f.xi * dl.transpose() + f.length * dxi);
  return (force_nt[0] * gap2 + force_nt[1] * slip2).topLeftCorner(n, n);
}

} // namespace stiction::contact
