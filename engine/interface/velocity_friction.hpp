// Friction whose coefficient goes from a static to a kinetic value with the sliding speed.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/schema.hpp"
#include "interface/friction.hpp"

namespace stiction::interface {

struct VelocityFriction {
  double mu_s = 0, mu_k = 0; ///< at rest and at high speed, 1
  double v_ref = 0;          ///< m/s

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<VelocityFriction>{"velocity", "friction mu_k + (mu_s - mu_k) exp(-|v_t| / v_ref)",
                                         "Tustin 1947; v_t: slip of the step over its length"}
            .number("mu_s", &VelocityFriction::mu_s, "1", coefficients, Need::required, "coefficient at rest")
            .number("mu_k", &VelocityFriction::mu_k, "1", coefficients, Need::required,
                    "coefficient at high speed")
            .number("v_ref", &VelocityFriction::v_ref, "m/s", core::positive, Need::required,
                    "speed over which it changes; one that falls has several answers in steps shorter than p "
                    "(mu_s - mu_k) / (v_ref k), k: stiffness along the surface, which runs remark on")
            .build();
    return made;
  }
  static constexpr bool follows = true;
  [[nodiscard]] double mu_from(Status) const { return mu_s; }
  /// On the first of the slip.
  [[nodiscard]] double steepest_fall(double dt) const { return std::max(mu_s - mu_k, 0.0) / (dt * v_ref); }
};

template<int D> [[nodiscard]] Coefficient<D> coefficient(VelocityFriction const& law, Sliding<D> const& at) {
  auto const slip = at.x.template tail<D - 1>();
  double const way = slip.norm();
  double const change = (law.mu_s - law.mu_k) * std::exp(-way / (at.dt * law.v_ref));
  Coefficient<D> result{law.mu_k + change};
  if (way > 0)
    result.by_x.template tail<D - 1>() = -change / (at.dt * law.v_ref * way) * slip;
  return result;
}

} // namespace stiction::interface
