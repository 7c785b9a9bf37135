// Leading terms of every phase, times how often it ran.
#include "scene/run/work.hpp"

#include "mesh/cells/cell.hpp"

namespace stiction::scene {

namespace {

constexpr double law = 200; // operations of a material law at a point

/// Operations of one pass over all cells: forces, then stiffness.
struct PassOperations {
  double force = 0, stiffness = 0;
};

PassOperations pass_operations(dynamics::Model const& model) {
  PassOperations sum;
  for (auto const& body : model.bodies)
    for (auto const& block : body->mesh.blocks) {
      auto const nodes = static_cast<double>(mesh::info(block.kind).nodes);
      auto const points = static_cast<double>(block.nodes.size()) / nodes *
                          static_cast<double>(mesh::stiffness_rule(block.kind).weights.size());
      double const width = model.dim(), unknowns = nodes * width;
      sum.force += points * (4 * unknowns * width + law);
      sum.stiffness += points * (unknowns * unknowns * 2 * width + law);
    }
  return sum;
}

} // namespace

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
