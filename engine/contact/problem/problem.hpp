// The contact problem as data: any solver answers it, one residual judges the answer.
#pragma once
#include <vector>

#include "contact/problem/delassus.hpp"
#include "core/types.hpp"
#include "interface/law.hpp"

namespace stiction::contact {

using interface::Local;
using interface::LocalMatrix;

/// One contact point of a Problem.
struct ProblemPoint {
  double area = 1;          ///< tributary reference area A, m^2 (m in plane strain)
  double mu = 0;            ///< friction coefficient
  int adhesion = -1;        ///< index into Problem::adhesions; -1: dry
  interface::BondStep bond; ///< bond used only with an adhesion
  int friction = -1;        ///< index into Problem::frictions; -1: the coefficient is mu
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); ///< (n, t1, t2), m: the cone sees x - shift, the bond x
};

/// Find forces p with x = free + W p and pbar = p - A rtilde(x) such that pbar = Proj(pbar - rho (y_n + mu
/// |y_t|, y_t)), y = x - shift. Components contact by contact, (n [, t1 [, t2]]).
struct Problem {
  int dim = 2;                      ///< components per contact: 1 (nothing acts along the surface), 2 or 3
  Delassus W;                       ///< [dim n, dim n], m/N
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
                                     Local<D> const& x, double rho);

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

/// rho of the natural map at one point: 1 / largest eigenvalue of W's diagonal block; of a block without
/// positive ones 1 / the largest size of its eigenvalues; of none the stiffness of the bond, or 1. N/m
[[nodiscard]] double natural_scale(Problem const& problem, Index point);

/// A^-1 b by LU with full pivots.
template<int D> [[nodiscard]] Local<D> solve_local(LocalMatrix<D> const& A, Local<D> const& b);

template<int D> struct PointAnswer {
  Local<D> force;
  bool found; ///< else the force whose residual is the least of those tried
};

/// The force of one point, everything else held fixed: x = free + W p with W of the point alone. Where the
/// search from p gets stuck, as at the fold of a snapping bond or past the single answer of friction, it
/// starts again from no force, then from the force that would make the point stick.
template<int D>
[[nodiscard]] PointAnswer<D> solve_point(Problem const& problem, Index point, Local<D> const& free,
                                         Local<D> p, double rho);

/// Sweeps in a row in each of which some point has no answer: more of them lead nowhere.
inline constexpr int vain_sweeps = 10;

/// x = free + W p.
[[nodiscard]] Vector displacement(Problem const& problem, Vector const& force);

/// The starting forces with the bond's force alone on points whose gap is given (W_nn = 0, a driven node) and
/// open: there the map has no slope that would lead away from a closed guess. [dim n], N
[[nodiscard]] Vector open_where_given(Problem const& problem, Vector force);

/// What the judge says of forces p.
struct Verdict {
  double residual = 0; ///< largest |pbar - Proj(...)| / A over the points, Pa; 0 for rounding alone
  double scale = 0;    ///< largest traction that the problem can feel, Pa: the yardstick of `residual`
  /// Infinite when any force or displacement is not finite.
  [[nodiscard]] double relative() const;
};
/// Forces of a point, N, where they lead, m, and the gap without any, m.
template<int D> struct PointForces {
  Local<D> p, x;
  double free;
};
/// A point's part of it. rho: its natural scale, N/m.
template<int D>
void judge_point(Problem const& problem, ProblemPoint const& data, double rho, PointForces<D> const& at,
                 Verdict& verdict);
[[nodiscard]] Verdict judge(Problem const& problem, Vector const& force);
/// Where x = free + lift + W p is known: free gaps are larger by the lift, m.
[[nodiscard]] Verdict judge(Problem const& problem, Vector const& force, Vector const& x, double lift = 0);

} // namespace stiction::contact
