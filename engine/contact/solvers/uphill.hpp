// Newton's method that goes on where nothing descends.
#pragma once
#include "contact/solvers/solver.hpp"

namespace stiction::contact {

/// Of a plain problem (`plain`), from the forces with which all points stick and from none, with more and
/// more weight on displacements: in pressed piles statuses depend on each other in long chains, and a descent
/// ends at a kink. The best forces by the judge, converged or not; takes a bounded number of operations, none
/// where one factorization takes more.
[[nodiscard]] Solution go_on(Problem const& problem, double tolerance);

/// So many of Newton's steps on the natural map from forces near an answer of a plain problem, with a little
/// more compliance where bodies hold each other in more ways than one. No worse than the start by the judge.
[[nodiscard]] Solution finish(Problem const& problem, Vector const& start, double tolerance, int steps);

} // namespace stiction::contact
