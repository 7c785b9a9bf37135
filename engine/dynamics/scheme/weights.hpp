// What a time scheme says about one step: the coefficients of its balance of forces and of its rates.
#pragma once

namespace stiction::dynamics {

/// What inertia the nodes of contact surfaces have. full: as all others. implicit: lumped mass and own
/// balance integrated by backward Euler, so that a node that lands stops at once. none: massless, F + R = 0
/// at the step's end. cells: as implicit, with the stress of the cells that these nodes belong to at the
/// step's end for all nodes of these cells, so that what contact nodes lose the others gain.
enum class ContactInertia { full, implicit, none, cells };

/// What the unilateral condition and friction bear on: gap and slip of the step, or their rates at its end.
enum class ContactLevel { position, velocity };

/// Coefficients of one step of size dt from (u0, v0, a0) to u1 = u0 + d (physics.md 5). With e = d - dt v0:
///   v1 = v0 + e / (rate dt) + rate_a dt a0
///   M (e / (mass dt^2) + mass_a a0) = early F0 + xi F1 + (1 - contact) R0 + contact R1,  F = F_ext - F_int -
///   A v
/// The scheme of Jean has rate = mass = theta and no accelerations; quasi-statics leaves M out.
struct StepWeights {
  double rate = 1, rate_a = 0;
  double mass = 1, mass_a = 0;
  double gamma = 0; ///< v1 = v0 + dt ((1 - gamma) a0 + gamma a1); 0: the scheme keeps no accelerations
  double early = 0, xi = 1;          ///< of F at the step's start and end, (44)
  double contact = 1;                ///< of R at the step's end; 1 is (45), xi averages R like F
  double work = 1, contact_work = 1; ///< of the step's end in the mean F and R that do the ledger's work
  bool inertia = true;               ///< false: quasi-static
  bool explicit_forces = false;      ///< F1 is known after the step only; M is lumped
  ContactInertia contact_inertia = ContactInertia::full;
  ContactLevel level = ContactLevel::position;
  double restitution = 0;   ///< e of 0 <= v_n1 + e v_n0, velocity level
  double stabilisation = 0; ///< quasi-static: viscous force over (BulkSystem::grip times velocity), s
  /// The stress of cells with contact nodes stands at the step's end; viscosity and loads remain means. Where
  /// bodies are linear and no normal turns, no step then makes energy, and momentum changes by impulses
  /// alone.
  bool skin = false;
  /// Contact nodes have a balance of their own instead of the weighted one.
  [[nodiscard]] bool surface_apart() const { return inertia && contact_inertia != ContactInertia::full; }
  /// Weight of F1 in that balance, beside the skin's stress, and the factor on its rows that keeps the matrix
  /// symmetric.
  [[nodiscard]] double apart_end() const { return skin ? xi : 1; }
  [[nodiscard]] double apart_factor() const { return xi / apart_end(); }
  [[nodiscard]] bool accelerations() const { return gamma > 0; }
  [[nodiscard]] bool velocity_level() const { return level == ContactLevel::velocity; }
};

/// Jean's scheme: M (v1 - v0) / dt = (1 - xi) F0 + xi F1 + R, d = dt ((1 - theta) v0 + theta v1). (44), (46)
[[nodiscard]] inline StepWeights theta_weights(double theta, double xi) {
  StepWeights weights;
  weights.rate = weights.mass = theta;
  weights.early = 1 - xi;
  weights.xi = weights.work = xi;
  return weights;
}

/// Newmark's beta and gamma with M at 1 - alpha_m and F at 1 - alpha_f of the step (Chung and
/// Hulbert 1993). R stands at the step's end; a contact node that balances by itself has the factor xi on
/// its rows, which keeps the matrix symmetric.
struct NewmarkFamily {
  double beta = 0.25, gamma = 0.5, alpha_m = 0, alpha_f = 0;
  [[nodiscard]] StepWeights weights(ContactInertia inertia, ContactLevel level) const {
    StepWeights weights;
    bool const full = inertia == ContactInertia::full;
    weights.rate = beta / gamma;
    weights.rate_a = 1 - gamma / (2 * beta);
    weights.mass = beta / (1 - alpha_m);
    weights.mass_a = alpha_m - (1 - alpha_m) * (1 / (2 * beta) - 1);
    weights.gamma = gamma;
    weights.early = alpha_f;
    weights.xi = 1 - alpha_f;
    // the right side at index n stands for the mean over the step to alpha_m + gamma of it
    weights.work = alpha_m + gamma - alpha_f;
    weights.contact_work = full ? alpha_m + gamma : 1;
    weights.contact_inertia = inertia;
    weights.contact = full ? 1 : weights.apart_factor();
    weights.level = level;
    return weights;
  }
};

} // namespace stiction::dynamics
