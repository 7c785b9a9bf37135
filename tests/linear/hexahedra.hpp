// The stiffness of a block of linear elastic hexahedra whose top is held, for the tests of multigrid.
#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "linear/block_matrix.hpp"

namespace stiction::test {

/// cells x cells x cells / 2 of edge 1 / cells and Young's modulus 1; layers from the bottom up.
struct Hexahedra {
  Index cells;
  double poisson = 0.3;
  [[nodiscard]] Index side() const { return cells + 1; }
  [[nodiscard]] Index layers() const { return cells / 2; }
  [[nodiscard]] Index nodes() const { return side() * side() * layers(); }
  [[nodiscard]] Index node(Index i, Index j, Index k) const { return (k * side() + j) * side() + i; }
  [[nodiscard]] Point at(Index node) const {
    Index const area = side() * side();
    return Point(node % side(), node % area / side(), node / area) / cells;
  }
  /// Corners of each cell, -1 for those that are held.
  template<class Visit> void each_cell(Visit&& visit) const {
    for (Index k = 0; k < layers(); ++k)
      for (Index j = 0; j < cells; ++j)
        for (Index i = 0; i < cells; ++i) {
          std::array<Index, 8> corners{};
          for (Index a = 0; a < 8; ++a)
            corners[ix(a)] = k + a / 4 < layers() ? node(i + a % 2, j + a / 2 % 2, k + a / 4) : -1;
          visit(corners);
        }
  }
  [[nodiscard]] Dense cell() const;
  [[nodiscard]] linear::BlockMatrix<3, 3> matrix() const;
  [[nodiscard]] Dense modes() const;
};

/// Stiffness of one cell by its eight quadrature points, [24, 24].
inline Dense Hexahedra::cell() const {
  double const h = 1.0 / cells, lame = poisson / ((1 + poisson) * (1 - 2 * poisson)),
               shear = 0.5 / (1 + poisson), g = 1 / std::sqrt(3.0);
  Dense C = Dense::Zero(6, 6), K = Dense::Zero(24, 24);
  C.topLeftCorner(3, 3).setConstant(lame);
  for (int i = 0; i < 3; ++i) {
    C(i, i) += 2 * shear;
    C(i + 3, i + 3) = shear;
  }
  auto const sign = [](int bits, int axis) { return (bits >> axis) & 1 ? 1.0 : -1.0; };
  for (int q = 0; q < 8; ++q) {
    Dense B = Dense::Zero(6, 24);
    for (int a = 0; a < 8; ++a) {
      Point d;
      for (int i = 0; i < 3; ++i) {
        d[i] = sign(a, i) / (4 * h);
        for (int o = 0; o < 3; ++o)
          d[i] *= o == i ? 1 : 1 + sign(a, o) * sign(q, o) * g;
      }
      for (int i = 0; i < 3; ++i) {
        B(i, 3 * a + i) = d[i];
        B(3 + i, 3 * a + i) = d[(i + 1) % 3];
        B(3 + i, 3 * a + (i + 1) % 3) = d[i];
      }
    }
    K += B.transpose() * C * B * (h * h * h / 8);
  }
  return K;
}

inline linear::BlockMatrix<3, 3> Hexahedra::matrix() const {
  linear::BlockMatrix<3, 3> A;
  A.columns = nodes();
  Index const n = side();
  for (Index row = 0; row < nodes(); ++row) {
    Index const i = row % n, j = row / n % n, k = row / (n * n);
    for (Index c = std::max(0, k - 1); c <= std::min(layers() - 1, k + 1); ++c)
      for (Index b = std::max(0, j - 1); b <= std::min(n - 1, j + 1); ++b)
        for (Index a = std::max(0, i - 1); a <= std::min(n - 1, i + 1); ++a)
          A.column.push_back(node(a, b, c));
    A.end_row();
  }
  A.values.assign(9 * A.column.size(), 0.0);
  Dense const K = cell();
  each_cell([&](auto const& corners) {
    for (int a = 0; a < 8; ++a)
      for (int b = 0; b < 8; ++b)
        if (corners[static_cast<std::size_t>(a)] >= 0 && corners[static_cast<std::size_t>(b)] >= 0)
          A.block(A.find(corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)])) +=
              K.block<3, 3>(3 * a, 3 * b);
  });
  return A;
}

inline Dense Hexahedra::modes() const {
  Dense all = Dense::Zero(3 * nodes(), 6);
  for (Index k = 0; k < nodes(); ++k) {
    auto rows = all.middleRows<3>(3 * k);
    rows.leftCols<3>().setIdentity();
    for (int axis = 0; axis < 3; ++axis)
      rows.col(3 + axis) = Point::Unit(axis).cross(at(k) - Point(0.5, 0.5, 0.25));
  }
  return all;
}

} // namespace stiction::test
