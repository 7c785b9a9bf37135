// Elimination of the bulk and of the geometric stiffness onto the components of the contact points.
#include "dynamics/reduced.hpp"

#include <Eigen/LU>

namespace stiction::dynamics {

void Reduced::clear() {
  rows_ = 0;
  H_.clear();
  K_.clear();
}

void Reduced::add_point(Indices const& unknowns, Eigen::Ref<Dense const> const& H) {
  for (std::size_t j = 0; j < unknowns.size(); ++j)
    for (Eigen::Index i = 0; i < H.rows(); ++i)
      if (double const value = H(i, static_cast<Eigen::Index>(j)); unknowns[j] >= 0 && value != 0)
        H_.push_back({rows_ + static_cast<Index>(i), unknowns[j], value});
  rows_ += static_cast<Index>(H.rows());
}

void Reduced::add_stiffness(Indices const& unknowns, Eigen::Ref<Dense const> const& K) {
  for (std::size_t j = 0; j < unknowns.size(); ++j)
    for (std::size_t i = 0; i < unknowns.size(); ++i)
      if (double const value = K(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
          unknowns[i] >= 0 && unknowns[j] >= 0 && value != 0)
        K_.push_back({unknowns[i], unknowns[j], value});
}

void Reduced::eliminate(Dense const& V, Vector const& y, double weight, Dense& W, Vector& free) {
  Index const n = static_cast<Index>(V.rows()), m = rows_;
  right_.setZero(n, m + 1);
  for (auto const& h : H_)
    right_.col(h.row) += (weight * h.value) * V.col(h.column);
  right_.col(m) = y;
  W.setZero(m, m);
  free.setZero(m);
  for (auto const& h : H_) {
    W.row(h.row) += h.value * right_.row(h.column).head(m);
    free[h.row] += h.value * right_(h.column, m);
  }

  place_.assign(ix(n), -1);
  support_.clear();
  for (auto const& k : K_)
    for (Index const u : {k.row, k.column})
      if (place_[ix(u)] < 0) {
        place_[ix(u)] = static_cast<Index>(support_.size());
        support_.push_back(u);
      }
  auto const s = static_cast<Index>(support_.size());
  motion_.resize(s, m + 1);
  if (s == 0)
    return;
  small_.setIdentity(s, s);
  for (auto const& k : K_)
    for (Index i = 0; i < s; ++i)
      small_(i, place_[ix(k.column)]) -= weight * V(support_[ix(i)], k.row) * k.value;
  for (Index i = 0; i < s; ++i)
    motion_.row(i) = right_.row(support_[ix(i)]);
  Dense const without = motion_.leftCols(m); // weight V H^T on the support
  motion_ = small_.partialPivLu().solve(motion_);
  pushed_.setZero(s, m + 1);
  for (auto const& k : K_)
    pushed_.row(place_[ix(k.row)]) += (weight * k.value) * motion_.row(place_[ix(k.column)]);
  // H V = (weight V H^T)^T / weight, V symmetric
  W.noalias() += (1 / weight) * (without.transpose() * pushed_.leftCols(m));
  free.noalias() += (1 / weight) * (without.transpose() * pushed_.col(m));
}

void Reduced::push(Vector const& force, double weight, Vector& c) const {
  for (auto const& h : H_)
    c[h.column] += weight * h.value * force[h.row];
  if (support_.empty())
    return;
  Vector const extra = pushed_.leftCols(rows_) * force + pushed_.col(rows_);
  for (std::size_t i = 0; i < support_.size(); ++i)
    c[support_[i]] += extra[static_cast<Index>(i)];
}

} // namespace stiction::dynamics
