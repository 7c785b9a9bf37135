// The contact law of one point against everything else held fixed: x = free + W p with W of the point alone.
#pragma once
#include <Eigen/LU>

#include "contact/problem.hpp"

namespace stiction::contact {

/// Damped semismooth Newton on one point from the force p; leaves the better force in p. Returns the
/// residual, N.
template<int D>
[[nodiscard]] double improve_point(Problem const& problem, Index point, Local<D> const& free, Local<D>& p,
                                   double rho) {
  LocalMatrix<D> const W = problem.W.block<D, D>(D * point, D * point);
  auto state = evaluate<D>(problem, point, p, free + W * p, rho);
  double norm = state.residual.norm();
  for (int iteration = 0; iteration < 30 && norm > 1e-15 * (p.norm() + rho * free.norm()); ++iteration) {
    LocalMatrix<D> const J =
        state.residual_by_dry + (state.residual_by_x - state.residual_by_dry * state.adhesion_by_x) * W;
    Local<D> const step = -J.fullPivLu().solve(state.residual);
    double length = 1;
    Local<D> trial = p + step;
    auto next = evaluate<D>(problem, point, trial, free + W * trial, rho);
    while (!(next.residual.norm() < norm) && length > 1e-3) {
      length *= 0.5;
      trial = p + length * step;
      next = evaluate<D>(problem, point, trial, free + W * trial, rho);
    }
    p = trial;
    state = next;
    norm = state.residual.norm();
  }
  return norm;
}

/// The force of one point; `free` is the displacement without it. Where the search from p gets stuck, as at
/// the fold of a snapping bond or past the single answer of friction, it starts again from no force, then
/// from the force that would make the point stick.
template<int D>
[[nodiscard]] Local<D> solve_point(Problem const& problem, Index point, Local<D> const& free, Local<D> p,
                                   double rho) {
  double best = improve_point<D>(problem, point, free, p, rho);
  auto const done = [&] { return best <= 1e-8 * (p.norm() + rho * free.norm()); };
  auto const start_from = [&](Local<D> start) {
    double const residual = improve_point<D>(problem, point, free, start, rho);
    if (!(residual < best))
      return;
    best = residual;
    p = start;
  };
  if (!done())
    start_from(Local<D>::Zero());
  if (!done()) {
    LocalMatrix<D> const W = problem.W.block<D, D>(D * point, D * point);
    start_from(-W.fullPivLu().solve(free - problem.points[ix(point)].shift.head<D>()));
  }
  return p;
}

} // namespace stiction::contact
