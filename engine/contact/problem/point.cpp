// The contact law of one point: its natural map, and its force against everything else held fixed.
#include <Eigen/LU>

#include "contact/problem/problem.hpp"

namespace stiction::contact {

template<int D> Local<D> solve_local(LocalMatrix<D> const& A, Local<D> const& b) {
  return A.fullPivLu().solve(b);
}

template Local<1> solve_local<1>(LocalMatrix<1> const&, Local<1> const&);
template Local<2> solve_local<2>(LocalMatrix<2> const&, Local<2> const&);
template Local<3> solve_local<3>(LocalMatrix<3> const&, Local<3> const&);

template<int D>
PointState<D> evaluate(Problem const& problem, ProblemPoint const& data, Local<D> const& p, Local<D> const& x,
                       double rho) {
  PointState<D> state;
  interface::Coefficient<D> friction {
    data.mu
  };
  double factor = 1;
  Local<D> factor_by_x = Local<D>::Zero();
  state.dry = p;
  if (data.adhesion >= 0) {
    auto const adhesion = interface::adhere<D>(problem.adhesions[ix(data.adhesion)], data.bond, x);
    state.dry -= data.area * adhesion.traction;
    state.adhesion_by_x = data.area * adhesion.traction_by_x;
    factor = adhesion.friction;
    factor_by_x = adhesion.friction_by_x;
  }
  Local<D> v = x - data.shift.head<D>();
  if (data.friction >= 0)
    friction = interface::coefficient<D>(problem.frictions[ix(data.friction)],
                                         {state.dry / data.area, v, data.bond.dt});
  double const mu = state.mu = friction.mu * factor;
  Local<D> const mu_by_x = factor * friction.by_x + friction.mu * factor_by_x;
  double const slip = v.template tail<D - 1>().norm();
  v[0] += mu * slip;
  LocalMatrix<D> v_by_x = LocalMatrix<D>::Identity();
  if (slip > 0)
    v_by_x.row(0).template tail<D - 1>() = mu / slip * v.template tail<D - 1>().transpose();
  v_by_x.row(0) += slip * mu_by_x.transpose();
  auto const projection = interface::project<D>(state.dry - rho * v, mu);
  state.status = projection.status;
  state.residual = state.dry - projection.value;
  state.residual_by_dry = LocalMatrix<D>::Identity() - projection.by_z;
  state.residual_by_x = rho * projection.by_z * v_by_x - projection.by_mu * mu_by_x.transpose();
  if (data.friction >= 0) // z and the cone follow pbar also through mu
    state.residual_by_dry += (rho * slip * projection.by_z.col(0) - projection.by_mu) *
                             (factor / data.area * friction.by_dry).transpose();
  return state;
}

template PointState<1> evaluate(Problem const&, ProblemPoint const&, Local<1> const&, Local<1> const&,
                                double);
template PointState<2> evaluate(Problem const&, ProblemPoint const&, Local<2> const&, Local<2> const&,
                                double);
template PointState<3> evaluate(Problem const&, ProblemPoint const&, Local<3> const&, Local<3> const&,
                                double);

namespace {

/// Damped semismooth Newton on one point from the force p, which becomes the answer. Returns its residual, N.
template<int D>
double improve_point(Problem const& problem, Index point, Local<D> const& free, Local<D>& p, double rho) {
  LocalMatrix<D> const W = problem.W.block<D>(point);
  auto state = evaluate<D>(problem, point, p, free + W * p, rho);
  double norm = state.residual.norm();
  int uphill = 0; // a step or two may leave a kink; more of them lead nowhere
  for (int iteration = 0; iteration < 30 && uphill < 3 && norm > 1e-15 * (p.norm() + rho * free.norm());
       ++iteration) {
    LocalMatrix<D> const J =
        state.residual_by_dry + (state.residual_by_x - state.residual_by_dry * state.adhesion_by_x) * W;
    Local<D> const step = -solve_local<D>(J, state.residual);
    double length = 1;
    Local<D> trial = p + step;
    auto next = evaluate<D>(problem, point, trial, free + W * trial, rho);
    while (!(next.residual.norm() < norm) && length > 1e-3) {
      length *= 0.5;
      trial = p + length * step;
      next = evaluate<D>(problem, point, trial, free + W * trial, rho);
    }
    if (!(next.residual.norm() < norm))
      ++uphill;
    p = trial;
    state = next;
    norm = state.residual.norm();
  }
  return norm;
}

} // namespace

template<int D>
PointAnswer<D> solve_point(Problem const& problem, Index point, Local<D> const& free, Local<D> p,
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
    LocalMatrix<D> const W = problem.W.block<D>(point);
    start_from(-solve_local<D>(W, free - problem.points[ix(point)].shift.head<D>()));
  }
  return {p, done()};
}

template PointAnswer<1> solve_point(Problem const&, Index, Local<1> const&, Local<1>, double);
template PointAnswer<2> solve_point(Problem const&, Index, Local<2> const&, Local<2>, double);
template PointAnswer<3> solve_point(Problem const&, Index, Local<3> const&, Local<3>, double);

} // namespace stiction::contact
