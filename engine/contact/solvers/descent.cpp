// Projected Newton on the potential of a frictionless contact problem, its softening damped where it must be.
#include "contact/solvers/descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr double enough = 1e-11;          // projected gradient over the largest force
constexpr double least_descent = 1e-4;    // of the descent that the gradient foretells
constexpr double longest_descent = 0.5;   // stride of a step, see `stride`
constexpr double harmless_descent = 1e-5; // step over the least opening of a law
constexpr double quick = 0.1;             // contraction of the gradient
constexpr double symmetric = 1e-12;       // difference across the diagonal over the largest entry
constexpr long most_in_vain = 100;        // iterations without a smaller gradient: bonds that mix modes cycle
constexpr double slight_stride = 0.1;     // stride of a step after which one is near the end
constexpr int most_tries = 8;             // of which points are held, in a step
constexpr int refinements = 10;           // of forces, each of which has to halve what is left at least
constexpr double last_digits = 1e-15;     // of them
constexpr int panels = 4;                 // of Simpson's rule for the work of a bond in one step

/// The unknown is x; the gradient of the potential is p - A rtilde(x) with p = W^-1 (x - free).
template<int D> class Descent {
public:
  explicit Descent(Problem const& problem) : problem_(problem) {
    Dense const& W = problem.W.dense();
    if (W.rows() == 0 || !(W.diagonal().minCoeff() > 0)) // at a point whose place is given
      return;
    Eigen::LLT<Dense> const inner(0.5 * (W + W.transpose()));
    if (inner.info() != Eigen::Success)
      return;
    stiffness_ = inner.solve(Dense::Identity(problem.W.rows(), problem.W.rows()));
    work_ = 7.0 / 6 * static_cast<double>(W.rows());
    stiffness_ = (0.5 * (stiffness_ + stiffness_.transpose())).eval();
    sound_ = stiffness_.allFinite();
    held_.resize(ix(problem.size()));
    for (auto const& law : problem.adhesions)
      opening_ = std::min(opening_, interface::scales(law).opening);
  }
  [[nodiscard]] bool sound() const { return sound_; }

  [[nodiscard]] Descended run(Vector const& guess, long iterations) {
    x_ = problem_.start.size() > 0 ? problem_.start : displacement(problem_, guess);
    for (Index i = 0; i < problem_.size(); ++i)
      x_[D * i] = std::max(x_[D * i], shift(i));
    double before = std::numeric_limits<double>::infinity(), least = before;
    long k = 0, least_at = 0;
    for (; k < iterations && k - least_at < most_in_vain; ++k) {
      differentiate();
      if (!accurate_ && take_whole())
        differentiate();
      double const now = projected_gradient();
      if (now <= enough * p_.template lpNorm<Eigen::Infinity>() + rounding())
        return {p_, k, work_, true};
      if (now < 0.9 * least) {
        least = now;
        least_at = k;
      }
      if (!(now < quick * before) && take_whole())
        differentiate();
      if (near_ && !(now < 0.5 * before)) {
        astray_ = true;
        near_ = false;
        differentiate();
      }
      bool const gone = find_direction() && walk();
      if (!gone && !take_whole())
        break;
      before = gone ? now : std::numeric_limits<double>::infinity();
      near_ = gone && !astray_ && gone_whole_ && stride(direction_) < slight_stride;
    }
    return {p_, k, work_, false};
  }

private:
  /// From now on with what W is not symmetric by, as where normals turn; false if that was done or is
  /// nothing.
  bool take_whole() {
    if (std::exchange(whole_, true))
      return false;
    Dense const& W = problem_.W.dense();
    if ((W - W.transpose()).cwiseAbs().maxCoeff() <= symmetric * W.cwiseAbs().maxCoeff())
      return false;
    Dense inverse = W.partialPivLu().inverse();
    turned_ = inverse.allFinite();
    if (turned_)
      stiffness_ = std::move(inverse);
    work_ += 2 * static_cast<double>(W.rows());
    return turned_;
  }
  [[nodiscard]] double shift(Index point) const { return problem_.points[ix(point)].shift[0]; }
  [[nodiscard]] interface::Adhesion<D> bond(Index point, Local<D> const& x) const {
    auto const& data = problem_.points[ix(point)];
    return data.adhesion < 0 ? interface::Adhesion<D>{}
                             : interface::adhere<D>(problem_.adhesions[ix(data.adhesion)], data.bond, x);
  }

  /// Forces, gradient, the bonds' stiffness, and which points are held at their bound.
  void
  differentiate() {
    set_forces();
    gradient_ = p_;
    softening_.assign(ix(problem_.size()), LocalMatrix<D>::Zero());
    mixes_ = false;
    for (Index i = 0; i < problem_.size(); ++i) {
      double const area = problem_.points[ix(i)].area;
      Local<D> at = x_.segment<D>(D * i);
      auto answer = bond(i, at);
      gradient_.segment<D>(D * i) -= area * answer.traction;
      if (std::abs(at[0]) < touching * opening_) { // where it can only open, the slope on that side
        at[0] = touching * opening_;
        answer = bond(i, at);
      }
      LocalMatrix<D> const& slope = answer.traction_by_x;
      softening_[ix(i)] = -0.5 * area * (slope + slope.transpose());
      if (near_ && !slope.isApprox(slope.transpose(), symmetric)) { // as of a bond that mixes modes
        softening_[ix(i)] = -area * slope;
        mixes_ = true;
      }
      held_[ix(i)] = x_[D * i] <= shift(i) && gradient_[D * i] >= 0;
    }
  }

  /// p of x = free + W p. The inverse may be that of W's symmetric part, and has few digits where bodies are
  /// slender: what it leaves is solved for again.
  void set_forces() {
    Vector const moved = x_ - problem_.free;
    Dense const& W = problem_.W.dense();
    p_ = stiffness_ * moved;
    work_ += 1;
    double before = std::numeric_limits<double>::infinity();
    accurate_ = false;
    for (int k = 0; k < refinements; ++k) {
      Vector const change = stiffness_ * (moved - W * p_);
      double const size = change.template lpNorm<Eigen::Infinity>();
      work_ += 2;
      if (!(size < 0.5 * before))
        return;
      p_ += change;
      double const largest = p_.template lpNorm<Eigen::Infinity>();
      accurate_ = size <= enough * largest;
      if (size <= last_digits * largest)
        return;
      before = size;
    }
  }

  [[nodiscard]] double projected_gradient() const {
    double largest = 0;
    for (Index k = 0; k < gradient_.size(); ++k)
      if (k % D != 0 || !held_[ix(k / D)])
        largest = std::max(largest, std::abs(gradient_[k]));
    return largest;
  }

  /// Of a force W^-1 (x - free), N.
  [[nodiscard]] double rounding() const {
    return 1e-15 * stiffness_.diagonal().maxCoeff() *
           (x_.template lpNorm<Eigen::Infinity>() + problem_.free.template lpNorm<Eigen::Infinity>());
  }

  /// Newton's direction; where the potential is not convex, with less and less of what softens.
  bool find_direction() {
    for (double const part : {1.0, 0.5, 0.25, 0.1, 0.0}) {
      add_bonds(part);
      if (solve_model())
        return true;
    }
    return false;
  }

  /// The minimum of the quadratic model over what the bounds admit: which points they hold is tried until
  /// none pulls and none is behind them, or often enough. False where the model is not convex.
  bool solve_model() {
    auto held = held_;
    for (int k = 0; k < most_tries; ++k) {
      if (!solve_with(held))
        return false;
      Vector const slope = gradient_ + hessian_ * direction_;
      work_ += 1;
      bool changed = false;
      for (Index i = 0; i < problem_.size(); ++i) {
        bool const now = held[ix(i)] ? slope[D * i] >= 0 : x_[D * i] + direction_[D * i] < shift(i);
        changed = changed || now != held[ix(i)];
        held[ix(i)] = now;
      }
      if (!changed)
        break;
    }
    return true;
  }

  /// direction_ of the model with these points at their bound.
  bool solve_with(std::vector<bool> const& held) {
    free_.clear();
    direction_.setZero(x_.size());
    for (Index k = 0; k < x_.size(); ++k)
      if (k % D != 0 || !held[ix(k / D)])
        free_.push_back(k);
      else
        direction_[k] = shift(k / D) - x_[k];
    Vector right = -gradient_(free_);
    if (!direction_.isZero(0))
      right -= (hessian_ * direction_)(free_);
    Dense const H = hessian_(free_, free_);
    bool const skew = turned_ || mixes_;
    Eigen::LLT<Dense> const factor(skew ? Dense(0.5 * (H + H.transpose())) : H);
    auto const whole = static_cast<double>(x_.size()), share = static_cast<double>(free_.size()) / whole;
    work_ += (skew ? 3 : 1) * whole * share * share * share / 6;
    if (factor.info() != Eigen::Success)
      return false;
    direction_(free_) = skew ? Vector(H.partialPivLu().solve(right)) : Vector(factor.solve(right));
    return direction_.allFinite();
  }

  /// hessian_ with a part of what softens of the bonds.
  void add_bonds(double part) {
    hessian_ = stiffness_;
    for (Index i = 0; i < problem_.size(); ++i) {
      LocalMatrix<D> const& K = softening_[ix(i)];
      LocalMatrix<D> taken = part * K;
      taken.diagonal() = taken.diagonal().cwiseMax(K.diagonal());
      hessian_.block<D, D>(D * i, D * i) += taken;
    }
  }

  /// The largest part that a step moves an attracted point, or one that touches whose bond will pull, of its
  /// bond's opening, or of how far it is open already: a law changes over either.
  [[nodiscard]] double stride(Vector const& step) const {
    double largest = 0;
    for (Index i = 0; i < problem_.size(); ++i) {
      auto const& data = problem_.points[ix(i)];
      Local<D> const at = x_.segment<D>(D * i);
      if (data.adhesion < 0)
        continue;
      auto const answer = bond(i, at);
      if (answer.traction.isZero(0) && (at[0] > shift(i) || answer.traction_by_x.isZero(0)))
        continue;
      double const opening = std::max(interface::scales(problem_.adhesions[ix(data.adhesion)]).opening,
                                      interface::opening<D>(at, data.bond.old).norm());
      largest = std::max(largest, step.segment<D>(D * i).norm() / opening);
    }
    return largest;
  }

  /// What the potential gains between x_ and next, J.
  [[nodiscard]] double gain(Vector const& next) const {
    Vector const d = next - x_;
    double sum = d.dot(p_) + 0.5 * d.dot(stiffness_ * d);
    for (Index i = 0; i < problem_.size(); ++i) {
      Local<D> const from = x_.segment<D>(D * i), change = d.segment<D>(D * i);
      if (problem_.points[ix(i)].adhesion < 0 || change.isZero(0))
        continue;
      double work = 0;
      for (int k = 0; k <= 2 * panels; ++k) {
        double const weight = k == 0 || k == 2 * panels ? 1 : (k % 2 == 1 ? 4 : 2);
        work += weight * bond(i, from + k / (2.0 * panels) * change).traction.dot(change);
      }
      sum -= problem_.points[ix(i)].area * work / (6 * panels);
    }
    return sum;
  }

  /// Goes along the direction, stopped at the bounds, as far as the potential falls; a step too small to leap
  /// over anything is taken at once, as rounding would judge it.
  bool walk() {
    double length = std::min(1.0, longest_descent / stride(direction_)); // however long the direction is
    double const shortest = 1e-6 * length;
    while (length > shortest) {
      Vector next = x_ + length * direction_;
      for (Index i = 0; i < problem_.size(); ++i)
        next[D * i] = std::max(next[D * i], shift(i));
      if (length * direction_.template lpNorm<Eigen::Infinity>() < harmless_descent * opening_ ||
          gain(next) <= least_descent * gradient_.dot(next - x_)) {
        x_ = next;
        gone_whole_ = length == 1;
        return true;
      }
      length *= 0.5;
    }
    return false;
  }

  Problem const& problem_;
  Dense stiffness_; ///< W^-1, or that of its symmetric part, N/m
  bool sound_ = false;
  bool near_ = false, astray_ = false;  ///< is the end near, and was it taken for near where it was not?
  bool mixes_ = false;                  ///< is `softening_` not symmetric?
  bool gone_whole_ = false;             ///< did `walk` go all of the step?
  bool accurate_ = false;               ///< does W p_ move as it should?
  bool whole_ = false, turned_ = false; ///< was all of W asked for, and is `stiffness_` its inverse?
  double work_ = 0;                     ///< in products of W
  double opening_ = std::numeric_limits<double>::infinity(); ///< least of the laws, m
  Vector x_, p_, gradient_, direction_;
  Dense hessian_;
  std::vector<LocalMatrix<D>> softening_; ///< second derivative of the bonds' energies, N/m
  std::vector<bool> held_;                ///< points that their bound holds
  Indices free_;                          ///< components that may move
};

} // namespace

