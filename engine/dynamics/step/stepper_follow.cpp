// A step beside another stepper's, whose model differs a little: what derivatives are differences of.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

/// One more iteration of a step that has converged, with a factor of where it is: those that follow are
/// corrected with it, and what the step leaves undone must not tell it from theirs. Where it leads away the
/// step stays as it was.
bool Stepper::polish(State const& old, double dt, Outcome& outcome) {
  Vector const reached = d_;
  bool better = bulk_.linear() ||
                bulk_.factorize(u_, weights_, dt, cost_,
                                {old.t + dt, bulk_.surface_loads().steady(gas_, gas_old_)});
  if (!better)
    bulk_.recall({}, weights_);
  better = better && apply_factor();
  ++outcome.iterations;
  ++cost_.newton_iterations;
  if (better && balance(old, dt, outcome) && converged(outcome))
    return true;
  d_ = reached;
  outcome.verdict = StepVerdict::not_converged;
  return balance(old, dt, outcome) && converged(outcome);
}

Outcome Stepper::follow(Stepper& lead, State const& old, double dt, double share) {
  constexpr int most = 12;
  constexpr double rounding = 1e-12, stalled = 1e-10; // of forces; the latter where no more falls
  constexpr int settled = 3;                          // iterations after which that is seen
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
    double const enough = std::max(share * first, rounding * force_scale_ + rounded());
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
  }
  finish(old, dt, outcome);
  return outcome;
}

} // namespace stiction::dynamics
