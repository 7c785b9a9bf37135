// The energy account of a step.
#include "dynamics/step/stepper.hpp"

#include <algorithm>

namespace stiction::dynamics {

namespace {

/// Work of a node's force on an obstacle that is carried and turned, J.
struct Carriage {
  Model const& model;
  RigidBody const& rigid;
  Vec3 carried, turned;
  [[nodiscard]] double work(Index node, State const& end, Vector const& reaction) const {
    Vec3 force = Vec3::Zero(), arm = -rigid.pivot - rigid.offset(end.t);
    for (int c = 0; c < model.dim(); ++c) {
      Index const dof = model.dim() * node + c;
      force[c] = reaction[dof];
      arm[c] += model.reference(node, c) + end.u[dof];
    }
    return force.dot(carried + turned.cross(arm));
  }
};

} // namespace

/// Work of an obstacle that follows a path: what it gives the body it gives where the node is, J.
double Stepper::obstacle_work(std::size_t index, State const& old, State const& next) const {
  auto const& pair = model_->pairs[index];
  auto const* side = std::get_if<RigidSide>(&pair.primary);
  if (side == nullptr || model_->rigids[side->body].free())
    return 0;
  auto const& rigid = model_->rigids[side->body];
  Vec3 const carried = rigid.offset(next.t) - rigid.offset(old.t);
  Vec3 const turned = (rigid.angle.value(next.t) - rigid.angle.value(old.t)) * rigid.axis;
  if (carried.isZero(0) && turned.isZero(0))
    return 0;
  Carriage const carriage{*model_, rigid, carried, turned};
  double const chi = weights_.contact_work;
  double work = 0;
  for (Index const node : pair.nodes())
    work += chi * carriage.work(node, next, next.reaction_of(index)) +
            (1 - chi) * carriage.work(node, old, old.reaction_of(index));
  return work;
}

/// What the bodies' viscosity takes, J: the work of the scheme's mean of its forces, never less than nothing;
/// what these make is the scheme's. At contact nodes, whose d is not dt times the mean rate, d . A d / dt
/// would be more than there is.
double Stepper::viscous_loss(State const& old, State const& next) const {
  Vector first = old.damping, last = damping_;
  if (bulk_.springs().damped()) { // dashpots are in there, too
    bulk_.damping_force(old.u, old.v, first);
    bulk_.damping_force(u_, next.v, last);
  }
  return std::max(0.0, ((1 - weights_.work) * first + weights_.work * last).dot(d_));
}

/// What friction takes of a point in a step, J (J/m): by the scheme's mean of its forces. Without inertia it
/// is always against the slip, by the mean of its sizes where the point slipped before, and else by its size
/// at the end, which it has from when the point begins to slip. A point that opens has none at the end, but
/// for rounding beside its bond.
double Stepper::rubbed(ContactState const& before, ContactState const& after) const {
  double const chi = weights_.contact_work;
  contact::Vec2 const first = before.area * before.dry.tail<2>(), last = after.area * after.dry.tail<2>();
  if (weights_.inertia)
    return -(chi * last + (1 - chi) * first).dot(after.slip);
  if (after.status == interface::Status::open)
    return 0;
  double const size = last.norm();
  bool const goes_on = size > 0 && before.status == interface::Status::slip;
  return -last.dot(after.slip) * (goes_on ? chi + (1 - chi) * first.norm() / size : 1);
}

/// What springs store, what their dashpots took, and what was done on ends that follow paths.
void Stepper::account_springs(State const& old, State& next) const {
  auto& ledger = next.ledger;
  auto const& springs = bulk_.springs();
  Instant const before{old.u, old.v, old.t}, after{next.u, next.v, next.t};
  Vector unused = Vector::Zero(next.u.size());
  ledger.spring = springs.add_force(next.u, next.t, unused);
  auto const work = springs.path_work(before, after, weights_.work);
  ledger.motion_work += work.elastic + work.viscous;
  if (springs.damped())
    ledger.dashpot_loss += springs.damping_loss(before, after, weights_.work);
}

/// Forces of motions that balance the given ones of all else and inertia, N.
void Stepper::drive_against(Vector const& force, Vector& drive) const {
  drive.setZero(force.size());
  for (Index dof = 0; dof < force.size(); ++dof)
    if (driver_[ix(dof)] != nullptr || bulk_.links().follows(dof))
      drive[dof] = inertia_[dof] - force[dof];
  bulk_.links().react(drive, [&](Index dof) { return driver_[ix(dof)] != nullptr; });
}

/// Adds the step to the ledger (physics.md 6); works use the force averages of the scheme.
void Stepper::account(State const& old, State& next) {
  next.onset = onset_;
  auto& ledger = next.ledger;
  double const chi = weights_.contact_work, omega = weights_.work;
  Vector mean_force = (1 - omega) * (external_old_ - old.internal) + omega * (external_ - internal_) +
                      (1 - chi) * old.reaction + chi * reaction_;
  if (weights_.skin)
    mean_force -= excess_;
  drive_against(mean_force, mean_drive_);
  if (weights_.inertia)
    next.drive = mean_drive_;
  else
    drive_against(external_ - internal_ + reaction_, next.drive);
  ledger.motion_work += mean_drive_.dot(d_);
  for (std::size_t p = 0; p < model_->pairs.size(); ++p) {
    for (std::size_t i = 0; i < next.contacts[p].size(); ++i)
      ledger.friction_loss += rubbed(old.contacts[p][i], next.contacts[p][i]);
    ledger.motion_work += obstacle_work(p, old, next);
  }
  auto const& dead_load = bulk_.mass().dead_load;
  ledger.load_work += ((1 - omega) * (external_old_ - dead_load) + omega * (external_ - dead_load)).dot(d_);
  if (bulk_.damped())
    ledger.damping_loss += viscous_loss(old, next);
  if (!bulk_.springs().empty())
    account_springs(old, next);
  ledger.relaxation_loss += relaxed_.dissipated;
  if (bulk_.surface_loads().stressed()) {
    Vector unused = Vector::Zero(next.u.size());
    ledger.surface = bulk_.surface_loads().add_stresses(next.u, unused);
  }
  if (weights_.stabilisation > 0)
    ledger.stabilisation_loss += weights_.stabilisation / (next.t - old.t) * bulk_.grip().dot(d_.cwiseAbs2());
  ledger.strain = strain_;
  ledger.potential = -dead_load.dot(next.u);
  if (!weights_.inertia)
    return;
  Vector momentum;
  bulk_.mass().times(next.v, momentum);
  ledger.kinetic = 0.5 * next.v.dot(momentum) + spin_energy(next);
}

} // namespace stiction::dynamics
