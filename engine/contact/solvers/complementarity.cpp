// Block principal pivoting within a proximal iteration, and Lemke's method on a dictionary.
#include "contact/solvers/complementarity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stiction::contact {

namespace {

constexpr double compliance = 1e-10; // of M's diagonal, about the last answer
constexpr int proximal = 60, exchanges = 60, patience = 4;
constexpr double zero = 1e-14;       // of what is largest
constexpr double too_small = 1e-10;  // pivot over the largest of its column
constexpr double same_ratio = 1e-12; // ratios
constexpr int balancings = 4;

} // namespace

/// Of rows without a diagonal, which no z moves, nothing is kept.
ConvexComplementarity::ConvexComplementarity(Dense const& M) : of_(static_cast<Index>(M.rows())) {
  double const largest = M.rows() > 0 ? M.diagonal().maxCoeff() : 0;
  for (Index i = 0; i < of_; ++i)
    if (M(i, i) > std::numeric_limits<double>::epsilon() * zero * largest)
      rows_.push_back(i);
  scale_ = Vector(M.diagonal()(rows_)).cwiseSqrt().cwiseInverse();
  if (static_cast<Index>(rows_.size()) == of_)
    M_ = M;
  else
    M_ = M(rows_, rows_);
  M_.array().colwise() *= scale_.array();
  M_.array().rowwise() *= scale_.array().transpose();
  M_.diagonal().setConstant(1 + compliance);
}

std::optional<Vector> ConvexComplementarity::solve(Vector const& q, std::vector<bool>& active) {
  Vector const scaled = scale_.cwiseProduct(Vector(q(rows_)));
  double const size = scaled.size() > 0 ? scaled.lpNorm<Eigen::Infinity>() : 0;
  std::vector<bool> set(rows_.size());
  for (std::size_t k = 0; k < set.size(); ++k)
    set[k] = active[ix(rows_[k])];
  Vector z = Vector::Zero(scaled.size());
  for (int k = 0; k < proximal && size > 0; ++k) {
    Vector const about = scaled - compliance * z;
    Vector next;
    if (exchange(about, set)) {
      next = z_;
    } else {
      auto const found = lemke(M_, about / size, 20 * about.size() + 100);
      if (found.end != Pivoted::answered)
        return std::nullopt;
      next = size * found.z;
      for (std::size_t i = 0; i < set.size(); ++i)
        set[i] = next[static_cast<Index>(i)] > 0;
    }
    double const moved = compliance * (next - z).lpNorm<Eigen::Infinity>();
    z = next.cwiseMax(0.0);
    if (moved <= std::numeric_limits<double>::epsilon() * size)
      break;
  }
  Vector result = Vector::Zero(of_);
  active.assign(ix(of_), false);
  for (std::size_t k = 0; k < set.size(); ++k) {
    active[ix(rows_[k])] = set[k];
    result[rows_[k]] = scale_[static_cast<Index>(k)] * z[static_cast<Index>(k)];
  }
  return result;
}

/// z_ and w_ for 0 <= z, 0 <= q + M z; false where the sets cycle.
bool ConvexComplementarity::exchange(Vector const& q, std::vector<bool>& active) {
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  int left = patience;
  for (int k = 0; k < exchanges; ++k) {
    if (!solve_with(q, active))
      return false;
    auto const wrong = wrong_ones(q, active);
    if (wrong.empty())
      return true;
    left = wrong.size() < fewest ? patience : left - 1;
    fewest = std::min(fewest, wrong.size());
    if (left < 0)
      return false;
    for (Index const i : wrong)
      active[ix(i)] = !active[ix(i)];
  }
  return false;
}

/// w = 0 where a row is active, z = 0 elsewhere.
bool ConvexComplementarity::solve_with(Vector const& q, std::vector<bool> const& active) {
  if (active != factored_) {
    set_.clear();
    for (Index i = 0; i < q.size(); ++i)
      if (active[ix(i)])
        set_.push_back(i);
    factor_.compute(M_(set_, set_));
    factored_ = active;
  }
  z_.setZero(q.size());
  w_ = q;
  if (set_.empty())
    return true;
  if (factor_.info() != Eigen::Success)
    return false;
  Vector const step = -factor_.solve(Vector(q(set_)));
  for (std::size_t k = 0; k < set_.size(); ++k) {
    z_[set_[k]] = step[static_cast<Index>(k)];
    w_.noalias() += step[static_cast<Index>(k)] * M_.col(set_[k]);
  }
  return z_.allFinite();
}

