// Sweeps over dry points, each mixed with those before it: quick where contacts are many and friction is
// plain.
#pragma once
#include "contact/solvers/solver.hpp"

namespace stiction::contact {

/// Is there neither a bond nor a coefficient that follows pressure or speed?
[[nodiscard]] bool plain(Problem const& problem);

/// Nonsmooth Gauss-Seidel with Anderson's mixing (Walker and Ni 2011) of the last sweeps' forces, W in single
/// precision within a sweep: what that rounds off is put right as forces settle. Of a plain problem; ends at
/// the tolerance, after `most` sweeps, or where more would not get there.
[[nodiscard]] Solution mix_sweeps(Problem const& problem, Vector const& guess, double tolerance, long most);

} // namespace stiction::contact
