// Blatz-Ko foam rubber: W = G/2 (I2/I3 + 2 sqrt(I3) - 5), Poisson's ratio 1/4.
#pragma once
#include "core/schema.hpp"
#include "material/isotropic.hpp"

namespace stiction::material {

struct BlatzKo {
  double shear_modulus = 0; ///< Pa
  static constexpr bool small_strain = false;
  static constexpr bool linear = false;

  template<class S>
  [[nodiscard]] InvariantEnergy<S> of_invariants(S const& /*I1*/, S const& I2, S const& I3) const {
    using std::sqrt;
    double const half = shear_modulus / 2;
    S const J = sqrt(I3);
    InvariantEnergy<S> W;
    W.energy = half * (I2 / I3 + 2 * J - 5);
    W.first = {0, half / I3, half * (1 / J - I2 / (I3 * I3))};
    W.second = {0, 0, half * (2 * I2 / (I3 * I3 * I3) - 0.5 / (I3 * J)), 0, 0, -half / (I3 * I3)};
    return W;
  }
  template<int N, Wanted wanted = Wanted::tangent, class S>
  [[nodiscard]] Response<N, S> respond(Voigt<N, S> const& strain) const {
    return isotropic<N, wanted>(*this, strain);
  }
  [[nodiscard]] Moduli moduli() const { return {2.5 * shear_modulus, 0.25}; }

  static core::Schema const& schema() {
    static auto const made =
        core::Describe<BlatzKo>{"blatz_ko", "compressible foam rubber, nu = 1/4", "physics.md 4"}
            .number("shear_modulus", &BlatzKo::shear_modulus, "Pa", core::positive, core::Need::required,
                    "shear modulus G at rest")
            .build();
    return made;
  }
};

} // namespace stiction::material
