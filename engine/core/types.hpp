// Array types used across the engine.
#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace stiction {

using Index = std::int32_t;
using Vector = Eigen::VectorXd;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Dense = Eigen::MatrixXd; ///< column-major, for LAPACK-like work
using Matrix3 = Eigen::Matrix3d;
using Indices = std::vector<Index>;
using Point = Eigen::Vector3d; ///< unused components are zero

/// An index as the standard containers want it.
[[nodiscard]] constexpr std::size_t ix(Index i) {
  return static_cast<std::size_t>(i);
}

} // namespace stiction
