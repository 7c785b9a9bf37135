// What rounding leaves of the residual of a contact problem, and of the sense of its forces.
#pragma once
#include "contact/solvers/solver.hpp"

namespace stiction::contact {

/// True if what is left of the residual is no more than rounding may make of gaps, slips and forces of this
/// size.
[[nodiscard]] bool within_rounding(Problem const& problem, Solution const& solution);

/// Largest traction that a problem and a start for it hold, Pa: of the start, of what would take all gaps and
/// slips away point by point, of whole bonds. Infinite where there is none of it.
[[nodiscard]] double forces_there(Problem const& problem, Vector const& guess);
/// What forces may leave of what was there without them, Pa. Their own size hides it from every judge: the
/// larger they are, the less it may be.
[[nodiscard]] double residual_felt(Problem const& problem, Vector const& force);
/// Does W p say where the points are, beside the forces there? Forces that W feels by rounding alone may grow
/// without end.
[[nodiscard]] bool felt(Problem const& problem, Solution const& solution, double there);

} // namespace stiction::contact
