// How displacement gradients become strain, and stress becomes force, in each kinematics: of four cells at
// once.
#pragma once
#include "core/pack.hpp"
#include "material/response.hpp"
#include "solid/body.hpp"

namespace stiction::solid {

/// Fixed sizes: `width` derivatives per displacement component: by each coordinate, and when axisymmetric
/// N/R as a third one, which acts on the radial component only.
template<Kinematics kinematics> struct Geometry {
  static constexpr bool axisymmetric = kinematics == Kinematics::axisymmetric;
  static constexpr bool spatial = kinematics == Kinematics::three_dimensional;
  static constexpr int dim = dimension(kinematics);
  static constexpr int width = axisymmetric ? 3 : dim;
  static constexpr int voigt = stress_components(kinematics);
  static constexpr int pairs = dim * (dim + 1) / 2; ///< of components i >= j
  using Strain = material::Voigt<voigt, Pack>;
  using Tensor = Eigen::Matrix<Pack, 3, 3>;
  using Row = Eigen::Matrix<Pack, width, 1>;
  using Gradient = Eigen::Matrix<Pack, width, dim>; ///< H(B, i) = du_i/dX_B; H(2, 0) = u_r/R

  /// How many of the derivatives act on component i.
  [[nodiscard]] static constexpr int active(int i) { return axisymmetric && i == 1 ? 2 : width; }
  [[nodiscard]] static constexpr int pair(int i, int j) { return i * (i + 1) / 2 + j; }

  /// F = I + H as a full tensor.
  [[nodiscard]] static Tensor deformation(Gradient const& H) {
    Tensor F = Tensor::Identity();
    F.topLeftCorner<dim, dim>() += H.template topRows<dim>().transpose();
    if constexpr (axisymmetric)
      F(2, 2) += H(2, 0);
    return F;
  }

  /// det F, not positive either where the plane is turned over.
  [[nodiscard]] static Pack jacobian(Tensor const& F) {
    Pack const in_plane = F(0, 0) * F(1, 1) - F(0, 1) * F(1, 0);
    if constexpr (axisymmetric)
      return where_positive(in_plane, in_plane * F(2, 2));
    if constexpr (!spatial)
      return in_plane;
    return F(2, 2) * in_plane + F(0, 2) * (F(1, 0) * F(2, 1) - F(1, 1) * F(2, 0)) -
           F(1, 2) * (F(0, 0) * F(2, 1) - F(0, 1) * F(2, 0));
  }

  /// sym(H) + quadratic H^T H: Green-Lagrange strain for quadratic = 1/2, small strain for 0.
  [[nodiscard]] static Strain strain(Gradient const& H, double quadratic) {
    auto const product = [&](int A, int B) { return quadratic * H.row(A).dot(H.row(B)); };
    Strain e;
    e[0] = H(0, 0) + product(0, 0);
    e[1] = H(1, 1) + product(1, 1);
    e[2] = 0;
    e[3] = H(0, 1) + H(1, 0) + 2 * product(0, 1);
    if constexpr (axisymmetric)
      e[2] = H(2, 0) + quadratic * H(2, 0) * H(2, 0);
    if constexpr (spatial) {
      e[2] = H(2, 2) + product(2, 2);
      e[4] = H(1, 2) + H(2, 1) + 2 * product(1, 2);
      e[5] = H(0, 2) + H(2, 0) + 2 * product(0, 2);
    }
    return e;
  }

  /// dE/dt of the velocity gradient V at F.
  [[nodiscard]] static Strain strain_rate(Tensor const& F, Gradient const& V) {
    Eigen::Matrix<Pack, dim, dim> const M =
        V.template topRows<dim>() * F.topLeftCorner<dim, dim>(); // M(A, B) = V_iA F_iB
    Strain e;
    e[0] = M(0, 0);
    e[1] = M(1, 1);
    e[2] = 0;
    e[3] = M(0, 1) + M(1, 0);
    if constexpr (axisymmetric)
      e[2] = F(2, 2) * V(2, 0);
    if constexpr (spatial) {
      e[2] = M(2, 2);
      e[4] = M(1, 2) + M(2, 1);
      e[5] = M(0, 2) + M(2, 0);
    }
    return e;
  }

  /// Row i of F S: what component i's derivatives are multiplied by in the force.
  template<class Stress> [[nodiscard]] static Row pull(Tensor const& F, int i, Stress const& S) {
    Row P;
    if constexpr (spatial) {
      P[0] = S[0] * F(i, 0) + S[3] * F(i, 1) + S[5] * F(i, 2);
      P[1] = S[3] * F(i, 0) + S[1] * F(i, 1) + S[4] * F(i, 2);
      P[2] = S[5] * F(i, 0) + S[4] * F(i, 1) + S[2] * F(i, 2);
    } else {
      P[0] = S[0] * F(i, 0) + S[3] * F(i, 1);
      P[1] = S[3] * F(i, 0) + S[1] * F(i, 1);
      if constexpr (axisymmetric)
        P[2] = i == 0 ? F(2, 2) * S[2] : Pack(0);
    }
    return P;
  }

  /// S between the derivatives of component i, for the geometric stiffness.
  [[nodiscard]] static Eigen::Matrix<Pack, width, width> initial_stress(Strain const& S, int i) {
    Eigen::Matrix<Pack, width, width> T;
    if constexpr (spatial)
      T << S[0], S[3], S[5], S[3], S[1], S[4], S[5], S[4], S[2];
    else if constexpr (axisymmetric)
      T << S[0], S[3], 0, S[3], S[1], 0, 0, 0, i == 0 ? S[2] : Pack(0);
    else
      T << S[0], S[3], S[3], S[1];
    return T;
  }
};

/// The full symmetric tensor of a stress.
template<int N, class S> [[nodiscard]] Eigen::Matrix<S, 3, 3> stress_tensor(material::Voigt<N, S> const& s) {
  S const s23 = N == 6 ? s[N - 2] : S(0), s13 = N == 6 ? s[N - 1] : S(0);
  Eigen::Matrix<S, 3, 3> T;
  T << s[0], s[3], s13, s[3], s[1], s23, s13, s23, s[2];
  return T;
}

} // namespace stiction::solid
