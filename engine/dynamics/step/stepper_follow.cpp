// Steps beside another stepper's, whose model differs a little: what derivatives are differences of.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "dynamics/bulk/timer.hpp"
#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

namespace {

constexpr double rounding_of_forces = 1e-12, stalled = 1e-10; // of forces; the latter where no more falls
constexpr double small = 1e-4; // correction, over a cell's size, along which forces are linear

void fail_contact(Outcome& outcome) {
  outcome.verdict = StepVerdict::contact_failed;
  outcome.reason = "its contact problem was not solved";
}

std::vector<bool> nodes_of(std::vector<Motion> const& motions, Index count) {
  std::vector<bool> driven(ix(count), false);
  for (auto const& motion : motions)
    for (Index const node : motion.nodes)
      driven[ix(node)] = true;
  return driven;
}

} // namespace

Stepper::Stepper(Model const& model, Stepper const& lead)
    : model_(&model), follows_(true), weights_(weights(model.scheme)), bulk_(model, weights_, lead.bulk_),
      contact_(make_contact_system(model, bulk_)), tunnelling_(model), carried_(model),
      driver_(ix(model.dofs()), nullptr), arms_(arms(model)) {
  learn_of_model();
  bool const rigid = std::ranges::any_of(model.rigids, [](auto const& one) { return one.free(); });
  bool const plain = !rigid && !bulk_.relaxing() && !bulk_.damped() && bulk_.springs().empty() &&
                     bulk_.surface_loads().empty() && bulk_.links().empty() && !weights_.skin;
  if (plain)
    rim_.emplace(model, nodes_of(model.motions, model.node_count()));
}

/// The last iterations of a leader, from a state near the answer, with one factor of there: those that follow
/// are corrected with it, and what the step leaves undone must not tell it from theirs. Where they lead away
/// all stays as it was. Has the step converged?
bool Stepper::polish(State const& old, double dt, Outcome& outcome) {
  constexpr int most = 3;
  Vector const reached = d_;
  contact_->keep();
  bool better = bulk_.linear() || bulk_.factorize(u_, weights_, dt, cost_,
                                                  {old.t + dt, bulk_.surface_loads().steady(gas_, gas_old_)});
  if (!better)
    bulk_.recall({}, weights_);
  for (int made = 0; better && made < most; ++made) {
    better = apply_factor() && balance(old, dt, outcome);
    ++outcome.iterations;
    ++cost_.newton_iterations;
    if (better && std::max(imbalance(), contact_->residual()) <= stalled * force_scale_)
      break;
  }
  if (better && converged(outcome))
    return true;
  d_ = reached;
  contact_->restore();
  previous_imbalance_ = std::numeric_limits<double>::infinity();
  mixing_.clear();
  outcome.verdict = StepVerdict::not_converged;
  outcome.reason.clear();
  return balance(old, dt, outcome) && converged(outcome);
}

/// The balance after a correction along which forces are linear: internal forces of free nodes are what
/// balances the others, those of driven ones are of the cells there.
bool Stepper::balance_on(State const& old, double dt, Outcome& outcome) {
  Vector const before = internal_;
  outcome.iterations += 1;
  along_ = true;
  bool const good = balance(old, dt, outcome);
  along_ = false;
  if (!good)
    return false;
  Timer const timer(cost_.assembly);
  rim_->internal_force(u_, internal_);
  double gained = 0;
  for (Index k = 0; k < bulk_.unknowns(); ++k) {
    Index const dof = bulk_.dof_of(k);
    // unbalanced_ holds xi times the force before the correction
    internal_[dof] = before[dof] + (weights_.contact * reaction_[dof] - unbalanced_[dof]) / weights_.xi;
    gained += 0.5 * (internal_[dof] + before[dof]) * correction_[k];
  }
  strain_ += gained;
  return true;
}

/// What is wrong with the step as `lead` has made it; false if nothing can be said of it.
bool Stepper::start_after(Stepper& lead, State const& old, double dt, Outcome& outcome) {
  bulk_.borrow_factor(lead.bulk_);
  predict(old, dt, lead.start_ == Start::unturned ? Start::unturned : Start::rest);
  d_ = lead.d_;
  arrive(old, old.t + dt);
  gas_ = lead.gas_;
  volumes_ = lead.volumes_;
  contact_->follow(*lead.contact_);
  return balance(old, dt, outcome);
}

