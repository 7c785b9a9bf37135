// The forces of a step beside contact and inertia: weight and loads, cells, springs, surfaces.
#include <algorithm>
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

/// Of both ends of a step. Without inertia nothing but the step's length could ease weight and loads that act
/// at once: where the first step is cut, they come on along it.
void Stepper::gather_external(State const& old, double dt) {
  double const t1 = old.t + dt;
  onset_ = old.t > 0 ? old.onset : weights_.inertia ? 0 : std::max(onset_, dt);
  gather_external(old.t, external_old_);
  gather_external(t1, external_);
  if (!(old.t > 0 ? old.t < onset_ : t1 < onset_))
    return;
  Vector at_once;
  gather_external(0, at_once);
  external_old_ -= (1 - old.t / onset_) * at_once;
  external_ -= std::max(0.0, 1 - t1 / onset_) * at_once;
}

/// Adds the loads that follow the surface.
void Stepper::add_following(Vector const& u, double t, Gases const& gas, Vector& force) const {
  if (bulk_.surface_loads().pressed())
    bulk_.surface_loads().add_pressures(u, t, gas, force);
}

/// Loads of the step's end where u_ is now.
void Stepper::follow(double t) {
  if (!bulk_.surface_loads().pressed())
    return;
  external_ = prescribed_;
  auto const& loads = bulk_.surface_loads();
  auto volumes = loads.volumes(u_);
  auto const known = loads.balanced(volumes_.empty() ? gas_old_ : gas_, volumes_, volumes);
  gas_ = loads.gas_pressures(u_, t, known);
  volumes_ = std::move(volumes);
  add_following(u_, t, gas_, external_);
  if (leads_)
    look_ahead(
        [&](Vector const& u, Vector& f) {
          f = prescribed_;
          add_following(u, t, loads.gas_pressures(u, t, known), f);
        },
        external_);
}

/// Forces of springs and surface stresses, and the energy that both store.
Vector Stepper::stored_forces(Vector const& u, double t, double& energy) const {
  Vector force = Vector::Zero(u.size());
  energy = bulk_.springs().add_force(u, t, force) + bulk_.surface_loads().add_stresses(u, force);
  return force;
}

/// F_int(u) of cells, springs and surface stresses; the energy is the cells' own.
solid::Pass Stepper::internal(Vector const& u, double t, Vector& force) const {
  auto const pass = bulk_.internal_force(u, force);
  if (!bulk_.springs().empty())
    bulk_.springs().add_force(u, t, force);
  if (bulk_.surface_loads().stressed())
    bulk_.surface_loads().add_stresses(u, force);
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
