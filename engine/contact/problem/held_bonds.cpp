// W^-1 plus the tangents of bonds must stay positive definite on the way of a step, else it leapt.
#include "contact/problem/held_bonds.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr Index most_rows = 900;   // as one factorization of them takes about as long as one of Newton's
constexpr double no_pivot = 1e-12; // over the mean of the diagonal, for what does not move
constexpr Index near = 20;         // points on either side, that are asked first whether they hold a bond
constexpr int most_looks = 8;      // along a way, a factorization each
constexpr double samples = 16;     // over the opening in which the steepest fall takes the whole strength
constexpr double least_samples = 4, most_samples = 128; // of a way; beyond, a bond passes its steepest fall

template<int D> class HeldBonds {
public:
  HeldBonds(Problem const& problem, Vector const& force, Vector const& x)
      : problem_(problem), force_(force), x_(x) {}

  SofteningDoubt operator()(Snapped snapped) {
    find_fast();
    auto const doubt = look(0, 1);
    if (snapped == Snapped::yes || !doubt.any() || far_)
      return doubt;
    SofteningDoubt worst; // bonds that fall one after the other do not fall together
    worst.held = true;
    int const looks = std::min(parts_, most_looks);
    for (int k = 0; k < looks; ++k)
      if (auto const found = look((k + 0.5) / looks, (k + 0.5) / looks); found.together > worst.together)
        worst = found;
    return worst;
  }

private:
  /// Each bond where it is weakest between two parts of the step's way.
  SofteningDoubt look(double from, double to) {
    sort(from, to);
    HeldBonds part(*this);
    if (part.leave_out_far()) // fewer bonds hold less
      if (auto const doubt = part.measure(); !doubt.any())
        return doubt;
    return measure();
  }

  /// Of what holds, the bonds next to those that fall, in walking order, alone; false if those are most.
  bool leave_out_far() {
    auto const count = static_cast<Index>(bonded_.size());
    std::vector<bool> keep(bonded_.size(), false);
    for (auto const& one : falling_)
      for (Index k = std::max<Index>(0, one.point - near); k < std::min(count, one.point + near + 1); ++k)
        keep[ix(k)] = true;
    std::vector<Index> places(bonded_.size());
    Index kept = 0;
    for (std::size_t k = 0; k < keep.size(); ++k) {
      places[k] = kept;
      if (!keep[k])
        continue;
      bonded_[ix(kept)] = bonded_[k];
      roots_[ix(kept++)] = roots_[k];
    }
    bonded_.resize(ix(kept));
    roots_.resize(ix(kept));
    for (auto& one : falling_)
      one.point = places[ix(one.point)];
    return 2 * kept < count;
  }

  [[nodiscard]] SofteningDoubt measure() const {
    SofteningDoubt doubt;
    doubt.held = true;
    if (falling_.empty())
      return doubt;
    Dense const W = compliance();
    auto const n = static_cast<Index>(falling_.size());
    Dense loads = Dense::Zero(W.rows(), n), moved(W.rows(), n);
    for (Index b = 0; b < n; ++b) {
      auto const& one = falling_[ix(b)];
      loads.col(b).segment<D>(D * one.point) = std::sqrt(one.fall) * one.along;
      moved.col(b).noalias() = W.middleCols<D>(D * one.point) * loads.col(b).segment<D>(D * one.point);
    }
    Dense const matrix = loads.transpose() * moved - taken(W, moved);
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

  /// Rows that contact holds.
  void find_fast() {
    for (Index i = 0; i < problem_.size(); ++i) {
      Local<D> const p = force_.segment<D>(D * i), at = x_.segment<D>(D * i);
      auto const status = evaluate<D>(problem_, i, p, at, natural_scale(problem_, i)).status;
      Index const rows = status == interface::Status::stick ? D : status == interface::Status::slip ? 1 : 0;
      for (Index k = 0; k < rows; ++k)
        fast_.push_back(D * i + k);
    }
  }

  /// The tangents of bonds parted into what holds and what falls.
  void sort(double from, double to) {
    bonded_.clear();
    roots_.clear();
    falling_.clear();
    for (Index i = 0; i < problem_.size(); ++i) {
      if (problem_.points[ix(i)].adhesion < 0)
        continue;
      Eigen::SelfAdjointEigenSolver<LocalMatrix<D>> const parts(weakest(i, from, to));
      if (parts.eigenvalues().isZero(0))
        continue;
      LocalMatrix<D> root = LocalMatrix<D>::Zero();
      for (int k = 0; k < D; ++k) {
        Local<D> const along = parts.eigenvectors().col(k);
        if (double const stiffness = parts.eigenvalues()[k]; stiffness >= 0)
          root += std::sqrt(stiffness) * along * along.transpose();
        else
          falling_.push_back({static_cast<Index>(bonded_.size()), along, -stiffness});
      }
      bonded_.push_back(i);
      roots_.push_back(root);
    }
  }

  /// The tangent stiffness of a bond, N/m, where on that part of its way it is least.
  [[nodiscard]] LocalMatrix<D> weakest(Index i, double from, double to) {
    auto const& point = problem_.points[ix(i)];
    auto const& law = problem_.adhesions[ix(point.adhesion)];
    Local<D> const end = x_.segment<D>(D * i), way = end - problem_.start.segment<D>(D * i);
    auto const scales = interface::scales(law);
    double const needed =
        std::ceil(std::max(least_samples, samples * way.norm() * scales.softening / scales.strength));
    bool const far = !(needed <= most_samples);
    int const parts = far ? 1 : static_cast<int>(needed);
    far_ = far_ || far;
    parts_ = std::max(parts_, parts);
    LocalMatrix<D> least = stiffness_at(i, end - (1 - to) * way);
    double value = least_eigenvalue(least);
    for (int k = 0; from < to && !far && k < parts; ++k) { // not at the start, where damaged bonds still hold
      LocalMatrix<D> const other = stiffness_at(i, end - (1 - (k + 0.5) / parts) * way);
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
    Dense const& W = problem_.W.dense();
    Dense const block = W(rows, rows);
    Dense own = 0.5 * (block + block.transpose());
    if (fast_.empty())
      return own;
    Dense const pressed = W(fast_, fast_);
    Dense fast = 0.5 * (pressed + pressed.transpose());
    fast.diagonal().array() += no_pivot * fast.diagonal().mean();
    Dense const between = 0.5 * (W(fast_, rows) + W(rows, fast_).transpose());
    own.noalias() -= between.transpose() * Eigen::LLT<Dense>(fast).solve(between);
    return own;
  }

  /// What bonds that hold take from displacements W f: (W^-1 + K)^-1 = W - W R (1 + R W R)^-1 R W, K = R R.
  [[nodiscard]] Dense taken(Dense const& W, Dense const& moved) const {
    Dense inner = W, held = moved;
    for (std::size_t b = 0; b < roots_.size(); ++b) {
      auto const row = D * static_cast<Index>(b);
      inner.middleCols<D>(row) = (inner.middleCols<D>(row) * roots_[b]).eval();
      held.middleRows<D>(row) = (roots_[b] * held.middleRows<D>(row)).eval();
    }
    for (std::size_t b = 0; b < roots_.size(); ++b) {
      auto const row = D * static_cast<Index>(b);
      inner.middleRows<D>(row) = (roots_[b] * inner.middleRows<D>(row)).eval();
    }
    inner.diagonal().array() += 1;
    return held.transpose() * Eigen::LLT<Dense>(inner).solve(held);
  }

  Problem const& problem_;
  Vector const &force_, &x_;
  std::vector<Index> fast_;           ///< rows that contact holds
  std::vector<Index> bonded_;         ///< points with a bond that is felt
  std::vector<LocalMatrix<D>> roots_; ///< of the stiffness with which each holds, N^(1/2)/m^(1/2)
  std::vector<Yielding<D>> falling_;  ///< `point` counts in bonded_
  bool far_ = false;                  ///< does a bond go farther than is sampled?
  int parts_ = 1;                     ///< of the way, in each of which no bond goes far
};

} // namespace

std::optional<SofteningDoubt> held_bonds(Problem const& problem, Vector const& force, Vector const& x,
                                         Snapped snapped) {
  if (problem.start.size() != x.size() || x.size() > most_rows)
    return {};
  return by_dimension(problem.dim, [&]<int D>() { return HeldBonds<D>(problem, force, x)(snapped); });
}

} // namespace stiction::contact
