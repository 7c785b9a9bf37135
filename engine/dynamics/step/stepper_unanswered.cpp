// Why a contact problem has no answer, as far as that is known.
#include <fmt/format.h>
#include <set>

#include "contact/solvers/answers.hpp"
#include "contact/solvers/pivoting.hpp"
#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

/// The first node that is held in all directions and lies in a rigid obstacle that cannot give way; else
/// nothing.
std::string Stepper::held_and_pressed() const {
  auto const& problem = contact_->problem();
  for (Index row = 0; row < problem.size(); ++row) {
    auto const point = contact_->point_of(row);
    auto const& pair = model_->pairs[ix(point.pair)];
    auto const* side = std::get_if<RigidSide>(&pair.primary);
    double const gap = problem.free[problem.dim * row];
    if (pair.shared() || side == nullptr || model_->rigids[side->body].free() || !(gap < 0))
      continue;
    Index const node = pair.secondary[ix(point.index)];
    std::set<std::string> sets;
    int held = 0;
    for (int c = 0; c < model_->dim(); ++c)
      if (auto const* motion = driver_[ix(model_->dim() * node + c)]) {
        ++held;
        sets.insert(motion->set);
      }
    if (held < model_->dim())
      continue;
    auto const X = model_->reference.row(node);
    return fmt::format(
        "the node at ({:g}) m is held or driven in all its directions, by {}, and pressed by {:.2g} m into "
        "{} of "
        "pair {}: nothing can give way; leave it free across the surface, as with motion.fix{{ set "
        "= \"{}\", x = true }}, or take it out of one of the sets",
        fmt::join(X.begin(), X.end(), ", "), fmt::join(sets, " and "), -gap, model_->rigids[side->body].name,
        pair.name, *sets.begin());
  }
  return "";
}

/// In space pivoting knows Coulomb's cone by facets within it and can show nothing.
std::string Stepper::unanswered() const {
  auto const& problem = contact_->problem();
  auto const& forces = contact_->forces();
  std::string const failed = "the contact solver did not reach its tolerance";
  if (problem.points.empty() || !forces.allFinite())
    return failed;
  auto const held = held_and_pressed();
  std::string const why = held.empty() ? held : ": " + held;
  if (problem.W.together() != nullptr)
    return failed + why;
  auto const found = problem.dim > 2 ? std::nullopt : contact::pivot(problem, forces, contact::From::nothing);
  return failed +
         (found && found->none
              ? ": pivoting shows that its problem, linear about the last forces, has no answer"
              : ": " + words(contact::without_answer(problem, forces), problem.dim)) +
         why;
}

} // namespace stiction::dynamics
