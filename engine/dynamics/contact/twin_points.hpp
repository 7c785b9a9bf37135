// Points of a curve that touches itself, of which each may be the other's counterpart.
#pragma once
#include "contact/problem/problem.hpp"

namespace stiction::dynamics {

/// Two such nodes ask the same twice and W is singular. A small compliance about the last force at the rows
/// from `first` on tells them apart and vanishes as the force settles.
template<int C> void separate_twins(contact::Problem& problem, Index first, contact::Local<C> const& force) {
  for (Index row = first; row < first + C; ++row) {
    double const compliance = 1e-6 * problem.W.diagonal(row);
    problem.W.entries()(row, row) += compliance;
    problem.free[row] -= compliance * force[row - first];
  }
}

} // namespace stiction::dynamics
