// Kelvin-Voigt damping: a viscous stress in parallel to any law.
#pragma once
#include "core/schema.hpp"
#include "material/response.hpp"

namespace stiction::material {

/// S_v = 2 eta dev(dE/dt) + zeta tr(dE/dt) I, second Piola-Kirchhoff.
struct KelvinVoigt {
  double shear_viscosity = 0; ///< eta, Pa s
  double bulk_viscosity = 0;  ///< zeta, Pa s

  /// dS_v/d(dE/dt), Pa s; positive semidefinite.
  template<int N> [[nodiscard]] VoigtMatrix<N> viscosity() const {
    VoigtMatrix<N> D = VoigtMatrix<N>::Zero();
    D.template topLeftCorner<3, 3>().setConstant(bulk_viscosity - 2 * shear_viscosity / 3);
    for (int i = 0; i < N; ++i)
      D(i, i) += i < 3 ? 2 * shear_viscosity : shear_viscosity;
    return D;
  }

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<KelvinVoigt>{"kelvin_voigt",
                                    "viscous stress 2 eta dev(dE/dt) + zeta tr(dE/dt) I beside the law's",
                                    "physics.md 4"}
            .number("shear_viscosity", &KelvinVoigt::shear_viscosity, "Pa s", core::non_negative,
                    Need::required, "eta, resists changes of shape")
            .number("bulk_viscosity", &KelvinVoigt::bulk_viscosity, "Pa s", core::non_negative,
                    Need::optional, "zeta, resists changes of volume")
            .build();
    return made;
  }
};

} // namespace stiction::material
