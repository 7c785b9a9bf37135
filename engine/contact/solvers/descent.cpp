// Projected Newton on the potential of a frictionless contact problem, its softening damped where it must be.
#include "contact/solvers/descent.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr double enough = 1e-11;          // projected gradient over the largest force
constexpr double least_descent = 1e-4;    // of the descent that the gradient foretells
constexpr double longest_descent = 0.5;   // stride of a step, see `stride`
constexpr double harmless_descent = 1e-5; // step over the least opening of a law
constexpr int panels = 4;                 // of Simpson's rule for the work of a bond in one step

/// The unknown is x; the gradient of the potential is p - A rtilde(x) with p = W^-1 (x - free).
template<int D> class Descent {
public:
  explicit Descent(Problem const& problem) : problem_(problem) {
    Dense const& W = problem.W.dense();
    if (W.rows() == 0 || !(W.diagonal().minCoeff() > 0)) // at a point whose place is given
      return;
    Eigen::LLT<Dense> const inner(W);
    if (inner.info() != Eigen::Success)
      return;
    stiffness_ = inner.solve(Dense::Identity(problem.W.rows(), problem.W.rows()));
    stiffness_ = (0.5 * (stiffness_ + stiffness_.transpose())).eval();
    sound_ = stiffness_.allFinite();
    for (auto const& law : problem.adhesions)
      opening_ = std::min(opening_, interface::scales(law).opening);
  }
  [[nodiscard]] bool sound() const { return sound_; }

  [[nodiscard]] Descended run(Vector const& guess, long iterations) {
    x_ = problem_.start.size() > 0 ? problem_.start : displacement(problem_, guess);
    for (Index i = 0; i < problem_.size(); ++i)
      x_[D * i] = std::max(x_[D * i], shift(i));
    long k = 0;
    for (; k < iterations; ++k) {
      differentiate();
      if (projected_gradient() <= enough * p_.template lpNorm<Eigen::Infinity>() + rounding())
        return {p_, k, work(k), true};
      if (!(find_direction() && walk()))
        break;
    }
    return {p_, k, work(k), false};
  }

private:
  /// A product and a symmetric factorization for each iteration.
  [[nodiscard]] double work(long iterations) const {
    return static_cast<double>(iterations) * (1 + static_cast<double>(problem_.free.size()) / 6);
  }
  [[nodiscard]] double shift(Index point) const { return problem_.points[ix(point)].shift[0]; }
  [[nodiscard]] interface::Adhesion<D> bond(Index point, Local<D> const& x) const {
    auto const& data = problem_.points[ix(point)];
    return data.adhesion < 0 ? interface::Adhesion<D>{}
                             : interface::adhere<D>(problem_.adhesions[ix(data.adhesion)], data.bond, x);
  }

  /// Forces, gradient, the bonds' stiffness, and which components are held at their bound.
  void
  differentiate() {
    p_ = stiffness_ * (x_ - problem_.free);
    gradient_ = p_;
    softening_.assign(ix(problem_.size()), LocalMatrix<D>::Zero());
    free_.clear();
    for (Index i = 0; i < problem_.size(); ++i) {
      auto const answer = bond(i, x_.segment<D>(D * i));
      double const area = problem_.points[ix(i)].area;
      gradient_.segment<D>(D * i) -= area * answer.traction;
      softening_[ix(i)] = -0.5 * area * (answer.traction_by_x + answer.traction_by_x.transpose());
      if (x_[D * i] > shift(i) || gradient_[D * i] < 0)
        free_.push_back(D * i);
      for (int c = 1; c < D; ++c)
        free_.push_back(D * i + c);
    }
  }

  [[nodiscard]] double projected_gradient() const {
    double largest = 0;
    for (Index const k : free_)
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
    auto const n = static_cast<Index>(free_.size());
    Vector right(n);
    for (Index a = 0; a < n; ++a)
      right[a] = -gradient_[free_[ix(a)]];
    for (double const part : {1.0, 0.5, 0.25, 0.1, 0.0}) {
      Eigen::LLT<Dense> const factor(hessian(part));
      if (factor.info() == Eigen::Success) {
        direction_.setZero(x_.size());
        Vector const step = factor.solve(right);
        for (Index a = 0; a < n; ++a)
          direction_[free_[ix(a)]] = step[a];
        return step.allFinite();
      }
    }
    return false;
  }

  [[nodiscard]] Dense hessian(double part) const {
    Dense H = stiffness_(free_, free_);
    for (std::size_t a = 0; a < free_.size(); ++a)
      for (std::size_t b = a - std::min<std::size_t>(a, D - 1); b <= a; ++b) {
        if (free_[a] / D != free_[b] / D)
          continue;
        double const entry = softening_[ix(free_[a] / D)](free_[a] % D, free_[b] % D);
        double const taken = a == b && entry > 0 ? entry : part * entry;
        H(static_cast<Index>(a), static_cast<Index>(b)) += taken;
        if (a != b)
          H(static_cast<Index>(b), static_cast<Index>(a)) += taken;
      }
    return H;
  }

  /// The largest part of any bond's opening that a step moves an attracted point, or one that touches, whose
  /// bond does not pull yet.
  [[nodiscard]] double stride(Vector const& step) const {
    double largest = 0;
    for (Index i = 0; i < problem_.size(); ++i) {
      auto const& data = problem_.points[ix(i)];
      if (data.adhesion < 0 || (x_[D * i] > shift(i) && bond(i, x_.segment<D>(D * i)).traction.isZero(0)))
        continue;
      double const opening = interface::scales(problem_.adhesions[ix(data.adhesion)]).opening;
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
        return true;
      }
      length *= 0.5;
    }
    return false;
  }

  Problem const& problem_;
  Dense stiffness_; ///< W^-1, N/m
  bool sound_ = false;
  double opening_ = std::numeric_limits<double>::infinity(); ///< least of the laws, m
  Vector x_, p_, gradient_, direction_;
  std::vector<LocalMatrix<D>> softening_; ///< second derivative of the bonds' energies, N/m
  std::vector<Index> free_;               ///< components that may move
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
  return steepest > 0 && steepest * problem.W.dense().cwiseAbs().rowwise().sum().maxCoeff() > 1;
}

std::optional<Descended> descend(Problem const& problem, Vector const& guess, long iterations) {
  return by_dimension(problem.dim, [&]<int D>() -> std::optional<Descended> {
    Descent<D> descent(problem);
    if (!descent.sound())
      return std::nullopt;
    return descent.run(guess, iterations);
  });
}

} // namespace stiction::contact
