// When a step counts as converged.
#include <algorithm>
#include <cmath>
#include <utility>

#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

namespace {
constexpr double nothing = 1e-250; ///< N: forces of a body let go fade step by step to numbers without digits
}

/// m, turns by their arms.
double Stepper::largest_way(Vector const& way) const {
  return arms_.size() > 0 ? way.cwiseProduct(arms_).lpNorm<Eigen::Infinity>() : way.lpNorm<Eigen::Infinity>();
}

/// N, moments over their arms.
double Stepper::largest_force(Vector const& force) const {
  return arms_.size() > 0 ? force.cwiseQuotient(arms_).lpNorm<Eigen::Infinity>()
                          : force.lpNorm<Eigen::Infinity>();
}

/// Largest force on a free unknown that nothing balances, N.
double Stepper::imbalance() const {
  double largest = 0;
  auto const& borne = bulk_.links().empty() ? reaction_ : gathered_;
  for (Index k = 0; k < bulk_.unknowns(); ++k) {
    Index const dof = bulk_.dof_of(k);
    double const force = std::abs(unbalanced_[dof] - weights_.contact * borne[dof]);
    largest = std::max(largest, arms_.size() > 0 ? force / arms_[dof] : force);
  }
  return largest;
}

/// What rounding alone leaves of the balance of bodies, N.
double Stepper::rounded() const {
  double const way = largest_way(u_) + largest_way(d_);
  double const beside_one = bulk_.linear_bodies() ? 0 : 1e-15 * bulk_.cell_size(); // F = 1 + grad u
  double const gas = bulk_.surface_loads().stiff() ? bulk_.surface_loads().rounding(u_) : 0;
  return 1e-14 * way * bulk_.stiffness_scale() + beside_one * bulk_.bodies_stiffness() + gas;
}

/// So near to the answer that a factor of here is as good as one of there.
bool Stepper::near(Outcome const& outcome) const {
  constexpr double part = 1e-5; // of the largest force
  return outcome.iterations > 0 && std::max(imbalance(), contact_->residual()) <= part * force_scale_;
}

/// What rounding alone leaves is enough: of bodies at once, of contact, whose gaps have the last digits of
/// rounding, once it no longer falls.
bool Stepper::converged(Outcome& outcome) {
  double const tolerance = model_->control.force_tolerance * force_scale_ + rounded() + nothing;
  double const forces = imbalance(), contact = contact_->residual(), worst = std::max(forces, contact);
  outcome.out_of_balance = force_scale_ > 0 ? worst / force_scale_ : worst;
  outcome.force_scale = force_scale_;
  double const rounding = 1e-15 * extent_ * bulk_.stiffness_scale();
  bool const stalls =
      worst > 0.5 * std::exchange(previous_worst_, worst) && outcome.iterations >= settle_after;
  return forces <= tolerance && contact <= tolerance + (stalls ? rounding : 0.0);
}

/// Where corrections in a row hardly contract, the matrix lacks what matters: the turn of normals, if it was
/// left out, is put in; where that is not it, corrections are mixed, after enough that points have settled.
/// What pressures that follow a free end lack shows in two corrections together: one makes good what the
/// other one spoils; where points bear something they may, and settle first.
void Stepper::watch(Outcome const& outcome) {
  constexpr double hardly = 0.5;
  constexpr int some = 2, several = 3;
  double const of_two = contraction_ * std::exchange(contraction_before_, contraction_);
  bool const to_and_fro = bulk_.surface_loads().pressed() && of_two > 1 && contact_->force_scale() == 0;
  slow_ = contraction_ > hardly || to_and_fro ? slow_ + 1 : 0;
  if (slow_ >= some && contact_->insist())
    slow_ = 0;
  mixes_ = mixes_ || (slow_ >= several && (to_and_fro || outcome.iterations >= settle_after));
}

/// Words where loads act on a body that contact and bonds bear nothing of any more.
std::string Stepper::come_off(State const& old, double imbalance) const {
  constexpr double nothing_borne = 1e-3, most = 0.1; // of the loads
  double const loads = largest_force(external_);
  bool const off = !weights_.inertia && loads > 0 && imbalance > most * loads &&
                   contact_->force_scale() < nothing_borne * loads && !old.reaction.isZero(0);
  return off ? ": a body has come off under its loads, which no equilibrium bears; a scheme with inertia "
               "follows it, and the run so far is kept"
             : "";
}

/// Of a step in which points turn the surface under them farther than the bulk bears: what to do where that
/// is a body's, node to segment.
Outcome Stepper::with_remedy(Outcome outcome) const {
  bool const by_nodes = std::ranges::any_of(model_->pairs, [](Pair const& pair) {
    return !std::holds_alternative<RigidSide>(pair.primary) && !pair.mortar && !pair.self;
  });
  if (by_nodes && !outcome.converged())
    outcome.reason += ": points turn the surface under them farther than the bodies bear, as corners do; the "
                      "pair's discretisation = \"mortar\" spreads their forces";
  return outcome;
}

bool Stepper::take_correction() {
  cost_.add(bulk_.factor().spent());
  ++cost_.solves;
  if (mixes_)
    mixing_.mix(correction_);
  for (Index k = 0; k < bulk_.unknowns(); ++k)
    d_[bulk_.dof_of(k)] += correction_[k];
  bulk_.links().follow(d_);
  return correction_.allFinite();
}

} // namespace stiction::dynamics
