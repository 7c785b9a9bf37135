// The forces of a step beside contact and inertia: weight and loads, cells, springs.
#include <fmt/format.h>

#include "dynamics/bulk/timer.hpp"
#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

/// Weight and prescribed forces at a time, N.
void Stepper::gather_external(double t, Vector& force) const {
  force = bulk_.mass().dead_load;
  for (auto const& load : model_->loads)
    force += load.path.value(t) * load.force;
}

/// F_int(u) of cells and springs; the energy is the cells' own.
solid::Pass Stepper::internal(Vector const& u, double t, Vector& force) const {
  auto const pass = bulk_.internal_force(u, force);
  if (!bulk_.springs().empty())
    bulk_.springs().add_force(u, t, force);
  return pass;
}

/// A(u) v of cells and dashpots.
void Stepper::damping(Instant const& now, Vector& force) const {
  bulk_.damping_force(now.u, now.v, force);
  if (bulk_.springs().damped())
    bulk_.springs().add_damping(now, force);
}

/// F_int(u1) and its energy; false if a cell has turned inside out.
bool Stepper::internal_forces(double t, Outcome& outcome) {
  Timer const timer(cost_.assembly);
  auto const pass = internal(u_, t, internal_);
  ++cost_.force_passes;
  if (!pass.sound()) {
    outcome.verdict = StepVerdict::inverted_cell;
    outcome.reason = fmt::format("{} before it is deformed, turned inside out: it is pressed or sheared too "
                                 "far for its size; give a finer mesh there, less load, or smaller steps",
                                 bulk_.cell_words(pass.inverted_cell));
    return false;
  }
  strain_ = pass.energy;
  return true;
}

} // namespace stiction::dynamics
