// Newton's steps on the natural map of the bi-potential, and sweeps between them.
#pragma once
#include <vector>

#include "contact/problem/problem.hpp"
#include "contact/solvers/rounding.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

/// The unknown is the total force p, so that x = free + W p holds exactly and the matrix is dim n x dim n.
template<int D> class NewtonRun {
public:
  NewtonRun(Problem const& problem, Vector const& guess)
      : problem_(problem), p_(open_where_given(problem, guess)) {
    Index const n = problem.size();
    rho_.resize(n);
    for (Index i = 0; i < n; ++i)
      rho_[i] = natural_scale(problem, i);
    states_.resize(ix(n));
    merit_ = evaluate_all(p_, x_);
  }

  /// One Newton step with a line search on the residual; false if no decrease was found.
  bool step() {
    assemble();
    Vector step;
    if (!active_.empty())
      step = matrix_.partialPivLu().solve(right_);
    count_factorization();
    if (!step.allFinite())
      return false;
    Vector direction = Vector::Zero(p_.size());
    for (std::size_t k = 0; k < active_.size(); ++k)
      direction.segment<D>(D * active_[k]) = step.segment<D>(D * static_cast<Index>(k));
    for (Index const i : idle_)
      direction.segment<D>(D * i) = -p_.segment<D>(D * i);
    double const before = merit_;
    Vector const start = p_;
    double length = 1;
    for (int halvings = 0; halvings < 5; ++halvings, length *= 0.5) { // down to 1/16
      p_ = start + length * direction;
      merit_ = evaluate_all(p_, x_);
      if (merit_ <= (1 - 1e-4 * length) * before)
        return true;
    }
    p_ = start;
    merit_ = evaluate_all(p_, x_);
    return false;
  }

  /// Less often where that is in vain.
  void sweep(int times) {
    int k = 0, vain = 0;
    for (; k < times && vain < vain_sweeps; ++k) {
      bool found = true;
      for (Index i = 0; i < problem_.size(); ++i) {
        Local<D> const old = p_.segment<D>(D * i);
        Local<D> const free = x_.segment<D>(D * i) - problem_.W.block<D>(i) * old;
        auto const answer = solve_point<D>(problem_, i, free, old, rho_[i]);
        Local<D> const change = answer.force - old;
        found = found && answer.found;
        p_.segment<D>(D * i) += change;
        problem_.W.add_column<D>(i, change, x_);
      }
      vain = found ? 0 : vain + 1;
    }
    in_vain_ = vain == vain_sweeps;
    work_ += k;
    merit_ = evaluate_all(p_, x_);
  }
  /// Did the last sweeps end as no more of them would help?
  [[nodiscard]] bool in_vain() const { return in_vain_; }
  [[nodiscard]] Vector const& force() const { return p_; }
  [[nodiscard]] Verdict verdict() const { return judge(problem_, p_); }
  [[nodiscard]] double work() const { return work_; }

private:
  double evaluate_all(Vector const& p, Vector& x) {
    x = displacement(problem_, p);
    work_ += 1;
    double sum = 0;
    for (Index i = 0; i < problem_.size(); ++i) {
      auto& state = states_[ix(i)];
      state = evaluate<D>(problem_, i, p.segment<D>(D * i), x.segment<D>(D * i), rho_[i]);
      sum += state.residual.squaredNorm();
    }
    return std::sqrt(sum);
  }

  /// Rows of points that are open and unbonded read p = 0 and leave the system.
  void assemble() {
    active_.clear();
    idle_.clear();
    for (Index i = 0; i < problem_.size(); ++i) {
      auto const& state = states_[ix(i)];
      bool const idle = state.status == interface::Status::open && state.adhesion_by_x.isZero(0) &&
                        state.residual.isApprox(p_.segment<D>(D * i), 0);
      (idle ? idle_ : active_).push_back(i);
    }
    Dense const& W = problem_.W.dense();
    auto const n = D * static_cast<Index>(active_.size());
    matrix_.resize(n, n);
    right_.resize(n);
    for (std::size_t a = 0; a < active_.size(); ++a) {
      Index const i = active_[a], row = D * static_cast<Index>(a);
      auto const& state = states_[ix(i)];
      LocalMatrix<D> const by_x = state.residual_by_x - state.residual_by_dry * state.adhesion_by_x;
      for (std::size_t b = 0; b < active_.size(); ++b)
        matrix_.template block<D, D>(row, D * static_cast<Index>(b)).noalias() =
            by_x * W.block<D, D>(D * i, D * active_[b]);
      matrix_.template block<D, D>(row, row) += state.residual_by_dry;
      right_.template segment<D>(row) = -state.residual;
      for (Index const j : idle_) // their step is known: -p_j
        right_.template segment<D>(row) += by_x * (W.block<D, D>(D * i, D * j) * p_.segment<D>(D * j));
    }
  }

  /// m^3 / 3 for the matrix of the m active rows, D m^2 to make it.
  void count_factorization() {
    auto const m = static_cast<double>(D) * static_cast<double>(active_.size());
    auto const whole = static_cast<double>(p_.size());
    work_ += whole > 0 ? (m / 3 + D) * m * m / (whole * whole) : 0;
  }

  Problem const& problem_;
  Vector p_, x_, rho_;
  std::vector<PointState<D>> states_;
  std::vector<Index> active_, idle_;
  Dense matrix_;
  Vector right_;
  double merit_ = 0, work_ = 0;
  bool in_vain_ = false;
};

} // namespace stiction::contact
