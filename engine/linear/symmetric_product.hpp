// Products with a symmetric matrix of 3 x 3 blocks, of which half is read.
#pragma once
#include "linear/block_matrix.hpp"
#include "linear/layers.hpp"
#include "linear/packed_rows.hpp"

namespace stiction::linear {

class SymmetricProduct {
public:
  /// waves: of its rows, as of SingleLevel.
  void take(BlockMatrix<3, 3> const& A, Waves const& waves);
  /// y = A x
  void operator()(Vector const& x, Vector& y);

private:
  PackedRows<double, 3, 3> left_; ///< of the diagonal
  std::vector<Matrix3> own_;      ///< the diagonal
  Waves waves_;
  Vector x_, y_; ///< padded
};

} // namespace stiction::linear
