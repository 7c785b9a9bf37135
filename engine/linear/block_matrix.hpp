// Sparse matrices of small dense blocks, one block per pair of nodes.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace stiction::linear {

/// Rows of R x C blocks, in compressed rows.
template<int R, int C> struct BlockMatrix {
  using Block = Eigen::Matrix<double, R, C>;
  Index columns = 0;            ///< of blocks
  Indices starts{0};            ///< [rows + 1], first block of each row
  Indices column;               ///< [blocks]
  std::vector<double> values{}; ///< [blocks R C], each block column-major

  [[nodiscard]] Index rows() const { return static_cast<Index>(starts.size()) - 1; }
  [[nodiscard]] Eigen::Map<Block const> block(Index k) const {
    return Eigen::Map<Block const>(values.data() + R * C * ix(k));
  }
  [[nodiscard]] Eigen::Map<Block> block(Index k) { return Eigen::Map<Block>(values.data() + R * C * ix(k)); }
  /// Ends a row: all blocks since the last one are its.
  void end_row() { starts.push_back(static_cast<Index>(column.size())); }
  /// Position of block (i, j), which has to be there; columns ascend within a row.
  [[nodiscard]] Index find(Index i, Index j) const {
    auto const first = column.begin() + starts[ix(i)], last = column.begin() + starts[ix(i) + 1];
    return static_cast<Index>(std::lower_bound(first, last, j) - column.begin());
  }
};

/// Blocks `first` to before `last`, of one row, times their parts of x.
template<int R, int C>
[[nodiscard]] Eigen::Matrix<double, R, 1> blocks_times(BlockMatrix<R, C> const& A, Index first, Index last,
                                                       Vector const& x) {
  Eigen::Matrix<double, R, 1> sum = Eigen::Matrix<double, R, 1>::Zero();
  for (Index k = first; k < last; ++k)
    sum.noalias() += A.block(k) * x.segment<C>(C * A.column[ix(k)]);
  return sum;
}

/// One row of A x.
template<int R, int C>
[[nodiscard]] Eigen::Matrix<double, R, 1> row_times(BlockMatrix<R, C> const& A, Index i, Vector const& x) {
  return blocks_times(A, A.starts[ix(i)], A.starts[ix(i) + 1], x);
}

/// y += A x
template<int R, int C> void add_product(BlockMatrix<R, C> const& A, Vector const& x, Vector& y) {
  for (Index i = 0; i < A.rows(); ++i)
    y.segment<R>(R * i) += row_times(A, i, x);
}

/// y += A^T x
template<int R, int C> void add_transposed_product(BlockMatrix<R, C> const& A, Vector const& x, Vector& y) {
  for (Index i = 0; i < A.rows(); ++i)
    for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1]; ++k)
      y.segment<C>(C * A.column[ix(k)]).noalias() += A.block(k).transpose() * x.segment<R>(R * i);
}

template<int R, int C> [[nodiscard]] BlockMatrix<C, R> transposed(BlockMatrix<R, C> const& A) {
  BlockMatrix<C, R> T;
  T.columns = A.rows();
  T.starts.assign(ix(A.columns) + 1, 0);
  for (Index const j : A.column)
    ++T.starts[ix(j) + 1];
  for (std::size_t j = 1; j < T.starts.size(); ++j)
    T.starts[j] += T.starts[j - 1];
  T.column.resize(A.column.size());
  T.values.resize(A.values.size());
  Indices next(T.starts.begin(), T.starts.end() - 1);
  for (Index i = 0; i < A.rows(); ++i)
    for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1]; ++k) {
      Index const to = next[ix(A.column[ix(k)])]++;
      T.column[ix(to)] = i;
      T.block(to) = A.block(k).transpose();
    }
  return T;
}

/// A row of blocks while it is summed up.
template<int R, int C> class RowOfBlocks {
public:
  using Block = Eigen::Matrix<double, R, C>;
  explicit RowOfBlocks(Index columns) : slot_(ix(columns), -1) {}
  /// The sum in this column.
  [[nodiscard]] Block& at(Index column) {
    Index& slot = slot_[ix(column)];
    if (slot < 0) {
      slot = static_cast<Index>(columns_.size());
      columns_.push_back(column);
      sums_.emplace_back(Block::Zero());
    }
    return sums_[ix(slot)];
  }
  /// Moves the row to the end of A, columns ascending.
  void move_to(BlockMatrix<R, C>& A) {
    std::sort(columns_.begin(), columns_.end());
    for (Index const j : columns_) {
      auto const& sum = sums_[ix(std::exchange(slot_[ix(j)], -1))];
      A.column.push_back(j);
      A.values.insert(A.values.end(), sum.data(), sum.data() + R * C);
    }
    A.end_row();
    columns_.clear();
    sums_.clear();
  }

private:
  Indices slot_, columns_; ///< where a column has its sum, or -1; those that have
  std::vector<Block> sums_;
};

/// A B, rows in ascending columns.
template<int R, int K, int C>
[[nodiscard]] BlockMatrix<R, C> product(BlockMatrix<R, K> const& A, BlockMatrix<K, C> const& B) {
  BlockMatrix<R, C> AB;
  AB.columns = B.columns;
  RowOfBlocks<R, C> row(B.columns);
  for (Index i = 0; i < A.rows(); ++i) {
    for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1]; ++k)
      for (Index l = B.starts[ix(A.column[ix(k)])]; l < B.starts[ix(A.column[ix(k)]) + 1]; ++l)
        row.at(B.column[ix(l)]).noalias() += A.block(k) * B.block(l);
    row.move_to(AB);
  }
  return AB;
}

} // namespace stiction::linear
