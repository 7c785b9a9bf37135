// Compressible neo-Hookean rubber with the volume change split off.
#pragma once
#include "core/schema.hpp"
#include "material/isochoric.hpp"

namespace stiction::material {

/// W = G/2 (J^-2/3 I1 - 3) + K/2 (J - 1)^2, with G and K from Young's modulus and Poisson's ratio at rest.
struct NeoHookean {
  double young = 0;   ///< Pa
  double poisson = 0; ///< 1
  static constexpr bool small_strain = false;
  static constexpr bool linear = false;

  template<class S> [[nodiscard]] Distortion<S> distortion(S const& I1, S const& /*I2*/) const {
    double const half = moduli().shear() / 2;
    return {half * (I1 - 3), half, 0, 0};
  }
  [[nodiscard]] double bulk() const { return moduli().bulk(); }
  template<int N, Wanted wanted = Wanted::tangent, class S>
  [[nodiscard]] Response<N, S> respond(Voigt<N, S> const& strain) const {
    return isochoric<N, wanted>(*this, strain);
  }
  /// Is it known what large strains change of a dent (scene/explain/reach)?
  [[nodiscard]] bool dent_is_measured() const { return true; }
  [[nodiscard]] Moduli moduli() const { return {young, poisson}; }

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<NeoHookean>{"neo_hookean", "rubber, W = G/2 (J^-2/3 I1 - 3) + K/2 (J - 1)^2",
                                   "physics.md 4"}
            .number("young", &NeoHookean::young, "Pa", core::positive, Need::required,
                    "Young's modulus at rest")
            .number("poisson", &NeoHookean::poisson, "1", {-1, 0.5, true, true}, Need::required,
                    "Poisson's ratio at rest")
            .build();
    return made;
  }
};

} // namespace stiction::material
