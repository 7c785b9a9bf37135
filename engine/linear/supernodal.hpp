// Solutions with one right side from CHOLMOD's supernodal factor: calls of BLAS for each of many small
// supernodes take longer than their numbers do.
#pragma once
#include <cholmod.h>

#include "core/types.hpp"

namespace stiction::linear {

/// b becomes L^-1 b, of the factor's own order. work[L.maxesize]
void solve_lower(cholmod_factor const& L, Vector& b, Vector& work);
/// b becomes L^-T b.
void solve_upper(cholmod_factor const& L, Vector& b, Vector& work);

} // namespace stiction::linear
