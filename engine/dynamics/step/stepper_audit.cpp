// The scheme's own loss in a step by its formulas, against which the ledger's remainder is held.
#include "dynamics/step/stepper.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::dynamics {

namespace {

interface::BondMove move_of(ContactState const& before, ContactState const& after, double dt) {
  interface::BondMove move {
    {}, interface::opening_of(after.bond, after.gap)
  };
  if (before.bond.beta > 0) // it may be gone by now, and its stretch with it
    move.to.tail<2>() = before.bond.stretch + after.slip;
  move.from = {std::max(before.gap, 0.0), move.to[1] - after.slip[0], move.to[2] - after.slip[1]};
  move.beta_from = before.bond.beta;
  move.beta_to = after.bond.beta;
  move.dt = dt;
  return move;
}

/// Step of a contact point: weight of its end forces in their work, length, s, and what its friction took, J.
struct PointStep {
  double chi, dt, rubbed;
};

struct PointAudit {
  double work = 0, loss = 0; ///< of the forces along gap and slip, and lost by the scheme, J (J/m)
};

/// Of a bond that stays as it is, Pa: an advanced one (History) pulls otherwise than the step that it ended.
Vec3 pull_of(interface::AdhesionLaw const& law, ContactState const& point) {
  interface::BondStep at_rest;
  at_rest.old = point.bond;
  at_rest.dt = 0;
  return interface::adhere<3>(law, at_rest, Vec3(point.gap, 0, 0)).traction;
}

/// A point that leaves the search has no gap any more: what its bond held is let go.
PointAudit audit_point(std::optional<interface::AdhesionLaw> const& adhesion, ContactState before,
                       ContactState const& after, PointStep step) {
  if (before.foot.found() && !after.foot.found())
    return {0, adhesion ? before.area * interface::bond_energy(*adhesion, before.bond, before.gap) : 0};
  double const chi = step.chi;
  before.bond = interface::turned(before.bond, after.spin);
  Vec3 const moved(after.gap - before.gap, after.slip[0], after.slip[1]);
  Vec3 const dry = chi * after.area * after.dry + (1 - chi) * before.area * before.dry;
  Vec3 const pull_0 = before.area * before.adhesion, pull_1 = after.area * after.adhesion;
  Vec3 const pull = (1 - chi) * pull_0 + chi * pull_1;
  double loss = -dry.dot(moved) - step.rubbed - pull.dot(moved);
  if (adhesion && interface::evolves(*adhesion)) {
    auto const move = move_of(before, after, step.dt);
    auto held = after.bond; // a torn one has forgotten its stretch
    held.stretch = move.to.tail<2>();
    loss += 0.5 * (pull_1 + before.area * pull_of(*adhesion, before)).dot(moved) +
            after.area * (interface::integration_loss(*adhesion, move) +
                          interface::bond_energy(*adhesion, held, after.gap) -
                          interface::bond_energy(*adhesion, after.bond, after.gap));
  } else if (adhesion) {
    Vec3 const from(before.gap, 0, 0);
    interface::BondStep const bond{before.bond, step.dt, false};
    loss += 0.5 * (before.area + after.area) * interface::work_along(*adhesion, bond, from, from + moved);
  }
  return {(dry + pull).dot(moved), loss};
}

} // namespace

/// M dv/dt less the mean forces that do the ledger's work, at free unknowns, N; what the schemes say it is:
///   quasi-statics: half of what lacks at the step's start, which ended in balance but for stabilisation
///   contact nodes that balance at the step's end: F1 + R1 less the means
///   Newmark's family: (work - xi) times the change of M a - F - R (zero where each step ends in balance);
///   driven and contact nodes have one acceleration per step
///   central differences: half the last impulse of each of the two steps, physics.md 5
///   Jean's scheme: nothing
Vector Stepper::unmet_balance(State const& old, State const& next) const {
  Index const dofs = model_->dofs();
  double const dt = next.t - old.t;
  Vector const more_force = (external_ - internal_) - (external_old_ - old.internal);
  Vector const more_reaction = next.reaction - old.reaction;
  Vector unmet = Vector::Zero(dofs), newly = Vector::Zero(dofs);
  if (!weights_.inertia)
    unmet = (weights_.work - 1) * (external_old_ - old.internal + old.reaction);
  if (weights_.accelerations()) {
    Vector more_a = next.a - old.a;
    for (Index dof = 0; dof < dofs; ++dof)
      if (driver_[ix(dof)] != nullptr || apart(dof))
        more_a[dof] = 0;
    bulk_.mass().times(more_a, newly);
    unmet = (weights_.work - weights_.xi) * (newly - more_force - more_reaction);
  }
  for (Index dof = 0; dof < dofs; ++dof) {
    if (apart(dof))
      unmet[dof] = (weights_.apart_end() - weights_.work) * more_force[dof] +
                   (1 - weights_.contact_work) * more_reaction[dof];
    else if (weights_.explicit_forces && inverse_mass_[dof] > 0)
      unmet[dof] = 0.5 * next.reaction[dof] - old.kick[dof] / (inverse_mass_[dof] * dt);
  }
  bulk_.links().gather(unmet);
  for (Index dof = 0; dof < dofs; ++dof)
    if (driver_[ix(dof)] != nullptr)
      unmet[dof] = 0;
  return unmet;
}

