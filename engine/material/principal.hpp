// Laws of the principal stretches: eigenvectors of C, and the tangent where stretches coalesce.
#pragma once
#include <array>
#include <cmath>

#include "material/isotropic.hpp"

namespace stiction::material {

/// C = directions diag(squares) directions^T, in no order; N = 4 keeps direction 3 out of the plane.
struct Principal {
  Eigen::Vector3d squares; ///< of the stretches
  Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();
};

/// One Jacobi rotation that makes C(p, q) vanish (Golub and Van Loan, alg. 8.5.1).
inline void annihilate(Eigen::Matrix3d& C, Eigen::Matrix3d& directions, int p, int q) {
  if (C(p, q) == 0)
    return;
  double const tau = (C(q, q) - C(p, p)) / (2 * C(p, q));
  double const t = (tau >= 0 ? 1 : -1) / (std::abs(tau) + std::hypot(1.0, tau));
  double const c = 1 / std::sqrt(1 + t * t), s = t * c, change = t * C(p, q);
  int const r = 3 - p - q;
  double const rp = C(r, p), rq = C(r, q);
  C(p, p) -= change;
  C(q, q) += change;
  C(p, q) = C(q, p) = 0;
  C(r, p) = C(p, r) = c * rp - s * rq;
  C(r, q) = C(q, r) = s * rp + c * rq;
  Eigen::Vector3d const old = directions.col(p);
  directions.col(p) = c * old - s * directions.col(q);
  directions.col(q) = s * old + c * directions.col(q);
}

/// Jacobi's method: exact to rounding however near the eigenvalues are.
template<int N> [[nodiscard]] Principal principal(Eigen::Matrix3d C) {
  Principal result;
  auto const off = [&] { return C(0, 1) * C(0, 1) + C(0, 2) * C(0, 2) + C(1, 2) * C(1, 2); };
  annihilate(C, result.directions, 0, 1);
  double const negligible = 1e-34 * C.squaredNorm();
  for (int sweep = 0; N == 6 && sweep < 10 && off() > negligible; ++sweep) {
    annihilate(C, result.directions, 0, 2);
    annihilate(C, result.directions, 1, 2);
    annihilate(C, result.directions, 0, 1);
  }
  result.squares = C.diagonal();
  return result;
}

/// sym(a (x) b) as a stress-like vector.
template<int N> [[nodiscard]] Voigt<N> dyad(Eigen::Vector3d const& a, Eigen::Vector3d const& b) {
  Voigt<N> v;
  v.template head<3>() = a.cwiseProduct(b);
  v[3] = 0.5 * (a[0] * b[1] + a[1] * b[0]);
  if constexpr (N == 6) {
    v[4] = 0.5 * (a[1] * b[2] + a[2] * b[1]);
    v[5] = 0.5 * (a[0] * b[2] + a[2] * b[0]);
  }
  return v;
}

/// What a law answers in terms of the logarithms e_i of the stretches.
struct PrincipalEnergy {
  double energy = 0;
  Eigen::Vector3d kirchhoff; ///< t_i = dW/de_i
  Eigen::Matrix3d tangent;   ///< dt_i/de_j
  Eigen::Vector3d gaps;      ///< t_j - t_i of the pairs 12, 23, 13; of full relative accuracy however small
};

/// The pairs (i, j) of shear components 12, 23, 13.
inline constexpr std::array<std::array<int, 2>, 3> pairs{{{0, 1}, {1, 2}, {0, 2}}};

/// (S_j - S_i) / (c_j - c_i) of pair k, with its limit where c_i = c_j.
inline double shear_secant(PrincipalEnergy const& W, Eigen::Vector3d const& e, std::size_t k) {
  auto const [i, j] = pairs[k];
  double const ratio = std::expm1(2 * (e[j] - e[i])); // c_j / c_i - 1
  double const slope =
      ratio == 0 ? (W.tangent(j, j) - W.tangent(i, j)) / 2 : W.gaps[static_cast<int>(k)] / ratio;
  return (slope - W.kirchhoff[i]) * std::exp(-2 * (e[i] + e[j]));
}

/// S and D for a law that offers `PrincipalEnergy of_stretches<N, wanted>(e)`; D after Ogden 1984, 6.1.4.
template<int N, Wanted wanted, class Law>
[[nodiscard]] Response<N> of_principal(Law const& law, Voigt<N> const& strain) {
  auto const [c, n] = principal<N>(right_cauchy_green<N>(strain));
  Eigen::Vector3d const e = 0.5 * c.array().log();
  PrincipalEnergy const W = law.template of_stretches<N, wanted>(e);
  Eigen::Vector3d const S = W.kirchhoff.cwiseQuotient(c);
  Eigen::Matrix<double, N, 3> M;
  for (int i = 0; i < 3; ++i)
    M.col(i) = dyad<N>(n.col(i), n.col(i));

  Response<N> response;
  response.energy = W.energy;
  response.stress = M * S;
  if constexpr (wanted == Wanted::stress)
    return response;

  Eigen::Vector3d const inverse = c.cwiseInverse();
  Eigen::Matrix3d L = inverse.asDiagonal() * W.tangent * inverse.asDiagonal();
  L.diagonal() -= 2 * S.cwiseProduct(inverse);
  response.tangent = M * L * M.transpose();
  for (std::size_t k = 0; k < N - 3; ++k) {
    auto const [i, j] = pairs[k];
    Voigt<N> const m = dyad<N>(n.col(i), n.col(j));
    response.tangent += 4 * shear_secant(W, e, k) * (m * m.transpose());
  }
  return response;
}

} // namespace stiction::material
