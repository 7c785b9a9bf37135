// Forward and backward substitution, supernode by supernode.
#include "linear/supernodal.hpp"

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

} // namespace stiction::linear
