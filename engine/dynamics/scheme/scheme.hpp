// The time schemes: Jean's first-order scheme with its cures, Newmark's family, Moreau-Jean, central
// differences and quasi-statics. A new one is a struct here and a line in `Scheme`.
#pragma once
#include <variant>

#include "core/error.hpp"
#include "core/schema.hpp"
#include "dynamics/scheme/owed.hpp"
#include "dynamics/scheme/weights.hpp"

namespace stiction::dynamics {

/// Jean's theta-xi scheme. contact_weight and contact_inertia are the cures of physics.md 5; theta = xi =
/// 1/2, contact_weight = 1 and contact_inertia = "full" is the paper's plain scheme.
struct ThetaXi {
  double theta = 0.5;
  double xi = 0.5;
  double contact_weight = 1;
  ContactInertia contact_inertia = ContactInertia::implicit;
  ContactLevel contact_level = ContactLevel::position;
  [[nodiscard]] StepWeights weights() const {
    auto weights = theta_weights(theta, xi);
    weights.contact_inertia = contact_inertia;
    weights.skin = contact_inertia == ContactInertia::cells && xi < 1;
    weights.contact = contact_inertia == ContactInertia::full ? contact_weight : weights.apart_factor();
    weights.contact_work = weights.contact; // others than skins' hand on the mean of R
    weights.level = contact_level;
    return weights;
  }
  [[nodiscard]] static core::Schema const& schema();
};

/// Equilibrium at each step's end; no mass, no damping. Works are trapezia of the forces at both ends.
struct QuasiStatic {
  double stabilisation = 0; ///< 1; of a Model times the duration of the run, s
  void set_duration(double duration) { stabilisation *= duration; }
  [[nodiscard]] StepWeights weights() const {
    StepWeights weights;
    weights.inertia = false;
    weights.work = weights.contact_work = 0.5;
    weights.stabilisation = stabilisation;
    return weights;
  }
  [[nodiscard]] static core::Schema const& schema();
};

/// u1 = u0 + dt v0 + dt^2 ((1/2 - beta) a0 + beta a1), v1 = v0 + dt ((1 - gamma) a0 + gamma a1), balance at
/// the step's end (Newmark 1959). Second order for gamma = 1/2.
struct Newmark {
  double beta = 0.25, gamma = 0.5;
  ContactInertia contact_inertia = ContactInertia::implicit;
  ContactLevel contact_level = ContactLevel::position;
  [[nodiscard]] StepWeights weights() const {
    return NewmarkFamily{beta, gamma, 0, 0}.weights(contact_inertia, contact_level);
  }
  [[nodiscard]] core::Complaints check() const; ///< 2 beta >= gamma, below which it is not always stable
  [[nodiscard]] static core::Schema const& schema();
};

/// Second order with the spectral radius rho_inf left to endless frequencies (Chung, Hulbert 1993).
struct GeneralisedAlpha {
  double rho_inf = 0.8;
  ContactInertia contact_inertia = ContactInertia::implicit;
  ContactLevel contact_level = ContactLevel::position;
  [[nodiscard]] NewmarkFamily family() const {
    double const m = (2 * rho_inf - 1) / (rho_inf + 1), f = rho_inf / (rho_inf + 1);
    return {0.25 * (1 - m + f) * (1 - m + f), 0.5 - m + f, m, f};
  }
  [[nodiscard]] StepWeights weights() const { return family().weights(contact_inertia, contact_level); }
  [[nodiscard]] static core::Schema const& schema();
};

/// M a1 = (1 + alpha) F1 - alpha F0 with beta = (1 - alpha)^2 / 4, gamma = 1/2 - alpha (Hilber, Hughes,
/// Taylor 1977). Second order.
struct Hht {
  double alpha = -0.05;
  ContactInertia contact_inertia = ContactInertia::implicit;
  ContactLevel contact_level = ContactLevel::position;
  [[nodiscard]] StepWeights weights() const {
    return NewmarkFamily{0.25 * (1 - alpha) * (1 - alpha), 0.5 - alpha, 0, -alpha}.weights(contact_inertia,
                                                                                           contact_level);
  }
  [[nodiscard]] static core::Schema const& schema();
};

/// Time stepping of Moreau and Jean: F at theta of the step, impulses at contact such that
/// 0 <= v_n1 + e v_n0  perp  impulse >= 0 (Jean, Comp. Meth. Appl. Mech. Engng 177, 1999).
struct MoreauJean {
  double theta = 0.5;
  double restitution = 0;
  [[nodiscard]] StepWeights weights() const {
    auto weights = theta_weights(theta, theta);
    weights.level = ContactLevel::velocity;
    weights.restitution = restitution;
    return weights;
  }
  [[nodiscard]] static core::Schema const& schema();
};

/// Explicit central differences (velocity Verlet) with a lumped mass; contact impulses are exact and such
/// that the gap at the step's end is admissible (Carpenter, Taylor, Katona 1991). With v0 free of the last
/// impulse: M (d - dt v0) / dt^2 = F0 / 2 + R, v1 = d / dt + dt M^-1 F1 / 2.
struct CentralDifference {
  [[nodiscard]] StepWeights weights() const {
    StepWeights weights;
    weights.early = weights.work = 0.5;
    weights.xi = 0;
    weights.explicit_forces = true;
    return weights;
  }
  [[nodiscard]] static core::Schema const& schema();
};

using Scheme =
    std::variant<ThetaXi, QuasiStatic, Newmark, GeneralisedAlpha, Hht, MoreauJean, CentralDifference>;
static_assert(core::every<Scheme, owed::OfScheme>);
[[nodiscard]] inline StepWeights weights(Scheme const& scheme) {
  return std::visit([](auto const& s) { return s.weights(); }, scheme);
}
/// Tells a scheme that asks for it how long the run is, s.
inline void set_duration(Scheme& scheme, double duration) {
  std::visit(
      [&](auto& s) {
        if constexpr (requires { s.set_duration(duration); })
          s.set_duration(duration);
      },
      scheme);
}

} // namespace stiction::dynamics
