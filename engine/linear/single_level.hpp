// A level of multigrid as its cycles see it: smoothing by block Gauss-Seidel and the way to the next level,
// in single precision: who preconditions wants no more digits, and half the memory is half the time.
#pragma once
#include <memory>

#include "linear/block_matrix.hpp"
#include "linear/layers.hpp"
#include "linear/packed_rows.hpp"

namespace stiction::linear {

inline constexpr int coarse = 6; ///< unknowns of a coarse node: the modes of its aggregate

/// Nodes of B unknowns. Of the symmetric matrix it has what stands left of the diagonal, and the inverse
/// diagonal blocks; each sweep reads that once, as products of rows and, transposed, of columns.
template<int B> struct SingleLevel {
  using Square = Eigen::Matrix<double, B, B>;
  std::shared_ptr<PackedRows<float, B, B> const> left; ///< of the diagonal
  std::vector<float> inverse; ///< of the diagonal blocks, [nodes B lanes<B>], columns padded
  PackedRows<float, B, coarse> P;
  PackedRows<float, coarse, B> P_transposed;
  Indices place_transposed; ///< of each block of P
  Waves waves; ///< of the nodes; their slabs are two layers deep, so that what rows add to columns of
               ///< other slabs comes from one slab of a wave
  Eigen::VectorXf r, z, rest; ///< padded: load, motion, what of the load is left

  void take_matrix(BlockMatrix<B, B> const& A);
  void take_prolongation(BlockMatrix<B, coarse> const& from);
  void set_inverse(Index i, Square const& block);
  /// Block number k of P.
  void set_prolongation(Index k, Eigen::Matrix<double, B, coarse> const& block);
  /// z from nothing by a sweep forwards, and the rest that it leaves.
  void forwards();
  /// A sweep backwards that ends what `forwards` and the next level began; uses up r.
  void backwards();
  void restrict_to(Eigen::VectorXf& coarse_r);
  void add_prolonged(Eigen::VectorXf const& coarse_z);

private:
  void clear_padding(Eigen::VectorXf& all) const;
  [[nodiscard]] Lanes<float, B> answer(Index i, Eigen::Array<float, B, 1> const& load) const;
};

extern template struct SingleLevel<3>;
extern template struct SingleLevel<coarse>;

} // namespace stiction::linear
