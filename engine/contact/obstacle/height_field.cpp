// Heights between those that were given, and the nearest of them by branch and bound.
#include "contact/obstacle/height_field.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stiction::contact {

namespace {

/// Coefficients of the cubic B-splines that run through `values`, one more at either end than there are
/// values; there are no third differences at the ends.
Vector open_spline(Vector const& values) {
  Eigen::Index const n = values.size();
  Vector c(n + 2), weight(n);
  // (c[i-1] + 4 c[i] + c[i+1]) / 6 = values[i]; at the ends c[0] - c[1] = values[0] - values[1]
  weight[0] = -1;
  c[1] = values[0] - values[1];
  for (Eigen::Index i = 1; i + 1 < n; ++i) {
    weight[i] = 1 / (4 - weight[i - 1]);
    c[i + 1] = (6 * values[i] - c[i]) * weight[i];
  }
  c[n] = (values[n - 1] - values[n - 2] + c[n - 1]) / (1 + weight[n - 2]);
  for (Eigen::Index i = n - 1; i > 0; --i)
    c[i] -= weight[i - 1] * c[i + 1];
  c[0] = 3 * c[1] - 3 * c[2] + c[3];
  c[n + 1] = 3 * c[n] - 3 * c[n - 1] + c[n - 2];
  return c;
}

/// Of every column, with what the cells between the values need beyond their ends: [n + 3 or n + 4, columns].
Dense splines(Dense const& values, bool periodic) {
  constexpr Eigen::Index seen = 40; // an end is felt 3.7^-40 as much so far from it
  Eigen::Index const n = values.rows();
  Dense all(periodic ? n + 3 : n + 4, values.cols());
  for (Eigen::Index k = 0; k < values.cols(); ++k) {
    if (!periodic) {
      Vector const c = open_spline(values.col(k));
      all.col(k) << 3 * c[0] - 3 * c[1] + c[2], c, 3 * c[n + 1] - 3 * c[n] + c[n - 1];
      continue;
    }
    Vector repeated(n + 2 * seen);
    for (Eigen::Index i = 0; i < repeated.size(); ++i)
      repeated[i] = values(((i - seen) % n + n) % n, k);
    all.col(k) = open_spline(repeated).segment(seen, n + 3);
  }
  return all;
}

/// Weights of the four coefficients of a cell and their derivatives, at t in [0, 1].
std::array<Eigen::Vector4d, 4> weights(double t, double length) {
  double const s = 1 - t, a = 1 / length;
  return {Eigen::Vector4d(s * s * s, 4 + 3 * t * t * (t - 2), 4 + 3 * s * s * (s - 2), t * t * t) / 6,
          a * Eigen::Vector4d(-s * s, t * (3 * t - 4), s * (4 - 3 * s), t * t) / 2,
          a * a * Eigen::Vector4d(s, 3 * t - 2, 3 * s - 2, t), a * a * a * Eigen::Vector4d(-1, 3, -3, 1)};
}

/// The cell that a place lies in, and where.
struct Spot {
  Index cell;
  double t;
};
Spot spot(double place, Index cells, bool round) {
  auto const at = std::floor(place);
  if (!round) {
    double const cell = std::clamp(at, 0.0, static_cast<double>(cells - 1));
    return {static_cast<Index>(cell), place - cell};
  }
  auto const cell = static_cast<Index>(at - cells * std::floor(at / cells));
  return {std::min(cell, cells - 1), place - at};
}

/// From a place to the nearest one of a stretch, or of its images, m.
double off(double place, double low, double high, double period) {
  double const middle = place - 0.5 * (low + high);
  double const way = period > 0 ? std::remainder(middle, period) : middle;
  return std::max(0.0, std::abs(way) - 0.5 * (high - low));
}

/// The shift, a multiple of the period, that brings a stretch nearest to a place.
double image(double place, double low, double high, double period) {
  return period > 0 ? period * std::round((place - 0.5 * (low + high)) / period) : 0.0;
}

constexpr double nearly = 1e-4; ///< of a cell: Newton's last steps are no longer

double square(double x) {
  return x * x;
}

} // namespace

HeightField::HeightField(HeightGrid const& grid, Vector const& heights)
    : grid_(grid), nu_(grid.periodic ? grid.nx : grid.nx + 1), round_v_(grid.periodic || grid.ny == 1) {
  nv_ = grid.ny == 1 ? 1 : round_v_ ? grid.ny : grid.ny + 1;
  u0_ = grid.periodic ? 0.5 * grid.dx : -0.5 * grid.dx;
  v0_ = round_v_ ? 0.5 * grid.dy : -0.5 * grid.dy;
  Dense const along = splines(Eigen::Map<Dense const>(heights.data(), grid.nx, grid.ny), grid.periodic);
  if (grid.ny == 1)
    coefficients_ = along.replicate(1, 4);
  else
    coefficients_ = splines(along.transpose(), grid.periodic).transpose();
  make_levels();
}

