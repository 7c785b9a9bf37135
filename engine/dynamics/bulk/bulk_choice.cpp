// What multigrid asks of a model, and from which size on it is taken.
#include "dynamics/bulk/bulk_choice.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace stiction::dynamics {

namespace {

/// Unknowns of a block that is pressed and dragged in ten to a hundred steps, Poisson's ratio 0.3, above
/// which a factor takes longer: one that serves all steps of linear bodies, and where each step takes several
/// iterations. In a single step multigrid is quicker from 3000 unknowns on, by tenths of a second.
constexpr double large_linear = 15'000, large = 20'000;
/// With bonds, and friction that follows pressure or speed, contact has more than one solver beside a factor
/// and one beside multigrid: it is left where it is quicker by far.
constexpr double large_bonded = 150'000;
constexpr double least_compressible = 0.49; ///< Poisson's ratio, where multigrid takes five times as long
constexpr double least_unasked = 0.48; ///< up to which it comes to an end on meshes of any grading as well

double poisson(solid::Body const& body) {
  return material::moduli(body.material).poisson;
}

/// Cycles are more the less bodies are compressible: measured at 0.3, 0.45 and 0.49.
double crossing(Model const& model) {
  double compressible = 1 - 2 * 0.3;
  bool linear = true;
  for (auto const& body : model.bodies) {
    linear = linear && solid::linear(*body);
    compressible = std::min(compressible, 1 - 2 * poisson(*body));
  }
  bool const bonded = std::any_of(model.pairs.begin(), model.pairs.end(), [](Pair const& pair) {
    return pair.law.adhesion.has_value() || pair.law.mu_follows();
  });
  return (bonded ? large_bonded : linear ? large_linear : large) * std::cbrt((1 - 2 * 0.3) / compressible);
}

/// Names a body whose Poisson's ratio is above the limit; "" where there is none.
std::string nearly_incompressible(Model const& model, double limit) {
  for (auto const& body : model.bodies)
    if (double const ratio = poisson(*body); ratio > limit)
      return fmt::format("body {} is nearly incompressible: with a Poisson's ratio of {:.4g}, above {:g}, it "
                         "takes too many iterations",
                         body->name, ratio, limit);
  return "";
}

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
  if (!model.links.empty())
    return "it has constraints";
  if (!std::ranges::all_of(model.springs, &Spring::spread))
    return "a spring acts on the mean of a set";
  if (!model.gases.empty())
    return "gas couples the wall of its cavity";
  if (!std::all_of(model.pairs.begin(), model.pairs.end(), drives))
    return "contact is between deformable bodies, or its points are means";
  if (!std::holds_alternative<contact::BipotentialNewton>(model.solver))
    return "the contact solver is not newton";
  return nearly_incompressible(model, least_compressible);
}

std::string unfit_for_ranks(Model const& model) {
  if (auto const why = unfit_for_multigrid(model); !why.empty())
    return why;
  auto const weights = dynamics::weights(model.scheme);
  bool const damped =
      std::any_of(model.bodies.begin(), model.bodies.end(), [](auto const& body) { return body->damping; });
  if (weights.skin || (weights.surface_apart() && damped))
    return "contact nodes have a balance of their own";
  if (!model.springs.empty() || !model.pressures.empty() || !model.surface_stresses.empty())
    return "it has springs, or loads that follow a surface";
  if (model.control.bulk == BulkSolver::direct)
    return "control.bulk is \"direct\", and a factor is one process's";
  return "";
}

namespace {
bool large_enough(Model const& model) {
  Index unknowns = model.dofs();
  for (auto const& motion : model.motions)
    unknowns -= static_cast<Index>(motion.nodes.size());
  return unknowns >= crossing(model);
}

std::string not_unasked(Model const& model) {
  auto why = unfit_for_multigrid(model);
  return why.empty() ? nearly_incompressible(model, least_unasked) : why;
}
} // namespace

bool by_multigrid(Model const& model) {
  if (model.share)
    return true;
  if (model.control.bulk != BulkSolver::automatic)
    return model.control.bulk == BulkSolver::multigrid;
  return not_unasked(model).empty() && large_enough(model);
}

std::string kept_from_multigrid(Model const& model) {
  if (model.control.bulk != BulkSolver::automatic || model.dim() != 3 || !large_enough(model))
    return "";
  return not_unasked(model);
}

} // namespace stiction::dynamics
