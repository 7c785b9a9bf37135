// From an energy of the invariants of C = F^T F to stress and tangent.
#pragma once
#include <array>
#include <cmath>

#include "material/response.hpp"

namespace stiction::material {

template<class S> using Tensor = Eigen::Matrix<S, 3, 3>;

/// W(I1, I2, I3) with its first and second derivatives; second = (11, 22, 33, 12, 13, 23).
template<class S> struct InvariantEnergy {
  S energy = 0;
  std::array<S, 3> first{};
  std::array<S, 6> second{};
};

/// Symmetric 3x3 tensor from strain: C = I + 2 E.
template<int N, class S>
[[nodiscard]] EIGEN_ALWAYS_INLINE Tensor<S> right_cauchy_green(Voigt<N, S> const& E) {
  Tensor<S> C = Tensor<S>::Identity();
  for (int i = 0; i < 3; ++i)
    C(i, i) += 2 * E[i];
  C(0, 1) = C(1, 0) = E[3];
  if constexpr (N == 6) {
    C(1, 2) = C(2, 1) = E[4];
    C(0, 2) = C(2, 0) = E[5];
  }
  return C;
}

/// Cofactors of a symmetric C: det(C) C^-1.
template<int N, class S> [[nodiscard]] EIGEN_ALWAYS_INLINE Tensor<S> cofactors(Tensor<S> const& C) {
  Tensor<S> A = Tensor<S>::Zero();
  auto const minor = [&](int i, int j, int k, int l) { return C(i, k) * C(j, l) - C(i, l) * C(j, k); };
  A.diagonal() << minor(1, 2, 1, 2), minor(0, 2, 0, 2), minor(0, 1, 0, 1);
  A(0, 1) = A(1, 0) = -minor(0, 2, 1, 2);
  if constexpr (N == 6) {
    A(1, 2) = A(2, 1) = -minor(0, 1, 0, 2);
    A(0, 2) = A(2, 0) = minor(0, 1, 1, 2);
  }
  return A;
}

/// Stress-like Voigt vector of a symmetric tensor.
template<int N, class S> [[nodiscard]] EIGEN_ALWAYS_INLINE Voigt<N, S> stress_vector(Tensor<S> const& T) {
  Voigt<N, S> v;
  v.template head<3>() = T.diagonal();
  v[3] = T(0, 1);
  if constexpr (N == 6) {
    v[4] = T(1, 2);
    v[5] = T(0, 2);
  }
  return v;
}

/// (A (.) A)_ijkl = (A_ik A_jl + A_il A_jk) / 2 as a Voigt matrix acting on engineering strain.
template<int N, class S>
[[nodiscard]] EIGEN_ALWAYS_INLINE VoigtMatrix<N, S> symmetric_square(Tensor<S> const& A) {
  static constexpr std::array<std::array<int, 2>, 6> pair{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
  VoigtMatrix<N, S> M;
  for (std::size_t a = 0; a < N; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      auto const [i, j] = pair[a];
      auto const [k, l] = pair[b];
      M(static_cast<int>(a), static_cast<int>(b)) = M(static_cast<int>(b), static_cast<int>(a)) =
          0.5 * (A(i, k) * A(j, l) + A(i, l) * A(j, k));
    }
  return M;
}

/// S = 2 dW/dC and D = 4 d2W/dC2 for a law that offers `InvariantEnergy<S> of_invariants(I1, I2, I3)`.
template<int N, Wanted wanted, class Law, class S>
[[nodiscard]] Response<N, S> isotropic(Law const& law, Voigt<N, S> const& strain) {
  Tensor<S> const C = right_cauchy_green<N>(strain);
  S const I1 = C.trace();
  Tensor<S> const A = cofactors<N>(C);
  S const I2 = A.trace();
  S const I3 = C.row(0).dot(A.row(0));
  auto const [energy, d, dd] = law.of_invariants(I1, I2, I3);

  // derivatives of I1, I2, I3 by C
  Voigt<N, S> one = Voigt<N, S>::Zero();
  one.template head<3>().setOnes();
  Voigt<N, S> const second = I1 * one - stress_vector<N>(C);
  Voigt<N, S> const cofactor = stress_vector<N>(A);

  Response<N, S> response;
  response.energy = energy;
  response.stress = 2 * (d[0] * one + d[1] * second + d[2] * cofactor);

  if constexpr (wanted == Wanted::stress)
    return response;

  Voigt<N, S> const by1 = dd[0] * one + dd[3] * second + dd[4] * cofactor;
  Voigt<N, S> const by2 = dd[3] * one + dd[1] * second + dd[5] * cofactor;
  Voigt<N, S> const by3 = dd[4] * one + dd[5] * second + dd[2] * cofactor;
  auto& D = response.tangent;
  D.noalias() = one * by1.transpose() + second * by2.transpose() + cofactor * by3.transpose();
  D += d[1] * (one * one.transpose());
  D.diagonal().template head<3>().array() -= d[1];
  D.diagonal().template tail<N - 3>().array() -= 0.5 * d[1];
  D += d[2] / I3 * (cofactor * cofactor.transpose() - symmetric_square<N>(A));
  D *= 4;
  return response;
}

} // namespace stiction::material
