// What multigrid asks of a model, and from which size on it is taken.
#include "dynamics/bulk/bulk_choice.hpp"

#include <algorithm>

namespace stiction::dynamics {

namespace {
constexpr Index large = 150'000; ///< unknowns, about where a factor takes as long
} // namespace

std::string unfit_for_multigrid(Model const& model) {
  auto const drives = [](Pair const& pair) {
    return !pair.self && !pair.shared() && std::holds_alternative<RigidSide>(pair.primary);
  };
  if (model.dim() != 3)
    return "it is for bodies in space";
  if (weights(model.scheme).explicit_forces)
    return "an explicit scheme has no matrix to solve with";
  if (model.held_by_bonds)
    return "some body is held by its bonds alone";
  if (std::any_of(model.rigids.begin(), model.rigids.end(), [](auto const& one) { return one.free(); }))
    return "a rigid body is free";
  if (!std::all_of(model.pairs.begin(), model.pairs.end(), drives))
    return "contact is between deformable bodies, or its points are means";
  if (!std::holds_alternative<contact::BipotentialNewton>(model.solver))
    return "the contact solver is not newton";
  return "";
}

bool by_multigrid(Model const& model) {
  if (model.control.bulk != BulkSolver::automatic)
    return model.control.bulk == BulkSolver::multigrid;
  Index unknowns = model.dofs();
  for (auto const& motion : model.motions)
    unknowns -= static_cast<Index>(motion.nodes.size());
  return unknowns >= large && unfit_for_multigrid(model).empty();
}

} // namespace stiction::dynamics
