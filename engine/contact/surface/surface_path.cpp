// Walking along the section of a surface with a plane; tangent vectors that turn with the normals.
#include "contact/surface/surface_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unsupported/Eigen/AutoDiff>

namespace stiction::contact {

namespace {

/// A side along which the way runs more than across it, up to this sine, is crossed anywhere: where does not
/// matter, and it is left where it is.
constexpr double along_side = 0.03;
/// A foot so near a side, in facets, lies on both facets.
constexpr double shared_side = 1e-9;

template<class T> T inner(Vec3Of<T> const& a, Vec3Of<T> const& b) {
  T sum = a[0] * b[0];
  sum += a[1] * b[1];
  sum += a[2] * b[2];
  return sum;
}
/// a + s b
template<class T> Vec3Of<T> plus(Vec3Of<T> const& a, T const& s, Vec3Of<T> const& b) {
  return {T(a[0] + s * b[0]), T(a[1] + s * b[1]), T(a[2] + s * b[2])};
}
/// A tangent vector at normal `from`, turned as `from` is turned the shortest way to `to`.
template<class T> Vec3Of<T> turned(Vec3Of<T> const& v, Vec3Of<T> const& from, Vec3Of<T> const& to) {
  T const share = T(-inner(to, v) / T(1.0 + inner(from, to)));
  return plus(plus(v, share, from), share, to);
}

/// Between two stations: tangent at the first, their normals, the vector between them.
template<class T> struct Stretch { Vec3Of<T> v, n0, n1, d; };

/// v and the part of d along the surface midway, both turned to the second station.
template<class T> Vec3Of<T> go_on(Stretch<T> const& s) {
  using std::sqrt;
  Vec3Of<T> const sum = plus(s.n0, T(1.0), s.n1);
  T const scale = T(1.0) / T(sqrt(inner(sum, sum)));
  Vec3Of<T> const middle(T(scale * sum[0]), T(scale * sum[1]), T(scale * sum[2]));
  Vec3Of<T> const along = plus(s.d, T(-inner(middle, s.d)), middle);
  return turned(plus(turned(s.v, s.n0, middle), T(1.0), along), middle, s.n1);
}

Stretch<double> between(Vec3 const& v, Station const& a, Station const& b) {
  return {v, a.n, b.n, b.x - a.x};
}

/// Of go_on by v, n0, n1 and d.
Eigen::Matrix<double, 3, 12> derivatives(Stretch<double> const& s) {
  using Dual = Eigen::AutoDiffScalar<Eigen::Matrix<double, 12, 1>>;
  auto const dual = [](Vec3 const& v, int first) -> Vec3Of<Dual> {
    return {Dual(v[0], 12, first), Dual(v[1], 12, first + 1), Dual(v[2], 12, first + 2)};
  };
  auto const end = go_on<Dual>({dual(s.v, 0), dual(s.n0, 3), dual(s.n1, 6), dual(s.d, 9)});
  Eigen::Matrix<double, 3, 12> by;
  for (int c = 0; c < 3; ++c)
    by.row(c) = end[c].derivatives().transpose();
  return by;
}

} // namespace

SurfacePath::SurfacePath(Surface const& surface, Foot from, std::pair<Foot, Vec3> const& to,
                         std::span<double const> x)
    : surface_(&surface), x_(x) {
  auto const start = surface.evaluate(from, x);
  Station const end{surface.position(to.first, x), to.second};
  from_ = start.x;
  chord_ = end.x - start.x;
  plane_ = chord_.cross(start.normal + end.n);
  add({start.x, start.normal});
  if (!walk(from, to.first))
    count_ = 1;
  add(end);
}

/// The side by which the plane leaves a facet, the foremost one but `entry`.
Station SurfacePath::exit(int facet, int entry) const {
  auto const now = surface_->now(facet, x_);
  int const count = surface_->facets()[ix(facet)].count;
  Station best;
  double foremost = 0;
  for (int k = 0; k < count; ++k) {
    auto const i = ix(k), j = ix((k + 1) % count);
    double const here = plane_.dot(now.x[i] - from_), there = plane_.dot(now.x[j] - from_);
    if (k == entry || (here >= 0) == (there >= 0))
      continue;
    double const part = here / (here - there);
    Vec3 const at = (1 - part) * now.x[i] + part * now.x[j];
    double const forward = chord_.dot(at - from_);
    if (best.side >= 0 && forward <= foremost)
      continue;
    foremost = forward;
    best = {at, ((1 - part) * now.normals[i] + part * now.normals[j]).normalized(), facet, k, part};
  }
  return best;
}

/// Two stations in one place where the normal jumps.
void SurfacePath::pass(Station const& crossing) {
  add(crossing);
  auto const& facet = surface_->facets()[ix(crossing.facet)];
  if (!facet.sharp[ix(crossing.side)])
    return;
  int const other = facet.neighbour[ix(crossing.side)], side = facet.across[ix(crossing.side)];
  auto const now = surface_->now(other, x_);
  auto const last = ix((side + 1) % surface_->facets()[ix(other)].count);
  double const part = 1 - crossing.part;
  Vec3 const n = ((1 - part) * now.normals[ix(side)] + part * now.normals[last]).normalized();
  add({crossing.x, n, other, side, part});
}

/// Does a foot lie on this facet, be it on a side or a node that it shares with the foot's own?
bool SurfacePath::holds(int facet, Foot const& foot) const {
  if (facet == foot.segment)
    return true;
  auto const& own = surface_->facets()[ix(foot.segment)];
  auto const& other = surface_->facets()[ix(facet)];
  auto const* end = other.nodes.data() + other.count;
  auto const N = shape(own.count, foot.xi, foot.eta).N;
  for (int k = 0; k < own.count; ++k)
    if (std::abs(N[ix(k)]) > shared_side && std::find(other.nodes.data(), end, own.nodes[ix(k)]) == end)
      return false;
  return true;
}

/// The foremost exit of the facets that hold the start; of side -1 if the end lies on one of them.
Station SurfacePath::first_exit(Foot const& from, Foot const& to) const {
  Station best;
  double foremost = -std::numeric_limits<double>::infinity();
  for (int const f : surface_->around(from.segment)) {
    if (!holds(f, from))
      continue;
    if (holds(f, to))
      return {};
    Station const one = exit(f, -1);
    double const forward =
        one.side < 0 ? -std::numeric_limits<double>::infinity() : chord_.dot(one.x - from_);
    if (forward <= foremost)
      continue;
    foremost = forward;
    best = one;
  }
  return best;
}

/// False if the section does not lead from one foot to the other.
bool SurfacePath::walk(Foot const& from, Foot const& to) {
  Station crossing = first_exit(from, to);
  for (int passed = 0; passed < longest && crossing.side >= 0; ++passed) {
    auto const& facet = surface_->facets()[ix(crossing.facet)];
    int const next = facet.neighbour[ix(crossing.side)];
    if (next < 0 || chord_.dot(crossing.x - from_) > (1 + shared_side) * chord_.squaredNorm())
      return false;
    pass(crossing);
    if (holds(next, to))
      return true;
    crossing = exit(next, facet.across[ix(crossing.side)]);
  }
  return false;
}

Vec3 SurfacePath::slip() const {
  Vec3 v = Vec3::Zero();
  for (int k = 1; k < count_; ++k)
    v = go_on(between(v, stations_[ix(k - 1)], stations_[ix(k)]));
  return v;
}

void SurfacePath::differentiate(Eigen::Matrix<double, 2, 3> const& tangents, Changes& changes) const {
  std::array<Vec3, 2 * longest + 2> v;
  v[0].setZero();
  for (int k = 1; k < count_; ++k)
    v[ix(k)] = go_on(between(v[ix(k - 1)], stations_[ix(k - 1)], stations_[ix(k)]));
  for (int k = 0; k < count_; ++k) {
    changes[ix(k)].by_x.setZero();
    changes[ix(k)].by_n.setZero();
  }
  Eigen::Matrix<double, 2, 3> by_v = tangents;
  for (int k = count_ - 1; k > 0; --k) {
    Eigen::Matrix<double, 2, 12> const by =
        by_v * derivatives(between(v[ix(k - 1)], stations_[ix(k - 1)], stations_[ix(k)]));
    by_v = by.leftCols<3>();
    changes[ix(k - 1)].by_n += by.middleCols<3>(3);
    changes[ix(k)].by_n += by.middleCols<3>(6);
    changes[ix(k - 1)].by_x -= by.rightCols<3>();
    changes[ix(k)].by_x += by.rightCols<3>();
  }
  follow_sides(changes);
}

/// plane . (x - from) = 0 at the crossings, plane = chord x (sum of the ends' normals): what moves a crossing
/// along its side is given over to what the plane depends on.
void SurfacePath::follow_sides(Changes& changes) const {
  auto const& first = stations_[0];
  auto const& last = stations_[ix(count_ - 1)];
  Vec3 const sum = first.n + last.n;
  for (int k = 1; k + 1 < count_; ++k) {
    auto const& at = stations_[ix(k)];
    auto const now = surface_->now(at.facet, x_);
    auto const i = ix(at.side), j = ix((at.side + 1) % surface_->facets()[ix(at.facet)].count);
    Vec3 const along = now.x[j] - now.x[i], mean = (1 - at.part) * now.normals[i] + at.part * now.normals[j];
    double const across = plane_.dot(along);
    if (std::abs(across) < along_side * plane_.norm() * along.norm())
      continue;
    Vec3 const turn = now.normals[j] - now.normals[i];
    Eigen::Vector2d const moved =
        changes[ix(k)].by_x * along + changes[ix(k)].by_n * (turn - at.n * at.n.dot(turn)) / mean.norm();
    Eigen::Vector2d const share = -moved / across;
    Vec3 const r = at.x - first.x, by_chord = sum.cross(r), by_sum = r.cross(chord_);
    changes[ix(k)].by_x += share * plane_.transpose();
    changes[0].by_x -= share * (plane_ + by_chord).transpose();
    changes[ix(count_ - 1)].by_x += share * by_chord.transpose();
    changes[0].by_n += share * by_sum.transpose();
    changes[ix(count_ - 1)].by_n += share * by_sum.transpose();
  }
}

} // namespace stiction::contact
