// Sparse matrices of small dense blocks, one block per pair of nodes.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "core/threads.hpp"

namespace stiction::linear {

inline constexpr Index few_rows = 128; ///< that one thread does best

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
  void push(Index in_column, Block const& block) {
    column.push_back(in_column);
    values.insert(values.end(), block.data(), block.data() + R * C);
  }
  /// Ends a row: all blocks since the last one are its.
  void end_row() { starts.push_back(static_cast<Index>(column.size())); }
  /// Position of block (i, j), which has to be there; columns ascend within a row.
  [[nodiscard]] Index find(Index i, Index j) const {
    auto const first = column.begin() + starts[ix(i)], last = column.begin() + starts[ix(i) + 1];
    return static_cast<Index>(std::lower_bound(first, last, j) - column.begin());
  }
};

/// act(i) for all rows, by all threads.
template<class Act> void each_row(Index rows, Act const& act) {
  core::each_piece(rows, few_rows, [&](Index first, Index last) {
    for (Index i = first; i < last; ++i)
      act(i);
  });
}

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
  each_row(A.rows(), [&](Index i) { y.segment<R>(R * i) += row_times(A, i, x); });
}

/// Where the blocks of each column are, by ascending rows.
struct Columns {
  Indices starts;     ///< [columns + 1]
  Indices row, place; ///< [blocks]
};

template<int R, int C> [[nodiscard]] Columns columns_of(BlockMatrix<R, C> const& A) {
  Columns made{Indices(ix(A.columns) + 1, 0), Indices(A.column.size()), Indices(A.column.size())};
  for (Index const j : A.column)
    ++made.starts[ix(j) + 1];
  for (std::size_t j = 1; j < made.starts.size(); ++j)
    made.starts[j] += made.starts[j - 1];
  Indices next(made.starts.begin(), made.starts.end() - 1);
  for (Index i = 0; i < A.rows(); ++i)
    for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1]; ++k) {
      auto const to = ix(next[ix(A.column[ix(k)])]++);
      made.row[to] = i;
      made.place[to] = k;
    }
  return made;
}

/// y = A^T x
template<int R, int C>
void transposed_product(BlockMatrix<R, C> const& A, Columns const& at, Vector const& x, Vector& y) {
  y.resize(C * A.columns);
  each_row(A.columns, [&](Index j) {
    Eigen::Matrix<double, C, 1> sum = Eigen::Matrix<double, C, 1>::Zero();
    for (Index k = at.starts[ix(j)]; k < at.starts[ix(j) + 1]; ++k)
      sum.noalias() += A.block(at.place[ix(k)]).transpose() * x.segment<R>(R * at.row[ix(k)]);
    y.segment<C>(C * j) = sum;
  });
}

template<int R, int C>
[[nodiscard]] BlockMatrix<C, R> transposed(BlockMatrix<R, C> const& A, Columns const& at) {
  BlockMatrix<C, R> T;
  T.columns = A.rows();
  T.starts = at.starts;
  T.column = at.row;
  T.values.resize(A.values.size());
  each_row(A.columns, [&](Index j) {
    for (Index k = at.starts[ix(j)]; k < at.starts[ix(j) + 1]; ++k)
      T.block(k) = A.block(at.place[ix(k)]).transpose();
  });
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

/// What of a product is wanted: all, or what stands left of the diagonal and on it.
enum class Triangles { both, left };

/// Rows `first` to before `last` of A B alone; columns of B ascend.
template<int R, int K, int C>
[[nodiscard]] BlockMatrix<R, C> rows_of_product(BlockMatrix<R, K> const& A, BlockMatrix<K, C> const& B,
                                                Index first, Index last, Triangles wanted) {
  BlockMatrix<R, C> AB;
  RowOfBlocks<R, C> row(B.columns);
  for (Index i = first; i < last; ++i) {
    for (Index k = A.starts[ix(i)]; k < A.starts[ix(i) + 1]; ++k)
      for (Index l = B.starts[ix(A.column[ix(k)])], end = B.starts[ix(A.column[ix(k)]) + 1];
           l < end && (wanted == Triangles::both || B.column[ix(l)] <= i); ++l)
        row.at(B.column[ix(l)]).noalias() += A.block(k) * B.block(l);
    row.move_to(AB);
  }
  return AB;
}

/// A B, rows in ascending columns.
template<int R, int K, int C>
[[nodiscard]] BlockMatrix<R, C> product(BlockMatrix<R, K> const& A, BlockMatrix<K, C> const& B,
                                        Triangles wanted = Triangles::both) {
  std::vector<BlockMatrix<R, C>> parts(core::most_pieces);
  core::each_piece(A.rows(), few_rows, [&](Index first, Index last) {
    parts[ix(core::piece_of(A.rows(), few_rows, first))] = rows_of_product(A, B, first, last, wanted);
  });
  BlockMatrix<R, C> AB;
  AB.columns = B.columns;
  std::size_t blocks = 0;
  for (auto const& part : parts)
    blocks += part.column.size();
  AB.column.reserve(blocks);
  AB.values.reserve(R * C * blocks);
  for (auto& part : parts) {
    auto const before = static_cast<Index>(AB.column.size());
    AB.column.insert(AB.column.end(), part.column.begin(), part.column.end());
    AB.values.insert(AB.values.end(), part.values.begin(), part.values.end());
    for (Index i = 1; i <= part.rows(); ++i)
      AB.starts.push_back(before + part.starts[ix(i)]);
    part = {}; // its memory is wanted for the next
  }
  return AB;
}

/// The symmetric matrix of which this is what stands left of the diagonal and on it.
template<int B> [[nodiscard]] BlockMatrix<B, B> mirrored(BlockMatrix<B, B> const& left) {
  auto const right = transposed(left, columns_of(left));
  BlockMatrix<B, B> all;
  all.columns = left.columns;
  for (Index i = 0; i < left.rows(); ++i) {
    for (Index k = left.starts[ix(i)]; k < left.starts[ix(i) + 1]; ++k)
      all.push(left.column[ix(k)], left.block(k));
    for (Index k = right.starts[ix(i)]; k < right.starts[ix(i) + 1]; ++k)
      if (right.column[ix(k)] > i)
        all.push(right.column[ix(k)], right.block(k));
    all.end_row();
  }
  return all;
}

/// Rows in another order, or as they are, and columns with other numbers.
template<int R, int C>
[[nodiscard]] BlockMatrix<R, C> renumbered(BlockMatrix<R, C> const& A, Indices const* order,
                                           Indices const& number) {
  BlockMatrix<R, C> B;
  B.columns = A.columns;
  RowOfBlocks<R, C> row(A.columns);
  for (Index i = 0; i < A.rows(); ++i) {
    Index const from = order != nullptr ? (*order)[ix(i)] : i;
    for (Index k = A.starts[ix(from)]; k < A.starts[ix(from) + 1]; ++k)
      row.at(number[ix(A.column[ix(k)])]) = A.block(k);
    row.move_to(B);
  }
  return B;
}

} // namespace stiction::linear
