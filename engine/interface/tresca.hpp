// Coulomb friction that cannot exceed a shear strength.
#pragma once
#include "core/schema.hpp"
#include "interface/friction.hpp"

namespace stiction::interface {

struct Tresca {
  double mu = 0;      ///< 1
  double tau_max = 0; ///< Pa

  static core::Schema const& schema() {
    static auto const made =
        core::Describe<Tresca>{"tresca", "friction |r_t| <= min(mu r_n, tau_max)", "Orowan 1943"}
            .number("mu", &Tresca::mu, "1", coefficients, core::Need::required,
                    "friction coefficient at low pressure")
            .number("tau_max", &Tresca::tau_max, "Pa", core::positive, core::Need::required,
                    "shear strength of the interface")
            .build();
    return made;
  }
  static constexpr bool follows = true;
  [[nodiscard]] double mu_from(Status) const { return mu; }
  [[nodiscard]] double steepest_fall(double) const { return 0; }
};

/// min(mu, tau_max / p).
template<int D> [[nodiscard]] Coefficient<D> coefficient(Tresca const& law, Sliding<D> const& at) {
  double const p = at.dry[0];
  Coefficient<D> result{law.mu};
  if (law.mu * p <= law.tau_max)
    return result;
  result.mu = law.tau_max / p;
  result.by_dry[0] = -law.tau_max / (p * p);
  return result;
}

} // namespace stiction::interface
