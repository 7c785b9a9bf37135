// Leading terms of the passes over cells.
#include "scene/explain/passes.hpp"

#include "mesh/cells/cell.hpp"

namespace stiction::scene {

namespace {
constexpr double law = 200; // operations of a material law at a point
}

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

} // namespace stiction::scene