/// What to do about what is wrong now.
Stepper::Next Stepper::weigh(State const& old, Wrong& wrong, Outcome& outcome) {
  constexpr int most = 12, settled = 3; // iterations; after the latter what no longer falls is rounding
  // of what is wrong at first that a step may leave; given volumes make far more of that than of the answer,
  // and with inertia all of a difference in speed is wrong at first, of which each step would keep its part
  double const share = bulk_.surface_loads().stiff() ? 1e-8 : weights_.inertia ? 1e-7 : 1e-4;
  force_scale_ = std::max({largest_force(internal_), largest_force(old.internal), largest_force(inertia_),
                           contact_->force_scale(), largest_force(external_)});
  double const forces = imbalance();
  double const worst = outcome.iterations > 0 ? std::max(forces, contact_->residual()) : forces;
  wrong.first = std::max(wrong.first, forces);
  bool const stalls =
      outcome.iterations >= settled && worst > 0.5 * wrong.before && worst <= stalled * force_scale_;
  double const enough = std::max(share * wrong.first, rounding_of_forces * force_scale_ + rounded());
  if (stalls || (outcome.iterations > 0 && worst <= enough))
    return Next::finish;
  wrong.before = worst;
  outcome.out_of_balance = worst / force_scale_;
  if (outcome.iterations < most && std::isfinite(worst))
    return Next::correct;
  outcome.reason = fmt::format("out of balance by {:.1e} of the largest force after {} iterations",
                               outcome.out_of_balance, outcome.iterations);
  return Next::leave_off;
}

/// First corrections, for which the factor is read once; of which the contact problem was solved?
std::vector<bool> Stepper::correct_together(std::vector<Stepper*> const& all) {
  std::vector<bool> corrected;
  if (bulk_.factor().coupled() != nullptr) { // what is condensed is kept until it is expanded
    for (auto* const one : all)
      corrected.push_back(one->apply_factor());
    return corrected;
  }
  std::vector<Vector*> corrections;
  for (auto* const one : all) {
    one->load_correction();
    corrections.push_back(&one->correction_);
  }
  auto motions = bulk_.factor().condense_all(corrections);
  std::vector<Vector const*> loads;
  corrections.clear();
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k]->surface_ = std::move(motions[k]);
    corrected.push_back(all[k]->answer_contact());
    if (!corrected.back())
      continue;
    loads.push_back(&all[k]->surface_load_);
    corrections.push_back(&all[k]->correction_);
  }
  bulk_.factor().expand_all(loads, corrections);
  for (std::size_t k = 0; k < all.size(); ++k)
    corrected[k] = corrected[k] && all[k]->take_correction();
  return corrected;
}

/// The rest of a step whose first correction has been made.
void Stepper::go_after(Follower const& how, double dt, Wrong wrong, Outcome& outcome) {
  auto const& old = *how.old;
  ++cost_.newton_iterations;
  if (how.trusting && rim_ && contact_->turning() &&
      correction_.lpNorm<Eigen::Infinity>() <= small * bulk_.cell_size()) {
    if (balance_on(old, dt, outcome))
      finish(old, dt, outcome);
    return;
  }
  for (++outcome.iterations; balance(old, dt, outcome); ++outcome.iterations, ++cost_.newton_iterations) {
    auto const next = weigh(old, wrong, outcome);
    if (next == Next::finish)
      finish(old, dt, outcome);
    if (next != Next::correct)
      return;
    if (!apply_factor())
      return fail_contact(outcome);
  }
}

std::vector<Outcome> Stepper::take_along(std::span<Follower const> followers, double dt) {
  std::vector<Outcome> outcomes(followers.size());
  std::vector<Wrong> wrong(followers.size());
  std::vector<Stepper*> going;
  std::vector<std::size_t> which;
  for (std::size_t k = 0; k < followers.size(); ++k) {
    auto* const stepper = followers[k].stepper;
    if (!stepper->start_after(*this, *followers[k].old, dt, outcomes[k]) ||
        stepper->weigh(*followers[k].old, wrong[k], outcomes[k]) != Next::correct)
      continue;
    going.push_back(stepper);
    which.push_back(k);
  }
  auto const corrected = correct_together(going);
  for (std::size_t i = 0; i < which.size(); ++i) {
    auto const k = which[i];
    if (corrected[i])
      going[i]->go_after(followers[k], dt, wrong[k], outcomes[k]);
    else
      fail_contact(outcomes[k]);
  }
  return outcomes;
}

} // namespace stiction::dynamics
