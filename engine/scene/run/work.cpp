// Leading terms of every phase, times how often it ran.
#include "scene/run/work.hpp"

#include "scene/explain/passes.hpp"

namespace stiction::scene {

double operations(dynamics::Model const& model, dynamics::Stepper const& stepper) {
  auto const& cost = stepper.cost();
  auto const& bulk = stepper.bulk();
  auto const effort = bulk.effort();
  auto const pass = pass_operations(model);
  return pass.force * static_cast<double>(cost.force_passes) +
         pass.stiffness * static_cast<double>(cost.stiffness_passes) +
         effort.operations * static_cast<double>(cost.factorizations) + cost.compliance_operations +
         4 * effort.entries * static_cast<double>(cost.solves) + cost.contact_operations;
}

} // namespace stiction::scene
