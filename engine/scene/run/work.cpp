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

std::map<std::string, double> counters_of(dynamics::Model const& model, dynamics::Stepper const& stepper) {
  auto const& cost = stepper.cost();
  auto const& bulk = stepper.bulk();
  double cells = 0;
  for (auto const& body : model.cells)
    cells += static_cast<double>(body.count());
  double const evaluated = cells * static_cast<double>(cost.force_passes + cost.stiffness_passes);
  return {{"force_passes", static_cast<double>(cost.force_passes)},
          {"stiffness_passes", static_cast<double>(cost.stiffness_passes)},
          {"shifted_factorizations", static_cast<double>(cost.shifted_factorizations)},
          {"solves", static_cast<double>(cost.solves)},
          {"compliance_columns", static_cast<double>(cost.compliance_columns)},
          {"contact_unknowns", static_cast<double>(bulk.factor().surface())},
          {"surface_bytes", 8 * bulk.factor().surface_numbers()},
          {"contact_iterations", static_cast<double>(cost.contact_iterations)},
          {"contact_problems", static_cast<double>(cost.contact_problems)},
          {"cells", cells},
          {"cells_evaluated", evaluated},
          {"cells_per_second", evaluated / cost.assembly},
          {"work", operations(model, stepper)},
          {"unknowns", static_cast<double>(bulk.unknowns())}};
}

} // namespace stiction::scene
