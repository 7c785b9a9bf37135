// Friction whose coefficient falls, or rises, with the pressure.
#pragma once
#include <cmath>

#include "core/schema.hpp"
#include "interface/friction.hpp"

namespace stiction::interface {

/// How the coefficient goes from its value at no pressure to that at high pressure.
enum class PressureDecay { exponential, thirion };

struct PressureFriction {
  double mu_0 = 0, mu_inf = 0; ///< at no and at high pressure, 1
  double p_ref = 0;            ///< Pa
  PressureDecay decay = PressureDecay::exponential;

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<PressureFriction>{"pressure", "coefficient of friction that follows the pressure",
                                         "Thirion 1946, with mu_inf = 0"}
            .number("mu_0", &PressureFriction::mu_0, "1", coefficients, Need::required,
                    "coefficient at no pressure")
            .number("mu_inf", &PressureFriction::mu_inf, "1", coefficients, Need::optional,
                    "coefficient at high pressure")
            .number("p_ref", &PressureFriction::p_ref, "Pa", core::positive, Need::required,
                    "pressure over which it changes")
            .choice("decay", &PressureFriction::decay, {"exponential", "thirion"}, Need::optional,
                    "mu_inf + (mu_0 - mu_inf) exp(-p / p_ref), or the same with 1 / (1 + p / p_ref)")
            .build();
    return made;
  }
  static constexpr bool follows = true;
  [[nodiscard]] double mu_from(Status) const { return mu_0; }
  [[nodiscard]] double steepest_fall(double) const { return 0; }
};

template<int D> [[nodiscard]] Coefficient<D> coefficient(PressureFriction const& law, Sliding<D> const& at) {
  if (at.dry[0] <= 0)
    return {law.mu_0};
  double const s = at.dry[0] / law.p_ref, range = law.mu_0 - law.mu_inf;
  bool const exponential = law.decay == PressureDecay::exponential;
  double const part = exponential ? std::exp(-s) : 1 / (1 + s);
  Coefficient<D> result{law.mu_inf + range * part};
  result.by_dry[0] = -range * (exponential ? part : part * part) / law.p_ref;
  return result;
}

} // namespace stiction::interface
