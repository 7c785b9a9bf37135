// Yeoh rubber: a cubic in the first invariant of the distortion, for the upturn at large stretch.
#pragma once
#include "core/schema.hpp"
#include "material/isochoric.hpp"

namespace stiction::material {

/// W = C10 x + C20 x^2 + C30 x^3 + K/2 (J - 1)^2, x = I1' - 3; shear modulus at rest 2 C10. The distortion
/// softens without bound once C10 + 2 C20 x + 3 C30 x^2 < 0.
struct Yeoh {
  double c10 = 0, c20 = 0, c30 = 0; ///< Pa
  double bulk_modulus = 0;          ///< Pa
  static constexpr bool small_strain = false;
  static constexpr bool linear = false;

  template<class S> [[nodiscard]] Distortion<S> distortion(S const& I1, S const& /*I2*/) const {
    S const x = I1 - 3;
    return {x * (c10 + x * (c20 + x * c30)), c10 + x * (2 * c20 + x * 3 * c30), 0, 2 * c20 + 6 * c30 * x};
  }
  [[nodiscard]] double bulk() const { return bulk_modulus; }
  template<int N, Wanted wanted = Wanted::tangent, class S>
  [[nodiscard]] Response<N, S> respond(Voigt<N, S> const& strain) const {
    return isochoric<N, wanted>(*this, strain);
  }
  [[nodiscard]] Moduli moduli() const { return Moduli::from(2 * c10, bulk_modulus); }

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<Yeoh>{"yeoh", "rubber, W = C10 x + C20 x^2 + C30 x^3 + K/2 (J - 1)^2 with x = I1' - 3",
                             "physics.md 4"}
            .number("C10", &Yeoh::c10, "Pa", core::positive, Need::required,
                    "factor of x, half the shear modulus at rest")
            .number("C20", &Yeoh::c20, "Pa", core::any_number, Need::required, "factor of x^2, often < 0")
            .number("C30", &Yeoh::c30, "Pa", core::any_number, Need::required, "factor of x^3")
            .number("bulk_modulus", &Yeoh::bulk_modulus, "Pa", core::positive, Need::required,
                    "bulk modulus K")
            .build();
    return made;
  }
};

} // namespace stiction::material
