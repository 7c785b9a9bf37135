// Whether bonds snapped in a step: what falls on its way against what all else holds.
#pragma once
#include <optional>

#include "contact/problem/uniqueness.hpp"

namespace stiction::contact {

/// A point whose force may fall as it moves along a unit direction, and how steeply, N/m.
template<int D> struct Yielding {
  Index point;
  Local<D> along;
  double fall;
};

/// Of the step from problem.start to an answer force[dim n], x[dim n]: each bond at the steepest fall on its
/// way there, held by the bodies, by what presses and by the bonds that do not fall; unless it is known that
/// something snapped, at falls that are there at the same time if all go evenly. None where the problem does
/// not know its start or is large.
[[nodiscard]] std::optional<SofteningDoubt> held_bonds(Problem const& problem, Vector const& force,
                                                       Vector const& x, Snapped snapped);

} // namespace stiction::contact
