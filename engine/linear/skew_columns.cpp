// Elimination of the columns of surface unknowns with a factor of the symmetric part.
#include "linear/skew_columns.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::linear {

namespace {
constexpr Index most = 64;  // columns made at a time: enough for matrix products, little memory
constexpr Index group = 24; // columns solved for together: whole nodes in the plane and in space
} // namespace

bool SkewColumns::add(Cholesky& factor, std::vector<ColumnEntry> entries, Index surface) {
  entries_ = std::move(entries);
  std::ranges::stable_sort(entries_, {}, &ColumnEntry::column);
  // L_c L_c^T + B_c - S_ci S_ii^-1 B_i = L_c (L_c^T + last rows of L^-1 B)
  Dense const& L = factor.trailing_factor();
  Dense sum = L.transpose(), B;
  auto entry = entries_.begin();
  for (Index first = 0; first < surface; first += most) {
    Index const count = std::min(most, surface - first);
    B.setZero(factor.pattern().size(), count);
    for (; entry != entries_.end() && entry->column < first + count; ++entry)
      B(entry->row, entry->column - first) += entry->value;
    factor.forward(B);
    sum.middleCols(first, count) += B.bottomRows(surface);
  }
  schur_.compute(L.triangularView<Eigen::Lower>() * sum);
  columns_.emplace(surface, group, false);
  double const least = schur_.matrixLU().diagonal().cwiseAbs().minCoeff();
  return least > 0 && std::isfinite(least);
}

long SkewColumns::compliance(Indices const& used, Dense& C) {
  auto const solve = [this](Index first, Dense& X) {
    X.setZero();
    X.middleRows(first, X.cols()).setIdentity();
    X = schur_.solve(X);
    return 0.0;
  };
  return columns_->gather(used, solve, C).columns;
}

Vector SkewColumns::condense(Cholesky& factor, Vector const& z) const {
  return schur_.solve(factor.trailing_factor().triangularView<Eigen::Lower>() * z.tail(schur_.rows()));
}

void SkewColumns::expand(Cholesky& factor, Vector const& surface_load, Vector& z) {
  Dense const& L = factor.trailing_factor();
  auto const first = z.size() - schur_.rows();
  Vector const force = L.triangularView<Eigen::Lower>() * z.tail(schur_.rows());
  Vector const motion = schur_.solve(force + surface_load);
  interior_.setZero(z.size());
  for (auto const& [row, column, value] : entries_)
    if (row < first)
      interior_[row] += value * motion[column];
  factor.forward(interior_);
  z.head(first) -= interior_.head(first);
  z.tail(schur_.rows()) = L.transpose().triangularView<Eigen::Upper>() * motion;
}

} // namespace stiction::linear
