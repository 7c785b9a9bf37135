// Gauss-Seidel with Anderson's mixing.
#include "contact/solvers/mixed_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/threads.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr Index memory = 10;       // sweeps that are mixed
constexpr double astray = 10;      // times the least change of a sweep: forget what was before
constexpr double refined = 1e-4;   // of the last change: x anew in double precision
constexpr long enough_sweeps = 50; // in which the change has to halve
constexpr Index together = 32;     // points whose changes reach the others at the same time
constexpr Index few_rows = 1024;   // that one thread does best

template<int D> class MixedSweeps {
public:
  MixedSweeps(Problem const& problem, Vector const& guess)
      : problem_(problem), W_(problem.W.dense().template cast<float>()), p_(open_where_given(problem, guess)),
        x_(displacement(problem, p_)) {
    for (Index i = 0; i < problem.size(); ++i) {
      LocalMatrix<D> const W = problem.W.block<D>(i);
      blocks_.push_back({W, W.inverse(), natural_scale(problem, i)});
      double const pressed = std::max(0.0, problem.points[ix(i)].shift[0] - problem.free[D * i]);
      yardstick_ = std::max(yardstick_, pressed * blocks_.back().rho / problem.points[ix(i)].area);
    }
  }

  Solution run(double tolerance, long most) {
    Solution solution;
    Vector const first = p_;
    double refine_at = std::numeric_limits<double>::infinity(), least = refine_at, halved = refine_at,
           target = tolerance;
    for (long since = 0; solution.iterations < most && since < enough_sweeps; ++since) {
      double const change = sweep();
      ++solution.iterations;
      if (!std::isfinite(change))
        break;
      if (change <= target || change < refine_at) {
        x_ = displacement(problem_, p_);
        solution.work += 1;
        forget();
        refine_at = refined * change;
      }
      if (change <= target) {
        solution.verdict = judge(problem_, p_);
        solution.work += 1;
        if ((solution.converged = solution.verdict.relative() <= tolerance))
          break;
        target *= 0.3;
      }
      if (change > astray * least)
        forget();
      least = std::min(least, change);
      if (least < 0.5 * halved) {
        halved = least;
        since = 0;
      }
      mix();
    }
    solution.work += static_cast<double>(solution.iterations);
    solution.force = p_;
    if (solution.converged) {
      solution.method = Method::sweeps;
      return solution;
    }
    bool const sound = last_force_.size() > 0 && last_force_.allFinite();
    solution.force = sound ? last_force_ : first; // of a sweep, not of a mixture
    solution.verdict = judge(problem_, solution.force);
    return solution;
  }

private:
  struct Block {
    LocalMatrix<D> W, inverse; ///< not finite where W is singular
    double rho;
  };

  /// Nothing, or what makes the point stick, or one projection (28).
  [[nodiscard]] Local<D> answer(Index i, Local<D> const& x, Local<D> const& old) const {
    auto const& block = blocks_[ix(i)];
    Local<D> const free = x - block.W * old - problem_.points[ix(i)].shift.template head<D>();
    if (free[0] >= 0)
      return Local<D>::Zero();
    double const mu = problem_.points[ix(i)].mu;
    if (Local<D> const stick = -(block.inverse * free);
        stick.allFinite() && stick.template tail<D - 1>().norm() <= mu * stick[0])
      return stick;
    Local<D> v = free + block.W * old;
    v[0] += mu * v.template tail<D - 1>().norm();
    return interface::project<D>(old - block.rho * v, mu).value;
  }

  /// p_ and x_ after one sweep; the largest change of a traction, of the yardstick. What a few points change
  /// is at once seen by these alone, by all others when all of them have been answered for.
  double sweep() {
    before_ = p_;
    moved_.setZero(x_.size());
    largest_ = 0;
    scale_ = yardstick_;
    for (Index first = 0; first < problem_.size(); first += together) {
      Index const last = std::min(first + together, problem_.size());
      changed_.clear();
      for (Index i = first; i < last; ++i)
        if (Local<D> const change = answer(i); !change.isZero(0)) {
          changed_.emplace_back(i, change.template cast<float>());
          move(changed_.back(), D * first, D * last);
        }
      core::each_piece(static_cast<Index>(moved_.size()), few_rows, [&](Index from, Index to) {
        move_by_all(from, std::min(to, D * first));
        move_by_all(std::max(from, D * last), to);
      });
    }
    x_ += moved_.template cast<double>();
    return scale_ > 0 ? largest_ / scale_ : largest_;
  }

  /// Gives a point its answer; its change.
  Local<D> answer(Index i) {
    double const area = problem_.points[ix(i)].area;
    Local<D> const old = p_.segment<D>(D * i);
    Local<D> const x = x_.segment<D>(D * i) + moved_.segment<D>(D * i).template cast<double>();
    Local<D> const next = answer(i, x, old), change = next - old;
    p_.segment<D>(D * i) = next;
    scale_ = std::max(scale_, next.norm() / area);
    largest_ = std::max(largest_, change.norm() / area);
    return change;
  }

  using Change = std::pair<Index, Eigen::Vector<float, D>>;
  /// What a point's change moves these rows by, [rows].
  auto motion(Change const& one, Index from, Index rows) const {
    return W_.middleCols<D>(D * one.first).middleRows(from, rows).lazyProduct(one.second);
  }
  void move(Change const& one, Index from, Index to) {
    moved_.segment(from, to - from) += motion(one, from, to - from);
  }
  /// By all that have changed; by four at a time, as memory likes several columns at once.
  void move_by_all(Index from, Index to) {
    if (from >= to)
      return;
    auto one = changed_.begin();
    auto const by = [&](int k) { return motion(one[k], from, to - from); };
    for (; changed_.end() - one >= 4; one += 4)
      moved_.segment(from, to - from) += (by(0) + by(1)) + (by(2) + by(3));
    for (; one != changed_.end(); ++one)
      move(*one, from, to);
  }

  void forget() {
    kept_ = 0;
    has_last_ = false;
  }

  /// p_ and x_ as the combination of the last sweeps' results whose changes cancel best.
  void mix() {
    Vector const change = p_ - before_;
    if (has_last_) {
      Index const at = next_++ % memory;
      changes_.col(at) = change - last_change_;
      forces_.col(at) = p_ - last_force_;
      displacements_.col(at) = x_ - last_x_;
      kept_ = std::min(kept_ + 1, memory);
    } else {
      changes_.resize(p_.size(), memory);
      forces_.resize(p_.size(), memory);
      displacements_.resize(p_.size(), memory);
      next_ = 0;
    }
    has_last_ = true;
    last_change_ = change;
    last_force_ = p_;
    last_x_ = x_;
    if (kept_ == 0)
      return;
    Dense const changes = changes_.leftCols(kept_);
    Vector const part = changes.colPivHouseholderQr().solve(change);
    p_ -= forces_.leftCols(kept_) * part;
    x_ -= displacements_.leftCols(kept_) * part;
  }

  Problem const& problem_;
  Eigen::MatrixXf W_;
  std::vector<Block> blocks_;
  Vector p_, x_, before_;
  Eigen::VectorXf moved_;          ///< by the present sweep, m
  std::vector<Change> changed_;    ///< of the present few, N
  double yardstick_ = 0;           ///< Pa
  double largest_ = 0, scale_ = 0; ///< of the present sweep: change, traction, Pa
  bool has_last_ = false;
  Index kept_ = 0, next_ = 0;
  Dense changes_, forces_, displacements_; ///< differences of successive sweeps, [dim n, memory]
  Vector last_change_, last_force_, last_x_;
};

} // namespace

bool plain(Problem const& problem) {
  return std::none_of(problem.points.begin(), problem.points.end(),
                      [](auto const& point) { return point.adhesion >= 0 || point.friction >= 0; });
}

Solution mix_sweeps(Problem const& problem, Vector const& guess, double tolerance, long most) {
  return by_dimension(problem.dim,
                      [&]<int D>() { return MixedSweeps<D>(problem, guess).run(tolerance, most); });
}

} // namespace stiction::contact
