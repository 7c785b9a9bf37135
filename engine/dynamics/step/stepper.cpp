// The step: predictor, balance of forces, correction, acceptance, energy account.
#include "dynamics/step/stepper.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "dynamics/bulk/timer.hpp"
#include "linear/decompositions.hpp"

namespace stiction::dynamics {

namespace {
constexpr double refactor_above = 0.2; // contraction per iteration that a kept factor must beat
constexpr double leap = 1e-2;          // of driven nodes, over a cell's size, into which bodies are led

/// What an attempt did not reach; imbalance of the bodies, N. A point's residual is infinite where the last
/// problem did not hold it.
std::string unmet(Outcome const& outcome, double imbalance) {
  if (!std::isfinite(imbalance))
    return "with forces beyond all numbers";
  if (!std::isfinite(outcome.out_of_balance))
    return "with points still coming into contact or changing their bonding";
  return fmt::format("out of balance by {:.1e} of the largest force", outcome.out_of_balance);
}
} // namespace

core::Schema const& StepControl::schema() {
  using core::Need;
  static auto const made =
      core::Describe<StepControl>{"control", "when a step counts as converged", ""}
          .number("force_tolerance", &StepControl::force_tolerance, "1", {1e-16, 1e-2, false, false},
                  Need::optional, "out-of-balance force and contact residual over the largest nodal force")
          .integer("iterations", &StepControl::iterations, {1, 1000, false, false}, Need::optional,
                   "Newton iterations at most")
          .choice("bulk", &StepControl::bulk, {"automatic", "direct", "multigrid"}, Need::optional,
                  "how loads on the bodies are solved for: by a factor, or by conjugate gradients with "
                  "multigrid, which takes less memory and, of large bodies in space, less time")
          .build();
  return made;
}

Stepper::Stepper(Model const& model, Purpose purpose)
    : model_(&model), weights_(weights(model.scheme)), bulk_(model, weights_, purpose),
      contact_(make_contact_system(model, bulk_)), tunnelling_(model), carried_(model),
      driver_(ix(model.dofs()), nullptr), arms_(arms(model)) {
  learn_of_model();
}

void Stepper::learn_of_model() {
  auto const& model = *model_;
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      driver_[ix(model.dim() * node + motion.component)] = &motion;
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      if (Index const dof = model.dim() * node + motion.component; driver_[ix(dof)] == &motion)
        driven_.push_back(dof);
  apart_.resize(driver_.size());
  for (Index dof = 0; dof < model.dofs(); ++dof)
    if (weights_.surface_apart() && bulk_.surface_dof(dof) && driver_[ix(dof)] == nullptr) {
      own_.push_back(dof);
      apart_[ix(dof)] = 1;
    }
  for (auto const coordinate : model.reference.reshaped())
    extent_ = std::max(extent_, std::abs(coordinate));
  if (weights_.explicit_forces)
    inverse_mass_ = bulk_.mass().diagonal().unaryExpr([](double m) { return m > 0 ? 1 / m : 0.0; });
}

State Stepper::initial() {
  State state;
  Index const dofs = model_->dofs();
  state.u.setZero(dofs);
  state.v = Eigen::Map<Vector const>(model_->velocity.data(), dofs);
  state.reaction.setZero(dofs);
  state.own_reactions.assign(model_->pairs.size() > 1 ? model_->pairs.size() : 0, Vector::Zero(dofs));
  state.drive.setZero(dofs);
  static_cast<void>(internal(state.u, 0, state.internal));
  state.gas = bulk_.surface_loads().gas_pressures(state.u, 0, Gases(model_->gases.size()));
  if (bulk_.damped()) {
    damping({state.u, state.v, 0}, state.damping);
    state.internal += state.damping;
  }
  for (auto const& pair : model_->pairs)
    state.contacts.emplace_back(ix(pair.size()), ContactState{});
  state.on_rigid.resize(model_->rigids.size());
  if (model_->dim() == 3)
    state.turned.assign(model_->rigids.size(), Eigen::Matrix3d::Identity());
  state.memory = bulk_.memory_at_rest();
  start_rates(state);
  contact_->begin(state, 0, 1, true);
  contact_->locate(state.u, true);
  State located = state;
  contact_->finish(state, 1, located);
  for (std::size_t p = 0; p < state.contacts.size(); ++p)
    for (std::size_t i = 0; i < state.contacts[p].size(); ++i) {
      auto& point = state.contacts[p][i];
      point.foot = located.contacts[p][i].foot;
      point.gap = located.contacts[p][i].gap;
      point.rate = located.contacts[p][i].rate;
      point.area = located.contacts[p][i].area;
      if (auto const& adhesion = model_->pairs[p].law.adhesion; adhesion) {
        point.bond =
            interface::initial_bond(*adhesion, point.foot.found() ? point.gap : interface::unreached);
        if (point.foot.found())
          state.ledger.bond += point.area * interface::bond_energy(*adhesion, point.bond, point.gap);
      }
    }
  if (weights_.inertia) {
    bulk_.mass().times(state.v, mass_rate_);
    state.ledger.kinetic = 0.5 * state.v.dot(mass_rate_) + spin_energy(state);
  }
  Vector unused = Vector::Zero(dofs);
  state.ledger.spring = bulk_.springs().add_force(state.u, 0, unused);
  state.ledger.surface = bulk_.surface_loads().add_stresses(state.u, unused);
  state.ledger.start = state.ledger.kinetic + state.ledger.bond + state.ledger.spring + state.ledger.surface;
  if (model_->tallied) {
    state.momenta.pairs.resize(model_->pairs.size());
    state.momenta.forces.resize(model_->pairs.size());
    set_momenta(state);
    for (auto const& body : state.momenta.bodies)
      state.momenta.start += body;
  }
  return state;
}

/// What the scheme keeps beside velocities: M a = F at rest without contact, and no impulse yet.
void Stepper::start_rates(State& state) {
  gather_external(0, external_);
  add_following(state.u, 0, state.gas, external_);
  Vector const force = external_ - state.internal;
  if (weights_.explicit_forces)
    state.kick.setZero(model_->dofs());
  if (!weights_.accelerations())
    return;
  std::vector<bool> held(ix(model_->dofs()));
  for (Index dof = 0; dof < model_->dofs(); ++dof)
    held[ix(dof)] = driver_[ix(dof)] != nullptr || apart(dof);
  state.a = bulk_.mass().solve(force, held);
}

/// First guess: on with the old rates, at rest or as a rigid body, driven unknowns where they are driven.
/// Where those leap out of bodies that are not linear, the first correction takes both there by the tangent.
void Stepper::predict(State const& old, double dt, Start start) {
  double const t1 = old.t + dt;
  d_ = (start == Start::onward ? dt : 0.0) * old.v;
  carried_.guess(old.u, t1, d_);
  lead_.setZero(d_.size());
  each_driven([&](Motion const& motion) { return motion.value(t1); },
              [&](Index dof, double value) { lead_[dof] = value - old.u[dof] - d_[dof]; });
  bulk_.links().follow(d_);
  bulk_.links().follow(lead_);
  leads_ = !bulk_.linear_bodies() && !weights_.explicit_forces &&
           lead_.lpNorm<Eigen::Infinity>() > leap * bulk_.cell_size();
  if (!leads_)
    arrive(old, t1);
  gather_external(old, dt);
  bulk_.remember_from(old.memory, dt);
  if (bulk_.surface_loads().pressed()) {
    prescribed_ = external_;
    gas_old_ = old.gas;
    volumes_.clear();
    add_following(old.u, old.t, gas_old_, external_old_);
  }
  if (weights_.skin)
    bulk_.skin_force(old.u, skin_old_);
  contact_->begin(old, t1, dt, start != Start::unturned);
  previous_imbalance_ = std::numeric_limits<double>::infinity();
  previous_worst_ = previous_imbalance_;
  slow_ = 0;
  mixes_ = false;
  mixing_.clear();
}

/// Puts driven unknowns where they are driven.
void Stepper::arrive(State const& old, double t1) {
  each_driven([&](Motion const& motion) { return motion.value(t1); },
              [&](Index dof, double value) { d_[dof] = value - old.u[dof]; });
  bulk_.links().follow(d_);
  leads_ = false;
}

/// rate_change_ = v1 - v0, and inertia_ = M times the acceleration that the balance asks for (StepWeights).
void Stepper::accelerate(State const& old, double dt) {
  double const t1 = old.t + dt;
  gained_ = d_ - dt * old.v;
  if (old.kick.size() > 0)
    gained_ += dt * old.kick;
  rate_change_ = gained_ / (weights_.rate * dt);
  if (weights_.accelerations())
    rate_change_ += weights_.rate_a * dt * old.a;
  for (Index const dof : own_)
    rate_change_[dof] = gained_[dof] / dt;
  gained_ /= weights_.mass * dt;
  if (weights_.accelerations())
    gained_ += weights_.mass_a * dt * old.a;
  for (Index const dof : own_)
    gained_[dof] = rate_change_[dof];
  each_driven([&](Motion const& motion) { return motion.rate_before(t1); },
              [&](Index dof, double rate) { rate_change_[dof] = gained_[dof] = rate - old.v[dof]; });
  bulk_.links().follow(rate_change_);
  bulk_.links().follow(gained_);
  bulk_.mass().times(gained_, inertia_);
  inertia_ /= dt;
  spin(old, dt);
}

/// unbalanced_ = inertia - weighted F - earlier R: what the present reaction has to balance, (48)-(51).
bool Stepper::balance(State const& old, double dt, Outcome& outcome) {
  u_ = old.u + d_;
  if (weights_.explicit_forces)
    internal_ = old.internal;
  else if (!along_ && !internal_forces(old.t + dt, outcome))
    return false;
  if (leads_) {
    Timer const timer(cost_.assembly);
    look_ahead([&](Vector const& u, Vector& f) { static_cast<void>(internal(u, old.t + dt, f)); }, internal_);
    ++cost_.force_passes;
  }
  follow(old.t + dt);
  if (weights_.inertia)
    accelerate(old, dt);
  else
    inertia_.setZero(d_.size());
  if (bulk_.damped()) {
    Timer const timer(cost_.assembly);
    Vector const rates = old.v + rate_change_;
    damping({u_, rates, old.t + dt}, damping_);
    internal_ += damping_;
  }
  unbalanced_ = inertia_ - weights_.early * (external_old_ - old.internal) -
                weights_.xi * (external_ - internal_) - (1 - weights_.contact) * old.reaction;
  if (weights_.stabilisation > 0)
    unbalanced_ += (weights_.stabilisation / dt) * bulk_.grip().cwiseProduct(d_);
  double const end = weights_.apart_end(), factor = weights_.apart_factor();
  for (Index const dof : own_)
    unbalanced_[dof] = factor * (inertia_[dof] - (1 - end) * (external_old_[dof] - old.internal[dof]) -
                                 end * (external_[dof] - internal_[dof]));
  if (weights_.skin) {
    Timer const timer(cost_.assembly);
    bulk_.skin_force(u_, excess_);
    if (leads_)
      look_ahead([&](Vector const& u, Vector& f) { bulk_.skin_force(u, f); }, excess_);
    excess_ -= skin_old_;
    unbalanced_ += excess_;
  }
  bulk_.links().gather(unbalanced_);
  Timer const timer(cost_.contact);
  contact_->locate(leads_ ? Vector(u_ + lead_) : u_, follows_ || outcome.iterations >= settle_after);
  contact_->reaction(reaction_);
  if (!bulk_.links().empty()) {
    gathered_ = reaction_;
    bulk_.links().gather(gathered_);
  }
  return true;
}

/// One correction with the kept factor if that still contracts, else, or if it leads nowhere, with a fresh
/// one.
bool Stepper::correct(State const& old, double dt, Outcome& outcome) {
  bool const slow = outcome.iterations > 1 && contraction_ > refactor_above;
  bool const keep =
      !bulk_.surface_loads().stiff() && bulk_.take_factor(weights_, dt, cost_) && (bulk_.linear() || !slow);
  if (keep && apply_factor())
    return true;
  if (!keep || !bulk_.linear()) {
    if (!bulk_.factorize(u_, weights_, dt, cost_,
                         {old.t + dt, bulk_.surface_loads().steady(gas_, gas_old_)})) {
      outcome.verdict = StepVerdict::indefinite;
      outcome.reason = "the effective stiffness is not positive definite: what is not held, buckles or "
                       "softens needs inertia or shorter steps";
      return false;
    }
    if (apply_factor())
      return true;
  }
  outcome.verdict = surface_.allFinite() ? StepVerdict::contact_failed : StepVerdict::indefinite;
  outcome.reason =
      surface_.allFinite()
          ? unanswered()
          : "multigrid did not solve for the loads on the bodies: their stiffness is not positive "
            "definite, or too badly conditioned; control.bulk = \"direct\" takes a factor";
  return false;
}

/// Solves for the correction and adds it to the displacement; false if the contact problem was not solved.
bool Stepper::apply_factor() {
  load_correction();
  {
    Timer const timer(cost_.solve);
    surface_ = bulk_.factor().condense(correction_);
  }
  if (!answer_contact())
    return false;
  {
    Timer const timer(cost_.solve);
    bulk_.factor().expand(surface_load_, correction_);
  }
  return take_correction();
}

/// correction_ becomes what is unbalanced, turned about.
void Stepper::load_correction() {
  correction_.resize(bulk_.unknowns());
  for (Index k = 0; k < bulk_.unknowns(); ++k)
    correction_[k] = -unbalanced_[bulk_.dof_of(k)];
}

/// The load of contact on the surface, from the surface's motion without it.
bool Stepper::answer_contact() {
  return surface_.allFinite() &&
         contact_->solve(bulk_.factor(), surface_, weights_.contact, surface_load_, cost_);
}

/// Where the old rates lead nowhere, as when contact has turned them about, a start from rest often does.
/// What nothing resists any more must not drift on with them. And where the turn of normals makes problems
/// with several answers, those without it converge.
Outcome Stepper::step(State const& old, double dt) {
  if (weights_.explicit_forces)
    if (auto refused = too_long(old, dt))
      return *std::move(refused);
  bulk_.recall(old.factors, weights_);
  bool const at_rest = old.v.isZero(0) || model_->held_by_bonds;
  Outcome outcome = attempt(old, dt, at_rest ? Start::rest : Start::onward);
  bool turned = contact_->turned(), overturned = contact_->overturned();
  auto const told = [&](Outcome const& what) { return overturned ? with_remedy(what) : what; };
  auto const again = [&](Start start) {
    int const before = outcome.iterations;
    bulk_.recall({}, weights_); // where one led nowhere its factor is of no use
    outcome = attempt(old, dt, start);
    outcome.iterations += before;
    turned = turned || contact_->turned();
    overturned = overturned || contact_->overturned();
  };
  if (!outcome.converged() && outcome.verdict != StepVerdict::interrupted && !at_rest)
    again(Start::rest);
  if (outcome.verdict != StepVerdict::not_converged || !turned || weights_.inertia)
    return told(outcome);
  Outcome turning = outcome;
  again(Start::unturned);
  if (outcome.converged() || turning.out_of_balance == 0 || turning.out_of_balance > outcome.out_of_balance)
    return told(outcome);
  turning.iterations = outcome.iterations; // what came nearest tells why the step failed
  return told(turning);
}

/// Of a step much too long a stiff viscosity makes energy, or the mean forces of the scheme, which ring: more
/// than the step had to turn over. So does an equilibrium behind a barrier that nothing has pushed the bodies
/// over, as where all bonds are gone that had hardly been pulled. What is wrong, or nothing.
std::string Stepper::makes_energy(State const& old, State const& next) const {
  if (bulk_.unknowns() == 0) // all goes as it is told to
    return "";
  auto const &before = old.ledger, &after = next.ledger;
  auto const change = [&](double Ledger::*part) { return std::abs(after.*part - before.*part); };
  double const rounded =
      1e-14 * bulk_.bodies_stiffness() * bulk_.cell_size() * bulk_.cell_size() +
      1e-9 * (std::abs(after.start) + std::abs(after.motion_work) + std::abs(after.load_work) +
              std::abs(after.potential) + std::abs(after.bond));
  double const there = before.kinetic + std::abs(before.strain) + change(&Ledger::motion_work) +
                       change(&Ledger::load_work) + change(&Ledger::potential) + std::abs(before.spring) +
                       std::abs(before.surface) + change(&Ledger::surface) + rounded;
  auto const loss = [](Ledger const& ledger) {
    return ledger.scheme_loss() + ledger.damping_loss + ledger.dashpot_loss + ledger.relaxation_loss;
  };
  if (weights_.explicit_forces || loss(before) - loss(after) <= there + change(&Ledger::bond))
    return "";
  return weights_.inertia ? "the time scheme made more energy than there was"
                          : "the step went to an equilibrium with more energy than there was and was put in";
}

double Stepper::rounding_energy(State const& state) const {
  if (bulk_.unknowns() == 0)
    return std::numeric_limits<double>::infinity();
  double const eps = std::numeric_limits<double>::epsilon(), last_digit = 8 * eps * extent_, // of positions
      way = state.u.lpNorm<Eigen::Infinity>();
  double const differences = bulk_.linear_bodies() ? 0 : eps * extent_ * extent_; // of stretches from 1
  return bulk_.bodies_stiffness() * (1e-14 * way * way + last_digit * last_digit + differences);
}

/// A correction that turns a cell inside out went too far, not astray: half of it, or half of that, need not.
bool Stepper::shorten(State const& old, double dt, Outcome& outcome) {
  double part = 1;
  mixing_.clear();
  for (int halvings = 0; halvings < 6 && outcome.iterations > 0; ++halvings) {
    part *= 0.5;
    for (Index k = 0; k < bulk_.unknowns(); ++k)
      d_[bulk_.dof_of(k)] -= part * correction_[k];
    bulk_.links().follow(d_);
    if (balance(old, dt, outcome)) {
      outcome.verdict = StepVerdict::not_converged;
      outcome.reason.clear();
      return true;
    }
  }
  return false;
}

Outcome Stepper::attempt(State const& old, double dt, Start start) {
  Outcome outcome;
  start_ = start;
  bool polished = false;
  predict(old, dt, start);
  for (;; ++outcome.iterations, ++cost_.newton_iterations) {
    if (!balance(old, dt, outcome) && !shorten(old, dt, outcome))
      return outcome;
    force_scale_ = std::max({largest_force(internal_), largest_force(old.internal), largest_force(inertia_),
                             contact_->force_scale(), largest_force(external_)});
    double const now = imbalance();
    contraction_ = now / previous_imbalance_;
    watch(outcome);
    previous_imbalance_ = now;
    bool const there = outcome.iterations > 0 && converged(outcome);
    if (leads_others_ && (there || (near(outcome) && !std::exchange(polished, true))))
      if (polish(old, dt, outcome))
        break;
    if (there && !leads_others_)
      break;
    if (outcome.iterations >= model_->control.iterations || !std::isfinite(now)) {
      outcome.reason = fmt::format("{} after {} iterations{}", unmet(outcome, now), outcome.iterations,
                                   come_off(old, now));
      return outcome;
    }
    if (enough_ && enough_()) {
      outcome.verdict = StepVerdict::interrupted;
      outcome.reason =
          fmt::format("left off after {} iterations, {}", outcome.iterations, unmet(outcome, now));
      return outcome;
    }
    if (!correct(old, dt, outcome))
      return outcome;
    if (leads_)
      arrive(old, old.t + dt);
  }
  if (!weights_.explicit_forces || internal_forces(old.t + dt, outcome))
    finish(old, dt, outcome);
  if (!outcome.converged())
    return outcome;
  if (auto made = makes_energy(old, outcome.state); !weights_.inertia)
    outcome.leap = std::move(made);
  else if (!made.empty()) {
    outcome.verdict = StepVerdict::unstable;
    outcome.reason = std::move(made);
  }
  if (auto const pair = tunnelling_.passed(old, outcome.state); !pair.empty()) {
    outcome.verdict = StepVerdict::passed;
    outcome.reason = fmt::format("a point of pair {} went through its counterpart within the step", pair);
  }
  return outcome;
}

void Stepper::finish(State const& old, double dt, Outcome& outcome) {
  auto& next = outcome.state;
  next.t = old.t + dt;
  next.u = u_;
  next.internal = internal_;
  next.gas = bulk_.surface_loads().leaked(next.u, next.t, gas_);
  next.damping = damping_;
  if (bulk_.relaxing()) {
    Timer const timer(cost_.assembly);
    next.memory = bulk_.relax(u_, relaxed_);
    strain_ += relaxed_.stored;
  }
  next.reaction = reaction_;
  next.own_reactions.resize(model_->pairs.size() > 1 ? model_->pairs.size() : 0);
  for (std::size_t pair = 0; pair < next.own_reactions.size(); ++pair)
    contact_->reaction(next.own_reactions[pair], static_cast<int>(pair));
  next.contacts = old.contacts;
  next.turned = old.turned;
  next.ledger = old.ledger;
  next.ledger.bond = 0;
  if (weights_.explicit_forces)
    set_explicit_rates(old, dt, next);
  else
    next.v = weights_.inertia ? Vector(old.v + rate_change_) : Vector(d_ / dt);
  turn_rates(old, dt, next);
  if (weights_.accelerations())
    next.a = ((next.v - old.v) / dt - (1 - weights_.gamma) * old.a) / weights_.gamma;
  for (Index dof = 0; dof < next.a.size(); ++dof)
    if (driver_[ix(dof)] != nullptr || apart(dof))
      next.a[dof] = (next.v[dof] - old.v[dof]) / dt;
  contact_->finish(old, dt, next);
  if (weights_.accelerations() || weights_.explicit_forces) { // the mean acceleration does the work
    bulk_.mass().times(next.v - old.v, inertia_);
    inertia_ /= dt;
  }
  account(old, next);
  if (model_->audited)
    audit(old, next);
  next.factors = bulk_.sources();
  next.critical_step = critical_step_;
  next.critical_age = critical_age_;
  if (model_->tallied)
    tally(old, next);
  outcome.verdict = StepVerdict::converged;
}

} // namespace stiction::dynamics
