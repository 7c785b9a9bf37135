// Rows of small blocks that are read a register at a time, with vectors padded to registers.
#pragma once
#include <vector>

#include "core/types.hpp"

namespace stiction::linear {

/// Numbers of a register that holds the C unknowns of a node; those beyond are padding.
template<int C> inline constexpr int lanes = C <= 4 ? 4 : 8;
template<class Real, int C> using Lanes = Eigen::Array<Real, lanes<C>, 1>;

template<int C, class Real> [[nodiscard]] Lanes<Real, C> load(Real const* from) {
  return Eigen::Map<Lanes<Real, C> const>(from);
}
template<int C, class Real> void store(Lanes<Real, C> const& values, Real* to) {
  Eigen::Map<Lanes<Real, C>>{to} = values;
}

/// C unknowns of each node, with and without padding.
template<int C, class Real> [[nodiscard]] auto unpadded(Eigen::VectorX<Real>& padded) {
  using All = Eigen::Matrix<Real, lanes<C>, Eigen::Dynamic>;
  return Eigen::Map<All>(padded.data(), lanes<C>, padded.size() / lanes<C>).template topRows<C>();
}
template<int C> [[nodiscard]] auto by_node(Vector& all) {
  return Eigen::Map<Dense>(all.data(), C, all.size() / C);
}
template<int C> [[nodiscard]] auto by_node(Vector const& all) {
  return Eigen::Map<Dense const>(all.data(), C, all.size() / C);
}

/// The way in which rows are gone through: their blocks are read in the same way, as memory likes it.
enum class Way { up, down };

/// R x C blocks in compressed rows. Vectors have lanes<C> numbers for each column of blocks.
template<class Real, int R, int C> class PackedRows {
public:
  using Part = Eigen::Array<Real, R, 1>;
  [[nodiscard]] Index rows() const { return static_cast<Index>(starts_.size()) - 1; }
  void reserve(Index rows, std::size_t blocks) {
    starts_.reserve(ix(rows) + 1);
    column_.reserve(blocks);
    values_.reserve(R * C * blocks + padding);
  }
  template<class Block> void push(Index column, Block const& block) {
    column_.push_back(column);
    values_.resize(R * C * column_.size() + padding);
    set(static_cast<Index>(column_.size()) - 1, block);
  }
  /// Block number k becomes this one.
  template<class Block> void set(Index k, Block const& block) {
    Eigen::Map<Eigen::Matrix<Real, R, C, Eigen::RowMajor>>(values_.data() + R * C * ix(k)) =
        block.template cast<Real>();
  }
  void end_row() { starts_.push_back(static_cast<Index>(column_.size())); }

  /// Row i times x, whose padding has to be zero.
  template<Way way> [[nodiscard]] Part times(Index i, Real const* x) const {
    Lanes<Real, C> sums[R];
    for (auto& sum : sums)
      sum.setZero();
    each<way>(i, [&](Real const* block, Index column) {
      Lanes<Real, C> const part = load<C>(x + lanes<C> * ix(column));
      for (int r = 0; r < R; ++r)
        sums[r] += load<C>(block + C * r) * part;
    });
    Part product;
    for (int r = 0; r < R; ++r)
      product[r] = sums[r].sum();
    return product;
  }
  /// y += (row i)^T z; leaves anything in the padding of y.
  template<Way way> void add_transposed(Index i, Part const& z, Real* y) const {
    each<way>(i, [&](Real const* block, Index column) {
      Real* const at = y + lanes<C> * ix(column);
      Lanes<Real, C> sum = load<C>(at);
      for (int r = 0; r < R; ++r)
        sum += load<C>(block + C * r) * z[r];
      store<C>(sum, at);
    });
  }
  [[nodiscard]] std::size_t numbers() const { return values_.size(); }

private:
  static constexpr std::size_t padding = 8; ///< what the last register reads beyond its block

  template<Way way, class Act> void each(Index i, Act const& act) const {
    Index const first = starts_[ix(i)], end = starts_[ix(i) + 1];
    for (Index n = 0; n < end - first; ++n) {
      Index const k = way == Way::up ? first + n : end - 1 - n;
      act(values_.data() + R * C * ix(k), column_[ix(k)]);
    }
  }

  Indices starts_{0};        ///< [rows + 1], first block of each row
  Indices column_;           ///< [blocks]
  std::vector<Real> values_; ///< each block row by row, and padding
};

} // namespace stiction::linear
