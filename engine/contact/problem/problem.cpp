// The judge: the natural-map residual of a contact problem, independent of every solver.
#include "contact/problem/problem.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <limits>

namespace stiction::contact {

namespace {

constexpr double no_motion = 1e-12; // of what else moves: rounding

/// Of a point that nothing can move: the stiffness of its bond, so that no unit is preferred, N/m.
double scale_of_law(Problem const& problem, Index point) {
  auto const& own = problem.points[ix(point)];
  if (own.adhesion < 0)
    return 1;
  auto const scales = interface::scales(problem.adhesions[ix(own.adhesion)]);
  double const stiffness = own.area * scales.strength / scales.opening;
  return stiffness > 0 && std::isfinite(stiffness) ? stiffness : 1;
}

/// Lowest and largest eigenvalue of the symmetric part of a point's block of W, m/N.
std::array<double, 2> range_of_block(Problem const& problem, Index point) {
  if (problem.dim == 1)
    return {problem.W.diagonal(point), problem.W.diagonal(point)};
  if (problem.dim == 2) { // closed form
    auto const block = problem.W.block<2>(point);
    double const mean = 0.5 * (block(0, 0) + block(1, 1)), half = 0.5 * (block(0, 0) - block(1, 1));
    double const away = std::hypot(half, 0.5 * (block(0, 1) + block(1, 0)));
    return {mean - away, mean + away};
  }
  auto const block = problem.W.block<3>(point);
  Eigen::Matrix3d const symmetric = 0.5 * (block + block.transpose());
  auto const values =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
  return {values[0], values[2]};
}

/// Largest entry of W's diagonal, m/N.
double largest_diagonal(Problem const& problem) {
  double largest = 0;
  for (Index row = 0; row < problem.W.rows(); ++row)
    largest = std::max(largest, std::abs(problem.W.diagonal(row)));
  return largest;
}

} // namespace

double natural_scale(Problem const& problem, Index point) {
  auto const [lowest, largest] = range_of_block(problem, point);
  if (largest > no_motion * std::abs(lowest))
    return 1 / largest;
  if (lowest < 0 && -lowest > no_motion * largest_diagonal(problem)) // an unstable body moves against a force
    return -1 / lowest;
  return scale_of_law(problem, point);
}

Vector displacement(Problem const& problem, Vector const& force) {
  Vector x = problem.free;
  problem.W.add_product(force, x);
  return x;
}

namespace {

/// x: where the points are with these forces; both change.
template<int D> void start_open_in(Problem const& problem, Index point, Vector& force, Vector& x) {
  auto const& data = problem.points[ix(point)];
  Local<D> const old = force.segment<D>(D * point), at = x.segment<D>(D * point);
  if (!(at[0] >= data.shift[0])) // one that just touches needs no push either
    return;
  Local<D> own = Local<D>::Zero();
  if (data.adhesion >= 0)
    own = data.area * interface::adhere<D>(problem.adhesions[ix(data.adhesion)], data.bond, at).traction;
  force.segment<D>(D * point) = own;
  problem.W.add_column<D>(point, own - old, x);
}

} // namespace

Vector open_where_given(Problem const& problem, Vector force) {
  Vector x;
  for (Index i = 0; i < problem.size(); ++i) {
    if (problem.W.diagonal(problem.dim * i) != 0) // below zero the body softens, and may be closed
      continue;
    if (x.size() == 0)
      x = displacement(problem, force);
    by_dimension(problem.dim, [&]<int D>() { start_open_in<D>(problem, i, force, x); });
  }
  return force;
}

double Verdict::relative() const {
  if (!std::isfinite(residual) || !std::isfinite(scale))
    return std::numeric_limits<double>::infinity();
  return scale > 0 ? residual / scale : residual;
}

template<int D>
void judge_point(Problem const& problem, ProblemPoint const& data, double rho, PointForces<D> const& at,
                 Verdict& verdict) {
  auto const state = evaluate<D>(problem, data, at.p, at.x, rho);
  double const residual = state.residual.norm();
  // the cone takes rho |x_t| off the pressure and gives it back: what that rounds to, a point that just
  // touches while it slides cannot do without
  double const rounding =
      state.status == interface::Status::open
          ? 0.0
          : 4 * std::numeric_limits<double>::epsilon() * rho * at.x.template tail<D - 1>().norm();
  if (!(residual <= rounding))
    verdict.residual = std::max(verdict.residual, residual / data.area);
  // a separated point far away must not set the yardstick: only pushing free gaps count
  double const pressed = std::max(0.0, data.shift[0] - at.free) * rho / data.area;
  verdict.scale = std::max({verdict.scale, at.p.norm() / data.area, pressed});
}
template void judge_point<1>(Problem const&, ProblemPoint const&, double, PointForces<1> const&, Verdict&);
template void judge_point<2>(Problem const&, ProblemPoint const&, double, PointForces<2> const&, Verdict&);
template void judge_point<3>(Problem const&, ProblemPoint const&, double, PointForces<3> const&, Verdict&);

Verdict judge(Problem const& problem, Vector const& force) {
  return judge(problem, force, displacement(problem, force));
}

Verdict judge(Problem const& problem, Vector const& force, Vector const& x, double lift) {
  if (!x.allFinite() || !force.allFinite())
    return {std::numeric_limits<double>::infinity(), 0};
  Verdict verdict;
  by_dimension(problem.dim, [&]<int D>() {
    for (Index i = 0; i < problem.size(); ++i)
      judge_point<D>(problem, problem.points[ix(i)], natural_scale(problem, i),
                     {force.segment<D>(D * i), x.segment<D>(D * i), problem.free[D * i] + lift}, verdict);
  });
  return verdict;
}

} // namespace stiction::contact
