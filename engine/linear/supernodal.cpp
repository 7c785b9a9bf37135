// Forward and backward substitution, supernode by supernode.
#include "linear/supernodal.hpp"

#include <algorithm>
#include <array>

namespace stiction::linear {

namespace {

using FactorColumns = Eigen::Map<Dense const, 0, Eigen::OuterStride<>>;
using VectorPart = Eigen::Map<Vector>;

/// Columns with the same rows below: a triangle, and what couples it to `rows`.
struct Supernode {
  FactorColumns triangle, below;
  int first;       ///< of its unknowns
  int const* rows; ///< of `below`
};

Supernode supernode(cholmod_factor const& L, std::size_t number) {
  auto const* super = static_cast<int const*>(L.super);
  auto const* pi = static_cast<int const*>(L.pi);
  auto const* px = static_cast<int const*>(L.px);
  int const columns = super[number + 1] - super[number], all = pi[number + 1] - pi[number];
  auto const* x = static_cast<double const*>(L.x) + px[number];
  Eigen::OuterStride<> const stride(all);
  return {FactorColumns(x, columns, columns, stride),
          FactorColumns(x + columns, all - columns, columns, stride), super[number],
          static_cast<int const*>(L.s) + pi[number] + columns};
}

constexpr int rows_at_once = 4; ///< of numbers that wait in registers

/// under[m] = below own: `Rows` rows at once from `i` on, until fewer are left.
template<int Rows>
Eigen::Index multiply(FactorColumns const& below, Pack const* own, Pack* under, Eigen::Index i) {
  for (; i + Rows <= below.rows(); i += Rows) {
    std::array<Pack, Rows> sum;
    sum.fill(0.0);
    for (Eigen::Index j = 0; j < below.cols(); ++j)
      for (std::size_t k = 0; k < Rows; ++k)
        sum[k] += Pack(below(i + static_cast<Eigen::Index>(k), j)) * own[j];
    std::ranges::copy(sum, under + i);
  }
  return i;
}

/// own[n] -= below^T under: `Columns` columns at once from `j` on, until fewer are left.
template<int Columns>
Eigen::Index take_away(FactorColumns const& below, Pack const* under, Pack* own, Eigen::Index j) {
  for (; j + Columns <= below.cols(); j += Columns) {
    std::array<Pack, Columns> sum;
    sum.fill(0.0);
    for (Eigen::Index i = 0; i < below.rows(); ++i)
      for (std::size_t k = 0; k < Columns; ++k)
        sum[k] += Pack(below(i, j + static_cast<Eigen::Index>(k))) * under[i];
    for (std::size_t k = 0; k < Columns; ++k)
      own[j + static_cast<Eigen::Index>(k)] -= sum[k];
  }
  return j;
}

} // namespace

void solve_lower(cholmod_factor const& L, Vector& b, Vector& work) {
  for (std::size_t k = 0; k < L.nsuper; ++k) {
    auto const [triangle, below, first, rows] = supernode(L, k);
    auto const n = triangle.cols(), m = below.rows();
    VectorPart own(b.data() + first, n), under(work.data(), m);
    for (Eigen::Index j = 0; j < n; ++j) {
      own[j] /= triangle(j, j);
      own.tail(n - j - 1) -= own[j] * triangle.col(j).tail(n - j - 1);
    }
    under.noalias() = below * own;
    for (Eigen::Index i = 0; i < m; ++i)
      b[rows[i]] -= under[i];
  }
}

void solve_upper(cholmod_factor const& L, Vector& b, Vector& work) {
  for (std::size_t k = L.nsuper; k-- > 0;) {
    auto const [triangle, below, first, rows] = supernode(L, k);
    auto const n = triangle.cols(), m = below.rows();
    VectorPart own(b.data() + first, n), under(work.data(), m);
    for (Eigen::Index i = 0; i < m; ++i)
      under[i] = b[rows[i]];
    own.noalias() -= below.transpose() * under;
    for (Eigen::Index j = n; j-- > 0;)
      own[j] = (own[j] - triangle.col(j).tail(n - j - 1).dot(own.tail(n - j - 1))) / triangle(j, j);
  }
}

void solve_lower(cholmod_factor const& L, std::span<Pack> b, std::vector<Pack>& work) {
  work.resize(L.maxesize);
  for (std::size_t k = 0; k < L.nsuper; ++k) {
    auto const [triangle, below, first, rows] = supernode(L, k);
    auto const n = triangle.cols();
    Pack *const own = b.data() + first, *const under = work.data();
    for (Eigen::Index j = 0; j < n; ++j) {
      own[j] /= triangle(j, j);
      for (Eigen::Index i = j + 1; i < n; ++i)
        own[i] -= Pack(triangle(i, j)) * own[j];
    }
    multiply<1>(below, own, under, multiply<rows_at_once>(below, own, under, 0));
    for (Eigen::Index i = 0; i < below.rows(); ++i)
      b[static_cast<std::size_t>(rows[i])] -= under[i];
  }
}

void solve_upper(cholmod_factor const& L, std::span<Pack> b, std::vector<Pack>& work) {
  work.resize(L.maxesize);
  for (std::size_t k = L.nsuper; k-- > 0;) {
    auto const [triangle, below, first, rows] = supernode(L, k);
    Pack *const own = b.data() + first, *const under = work.data();
    for (Eigen::Index i = 0; i < below.rows(); ++i)
      under[i] = b[static_cast<std::size_t>(rows[i])];
    take_away<1>(below, under, own, take_away<rows_at_once>(below, under, own, 0));
    for (Eigen::Index j = triangle.cols(); j-- > 0;) {
      Pack sum = own[j];
      for (Eigen::Index i = j + 1; i < triangle.cols(); ++i)
        sum -= Pack(triangle(i, j)) * own[i];
      own[j] = sum / Pack(triangle(j, j));
    }
  }
}

} // namespace stiction::linear
