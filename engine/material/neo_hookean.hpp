// Compressible neo-Hookean rubber with the volume change split off.
#pragma once
#include "core/schema.hpp"
#include "material/isotropic.hpp"

namespace stiction::material {

/// W = G/2 (J^-2/3 I1 - 3) + K/2 (J - 1)^2, with G and K from Young's modulus and Poisson's ratio at rest.
struct NeoHookean {
  double young = 0;   ///< Pa
  double poisson = 0; ///< 1
  static constexpr bool small_strain = false;

  [[nodiscard]] InvariantEnergy of_invariants(double I1, double /*I2*/, double I3) const {
    double const G = moduli().shear(), K = moduli().bulk();
    double const J = std::sqrt(I3), p = std::cbrt(1 / I3); // p = I3^-1/3
    InvariantEnergy W;
    W.energy = G / 2 * (p * I1 - 3) + K / 2 * (J - 1) * (J - 1);
    W.first = {G / 2 * p, 0, -G / 6 * p * I1 / I3 + K / 2 * (1 - 1 / J)};
    W.second = {0, 0, 2 * G / 9 * p * I1 / (I3 * I3) + K / 4 / (I3 * J), 0, -G / 6 * p / I3, 0};
    return W;
  }
  template<int N, Wanted wanted = Wanted::tangent>
  [[nodiscard]] Response<N> respond(Voigt<N> const& strain) const {
    return isotropic<N, wanted>(*this, strain);
  }
  [[nodiscard]] Moduli moduli() const { return {young, poisson}; }

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<NeoHookean>{"neo_hookean", "rubber, W = G/2 (J^-2/3 I1 - 3) + K/2 (J - 1)^2",
                                   "PHYSICS 4"}
            .number("young", &NeoHookean::young, "Pa", core::positive, Need::required,
                    "Young's modulus at rest")
            .number("poisson", &NeoHookean::poisson, "1", {-1, 0.5, true, true}, Need::required,
                    "Poisson's ratio at rest")
            .build();
    return made;
  }
};

} // namespace stiction::material
