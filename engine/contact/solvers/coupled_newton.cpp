// Semismooth Newton on the natural map, its linear systems solved together with the bulk.
#include "contact/solvers/coupled_newton.hpp"

#include <algorithm>
#include <limits>

#include "contact/solvers/rounding.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

/// Of the linear system's right-hand side, left by its solution: as long as points change their status, then;
/// and of what is asked for in the end, if that comes within reach.
constexpr double coarse_step = 3e-2, fine_step = 1e-3, last_step = 0.1;
constexpr double status_settled = 1e-3; ///< residual over its scale, below which no status should change
/// Residual over its scale that motions solved for to 1e-12 always allow; and how often it has to be met by
/// forces that get no better.
constexpr double attainable = 1e-9;
constexpr int often = 3;
constexpr int most_halvings = 5;
constexpr int most_idle = 8;       ///< iterations in which the residual has to halve
constexpr int most_idle_held = 12; ///< the same while falling bonds are held
constexpr int most_holds = 4;
constexpr double let_go = 0.05; ///< residual after a hold over the one before, at which it ends

double left_over(double relative, double tolerance) {
  return relative > status_settled ? coarse_step
                                   : std::clamp(last_step * tolerance / relative, fine_step, coarse_step);
}

template<int D> class CoupledRun {
public:
  CoupledRun(Problem const& problem, Vector const& guess)
      : problem_(problem), p_(open_where_given(problem, guess)), rho_(problem.size()) {
    for (Index i = 0; i < problem.size(); ++i)
      rho_[i] = natural_scale(problem, i);
    laws_.A.resize(p_.size(), D);
    laws_.B.resize(p_.size(), D);
    laws_.right.resize(p_.size());
    recover();
  }
  /// x of the forces themselves: what the linear solutions leave gathers in x.
  void recover() {
    x_ = displacement(problem_, p_);
    merit_ = evaluate_all(p_, x_);
  }
  /// False if the linear system was not solved. hold: bonds pull as they did where opening weakens them; then
  /// a step leads downhill, whatever the residual does, and whole.
  [[nodiscard]] bool step(double part, bool hold) {
    linearise(hold);
    Vector dp, dx;
    if (!problem_.W.together()->solve(laws_, p_, part, dp, dx))
      return false;
    double length = 1, before = merit_;
    Vector p, x;
    for (int k = 0;; ++k, length *= 0.5) {
      p = p_ + length * dp;
      x = x_ + length * dx;
      merit_ = evaluate_all(p, x);
      if (hold || merit_ <= (1 - 1e-4 * length) * before || k == most_halvings)
        break;
    }
    problem_.W.together()->advance(length);
    p_ = std::move(p);
    x_ = std::move(x);
    return std::isfinite(merit_);
  }
  [[nodiscard]] Vector const& force() const { return p_; }
  [[nodiscard]] double merit() const { return merit_; }
  [[nodiscard]] Verdict verdict() const { return judge(problem_, p_, x_); }

private:
  double evaluate_all(Vector const& p, Vector const& x) {
    double sum = 0;
    states_.resize(ix(problem_.size()));
    for (Index i = 0; i < problem_.size(); ++i) {
      states_[ix(i)] = evaluate<D>(problem_, i, p.segment<D>(D * i), x.segment<D>(D * i), rho_[i]);
      sum += states_[ix(i)].residual.squaredNorm();
    }
    return std::sqrt(sum);
  }
  /// Of a bond that opening weakens, the modes in which it does not.
  static LocalMatrix<D> stiffening(LocalMatrix<D> const& adhesion_by_x) {
    return linear::negative_part(0.5 * (adhesion_by_x + adhesion_by_x.transpose()));
  }
  void linearise(bool hold) {
    for (Index i = 0; i < problem_.size(); ++i) {
      auto const& state = states_[ix(i)];
      laws_.A.template middleRows<D>(D * i) = state.residual_by_dry;
      laws_.B.template middleRows<D>(D * i) =
          state.residual_by_x -
          state.residual_by_dry * (hold ? stiffening(state.adhesion_by_x) : state.adhesion_by_x);
      laws_.right.template segment<D>(D * i) = -state.residual;
    }
  }

  Problem const& problem_;
  Vector p_, x_, rho_;
  std::vector<PointState<D>> states_;
  linear::PointLaws laws_;
  double merit_ = 0;
};

template<int D> Solution run(Problem const& problem, Vector const& guess, double tolerance, int iterations) {
  CoupledRun<D> newton(problem, guess);
  Solution solution;
  bool exact = true; // x is that of the forces
  double const there = forces_there(problem, guess);
  double halved = std::numeric_limits<double>::infinity(), left = 0;
  int met = 0, holds = 0;
  bool hold = false;
  for (int idle = 0;;) {
    double const relative = (solution.verdict = newton.verdict()).relative();
    if (relative <= tolerance && !exact) {
      newton.recover();
      exact = true;
      continue;
    }
    met += exact && relative <= attainable ? 1 : 0;
    solution.rounded = relative > tolerance && met >= often;
    solution.converged = relative <= tolerance || solution.rounded;
    if (newton.merit() < 0.5 * halved) {
      halved = newton.merit();
      idle = 0;
    }
    if (solution.converged || solution.iterations == iterations)
      break;
    if (hold && newton.merit() < let_go * left) {
      hold = false;
      idle = 0;
    }
    if (++idle > (hold ? most_idle_held : most_idle)) {
      if (!hold && ++holds > most_holds)
        break;
      hold = !hold;
      left = newton.merit();
      idle = 0;
    }
    if (!newton.step(left_over(relative, tolerance), hold))
      break;
    ++solution.iterations;
    exact = false;
  }
  solution.force = newton.force();
  solution.converged = solution.converged && felt(problem, solution, there);
  solution.rounded = solution.rounded && solution.converged;
  solution.method = solution.converged ? Method::newton : Method::none;
  return solution;
}

} // namespace

Solution coupled_newton(Problem const& problem, Vector const& guess, double tolerance, int iterations) {
  return by_dimension(problem.dim, [&]<int D>() { return run<D>(problem, guess, tolerance, iterations); });
}

} // namespace stiction::contact
