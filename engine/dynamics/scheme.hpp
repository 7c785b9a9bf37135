// Time schemes as coefficients: Jean's first-order scheme with its cures, and quasi-statics.
#pragma once
#include <variant>

#include "core/schema.hpp"

namespace stiction::dynamics {

/// What inertia the nodes of contact surfaces have. full: as all others. implicit: lumped mass integrated by
/// backward Euler, so that a node that lands stops at once. none: massless, F + R = 0 at the step's end.
enum class ContactInertia { full, implicit, none };

/// Coefficients of one step (PHYSICS 5): M dv / dt = weighted F + weighted R.
struct StepWeights {
  double theta = 1;    ///< displacement, (46)
  double xi = 1;       ///< forces F, (44)
  double contact = 1;  ///< reaction R at the step's end; 1 is (45), xi averages R like F
  bool inertia = true; ///< false: quasi-static
  ContactInertia contact_inertia = ContactInertia::full;
  /// Contact nodes have a balance of their own at the step's end instead of the weighted one.
  [[nodiscard]] bool surface_apart() const { return inertia && contact_inertia != ContactInertia::full; }
};

/// Jean's theta-xi scheme. contact_weight and contact_inertia are the cures of PHYSICS 5; theta = xi = 1/2,
/// contact_weight = 1 and contact_inertia = "full" is the paper's plain scheme.
struct ThetaXi {
  double theta = 0.5;
  double xi = 0.5;
  double contact_weight = 1;
  ContactInertia contact_inertia = ContactInertia::implicit;
  /// Where contact nodes balance at the step's end, their rows carry the factor xi to keep the matrix
  /// symmetric.
  [[nodiscard]] StepWeights weights() const {
    bool const full = contact_inertia == ContactInertia::full;
    return {theta, xi, full ? contact_weight : xi, true, contact_inertia};
  }
  [[nodiscard]] static core::Schema const& schema();
};

/// Equilibrium at each step's end; no mass, no damping.
struct QuasiStatic {
  [[nodiscard]] StepWeights weights() const { return {1, 1, 1, false, ContactInertia::full}; }
  [[nodiscard]] static core::Schema const& schema();
};

using Scheme = std::variant<ThetaXi, QuasiStatic>;
[[nodiscard]] inline StepWeights weights(Scheme const& scheme) {
  return std::visit([](auto const& s) { return s.weights(); }, scheme);
}

} // namespace stiction::dynamics
