// Newton where contact is solved together with the bulk, without W.
#pragma once
#include "contact/solvers/solver.hpp"

namespace stiction::contact {

/// From these forces, of a problem whose W solves together. [dim n], N
[[nodiscard]] Solution coupled_newton(Problem const& problem, Vector const& guess, double tolerance,
                                      int iterations);

} // namespace stiction::contact
