// Time schemes as coefficients: Jean's first-order scheme with its cures, and quasi-statics.
#pragma once
#include <variant>

#include "core/schema.hpp"

namespace stiction::dynamics {

/// Coefficients of one step (PHYSICS 5): M dv / dt = weighted F + weighted R.
struct StepWeights {
  double theta = 1;              ///< displacement, (46)
  double xi = 1;                 ///< forces F, (44)
  double contact = 1;            ///< reaction R at the step's end; 1 is (45), xi averages R like F
  bool inertia = true;           ///< false: quasi-static
  bool massless_contact = false; ///< no inertia on contact nodes; there F + R = 0 holds at the step's end
};

/// Jean's theta-xi scheme. contact_weight and massless_contact are the cures of PHYSICS 5; theta = xi = 1/2,
/// contact_weight = 1 and massless_contact = false is the paper's plain scheme.
struct ThetaXi {
  double theta = 0.5;
  double xi = 0.5;
  double contact_weight = 0.5;
  bool massless_contact = true;
  [[nodiscard]] StepWeights weights() const {
    return {theta, xi, massless_contact ? xi : contact_weight, true, massless_contact};
  }
  [[nodiscard]] static core::Schema const& schema();
};

/// Equilibrium at each step's end; no mass, no damping.
struct QuasiStatic {
  [[nodiscard]] StepWeights weights() const { return {1, 1, 1, false, false}; }
  [[nodiscard]] static core::Schema const& schema();
};

using Scheme = std::variant<ThetaXi, QuasiStatic>;
[[nodiscard]] inline StepWeights weights(Scheme const& scheme) {
  return std::visit([](auto const& s) { return s.weights(); }, scheme);
}

} // namespace stiction::dynamics
