// Mooney-Rivlin rubber: linear in both invariants of the distortion.
#pragma once
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/schema.hpp"
#include "material/isochoric.hpp"

namespace stiction::material {

/// W = C10 (I1' - 3) + C01 (I2' - 3) + K/2 (J - 1)^2; shear modulus at rest 2 (C10 + C01).
struct MooneyRivlin {
  double c10 = 0, c01 = 0; ///< Pa
  double bulk_modulus = 0; ///< Pa
  static constexpr bool small_strain = false;
  static constexpr bool linear = false;

  template<class S> [[nodiscard]] Distortion<S> distortion(S const& I1, S const& I2) const {
    return {c10 * (I1 - 3) + c01 * (I2 - 3), c10, c01, 0};
  }
  [[nodiscard]] double bulk() const { return bulk_modulus; }
  template<int N, Wanted wanted = Wanted::tangent, class S>
  [[nodiscard]] Response<N, S> respond(Voigt<N, S> const& strain) const {
    return isochoric<N, wanted>(*this, strain);
  }
  /// Is it known what large strains change of a dent (scene/explain/reach)?
  [[nodiscard]] bool dent_is_measured() const { return c10 >= 0 && c01 >= 0; }
  [[nodiscard]] Moduli moduli() const { return Moduli::from(2 * (c10 + c01), bulk_modulus); }

  [[nodiscard]] core::Complaints check() const {
    if (c10 + c01 > 0)
      return {};
    return {{"", "C01",
             fmt::format("is {:g} Pa, so that the shear modulus at rest 2 (C10 + C01) is {:g} Pa; it must be "
                         "> 0 Pa: raise C01 above {:g} Pa or C10 above {:g} Pa",
                         c01, 2 * (c10 + c01), -c10, -c01)}};
  }
  static core::Schema const& schema() {
    using core::Need;
    using Self = MooneyRivlin;
    static auto const made =
        core::Describe<Self>{"mooney_rivlin", "rubber, W = C10 (I1' - 3) + C01 (I2' - 3) + K/2 (J - 1)^2",
                             "physics.md 4"}
            .number("C10", &Self::c10, "Pa", core::any_number, Need::required, "factor of I1' - 3")
            .number("C01", &Self::c01, "Pa", core::any_number, Need::required,
                    "factor of I2' - 3; the shear modulus at rest is 2 (C10 + C01) > 0")
            .number("bulk_modulus", &Self::bulk_modulus, "Pa", core::positive, Need::required,
                    "bulk modulus K")
            .build();
    return made;
  }
};

} // namespace stiction::material
