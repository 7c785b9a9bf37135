// Newton alone, without all that the newton solver falls back on.
#pragma once
#include "contact/solvers/solver.hpp"

namespace stiction::contact {

/// Rows, from which on the newton solver sweeps first.
inline constexpr long many = 60;

/// From these forces to whatever answer is next; gives up where it stagnates. [dim n], N
[[nodiscard]] Solution newton_from(Problem const& problem, Vector const& guess, double tolerance);

} // namespace stiction::contact
