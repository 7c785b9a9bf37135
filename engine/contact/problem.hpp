// The contact problem as data: any solver answers it, one residual judges the answer.
#pragma once
#include <vector>

#include "core/types.hpp"
#include "interface/law.hpp"

namespace stiction::contact {

using interface::Local;
using interface::LocalMatrix;

/// One contact point of a Problem.
struct ProblemPoint {
  double area = 1;          ///< tributary reference area A, m^2 (m in plane strain)
  double mu = 0;            ///< friction coefficient
  int law = -1;             ///< index into Problem::adhesions; -1: dry
  interface::BondStep bond; ///< bond used only with a law
  int friction = -1;        ///< index into Problem::frictions; -1: the coefficient is mu
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< (n, t1, t2), m: the cone sees x - shift, the bond x
};

/// Find forces p with x = free + W p and pbar = p - A rtilde(x) such that pbar = Proj(pbar - rho (y_n + mu
/// |y_t|, y_t)), y = x - shift. Components contact by contact, (n [, t1 [, t2]]).
struct Problem {
  int dim = 2;                      ///< components per contact: 1 (nothing acts along the surface), 2 or 3
  Dense W;                          ///< Delassus operator, [dim n, dim n], m/N
  Vector free;                      ///< gap and slip at zero contact force, [dim n], m
  std::vector<ProblemPoint> points; ///< [n]
  std::vector<interface::AdhesionLaw> adhesions;
  std::vector<interface::FrictionLaw> frictions{}; ///< those whose coefficient follows pressure or speed
  Vector start{}; ///< x at the last accepted state, [dim n], m, to tell answers apart; or empty
  [[nodiscard]] Index size() const { return static_cast<Index>(points.size()); }
};

/// The law at one point for the total force p at displacement x.
template<int D> struct PointState {
  Local<D> dry = Local<D>::Zero();                       ///< pbar, N
  LocalMatrix<D> adhesion_by_x = LocalMatrix<D>::Zero(); ///< d(A rtilde)/dx, N/m
  Local<D> residual = Local<D>::Zero();                  ///< pbar - Proj(...), N
  LocalMatrix<D> residual_by_dry = LocalMatrix<D>::Zero(), residual_by_x = LocalMatrix<D>::Zero();
  interface::Status status = interface::Status::open;
  double mu = 0; ///< friction coefficient as it acts
};

/// Natural map (27), (28) and its derivatives for one point; rho in N/m. A coefficient that follows the
/// pressure is that of pbar itself, one that follows the speed that of x: both belong to the map.
template<int D>
[[nodiscard]] PointState<D> evaluate(Problem const& problem, ProblemPoint const& data, Local<D> const& p,
                                     Local<D> const& x, double rho) {
  PointState<D> state;
  interface::Coefficient<D> friction {
    data.mu
  };
  double factor = 1;
  Local<D> factor_by_x = Local<D>::Zero();
  state.dry = p;
  if (data.law >= 0) {
    auto const adhesion = interface::adhere<D>(problem.adhesions[ix(data.law)], data.bond, x);
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

template<int D>
[[nodiscard]] PointState<D> evaluate(Problem const& problem, Index point, Local<D> const& p,
                                     Local<D> const& x, double rho) {
  return evaluate<D>(problem, problem.points[ix(point)], p, x, rho);
}

/// call.operator()<D>() for the D of a problem.
template<class Call> auto by_dimension(int dim, Call&& call) {
  return dim == 1   ? call.template operator()<1>()
         : dim == 2 ? call.template operator()<2>()
                    : call.template operator()<3>();
}

/// rho of the natural map at one point: 1 / largest eigenvalue of W's diagonal block, N/m.
[[nodiscard]] double natural_scale(Problem const& problem, Index point);

/// x = free + W p.
[[nodiscard]] Vector displacement(Problem const& problem, Vector const& force);

/// The starting forces with the bond's force alone on points whose gap is given (W_nn = 0, a driven node) and
/// open: there the map has no slope that would lead away from a closed guess. [dim n], N
[[nodiscard]] Vector open_where_given(Problem const& problem, Vector force);

/// What the judge says of forces p.
struct Verdict {
  double residual = 0; ///< largest |pbar - Proj(...)| / A over the points, Pa
  double scale = 0;    ///< largest traction that the problem can feel, Pa: the yardstick of `residual`
  /// Infinite when any force or displacement is not finite.
  [[nodiscard]] double relative() const;
};
[[nodiscard]] Verdict judge(Problem const& problem, Vector const& force);

} // namespace stiction::contact
