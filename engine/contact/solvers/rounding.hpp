// What rounding leaves of the residual of a contact problem.
#pragma once
#include "contact/solvers/solver.hpp"

namespace stiction::contact {

/// True if what is left of the residual is no more than rounding may make of gaps, slips and forces of this
/// size.
[[nodiscard]] bool within_rounding(Problem const& problem, Solution const& solution);

} // namespace stiction::contact