Indices ConvexComplementarity::wrong_ones(Vector const& q, std::vector<bool> const& active) const {
  double const least_z = -zero * z_.lpNorm<Eigen::Infinity>(), least_w = -zero * q.lpNorm<Eigen::Infinity>();
  Indices wrong;
  for (Index i = 0; i < q.size(); ++i)
    if (active[ix(i)] ? z_[i] < least_z : w_[i] < least_w)
      wrong.push_back(i);
  return wrong;
}

namespace {

/// Basic variables as affine functions of the others: rows of (constant | coefficients). Variables: w 0..n-1,
/// z n..2n-1, the artificial one 2n, which is added to every w.
class Dictionary {
public:
  Dictionary(Dense const& M, Vector const& q)
      : n_(static_cast<Index>(q.size())), table_(q.size(), q.size() + 1), constant_(q) {
    table_.leftCols(n_) = M;
    table_.col(n_).setOnes();
    basic_.resize(ix(n_));
    other_.resize(ix(n_) + 1);
    std::iota(basic_.begin(), basic_.end(), Index{0});
    std::iota(other_.begin(), other_.end(), n_);
  }

  [[nodiscard]] Index artificial() const { return 2 * n_; }
  [[nodiscard]] Index column_of(Index variable) const {
    return static_cast<Index>(std::find(other_.begin(), other_.end(), variable) - other_.begin());
  }
  [[nodiscard]] Index basic(Index row) const { return basic_[ix(row)]; }

  /// The row that bounds the growth of a column's variable first; -1: none does.
  [[nodiscard]] Index leaving(Index column) const {
    auto const entries = table_.col(column);
    double const least = -too_small * std::max(1e-300, entries.cwiseAbs().maxCoeff());
    double best = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < n_; ++i)
      if (entries[i] < least)
        best = std::min(best, std::max(constant_[i], 0.0) / -entries[i]);
    Index row = -1;
    for (Index i = 0; i < n_; ++i) {
      if (!(entries[i] < least) ||
          std::max(constant_[i], 0.0) / -entries[i] > best + same_ratio * (best + unit(i, column)))
        continue;
      if (basic_[ix(i)] == artificial())
        return i;
      if (row < 0 || sooner(i, row, column))
        row = i;
    }
    return row;
  }

  void pivot(Index row, Index column) {
    double const entry = table_(row, column);
    Vector col = table_.col(column) / entry;
    Eigen::RowVectorXd const line = table_.row(row);
    double const value = constant_[row];
    col[row] = 0;
    table_.noalias() -= col * line;
    constant_ -= value * col;
    table_.col(column) = col;
    table_.row(row) = -line / entry;
    table_(row, column) = 1 / entry;
    constant_[row] = -value / entry;
    std::swap(basic_[ix(row)], other_[ix(column)]);
  }

  /// The row of the artificial variable at the start: the most negative constant.
  [[nodiscard]] Index first_row() const {
    Index row = 0;
    constant_.minCoeff(&row);
    return row;
  }
  /// z of the vertex, or of the direction along a column.
  [[nodiscard]] Vector z_of(Vector const& values, Index entering) const {
    Vector z = Vector::Zero(n_);
    for (Index i = 0; i < n_; ++i)
      if (basic(i) >= n_ && basic(i) < 2 * n_)
        z[basic(i) - n_] = values[i];
    if (entering >= n_ && entering < 2 * n_)
      z[entering - n_] = 1;
    return z;
  }
  [[nodiscard]] Vector vertex() const { return z_of(constant_, -1); }
  [[nodiscard]] Vector direction(Index column) const { return z_of(table_.col(column), other_[ix(column)]); }

private:
  /// Ratios below this are as good as none: q is about one in size.
  [[nodiscard]] double unit(Index row, Index column) const { return 1 / std::max(1.0, -table_(row, column)); }

  /// Of the perturbation e_k added to w_k in row i, over its pivot.
  [[nodiscard]] double perturbed(Index row, Index k, Index column) const {
    double const by = -table_(row, column);
    if (basic_[ix(row)] == k)
      return 1 / by;
    Index const at = place_[ix(k)];
    return at < 0 ? 0 : -table_(row, at) / by;
  }
  [[nodiscard]] bool sooner(Index one, Index other, Index column) const {
    place_.assign(ix(n_), -1);
    for (std::size_t c = 0; c < other_.size(); ++c)
      if (other_[c] < n_)
        place_[ix(other_[c])] = static_cast<Index>(c);
    for (Index k = 0; k < n_; ++k) {
      double const a = perturbed(one, k, column), b = perturbed(other, k, column);
      if (std::abs(a - b) > same_ratio * (std::abs(a) + std::abs(b)))
        return a < b;
    }
    return false;
  }

