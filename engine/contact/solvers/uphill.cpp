// Newton's method on two maps, one after the other, which leaves kinks behind that a descent ends at.
#include "contact/solvers/uphill.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr int walks = 60;                  // iterations from a start
constexpr double all_operations = 2e10;    // multiply-adds, in all
constexpr double shortest_walk = 1.0 / 16; // step that is tried for a descent
constexpr double without_descent = 0.1;    // step where none descends: a kink is left behind
constexpr int whole_again = 5;             // of so many iterations one then goes all the way
constexpr double singular = 1e-14;         // reciprocal condition, below which a step has no digits
constexpr long smallest_cost = 8;          // factorizations that `smallest` takes as long as
constexpr double little = 1e-8;       // of the mean of W's diagonal: where W is singular no step is large
constexpr double least_pivot = 1e-12; // pivots below it, over the largest, count as none

/// The smallest x of those with the smallest A x - b.
Vector smallest(Dense const& A, Vector const& b) {
  Eigen::CompleteOrthogonalDecomposition<Dense> decomposition(A.rows(), A.cols());
  decomposition.setThreshold(least_pivot);
  decomposition.compute(A);
  return decomposition.solve(b);
}

/// The natural map of the bi-potential, or that of Alart and Curnier 1991, whose normal part does not see
/// the slip.
enum class Map { natural, alart_curnier };

/// p - (z_n+, Proj_disc(z_t)), z = p - rho y, with the disc's radius mu z_n+, and its derivatives by p and y.
template<int D>
PointState<D> alart_curnier(ProblemPoint const& point, Local<D> const& p, Local<D> const& x, double rho) {
  Local<D> const z = p - rho * (x - point.shift.head<D>());
  Local<D> kept = Local<D>::Zero();
  LocalMatrix<D> by_z = LocalMatrix<D>::Zero();
  if (z[0] > 0) {
    kept[0] = z[0];
    by_z(0, 0) = 1;
    auto const t = z.template tail<D - 1>();
    double const size = t.norm(), limit = point.mu * z[0];
    kept.template tail<D - 1>() = size <= limit ? t : Local<D - 1>(limit / size * t);
    if (size <= limit) {
      by_z.diagonal().setOnes();
    } else if (limit > 0) {
      Local<D - 1> const along = t / size;
      by_z.template block<D - 1, D - 1>(1, 1) =
          limit / size * (LocalMatrix<D - 1>::Identity() - along * along.transpose());
      by_z.template block<D - 1, 1>(1, 0) = point.mu * along;
    }
  }
  PointState<D> state;
  state.residual = p - kept;
  state.residual_by_dry = LocalMatrix<D>::Identity() - by_z;
  state.residual_by_x = rho * by_z;
  return state;
}

