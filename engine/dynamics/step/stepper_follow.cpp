// Steps beside another stepper's, whose model differs a little: what derivatives are differences of.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "dynamics/bulk/timer.hpp"
#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

namespace {

constexpr double rounding_of_forces = 1e-12, stalled = 1e-10; // of forces; the latter where no more falls
constexpr double small = 1e-4; // correction, over a cell's size, along which forces are linear

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
      contact_(make_contact_system(model, bulk_)), tunnelling_(model), driver_(ix(model.dofs()), nullptr),
      arms_(arms(model)) {
  learn_of_model();
  bool const rigid = std::ranges::any_of(model.rigids, [](auto const& one) { return one.free(); });
  bool const plain = !rigid && !bulk_.relaxing() && !bulk_.damped() && bulk_.springs().empty() &&
                     bulk_.surface_loads().empty() && bulk_.links().empty() && !weights_.skin &&
                     !weights_.surface_apart();
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

Outcome Stepper::follow(Stepper& lead, State const& old, double dt, Following const& how) {
  constexpr int most = 12, settled = 3; // iterations; after the latter what no longer falls is rounding
  Outcome outcome;
  bulk_.borrow_factor(lead.bulk_);
  predict(old, dt, lead.start_ == Start::unturned ? Start::unturned : Start::rest);
  d_ = lead.d_;
  arrive(old, old.t + dt);
  contact_->follow(*lead.contact_);
  for (double first = 0, before = 0;; ++outcome.iterations, ++cost_.newton_iterations) {
    if (!balance(old, dt, outcome))
      return outcome;
    force_scale_ = std::max({largest_force(internal_), largest_force(old.internal), largest_force(inertia_),
                             contact_->force_scale(), largest_force(external_)});
    double const forces = imbalance();
    double const worst = outcome.iterations > 0 ? std::max(forces, contact_->residual()) : forces;
    first = std::max(first, forces);
    bool const stalls =
        outcome.iterations >= settled && worst > 0.5 * before && worst <= stalled * force_scale_;
    double const enough = std::max(how.share * first, rounding_of_forces * force_scale_ + rounded());
    if (stalls || (outcome.iterations > 0 && worst <= enough))
      break;
    before = worst;
    outcome.out_of_balance = worst / force_scale_;
    if (outcome.iterations == most || !std::isfinite(worst)) {
      outcome.reason = fmt::format("out of balance by {:.1e} of the largest force after {} iterations",
                                   outcome.out_of_balance, outcome.iterations);
      return outcome;
    }
    if (!apply_factor()) {
      outcome.verdict = StepVerdict::contact_failed;
      outcome.reason = "its contact problem was not solved";
      return outcome;
    }
    bool const linear = how.trusting && rim_ && contact_->turning() && outcome.iterations == 0 &&
                        correction_.lpNorm<Eigen::Infinity>() <= small * bulk_.cell_size();
    if (linear) {
      if (!balance_on(old, dt, outcome))
        return outcome;
      ++cost_.newton_iterations;
      break;
    }
  }
  finish(old, dt, outcome);
  return outcome;
}

} // namespace stiction::dynamics
