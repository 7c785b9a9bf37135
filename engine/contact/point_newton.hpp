// The contact law of one point against everything else held fixed: x = free + W p with W of the point alone.
#pragma once
#include <Eigen/LU>

#include "contact/problem.hpp"

namespace stiction::contact {

/// Damped semismooth Newton on one point. Returns the force; `free` is the displacement without it.
template<int D>
[[nodiscard]] Local<D> solve_point(Problem const& problem, Index point, Local<D> const& free, Local<D> p,
                                   double rho) {
  LocalMatrix<D> const W = problem.W.block<D, D>(D * point, D * point);
  auto state = evaluate<D>(problem, point, p, free + W * p, rho);
  for (int iteration = 0; iteration < 30; ++iteration) {
    double const norm = state.residual.norm();
    if (norm <= 1e-15 * (p.norm() + rho * free.norm()))
      break;
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
  }
  return p;
}

} // namespace stiction::contact