bool leaps(Problem const& problem, Vector const& guess, Vector const& force) {
  Vector const start = problem.start.size() > 0 ? problem.start : displacement(problem, guess);
  Vector const moved = displacement(problem, force) - start;
  for (Index i = 0; i < problem.size(); ++i) {
    int const law = problem.points[ix(i)].adhesion;
    double const way = moved.segment(problem.dim * i, problem.dim).lpNorm<Eigen::Infinity>();
    if (law >= 0 && !(way <= interface::scales(problem.adhesions[ix(law)]).opening))
      return true;
  }
  return false;
}

bool frictionless(Problem const& problem) {
  return std::none_of(problem.points.begin(), problem.points.end(),
                      [](auto const& point) { return point.mu > 0 || point.friction >= 0; });
}

bool may_snap(Problem const& problem) {
  if (problem.size() == 0 || !frictionless(problem))
    return false;
  double steepest = 0;
  for (auto const& point : problem.points)
    if (point.adhesion >= 0)
      steepest =
          std::max(steepest, point.area * interface::scales(problem.adhesions[ix(point.adhesion)]).softening);
  if (steepest == 0)
    return false;
  auto const& W = problem.W.dense();
  Vector sums = Vector::Zero(W.rows()); // column by column, as they lie in memory
  for (Eigen::Index j = 0; j < W.cols(); ++j)
    sums += W.col(j).cwiseAbs();
  return steepest * sums.maxCoeff() > 1;
}

