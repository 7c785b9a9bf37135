// A reversible adhesion potential of short range along the normal, psi = - w (1 + x/delta) exp(-x/delta).
#pragma once
#include <numbers>

#include "core/schema.hpp"
#include "interface/bond.hpp"

namespace stiction::interface {

struct Potential {
  double w = 0;     ///< work of separation, J/m^2
  double delta = 0; ///< opening at the largest traction w / (e delta), m

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<Potential>{"potential", "reversible normal attraction of short range",
                                  "the potential of Rose, Ferrante, Smith 1981"}
            .number("w", &Potential::w, "J/m^2", core::positive, Need::required, "work of separation")
            .number("delta", &Potential::delta, "m", core::positive, Need::required,
                    "opening at the largest traction, which is w / (e delta)")
            .build();
    return made;
  }
  static constexpr bool evolves = false;
  [[nodiscard]] static bool tangential() { return false; }
  /// Where less than 1e-11 of the strength is left.
  [[nodiscard]] double range() const { return 30 * delta; }
  [[nodiscard]] static bool lasts() { return false; }
  [[nodiscard]] Bond initial(double gap) const {
    double const s = std::min(std::max(gap, 0.0) / delta, 700.0);
    return {(1 + s) * std::exp(-s), {0, 0}};
  }
  [[nodiscard]] Scales scales() const {
    return {w, w / (std::numbers::e * delta), delta, w / (delta * delta) * std::exp(-2.0), 0};
  }
  [[nodiscard]] double steepest_fall(BondStep const&) const { return scales().softening; }
};

template<int D> [[nodiscard]] Adhesion<D> adhere(Potential const& law, BondStep const&, Local<D> const& x) {
  double const s = std::max(x[0], 0.0) / law.delta, part = std::exp(-s);
  Adhesion<D> result;
  result.beta = (1 + s) * part;
  result.traction[0] = -law.w / law.delta * s * part;
  if (x[0] > 0) {
    result.beta_by_x[0] = -s * part / law.delta;
    result.traction_by_x(0, 0) = law.w / (law.delta * law.delta) * (s - 1) * part;
  }
  return result;
}

template<int D> [[nodiscard]] Bond advance(Potential const& law, BondStep const& step, Local<D> const& x) {
  return {adhere<D>(law, step, x).beta, {0, 0}};
}

/// psi, J/m^2.
[[nodiscard]] inline double bond_energy(Potential const& law, Bond const& bond, double) {
  return -law.w * bond.beta;
}

template<int D> [[nodiscard]] double dissipation(Potential const&, BondStep const&, Local<D> const&) {
  return 0;
}

} // namespace stiction::interface
