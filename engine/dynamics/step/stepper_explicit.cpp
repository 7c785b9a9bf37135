// What the step does for explicit schemes alone: the critical step, and rates once the new forces are known.
#include "dynamics/bulk/critical_step.hpp"
#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

namespace {
constexpr int critical_steps =
    100; // after which the critical step of bodies that are not linear is found anew
} // namespace

/// v1 = d / dt + dt M^-1 (F1 + R) / 2: R, here that of the last step, is the best guess of the next one's.
void Stepper::set_explicit_rates(State const& old, double dt, State& next) const {
  next.kick = 0.5 * dt * inverse_mass_.cwiseProduct(reaction_);
  next.v = d_ / dt + 0.5 * dt * inverse_mass_.cwiseProduct(external_ - internal_) + next.kick;
  for (Index dof = 0; dof < d_.size(); ++dof)
    if (driver_[ix(dof)] != nullptr) {
      next.v[dof] = old.v[dof] + rate_change_[dof];
      next.kick[dof] = 0;
    }
}

/// The stability limit holds for the state it was found for; where bodies are not linear it is found anew
/// from time to time.
std::optional<Outcome> Stepper::too_long(State const& old, double dt) {
  critical_step_ =
      old.critical_age == 0 ? critical_step(*model_, old.u, old.t, old.memory.get()) : old.critical_step;
  critical_age_ = bulk_.linear_bodies() ? 1 : (old.critical_age + 1) % critical_steps;
  if (dt <= critical_step_ * (1 + critical_margin))
    return {};
  Outcome outcome;
  outcome.verdict = StepVerdict::unstable;
  outcome.reason = above_critical(dt, critical_step_);
  return outcome;
}

} // namespace stiction::dynamics