template<int D> class Walk {
public:
  /// weight: on displacements beside forces, over that of the judge. shift: added to the diagonal of W in the
  /// derivative, m/N; 0: where that is singular the smallest step is sought.
  Walk(Problem const& problem, Map map, double weight, double shift = 0)
      : problem_(problem), map_(map), shift_(shift), rho_(problem.size()), residual_(problem.free.size()),
        by_force_(residual_.size(), D), by_x_(residual_.size(), D) {
    for (Index i = 0; i < problem.size(); ++i)
      rho_[i] = weight * natural_scale(problem, i);
  }

  /// `best` turns to what is better by the judge; has it converged?
  bool run(Vector p, double tolerance, long& left, Solution& best) {
    for (int k = 0; k < walks && left > 0; ++k, --left) {
      Vector const step = direction(p, left);
      ++best.iterations;
      if (!step.allFinite())
        return false;
      double const before = residual_.norm();
      double length = 1;
      while (length >= shortest_walk && !(evaluate(p + length * step) < (1 - 1e-4 * length) * before))
        length *= 0.5;
      if (length < shortest_walk)
        length = k % whole_again == whole_again - 1 ? 1 : without_descent;
      p += length * step;
      if (!p.allFinite())
        return false;
      auto const verdict = judge(problem_, p);
      if (best.force.size() == 0 || verdict.relative() < best.verdict.relative()) {
        best.force = p;
        best.verdict = verdict;
      }
      if (verdict.relative() <= tolerance)
        return best.converged = true;
    }
    return false;
  }

private:
  /// The map's norm, N.
  double evaluate(Vector const& p) {
    Vector const x = displacement(problem_, p);
    for (Index i = 0; i < problem_.size(); ++i) {
      Local<D> const own = p.segment<D>(D * i), at = x.segment<D>(D * i);
      auto const state = map_ == Map::natural ? contact::evaluate<D>(problem_, i, own, at, rho_[i])
                                              : alart_curnier<D>(problem_.points[ix(i)], own, at, rho_[i]);
      residual_.segment<D>(D * i) = state.residual;
      by_force_.template middleRows<D>(D * i) = state.residual_by_dry;
      by_x_.template middleRows<D>(D * i) = state.residual_by_x;
    }
    return residual_.norm();
  }

  [[nodiscard]] Vector direction(Vector const& p, long& left) {
    evaluate(p);
    Dense const& W = problem_.W.dense();
    Dense J(W.rows(), W.cols());
    for (Index i = 0; i < problem_.size(); ++i) {
      auto rows = J.middleRows<D>(D * i);
      rows.noalias() = by_x_.template middleRows<D>(D * i) * W.middleRows<D>(D * i);
      rows.template middleCols<D>(D * i) +=
          by_force_.template middleRows<D>(D * i) + shift_ * by_x_.template middleRows<D>(D * i);
    }
    Vector const sizes = J.cwiseAbs().rowwise().maxCoeff().cwiseMax(std::numeric_limits<double>::min());
    J.array().colwise() /= sizes.array();
    Vector const right = -residual_.cwiseQuotient(sizes);
    Eigen::PartialPivLU<Dense> const lu(J);
    if (shift_ > 0 || lu.rcond() > singular)
      return lu.solve(right);
    left -= smallest_cost - 1;
    return smallest(J, right); // bodies that hold each other in more ways than one
  }

  Problem const& problem_;
  Map map_;
  double shift_;
  Vector rho_, residual_;
  Eigen::Matrix<double, Eigen::Dynamic, D> by_force_, by_x_;
};

/// With which no point moves along the surface or into it: pulls as well.
Vector sticking(Problem const& problem) {
  Vector gaps = problem.free;
  for (Index i = 0; i < problem.size(); ++i)
    gaps.segment(problem.dim * i, problem.dim) -= problem.points[ix(i)].shift.head(problem.dim);
  return -smallest(problem.W.dense(), gaps);
}

double work_of(long factorizations, Problem const& problem) {
  return static_cast<double>(factorizations) *
         (static_cast<double>(problem.free.size()) / 3 + problem.dim + 4);
}

} // namespace

Solution finish(Problem const& problem, Vector const& start, double tolerance, int steps) {
  Solution best;
  best.force = start;
  best.verdict = judge(problem, start);
  long left = steps;
  double const shift = little * problem.W.dense().diagonal().mean();
  by_dimension(problem.dim,
               [&]<int D>() { Walk<D>(problem, Map::natural, 1, shift).run(start, tolerance, left, best); });
  best.work = work_of(steps - left, problem);
  return best;
}

Solution go_on(Problem const& problem, double tolerance) {
  Solution best;
  best.force = Vector::Zero(problem.free.size());
  best.verdict = judge(problem, best.force);
  auto const rows = static_cast<double>(problem.free.size());
  auto left = static_cast<long>(all_operations / (rows * rows * rows / 3 + 1));
  long const all = std::min(left, 12L * walks);
  left = all;
  if (left == 0)
    return best;
  auto const starts = {sticking(problem), Vector(Vector::Zero(problem.free.size()))};
  by_dimension(problem.dim, [&]<int D>() {
    for (double const weight : {1.0, 10.0, 100.0})
      for (auto const map : {Map::alart_curnier, Map::natural}) {
        Walk<D> walk(problem, map, weight);
        for (auto const& start : starts)
          if (start.allFinite() && walk.run(start, tolerance, left, best))
            return;
      }
  });
  best.work = work_of(all - left, problem);
  best.method = best.converged ? Method::uphill : Method::none;
  return best;
}

} // namespace stiction::contact