void HeightField::make_levels() {
  for (Index nx = nu_, ny = nv_; nx > 1 || ny > 1;) {
    nx = (nx + 1) / 2;
    ny = (ny + 1) / 2;
    Level level{nx, ny, {}, {}};
    level.low.reserve(ix(nx) * ix(ny));
    level.high.reserve(ix(nx) * ix(ny));
    for (Index b = 0; b < nx * ny; ++b) {
      auto const [low, high] = bounds_of_four(levels_.size(), 2 * (b % nx), 2 * (b / nx));
      level.low.push_back(low);
      level.high.push_back(high);
    }
    levels_.push_back(std::move(level));
  }
}

/// Of block (i, j), the next ones along u and v, and that across, as far as there are any.
std::pair<double, double> HeightField::bounds_of_four(std::size_t level, Index i, Index j) const {
  Index const wide = level == 0 ? nu_ : levels_[level - 1].nx,
              tall = level == 0 ? nv_ : levels_[level - 1].ny;
  auto [low, high] = bounds(level, i, j);
  for (auto const& [k, l] : {std::pair{i + 1, j}, {i, j + 1}, {i + 1, j + 1}}) {
    if (k >= wide || l >= tall)
      continue;
    auto const [least, most] = bounds(level, k, l);
    low = std::min(low, least);
    high = std::max(high, most);
  }
  return {low, high};
}

/// A cell lies between the least and the largest of its coefficients.
std::pair<double, double> HeightField::bounds(std::size_t level, Index i, Index j) const {
  if (level == 0) {
    auto const own = coefficients_.block<4, 4>(i, j);
    return {own.minCoeff(), own.maxCoeff()};
  }
  auto const& blocks = levels_[level - 1];
  std::size_t const b = ix(j) * ix(blocks.nx) + ix(i);
  return {blocks.low[b], blocks.high[b]};
}

HeightJet HeightField::at(double u, double v) const {
  auto const [i, s] = spot((u - u0_) / grid_.dx, nu_, grid_.periodic);
  auto const [j, t] = spot((v - v0_) / grid_.dy, nv_, round_v_);
  auto const a = weights(s, grid_.dx), b = weights(t, grid_.dy);
  Eigen::Matrix4d const c = coefficients_.block<4, 4>(i, j);
  Eigen::Vector4d const plain = c * b[0], by_v = c * b[1];
  return {a[0].dot(plain), a[1].dot(plain),    a[0].dot(by_v), a[2].dot(plain),
          a[1].dot(by_v),  a[0].dot(c * b[2]), a[3].dot(plain)};
}

double HeightField::distance2(double u, double v, Vec3 const& point) const {
  auto const [i, s] = spot((u - u0_) / grid_.dx, nu_, grid_.periodic);
  auto const [j, t] = spot((v - v0_) / grid_.dy, nv_, round_v_);
  double const h = weights(s, 1)[0].dot(coefficients_.block<4, 4>(i, j) * weights(t, 1)[0]);
  return square(u - point.x()) + square(v - point.y()) + square(h - point.z());
}

/// Half the square of the distance: derivatives by u and v.
HeightField::Slope HeightField::slope(double u, double v, Vec3 const& point) const {
  auto const h = at(u, v);
  double const w = h.h - point.z();
  Slope here;
  here.gradient = {u - point.x() + w * h.u, v - point.y() + w * h.v};
  here.hessian << 1 + h.u * h.u + w * h.uu, h.u * h.v + w * h.uv, h.u * h.v + w * h.uv,
      1 + h.v * h.v + w * h.vv;
  here.convex = here.hessian(0, 0) > 0 && here.hessian.determinant() > 0;
  if (!here.convex) // as if the surface were flat
    here.hessian << 1 + h.u * h.u, h.u * h.v, h.u * h.v, 1 + h.v * h.v;
  return here;
}

/// One of Newton's steps towards the nearest point within `range`; false if it comes no nearer.
bool HeightField::step(Range const& range, Vec3 const& point, Best& best) const {
  auto [g, H, convex] = slope(best.u, best.v, point);
  std::array<bool, 2> const stuck{(best.u <= range.u_low && g[0] > 0) || (best.u >= range.u_high && g[0] < 0),
                                  (best.v <= range.v_low && g[1] > 0) ||
                                      (best.v >= range.v_high && g[1] < 0)};
  for (int const k : {0, 1})
    if (stuck.at(ix(k))) {
      g[k] = H(0, 1) = H(1, 0) = 0;
      H(k, k) = 1;
    }
  Vec2 const way = -(H.inverse() * g);
  constexpr int most_halvings = 30;
  double part = 1;
  for (int k = 0; k < most_halvings; ++k, part /= 2) {
    double const u = std::clamp(best.u + part * way[0], range.u_low, range.u_high);
    double const v = std::clamp(best.v + part * way[1], range.v_low, range.v_high);
    double const there = distance2(u, v, point);
    if (there >= best.distance2)
      continue;
    best = {u, v, there};
    return true;
  }
  return false;
}

