// Mean dilatation at one point of four cells: the strain whose volume change is the cell's mean, and what is
// conjugate to it.
#pragma once
#include "core/pack.hpp"
#include "material/isotropic.hpp"

namespace stiction::solid {

/// Fbar = (theta/J)^(1/3) F, so that Ebar = (a C - I)/2 with a = (theta/J)^(2/3) depends on this point's E
/// and on tau = ln theta (Simo, Taylor and Pister 1985). With small
/// strains Ebar = dev(E) + tau/3 I, tau the mean of tr(E): the same formulas with C = I and a = J = 1 held.
template<int N> struct Dilatation {
  using Voigt = material::Voigt<N, Pack>;
  using VoigtMatrix = material::VoigtMatrix<N, Pack>;

  /// Second derivatives of w(Ebar(E, tau)).
  struct Second {
    VoigtMatrix by_strain;
    Voigt mixed;
    Pack by_tau = 0;
  };

  bool finite = false;
  Voigt C;             ///< strain-like: 11, 22, 33, 2*12, ...
  Voigt inverse;       ///< stress-like C^-1, the derivative of ln J by E
  VoigtMatrix squared; ///< C^-1 (.) C^-1; only where finite
  Pack jacobian = 1, a = 1;

  Dilatation() = default;
  Dilatation(Voigt const& strain, Pack const& J, bool is_finite) : finite(is_finite), jacobian(J) {
    C = is_finite ? Voigt(2 * strain) : Voigt(Voigt::Zero());
    C.template head<3>().array() += 1;
    inverse = C;
    if (is_finite) {
      auto const full_C = material::right_cauchy_green<N>(strain);
      auto const cofactors = material::cofactors<N>(full_C);
      material::Tensor<Pack> const full = cofactors / full_C.row(0).dot(cofactors.row(0));
      inverse = material::stress_vector<N>(full);
      squared = material::symmetric_square<N>(full);
    }
  }

  /// Ebar of the strain E, and a, for the mean dilatation theta, or the mean of tr(E) with small strains.
  [[nodiscard]] Voigt mean_strain(Voigt const& strain, Pack const& theta) {
    Voigt result = strain;
    if (finite) {
      Pack const ratio = cbrt(theta / jacobian);
      a = ratio * ratio;
      result *= a;
    }
    result.template head<3>().array() +=
        finite ? 0.5 * (a - 1) : (theta - strain.template head<3>().sum()) / 3;
    return result;
  }

  /// dEbar/dt = a (Edot + C/3 (taudot - d ln J/dt)).
  [[nodiscard]] Voigt mean_rate(Voigt const& rate, Pack const& tau_rate) const {
    return a * (rate + (tau_rate - inverse.dot(rate)) / 3 * C);
  }
  /// Conjugates to E and to tau of the stress conjugate to Ebar.
  [[nodiscard]] Voigt by_strain(Voigt const& S) const { return a * deviator(S); }
  [[nodiscard]] Pack by_tau(Voigt const& S) const { return a / 3 * S.dot(C); }
  /// dJ/dE and d2J/dE2, of tr(E) with small strains.
  [[nodiscard]] Voigt volume_gradient() const { return jacobian * inverse; }
  [[nodiscard]] VoigtMatrix volume_hessian() const {
    if (!finite)
      return VoigtMatrix::Zero();
    return jacobian * (inverse * inverse.transpose() - 2 * squared);
  }

  /// Second derivatives of the energy with stress S and tangent D at Ebar.
  [[nodiscard]] Second second(Voigt const& S, VoigtMatrix const& D) const {
    Voigt const DC = D * C;
    Pack const curvature = C.dot(DC), b = 2 * a / 3;
    VoigtMatrix const square = inverse * inverse.transpose();
    Second result;
    result.by_strain =
        a * a * (D - (inverse * DC.transpose() + DC * inverse.transpose() - curvature / 3 * square) / 3);
    result.mixed = a * a / 3 * (DC - curvature / 3 * inverse);
    result.by_tau = a * a / 9 * curvature;
    if (finite) {
      Pack const pressure = S.dot(C);
      Voigt const dev = deviator(S);
      result.by_strain += b * (pressure * squared - pressure / 3 * square - dev * inverse.transpose() -
                               inverse * dev.transpose());
      result.mixed += b * dev;
      result.by_tau += b / 3 * pressure;
    }
    return result;
  }

private:
  [[nodiscard]] Voigt deviator(Voigt const& S) const { return S - S.dot(C) / 3 * inverse; }
};

} // namespace stiction::solid
