// W^-1 plus the tangents of bonds must stay positive definite on the way of a step, else it leapt.
#include "contact/problem/held_bonds.hpp"

#include <cmath>
#include <vector>

#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr Index most_rows = 900;   // as one factorization of them takes about as long as one of Newton's
constexpr double no_pivot = 1e-12; // over the mean of the diagonal, for what does not move
constexpr double samples = 16;     // over the opening in which the steepest fall takes the whole strength
constexpr double least_samples = 4, most_samples = 128; // of a way; beyond, a bond passes its steepest fall

/// A direction of a bond along which its force falls as it opens, N/m > 0.
struct Falling {
  Index point;
  Vector along; ///< [dim]
  double fall;
};

template<int D> class HeldBonds {
public:
  HeldBonds(Problem const& problem, Vector const& force, Vector const& x)
      : problem_(problem), force_(force), x_(x) {}

  SofteningDoubt operator()(Snapped snapped) {
    auto const doubt = look(0, 1);
    if (snapped == Snapped::yes || !doubt.any() || far_)
      return doubt;
    SofteningDoubt worst; // bonds that fall one after the other do not fall together
    worst.held = true;
    for (double at = 0.5; at < parts_; ++at)
      if (auto const found = look(at / parts_, at / parts_); found.together > worst.together)
        worst = found;
    return worst;
  }

private:
  /// Each bond where it is weakest between two parts of the step's way.
  SofteningDoubt look(double from, double to) {
    sort(from, to);
    SofteningDoubt doubt;
    doubt.held = true;
    if (falling_.empty())
      return doubt;
    Dense const W = compliance();
    auto const n = static_cast<Index>(falling_.size());
    Dense loads = Dense::Zero(W.rows(), n);
    for (Index b = 0; b < n; ++b)
      loads.col(b).segment(D * falling_[ix(b)].point, D) =
          std::sqrt(falling_[ix(b)].fall) * falling_[ix(b)].along;
    Dense const matrix = loads.transpose() * held(W, loads);
    for (Index b = 0; b < n; ++b) {
      doubt.points += matrix(b, b) >= 1 ? 1 : 0;
      if (doubt.worst >= 0 && matrix(b, b) * doubt.stiffness <= doubt.fall)
        continue;
      doubt.worst = bonded_[ix(falling_[ix(b)].point)];
      doubt.fall = falling_[ix(b)].fall;
      doubt.stiffness = doubt.fall / matrix(b, b);
    }
    doubt.together =
        Eigen::SelfAdjointEigenSolver<Dense>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[n - 1];
    return doubt;
  }

  /// Rows that contact holds, and the tangents of bonds parted into what holds and what falls.
  void sort(double from, double to) {
    fast_.clear();
    bonded_.clear();
    holds_.clear();
    falling_.clear();
    for (Index i = 0; i < problem_.size(); ++i) {
      Local<D> const p = force_.segment<D>(D * i), at = x_.segment<D>(D * i);
      auto const status = evaluate<D>(problem_, i, p, at, natural_scale(problem_, i)).status;
      Index const rows = status == interface::Status::stick ? D : status == interface::Status::slip ? 1 : 0;
      for (Index k = 0; k < rows; ++k)
        fast_.push_back(D * i + k);
      if (problem_.points[ix(i)].adhesion < 0)
        continue;
      Eigen::SelfAdjointEigenSolver<LocalMatrix<D>> const parts(weakest(i, from, to));
      if (parts.eigenvalues().isZero(0))
        continue;
      LocalMatrix<D> holds = LocalMatrix<D>::Zero();
      for (int k = 0; k < D; ++k) {
        Local<D> const along = parts.eigenvectors().col(k);
        if (double const stiffness = parts.eigenvalues()[k]; stiffness >= 0)
          holds += stiffness * along * along.transpose();
        else
          falling_.push_back({static_cast<Index>(bonded_.size()), along, -stiffness});
      }
      bonded_.push_back(i);
      holds_.push_back(holds);
    }
  }

  /// The tangent stiffness of a bond, N/m, where on that part of its way it is least.
  [[nodiscard]] LocalMatrix<D> weakest(Index i, double from, double to) {
    auto const& point = problem_.points[ix(i)];
    auto const& law = problem_.adhesions[ix(point.adhesion)];
    Local<D> const end = x_.segment<D>(D * i), way = end - problem_.start.segment<D>(D * i);
    auto const scales = interface::scales(law);
    double const parts =
        std::ceil(std::max(least_samples, samples * way.norm() * scales.softening / scales.strength));
    bool const far = !(parts <= most_samples);
    far_ = far_ || far;
    parts_ = far ? parts_ : std::max(parts_, parts);
    LocalMatrix<D> least = stiffness_at(i, end - (1 - to) * way);
    double value = least_eigenvalue(least);
    for (double at = 0.5; from < to && !far && at < parts; ++at) { // where a damaged bond starts it is held
      LocalMatrix<D> const other = stiffness_at(i, end - (1 - at / parts) * way);
      if (double const its = least_eigenvalue(other); its < value) {
        value = its;
        least = other;
      }
    }
    if (double const fall = point.area * interface::steepest_fall(law, point.bond); far && -fall < value)
      least = -fall / way.squaredNorm() * way * way.transpose();
    return least;
  }

  [[nodiscard]] LocalMatrix<D> stiffness_at(Index i, Local<D> const& x) const {
    auto const& point = problem_.points[ix(i)];
    auto const by_x =
        interface::adhere<D>(problem_.adhesions[ix(point.adhesion)], point.bond, x).traction_by_x;
    return -0.5 * point.area * (by_x + by_x.transpose());
  }

  static double least_eigenvalue(LocalMatrix<D> const& matrix) {
    return Eigen::SelfAdjointEigenSolver<LocalMatrix<D>>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
  }

  /// W's symmetric part at the bonds, with what contact holds held.
  [[nodiscard]] Dense compliance() const {
    std::vector<Index> rows;
    for (Index const i : bonded_)
      for (int k = 0; k < D; ++k)
        rows.push_back(D * i + k);
    Dense const W = 0.5 * (problem_.W.dense() + problem_.W.dense().transpose());
    Dense own = W(rows, rows);
    if (fast_.empty())
      return own;
    Dense fast = W(fast_, fast_);
    fast.diagonal().array() += no_pivot * fast.diagonal().mean();
    Dense const between = W(fast_, rows);
    own.noalias() -= between.transpose() * Eigen::LLT<Dense>(fast).solve(between);
    return own;
  }

  /// (W^-1 + K)^-1 loads = L (1 + L' K L)^-1 L' loads, K of what holds, W = L L'.
  [[nodiscard]] Dense held(Dense const& W, Dense const& loads) const {
    Dense shifted = W;
    shifted.diagonal().array() += no_pivot * std::abs(W.diagonal().mean());
    Dense const L = Eigen::LLT<Dense>(shifted).matrixL();
    Dense KL = L;
    for (std::size_t b = 0; b < holds_.size(); ++b)
      KL.middleRows<D>(D * static_cast<Index>(b)) =
          (holds_[b] * KL.middleRows<D>(D * static_cast<Index>(b))).eval();
    Dense inner = L.transpose() * KL;
    inner.diagonal().array() += 1;
    return L * Eigen::LLT<Dense>(inner).solve(L.transpose() * loads);
  }

  Problem const& problem_;
  Vector const &force_, &x_;
  std::vector<Index> fast_;   ///< rows that contact holds
  std::vector<Index> bonded_; ///< points with a bond that is felt
  std::vector<LocalMatrix<D>> holds_;
  std::vector<Falling> falling_; ///< `point` counts in bonded_
  bool far_ = false;             ///< does a bond go farther than is sampled?
  double parts_ = 1;             ///< of the way, in each of which no bond goes far
};

} // namespace

std::optional<SofteningDoubt> held_bonds(Problem const& problem, Vector const& force, Vector const& x,
                                         Snapped snapped) {
  if (problem.start.size() != x.size() || x.size() > most_rows)
    return {};
  return by_dimension(problem.dim, [&]<int D>() { return HeldBonds<D>(problem, force, x)(snapped); });
}

} // namespace stiction::contact