HeightField::Block HeightField::block(std::size_t level, Index i, Index j, Vec3 const& point) const {
  Index const size = Index{1} << level;
  auto const edge = [&](double from, double length, Index k, Index cells) {
    return from + length * std::min(k * size, cells);
  };
  auto const [low, high] = bounds(level, i, j);
  double const du = off(point.x(), edge(u0_, grid_.dx, i, nu_), edge(u0_, grid_.dx, i + 1, nu_),
                        grid_.periodic ? nu_ * grid_.dx : 0),
               dv = off(point.y(), edge(v0_, grid_.dy, j, nv_), edge(v0_, grid_.dy, j + 1, nv_),
                        round_v_ ? nv_ * grid_.dy : 0);
  return {level, i, j, square(du) + square(dv) + square(off(point.z(), low, high, 0))};
}

/// The nearest of its parts first, as far as they may hold what is nearer than the best.
void HeightField::look_into(Block const& whole, Vec3 const& point, Best& best) const {
  if (whole.level == 0)
    return look_at_cell(whole.i, whole.j, point, best);
  std::size_t const below = whole.level - 1;
  Index const wide = below == 0 ? nu_ : levels_[below - 1].nx,
              tall = below == 0 ? nv_ : levels_[below - 1].ny;
  std::array<Block, 4> parts;
  std::size_t count = 0;
  for (Index const j : {2 * whole.j, 2 * whole.j + 1})
    for (Index const i : {2 * whole.i, 2 * whole.i + 1})
      if (i < wide && j < tall)
        parts[count++] = block(below, i, j, point);
  std::sort(parts.begin(), parts.begin() + count,
            [](Block const& one, Block const& other) { return one.bound < other.bound; });
  for (std::size_t k = 0; k < count && parts[k].bound < best.distance2; ++k)
    look_into(parts[k], point, best);
}

/// Near enough for Newton's method to go on from.
void HeightField::look_at_cell(Index i, Index j, Vec3 const& point, Best& best) const {
  double const u = u0_ + i * grid_.dx, v = v0_ + j * grid_.dy;
  double const by_u = image(point.x(), u, u + grid_.dx, grid_.periodic ? nu_ * grid_.dx : 0),
               by_v = image(point.y(), v, v + grid_.dy, round_v_ ? nv_ * grid_.dy : 0);
  Range const cell{u + by_u, u + by_u + grid_.dx, v + by_v, v + by_v + grid_.dy};
  Best own{std::clamp(point.x(), cell.u_low, cell.u_high), std::clamp(point.y(), cell.v_low, cell.v_high), 0};
  own.distance2 = distance2(own.u, own.v, point);
  constexpr int steps = 6;
  for (int k = 0; k < steps && step(cell, point, own); ++k) {
  }
  if (own.distance2 < best.distance2)
    best = own;
}

HeightField::Foot HeightField::nearest(Vec3 const& point) const {
  constexpr double far = std::numeric_limits<double>::max();
  Range range{u0_, u0_ + nu_ * grid_.dx, v0_, v0_ + nv_ * grid_.dy};
  if (grid_.periodic)
    range.u_low = -far, range.u_high = far;
  if (round_v_)
    range.v_low = -far, range.v_high = far;
  Best best{std::clamp(point.x(), range.u_low, range.u_high),
            std::clamp(point.y(), range.v_low, range.v_high), 0};
  best.distance2 = distance2(best.u, best.v, point);
  look_into(block(levels_.size(), 0, 0, point), point, best);
  constexpr int most_steps = 50, last_steps = 2;
  for (int k = 0; k < most_steps && step(range, point, best); ++k) {
  }
  bool const past =
      best.u <= range.u_low || best.u >= range.u_high || best.v <= range.v_low || best.v >= range.v_high;
  if (past)
    return {};
  for (int k = 0; k < last_steps; ++k) { // distances no longer tell, their derivatives do
    auto const [g, H, convex] = slope(best.u, best.v, point);
    Vec2 const way = -(H.inverse() * g);
    if (!convex || way.squaredNorm() > square(nearly * (grid_.dx + grid_.dy)))
      break;
    best.u += way[0];
    best.v += way[1];
  }
  auto const i = spot((best.u - u0_) / grid_.dx, nu_, grid_.periodic).cell,
             j = spot((best.v - v0_) / grid_.dy, nv_, round_v_).cell;
  return {j * nu_ + i, best.u, best.v};
}

} // namespace stiction::contact
