// Free rigid bodies with an inertia tensor: their torque, rates, energy and loss in a step.
#include "dynamics/model/spin.hpp"

#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

/// Puts the change of their angular momentum into inertia_.
void Stepper::spin(State const& old, double dt) {
  for (std::size_t r = 0; r < model_->rigids.size(); ++r)
    if (auto const& rigid = model_->rigids[r]; tensorial(rigid))
      inertia_.segment<3>(rigid.turn()) = spin_of(*model_, r, old, dt).torque(d_.segment<3>(rigid.turn()));
}

/// What the scheme says of the rates is told in axes that turn with the body in the step.
void Stepper::turn_rates(State const& old, double dt, State& next) const {
  for (std::size_t r = 0; r < model_->rigids.size(); ++r)
    if (auto const& rigid = model_->rigids[r]; tensorial(rigid)) {
      Vec3 const d = d_.segment<3>(rigid.turn());
      next.v.segment<3>(rigid.turn()) = rotation(d) * spin_of(*model_, r, old, dt).rate_before_turn(d);
    }
}

/// Kinetic energy beyond that of the mass matrix, J.
double Stepper::spin_energy(State const& state) const {
  double energy = 0;
  for (std::size_t r = 0; r < model_->rigids.size(); ++r)
    if (auto const& rigid = model_->rigids[r]; tensorial(rigid)) {
      Vec3 const w = state.v.segment<3>(rigid.turn());
      energy += 0.5 * w.dot(inertia_in_space(*model_, r, state) * w - rigid.inertia * w);
    }
  return energy;
}

/// d . (L1 - L0) / dt is the change of energy and this, of which the mass matrix tells nothing, J.
double Stepper::spin_loss(State const& old, State const& next) const {
  double loss = spin_energy(old) - spin_energy(next);
  for (auto const& rigid : model_->rigids)
    if (tensorial(rigid)) {
      Vec3 const before = old.v.segment<3>(rigid.turn()), after = next.v.segment<3>(rigid.turn());
      Vec3 const mean = 0.5 * (next.t - old.t) * (before + after);
      loss += mean.dot(inertia_.segment<3>(rigid.turn())) -
              0.5 * rigid.inertia * (after.squaredNorm() - before.squaredNorm());
    }
  return loss;
}

} // namespace stiction::dynamics
