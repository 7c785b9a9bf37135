// Iterations with one factor mixed with each other.
#include "dynamics/bulk/timer.hpp"
#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

/// What free unknowns lack to balance, N.
void Stepper::gather_imbalance(Vector& force) const {
  force.resize(bulk_.unknowns());
  for (Index k = 0; k < bulk_.unknowns(); ++k) {
    Index const dof = bulk_.dof_of(k);
    force[k] = unbalanced_[dof] - weights_.contact * reaction_[dof];
  }
}

/// Correction and contact forces become those of the last iterations with this factor together.
void Stepper::mix() {
  Timer const timer(cost_.solve);
  Vector imbalance, forces;
  gather_imbalance(imbalance);
  if (!contact_->problem().points.empty())
    forces = contact_->forces();
  mixing_.mix(imbalance, correction_, forces);
  if (forces.size() > 0)
    contact_->take(forces);
}

} // namespace stiction::dynamics
