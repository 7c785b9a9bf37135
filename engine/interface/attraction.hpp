// A reversible adhesion along the normal that falls exponentially with the gap, psi = - w exp(-x/range).
#pragma once
#include "core/schema.hpp"
#include "interface/bond.hpp"

namespace stiction::interface {

struct Attraction {
  double w = 0;      ///< work of separation, J/m^2
  double length = 0; ///< opening that leaves 1/e of the largest traction, w / length, m

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<Attraction>{
            "attraction",
            "reversible normal attraction that falls exponentially with the gap, strongest at none",
            "the contact mechanics challenge, Muser 2017"}
            .number("w", &Attraction::w, "J/m^2", core::positive, Need::required, "work of separation")
            .number("range", &Attraction::length, "m", core::positive, Need::required,
                    "opening that leaves 1/e of the largest traction, w / range")
            .build();
    return made;
  }
  static constexpr bool evolves = false;
  [[nodiscard]] static bool tangential() { return false; }
  /// Where less than 1e-11 of the strength is left.
  [[nodiscard]] double range() const { return 26 * length; }
  [[nodiscard]] static bool lasts() { return false; }
  [[nodiscard]] Bond initial(double gap) const {
    return {std::exp(-std::min(std::max(gap, 0.0) / length, 700.0)), {0, 0}};
  }
  [[nodiscard]] Scales scales() const { return {w, w / length, length, w / (length * length), 0}; }
  [[nodiscard]] double steepest_fall(BondStep const&) const { return scales().softening; }
};

template<int D> [[nodiscard]] Adhesion<D> adhere(Attraction const& law, BondStep const&, Local<D> const& x) {
  double const strength = law.w / law.length;
  Adhesion<D> result;
  result.beta = std::exp(-std::max(x[0], 0.0) / law.length);
  result.traction[0] = -strength * result.beta;
  if (x[0] > 0) {
    result.beta_by_x[0] = -result.beta / law.length;
    result.traction_by_x(0, 0) = strength * result.beta / law.length;
  }
  return result;
}

template<int D> [[nodiscard]] Bond advance(Attraction const& law, BondStep const& step, Local<D> const& x) {
  return {adhere<D>(law, step, x).beta, {0, 0}};
}

/// psi, J/m^2.
[[nodiscard]] inline double bond_energy(Attraction const& law, Bond const& bond, double) {
  return -law.w * bond.beta;
}

template<int D> [[nodiscard]] double dissipation(Attraction const&, BondStep const&, Local<D> const&) {
  return 0;
}

} // namespace stiction::interface
