// A contact solver as sharp as the balance of forces wants it.
#pragma once
#include <algorithm>

#include "dynamics/model/model.hpp"

namespace stiction::dynamics {

/// The model's solver with a tolerance that lets the balance reach its own: where the solver is content with
/// forces that the balance is not, no iteration changes them.
[[nodiscard]] inline std::unique_ptr<contact::Solver> sharp_solver(Model const& model) {
  constexpr double part = 0.1, least = 1e-16; // less than rounding leaves
  auto choice = model.solver;
  double const wanted = std::max(part * model.control.force_tolerance, least);
  std::visit([&](auto& settings) { settings.tolerance = std::min(settings.tolerance, wanted); }, choice);
  return contact::make_solver(choice);
}

} // namespace stiction::dynamics