/// Work of the internal forces along the straight way from u0 to u1, J: of springs and surfaces what they
/// store more, of cells by the Gauss-Lobatto rule of four points, whose error falls with the sixth power of
/// the way, or trapezia where they are linear in u. That of networks that relax is what they store more and
/// dissipate.
double Stepper::path_work(State const& old, State const& next) const {
  double stored = 0, by_others = 0;
  if (!bulk_.springs().empty() || bulk_.surface_loads().stressed()) {
    double before = 0, after = 0;
    by_others = (stored_forces(old.u, old.t, before) + stored_forces(next.u, next.t, after)).dot(d_);
    stored = after - before;
  }
  if (bulk_.relaxing())
    return relaxing_work(old) + stored;
  if (follows_) // the leader's audit tells of both; the rule would take two passes of forces a step
    return strain_ - old.ledger.strain + stored;
  auto const elastic = [this](Vector const& all, Vector const& viscous) {
    return bulk_.damped() ? all.dot(d_) - viscous.dot(d_) : all.dot(d_);
  };
  double const ends = elastic(old.internal, old.damping) + elastic(internal_, damping_) - by_others;
  if (bulk_.linear_bodies())
    return 0.5 * ends + stored;
  return (ends + 5 * work_within(old)) / 12 + stored;
}

/// What the laws' forces at the two inner points of that rule do along the whole way, J.
double Stepper::work_within(State const& old) const {
  double const inner = 0.5 - 0.5 / std::sqrt(5.0);
  Vector first, second;
  static_cast<void>(bulk_.internal_force(old.u + inner * d_, first, Forces::laws));
  static_cast<void>(bulk_.internal_force(old.u + (1 - inner) * d_, second, Forces::laws));
  return (first + second).dot(d_);
}

/// That work where bodies relax, J: of the laws alone, and what networks store more and dissipate.
double Stepper::relaxing_work(State const& old) const {
  Vector first, last;
  double const stored = old.ledger.strain - bulk_.internal_force(old.u, first, Forces::laws).energy;
  static_cast<void>(bulk_.internal_force(u_, last, Forces::laws));
  double const ends = (first + last).dot(d_);
  return (bulk_.linear_bodies() ? 0.5 * ends : (ends + 5 * work_within(old)) / 12) + relaxed_.stored -
         stored + relaxed_.dissipated;
}

/// Loss at the contact points, and what the nodal reactions do beside the work at the points.
void Stepper::audit_contact(State const& old, State& next) const {
  auto& loss = next.ledger.predicted;
  double const chi = weights_.contact_work, dt = next.t - old.t;
  Vector const mean = (1 - chi) * old.reaction + chi * next.reaction;
  double nodes = mean.dot(d_), points = 0;
  for (std::size_t p = 0; p < model_->pairs.size(); ++p) {
    nodes -= obstacle_work(p, old, next);
    for (std::size_t i = 0; i < next.contacts[p].size(); ++i) {
      auto const &before = old.contacts[p][i], &after = next.contacts[p][i];
      auto const point =
          audit_point(model_->pairs[p].law.adhesion, before, after, {chi, dt, rubbed(before, after)});
      points += point.work;
      loss.contact += point.loss;
    }
  }
  loss.turning += points - nodes;
}

/// Sums each step's identity: with d = dt (v0 + v1) / 2 + e, d M dv / dt = change of kinetic energy
/// + e M dv / dt.
void Stepper::audit(State const& old, State& next) const {
  auto& loss = next.ledger.predicted;
  double const omega = weights_.work, dt = next.t - old.t;
  loss.rates -= unmet_balance(old, next).dot(d_);
  if (weights_.inertia)
    loss.rates += (d_ - 0.5 * dt * (old.v + next.v)).dot(inertia_) + spin_loss(old, next);
  else
    loss.rates += (omega - 1) * (next.ledger.stabilisation_loss - old.ledger.stabilisation_loss);
  SpringWork on_paths;
  if (!bulk_.springs().empty())
    on_paths = bulk_.springs().path_work({old.u, old.v, old.t}, {next.u, next.v, next.t}, omega);
  double mean_work = ((1 - omega) * old.internal + omega * internal_).dot(d_) + on_paths.elastic;
  if (bulk_.damped()) {
    double const viscous = ((1 - omega) * old.damping + omega * damping_).dot(d_);
    mean_work -= viscous;
    loss.rates += viscous + on_paths.viscous - (next.ledger.damping_loss - old.ledger.damping_loss) -
                  (next.ledger.dashpot_loss - old.ledger.dashpot_loss);
  }
  if (weights_.skin)
    mean_work += excess_.dot(d_);
  loss.averages += mean_work - path_work(old, next);
  audit_contact(old, next);
}

} // namespace stiction::dynamics
