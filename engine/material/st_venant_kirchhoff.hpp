// St Venant-Kirchhoff: Hooke's law between Green-Lagrange strain and second Piola-Kirchhoff stress.
#pragma once
#include "core/schema.hpp"
#include "material/hooke.hpp"

namespace stiction::material {

struct StVenantKirchhoff {
  double young = 0;   ///< Pa
  double poisson = 0; ///< 1
  static constexpr bool small_strain = false;
  static constexpr bool linear = false;

  template<int N, Wanted = Wanted::tangent, class S>
  [[nodiscard]] Response<N, S> respond(Voigt<N, S> const& strain) const {
    return hooke<N>(moduli(), strain);
  }
  [[nodiscard]] Moduli moduli() const { return {young, poisson}; }

  static core::Schema const& schema() {
    using core::Need;
    using Self = StVenantKirchhoff;
    static auto const made =
        core::Describe<Self>{"st_venant_kirchhoff",
                             "large rotations, moderate strains; softens without bound in compression",
                             "(35)"}
            .number("young", &Self::young, "Pa", core::positive, Need::required, "Young's modulus at rest")
            .number("poisson", &Self::poisson, "1", {-1, 0.5, true, true}, Need::required,
                    "Poisson's ratio at rest")
            .build();
    return made;
  }
};

} // namespace stiction::material