std::optional<Descended> descend(Problem const& problem, Vector const& guess, long iterations) {
  return by_dimension(problem.dim, [&]<int D>() -> std::optional<Descended> {
    Descent<D> descent(problem);
    if (!descent.sound())
      return std::nullopt;
    return descent.run(guess, iterations);
  });
}

std::optional<Descended> descend_beside_friction(Problem const& problem, Vector const& force,
                                                 long iterations) {
  if (frictionless(problem) || std::none_of(problem.points.begin(), problem.points.end(),
                                            [](auto const& point) { return point.adhesion >= 0; }))
    return std::nullopt;
  return by_dimension(problem.dim, [&]<int D>() -> std::optional<Descended> {
    Vector const x = displacement(problem, force);
    Vector held = Vector::Zero(force.size());
    Problem eased = problem;
    for (Index i = 0; i < problem.size(); ++i) {
      auto& point = eased.points[ix(i)];
      if (!(point.mu > 0) && point.friction < 0)
        continue;
      Local<D> dry = force.segment<D>(D * i);
      if (point.adhesion >= 0)
        dry -= point.area *
               interface::adhere<D>(problem.adhesions[ix(point.adhesion)], point.bond, x.segment<D>(D * i))
                   .traction;
      held.segment<D>(D * i).template tail<D - 1>() = dry.template tail<D - 1>();
      point.mu = 0;
      point.friction = -1;
    }
    eased.free += problem.W.dense() * held;
    Descent<D> descent(eased);
    if (!descent.sound())
      return std::nullopt;
    auto end = descent.run(force - held, iterations);
    if (!end.settled)
      return std::nullopt;
    end.force += held;
    return end;
  });
}

} // namespace stiction::contact
