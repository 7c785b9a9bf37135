// Gap, slip, rows of H and geometric stiffness of a point against a surface in space.
#include <Eigen/LU>
#include <cmath>
#include <unsupported/Eigen/AutoDiff>

#include "contact/kinematics.hpp"

namespace stiction::contact {

namespace {

/// On an edge this near (in facets) the direction to the point says nothing; the facet's own normal is taken.
constexpr double on_edge = 1e-6;

/// Derivatives by the point (3), the facet's nodes (12) and their nodal normals (12); padded for speed.
using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 28, 1>>;

/// All that the forces of one point depend on.
template<class T> struct Inputs {
  Vec3Of<T> point;
  std::array<Vec3Of<T>, 4> x, normals;
};

template<class T> T dot(Vec3Of<T> const& a, Vec3Of<T> const& b) {
  T sum = a[0] * b[0];
  sum += a[1] * b[1];
  sum += a[2] * b[2];
  return sum;
}
template<class T> Vec3Of<T> cross(Vec3Of<T> const& a, Vec3Of<T> const& b) {
  return {T(a[1] * b[2] - a[2] * b[1]), T(a[2] * b[0] - a[0] * b[2]), T(a[0] * b[1] - a[1] * b[0])};
}
/// sum of scaled vectors
template<class T> Vec3Of<T> sum(T const& u, Vec3Of<T> const& a, T const& v, Vec3Of<T> const& b) {
  return {T(u * a[0] + v * b[0]), T(u * a[1] + v * b[1]), T(u * a[2] + v * b[2])};
}
template<class T> Vec3Of<T> unit(Vec3Of<T> const& a) {
  using std::sqrt;
  T const scale = T(1.0) / T(sqrt(dot(a, a)));
  return {T(a[0] * scale), T(a[1] * scale), T(a[2] * scale)};
}

double value(double x) {
  return x;
}
double value(Dual const& x) {
  return x.value();
}

template<class T> struct Local2 { T xi, eta; };

/// The pairing at one foot.
template<class T> struct Pairing {
  Shape<T> N;
  Vec3Of<T> d, by_xi, by_eta; ///< x1 - x2; tangents of the facet
  Vec3Of<T> n, t1, t2;
  T gap;
};

template<class T> Vec3Of<T> normal_of(Facet const& facet, Inputs<T> const& in, std::array<T, 4> const& N) {
  return unit(combine<T>(N, in.normals, facet.count));
}

/// Normal and gap. In the wedge of an edge the normal points along x1 - x2, outward.
template<class T>
void point_normal(Facet const& facet, Inputs<T> const& in, FootPlace const& kind, Pairing<T>& p) {
  p.n = normal_of(facet, in, p.N.N);
  p.gap = dot(p.n, p.d);
  T const distance2 = dot(p.d, p.d);
  double const size2 = area_vector(facet.reference, facet.count).norm();
  if (kind.kind == FootPlace::face || value(distance2) < on_edge * on_edge * size2)
    return;
  using std::sqrt;
  double const side = value(p.gap) < 0 ? -1 : 1;
  p.gap = T(side * T(sqrt(distance2)));
  T const scale = T(1.0) / p.gap;
  p.n = {T(p.d[0] * scale), T(p.d[1] * scale), T(p.d[2] * scale)};
}

/// t1 is the material direction of the reference, carried along by the facet, in the plane across n.
template<class T> void turn_tangents(Facet const& facet, Pairing<T>& p) {
  Vec3Of<T> const A = combine<T>(p.N.by_xi, facet.reference, facet.count),
                  B = combine<T>(p.N.by_eta, facet.reference, facet.count);
  T const AA = dot(A, A), AB = dot(A, B), BB = dot(B, B);
  T const dA = A[0] * facet.direction[0] + A[1] * facet.direction[1] + A[2] * facet.direction[2];
  T const dB = B[0] * facet.direction[0] + B[1] * facet.direction[1] + B[2] * facet.direction[2];
  Vec3Of<T> const carried =
      sum(T(BB * dA - AB * dB), p.by_xi, T(AA * dB - AB * dA), p.by_eta); // times det > 0
  p.t1 = unit(sum(T(1.0), carried, T(-dot(p.n, carried)), p.n));
  p.t2 = cross(p.n, p.t1);
}

template<class T>
Pairing<T> pair_at(Facet const& facet, Inputs<T> const& in, FootPlace const& kind, Local2<T> const& at) {
  Pairing<T> p;
  p.N = shape<T>(facet.count, at.xi, at.eta);
  p.d = sum(T(1.0), in.point, T(-1.0), combine<T>(p.N.N, in.x, facet.count));
  p.by_xi = combine<T>(p.N.by_xi, in.x, facet.count);
  p.by_eta = combine<T>(p.N.by_eta, in.x, facet.count);
  point_normal(facet, in, kind, p);
  turn_tangents(facet, p);
  return p;
}

/// H^T f on the point and on each node of the facet. A tangential force at a distance makes a moment, which
/// the facet bears by forces along n: c_b with (a_b . t_a) c_b = g f_a.
template<class T> std::array<Vec3Of<T>, 5> nodal_forces(Pairing<T> const& p, int count, Vec3 const& f) {
  Vec3Of<T> const tangential = sum(T(f[1]), p.t1, T(f[2]), p.t2);
  Vec3Of<T> const force = sum(T(f[0]), p.n, T(1.0), tangential);
  T const a1 = dot(p.by_xi, p.t1), a2 = dot(p.by_xi, p.t2), b1 = dot(p.by_eta, p.t1),
          b2 = dot(p.by_eta, p.t2);
  T const scale = p.gap / T(a1 * b2 - b1 * a2);
  T const c1 = scale * T(f[1] * b2 - f[2] * b1), c2 = scale * T(f[2] * a1 - f[1] * a2);
  std::array<Vec3Of<T>, 5> forces;
  forces[0] = force;
  for (std::size_t k = 0; k < ix(count); ++k)
    forces[k + 1] = sum(T(-p.N.N[k]), force, T(c1 * p.N.by_xi[k] + c2 * p.N.by_eta[k]), p.n);
  return forces;
}

Inputs<double> inputs(Surface const& surface, int facet, Index node, std::span<double const> x) {
  auto const now = surface.now(facet, x);
  return {Eigen::Map<Vec3 const>(&x[3 * ix(node)]), now.x, now.normals};
}

Inputs<Dual> with_derivatives(Inputs<double> const& in) {
  auto const dual = [](Vec3 const& v, int first) -> Vec3Of<Dual> {
    return {Dual(v[0], 28, first), Dual(v[1], 28, first + 1), Dual(v[2], 28, first + 2)};
  };
  Inputs<Dual> result;
  result.point = dual(in.point, 0);
  for (int k = 0; k < 4; ++k) {
    result.x[ix(k)] = dual(in.x[ix(k)], 3 + 3 * k);
    result.normals[ix(k)] = dual(in.normals[ix(k)], 15 + 3 * k);
  }
  return result;
}

/// d(x2 + g n) by (xi, eta, g).
Matrix3 pairing_jacobian(Facet const& facet, Inputs<double> const& in, Foot const& foot, double gap) {
  auto const N = shape(facet.count, foot.xi, foot.eta);
  Vec3 const sum = combine<double>(N.N, in.normals, facet.count), n = sum.normalized();
  Matrix3 const across = (Matrix3::Identity() - n * n.transpose()) * (gap / sum.norm());
  Matrix3 J;
  J.col(0) = combine<double>(N.by_xi, in.x, facet.count) +
             across * combine<double>(N.by_xi, in.normals, facet.count);
  J.col(1) = combine<double>(N.by_eta, in.x, facet.count) +
             across * combine<double>(N.by_eta, in.normals, facet.count);
  J.col(2) = n;
  return J;
}

/// The foot with its derivatives: on a facet by one Newton step from where the residual vanishes, on an edge
/// as the foot of the perpendicular.
Local2<Dual> foot_with_derivatives(Facet const& facet, Inputs<Dual> const& in, Foot const& foot,
                                   Matrix3 const& J) {
  auto const kind = FootPlace::of(foot);
  Local2<Dual> at{Dual(foot.xi), Dual(foot.eta)};
  if (kind.kind == FootPlace::vertex)
    return at;
  if (kind.kind == FootPlace::edge) {
    auto const first = ix(kind.side), last = ix((kind.side + 1) % facet.count);
    Vec3Of<Dual> const along = sum(Dual(1.0), in.x[last], Dual(-1.0), in.x[first]);
    Vec3Of<Dual> const d = sum(Dual(1.0), in.point, Dual(-1.0), in.x[first]);
    Dual const part = dot(d, along) / dot(along, along);
    Vec2 const from = node_place(facet.count, kind.side),
               step = node_place(facet.count, (kind.side + 1) % facet.count) - from;
    return {Dual(from.x() + part * step.x()), Dual(from.y() + part * step.y())};
  }
  auto const N = shape<Dual>(facet.count, at.xi, at.eta);
  Vec3Of<Dual> const n = normal_of(facet, in, N.N);
  Vec3Of<Dual> const d = sum(Dual(1.0), in.point, Dual(-1.0), combine<Dual>(N.N, in.x, facet.count));
  Vec3Of<Dual> const rest = sum(Dual(1.0), d, Dual(-value(dot(n, d))), n);
  Matrix3 const inverse = J.inverse();
  at.xi.derivatives() = inverse(0, 0) * rest[0].derivatives() + inverse(0, 1) * rest[1].derivatives() +
                        inverse(0, 2) * rest[2].derivatives();
  at.eta.derivatives() = inverse(1, 0) * rest[0].derivatives() + inverse(1, 1) * rest[1].derivatives() +
                         inverse(1, 2) * rest[2].derivatives();
  return at;
}

PointKinematics<3> kinematics_at(Surface const& surface, Index node, Foot start, Foot foot,
                                 std::span<double const> x) {
  PointKinematics<3> point;
  point.foot = foot;
  point.found = foot.found();
  if (!point.found)
    return point;
  auto const& facet = surface.facets()[ix(foot.segment)];
  auto const in = inputs(surface, foot.segment, node, x);
  auto const pairing = pair_at<double>(facet, in, FootPlace::of(foot), {foot.xi, foot.eta});
  point.gap = pairing.gap;
  point.frame << pairing.n, pairing.t1, pairing.t2;
  if (start.found())
    point.slip = point.frame.rightCols<2>().transpose() * (surface.place(foot, x) - surface.place(start, x));
  auto const stencil = surface.stencil(foot.segment);
  point.count = 1 + static_cast<int>(stencil.size());
  point.nodes.assign(1, node);
  point.nodes.insert(point.nodes.end(), stencil.begin(), stencil.end());
  point.H.setZero(3, point.unknowns());
  for (int row = 0; row < 3; ++row) {
    auto const forces = nodal_forces(pairing, facet.count, Vec3::Unit(row));
    for (int k = 0; k <= facet.count; ++k)
      point.H.block<1, 3>(row, 3 * k) = forces[ix(k)].transpose();
  }
  return point;
}

/// A point whose stiffness is asked for.
struct Asked {
  Surface const& surface;
  PointKinematics<3> const& point;
  std::span<double const> x;
};

/// Adds what the motion of nodes does through nodal normal k; by_normal: [rows, 3].
template<class ByNormal>
void add_by_normal(Asked const& asked, int k, ByNormal const& by_normal, Block<3>& K) {
  auto const& [surface, point, x] = asked;
  auto const fan = surface.fan(surface.facets()[ix(point.foot.segment)].corner[ix(k)]);
  Vec3 area = Vec3::Zero();
  for (int const f : fan)
    area += area_vector(surface.positions(f, x), surface.facets()[ix(f)].count);
  Vec3 const n = area.normalized();
  Eigen::Matrix<double, 15, 3> const by_area =
      by_normal * (Matrix3::Identity() - n * n.transpose()) * (0.5 / area.norm());
  auto const* end = point.nodes.data() + point.count;
  for (int const f : fan) {
    auto const& facet = surface.facets()[ix(f)];
    auto const at = surface.positions(f, x);
    for (int i = 0; i < facet.count; ++i) { // area = 1/2 sum_i x_i x x_{i+1}
      Vec3 const e = at[ix((i + 1) % facet.count)] - at[ix((i + facet.count - 1) % facet.count)];
      Matrix3 turn;
      turn << 0, e.z(), -e.y(), -e.z(), 0, e.x(), e.y(), -e.x(), 0; // dx x e
      auto const column = std::find(point.nodes.data() + 1, end, facet.nodes[ix(i)]) - point.nodes.data();
      K.block<15, 3>(0, 3 * column) += by_area * turn;
    }
  }
}

} // namespace

PointKinematics<3> kinematics(Surface const& surface, Index node, Foot start, Foot guess,
                              std::span<double const> x) {
  Vec3 const p1 = Eigen::Map<Vec3 const>(&x[3 * ix(node)]);
  return kinematics_at(surface, node, start, surface.project(p1, guess, x), x);
}

PointKinematics<3> kinematics(Search<3> const& search, Index node, Foot start, Foot guess,
                              std::span<double const> x) {
  Vec3 const p1 = Eigen::Map<Vec3 const>(&x[3 * ix(node)]);
  return kinematics_at(search.primary(), node, start, search.project(node, p1, guess, x), x);
}

Block<3> geometric_stiffness(Surface const& surface, PointKinematics<3> const& point,
                             std::span<double const> x, Vec3 const& force_ntt) {
  auto const& facet = surface.facets()[ix(point.foot.segment)];
  auto const in = inputs(surface, point.foot.segment, point.nodes[0], x);
  auto const dual = with_derivatives(in);
  auto const at =
      foot_with_derivatives(facet, dual, point.foot, pairing_jacobian(facet, in, point.foot, point.gap));
  auto const forces =
      nodal_forces(pair_at<Dual>(facet, dual, FootPlace::of(point.foot), at), facet.count, force_ntt);
  Eigen::Matrix<double, 15, 28> by_input = Eigen::Matrix<double, 15, 28>::Zero();
  for (int k = 0; k <= facet.count; ++k)
    for (int c = 0; c < 3; ++c)
      by_input.row(3 * k + c) = forces[ix(k)][c].derivatives().transpose();
  int const own = 3 * (1 + facet.count), n = point.unknowns();
  Block<3> K = Block<3>::Zero(n, n);
  K.topLeftCorner(15, own) = by_input.leftCols(own);
  for (int k = 0; k < facet.count; ++k)
    add_by_normal({surface, point, x}, k, by_input.middleCols<3>(15 + 3 * k), K);
  return K;
}

} // namespace stiction::contact