  Index n_;
  Dense table_;
  Vector constant_;
  std::vector<Index> basic_, other_;
  mutable std::vector<Index> place_; ///< column of w_k where it is not basic
};

/// Rows and columns of about one in size: w = rows * scaled w, z = columns * scaled z.
struct Balanced {
  Dense M;
  Vector rows, columns;
  explicit Balanced(Dense const& from) : M(from), rows(Vector::Ones(from.rows())), columns(rows) {
    for (int k = 0; k < balancings; ++k) {
      Vector const row = factors(M.cwiseAbs().rowwise().maxCoeff());
      M = row.asDiagonal() * M;
      Vector const column = factors(M.cwiseAbs().colwise().maxCoeff().transpose());
      M = M * column.asDiagonal();
      rows = rows.cwiseProduct(row);
      columns = columns.cwiseProduct(column);
    }
  }
  static Vector factors(Vector const& largest) {
    return largest.unaryExpr([](double x) { return x > 0 ? 1 / std::sqrt(x) : 1.0; });
  }
};

LemkeResult pivot_balanced(Dense const& M, Vector const& q, long most) {
  auto const n = static_cast<Index>(q.size());
  LemkeResult result;
  result.end = Pivoted::answered;
  if (n == 0 || q.minCoeff() >= 0) {
    result.z = Vector::Zero(n);
    return result;
  }
  Dictionary dictionary(M, q);
  Index column = n, row = dictionary.first_row();
  for (; result.pivots < most; ++result.pivots) {
    Index const left = dictionary.basic(row);
    dictionary.pivot(row, column);
    if (left == dictionary.artificial()) {
      result.z = dictionary.vertex().cwiseMax(0.0);
      return result;
    }
    column = dictionary.column_of(left < n ? left + n : left - n);
    row = dictionary.leaving(column);
    if (row < 0) {
      result.end = Pivoted::ray;
      result.z = dictionary.direction(column).cwiseMax(0.0);
      return result;
    }
  }
  result.end = Pivoted::limit;
  result.z = dictionary.vertex().cwiseMax(0.0);
  return result;
}

} // namespace

LemkeResult lemke(Dense const& M, Vector const& q, long most) {
  Balanced const balanced(M);
  Vector const right = balanced.rows.cwiseProduct(q);
  double const size = q.size() > 0 ? right.lpNorm<Eigen::Infinity>() : 0;
  auto result = pivot_balanced(balanced.M, right / (size > 0 ? size : 1), most);
  result.z = size * balanced.columns.cwiseProduct(result.z);
  return result;
}

LemkeResult lemke_from(Dense const& M, Vector const& q, std::vector<Index> const& set, long most) {
  if (set.empty())
    return lemke(M, q, most);
  std::vector<Index> others;
  for (Index i = 0, k = 0; i < q.size(); ++i)
    if (k < static_cast<Index>(set.size()) && set[ix(k)] == i)
      ++k;
    else
      others.push_back(i);
  Eigen::PartialPivLU<Dense> const factor(M(set, set));
  Dense across(set.size(), others.size());
  if (!others.empty()) // Eigen's solve would bind a reference to nothing
    across = factor.solve(Dense(M(set, others)));
  Vector const held = factor.solve(Vector(q(set)));
  LemkeResult failed;
  if (!across.allFinite() || !held.allFinite())
    return failed;
  Dense turned(M.rows(), M.cols());
  Vector right(q.size());
  Dense const inside_out = factor.inverse();
  turned(set, set) = inside_out;
  turned(set, others) = -across;
  turned(others, set) = M(others, set) * inside_out;
  turned(others, others) = M(others, others) - M(others, set) * across;
  right(set) = -held;
  right(others) = q(others) - M(others, set) * held;
  auto result = lemke(turned, right, most);
  if (result.end != Pivoted::answered)
    return failed;
  Vector const inside = turned(set, Eigen::all) * result.z + right(set);
  result.z(set) = inside.cwiseMax(0.0);
  return result;
}

bool proves_none(Dense const& M, Vector const& q, Vector const& y) {
  if (!(y.size() > 0 && y.maxCoeff() > 0))
    return false;
  double const rounding = 1e-9 * y.sum();
  return (M.transpose() * y).maxCoeff() <= rounding && q.dot(y) < -rounding;
}

} // namespace stiction::contact
