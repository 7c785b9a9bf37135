// H = 1 + F^T K F, K of one block for each point: factored once and kept while few blocks change.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "contact/problem/problem.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

/// Of points that changed, V = L^-1 F^T of their rows = Q R and E = 1 + R dK R^T: then
///   H^-1 = L^-T (1 - Q (1 - E^-1) Q^T) L^-1.
template<int D> class KeptHessian {
public:
  using Blocks = std::vector<LocalMatrix<D>>;

  /// F[dim n, rank] stays where it is.
  explicit KeptHessian(Dense const& F)
      : F_(&F), normal_(F(Eigen::seqN(0, F.rows() / D, D), Eigen::all)),
        widths_(ix(static_cast<Index>(normal_.rows()))) {
    for (std::size_t i = 0; F.cols() > 0 && i < widths_.size(); ++i) {
      auto& width = widths_[i] = static_cast<Index>(F.cols());
      auto const rows = F.template middleRows<D>(D * static_cast<Index>(i));
      while (width > 0 && rows.col(width - 1).isZero(0))
        --width;
    }
  }

  /// Is there an H?
  [[nodiscard]] bool made() const { return !kept_.empty(); }
  void forget() {
    kept_.clear();
    spent_ = 0;
  }

  /// For symmetric K[n]; false, and as it was, where H is not positive definite. slight: change of a block
  /// over what its point resists with, below which it may stay as it is.
  [[nodiscard]] bool set(Blocks const& K, double slight = 0) {
    Indices changed;
    for (std::size_t i = 0; i < kept_.size(); ++i)
      if (K[i] != kept_[i] &&
          !((K[i] - kept_[i]).cwiseAbs().maxCoeff() * base_(static_cast<Index>(i), static_cast<Index>(i)) <=
            slight))
        changed.push_back(static_cast<Index>(i));
    bool const few = made() && 4 * D * static_cast<Index>(changed.size()) <= F_->cols();
    return few ? update(K, changed) : factorize(K);
  }

  /// F_n H^-1 F_n^T [n, n], F_n: the first row of each point.
  [[nodiscard]] Dense const& normal_compliance() const { return M_; }

  /// F_n.
  [[nodiscard]] Dense const& normal() const { return normal_; }
  /// H^-1 g.
  [[nodiscard]] Vector solve(Vector const& g) const {
    Vector y = factor_.matrixL().solve(g);
    if (Q_.cols() > 0)
      y -= Q_ * (T_ * (Q_.transpose() * y));
    return factor_.matrixU().solve(y);
  }

  /// Multiply-adds since this was last asked for, in products of a square matrix of F's rows.
  [[nodiscard]] double spent() { return std::exchange(spent_, 0); }

private:
  void spend(double multiply_adds) {
    auto const n = static_cast<double>(F_->rows());
    spent_ += multiply_adds / (n * n);
  }
  /// Rows of points in blocks, each as wide as it is not zero: F may be a triangle.
  [[nodiscard]] Dense assemble(Blocks const& K) const {
    constexpr std::size_t block = 32;
    Dense H = Dense::Identity(F_->cols(), F_->cols()), scaled;
    for (std::size_t from = 0; F_->cols() > 0 && from < K.size(); from += block) {
      std::size_t const end = std::min(from + block, K.size());
      Index const width = *std::max_element(widths_.begin() + static_cast<long>(from),
                                            widths_.begin() + static_cast<long>(end));
      if (width == 0) // nothing moves these points
        continue;
      auto const first = static_cast<Index>(from);
      auto const rows = F_->block(D * first, 0, D * static_cast<Index>(end - from), width);
      scaled.resize(rows.rows(), width);
      for (std::size_t i = from; i < end; ++i) {
        Index const row = D * static_cast<Index>(i - from);
        scaled.template middleRows<D>(row).noalias() = K[i] * rows.template middleRows<D>(row);
      }
      H.topLeftCorner(width, width).template triangularView<Eigen::Lower>() += rows.transpose() * scaled;
    }
    return H;
  }

  [[nodiscard]] bool factorize(Blocks const& K) {
    Eigen::LLT<Dense> factor(assemble(K));
    if (factor.info() != Eigen::Success)
      return false;
    auto const rank = static_cast<double>(F_->cols()), points = static_cast<double>(K.size());
    spend(rank * rank * (D * points + rank / 3 + points) / 2 + points * points * rank / 2);
    factor_ = std::move(factor);
    kept_ = K;
    auto const n = static_cast<Index>(K.size());
    G_ = factor_.matrixL().solve(normal_.transpose());
    M_.setZero(n, n);
    M_.template selfadjointView<Eigen::Lower>().rankUpdate(G_.transpose());
    M_.template triangularView<Eigen::StrictlyUpper>() = M_.transpose();
    base_ = M_;
    Q_.resize(0, 0);
    return true;
  }

  [[nodiscard]] bool update(Blocks const& K, Indices const& changed) {
    if (changed.empty()) {
      Q_.resize(0, 0);
      M_ = base_;
      return true;
    }
    auto const s = D * static_cast<Index>(changed.size());
    auto const rank = static_cast<double>(F_->cols()), points = static_cast<double>(K.size()),
               m = static_cast<double>(s);
    spend(m * (rank * (rank / 2 + 4 * m + points) + points * (m + points)));
    Dense V(F_->cols(), s);
    for (std::size_t k = 0; k < changed.size(); ++k)
      V.template middleCols<D>(D * static_cast<Index>(k)) =
          F_->template middleRows<D>(D * changed[k]).transpose();
    factor_.matrixL().solveInPlace(V);
    Eigen::HouseholderQR<Dense> const qr(V);
    Dense const R = qr.matrixQR().topRows(s).template triangularView<Eigen::Upper>();
    Dense scaled(s, s); // dK R^T
    for (std::size_t k = 0; k < changed.size(); ++k) {
      Index const row = D * static_cast<Index>(k);
      scaled.template middleRows<D>(row) =
          (K[ix(changed[k])] - kept_[ix(changed[k])]) * R.template middleCols<D>(row).transpose();
    }
    Eigen::LLT<Dense> const small(Dense::Identity(s, s) + R * scaled);
    if (small.info() != Eigen::Success)
      return false;
    Q_ = linear::first_columns(qr.householderQ(), s);
    T_ = Dense::Identity(s, s) - small.solve(Dense::Identity(s, s));
    Dense const Y = G_.transpose() * Q_;
    M_ = base_;
    M_.noalias() -= Y * (T_ * Y.transpose());
    return true;
  }

  Dense const* F_;
  Dense normal_;             ///< F_n
  Indices widths_;           ///< columns of F that are not zero in a point's rows
  Eigen::LLT<Dense> factor_; ///< L, of the blocks kept
  Blocks kept_;
  Dense G_, base_; ///< L^-1 F_n^T and G^T G
  Dense Q_, T_;    ///< T = 1 - E^-1; Q without columns: nothing has changed
  Dense M_;
  double spent_ = 0;
};

} // namespace stiction::contact
