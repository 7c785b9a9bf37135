// Solutions with one right side or four from CHOLMOD's supernodal factor: calls of BLAS for each of many
// small supernodes take longer than their numbers do.
#pragma once
#include <cholmod.h>

#include <span>
#include <vector>

#include "core/pack.hpp"
#include "core/types.hpp"

namespace stiction::linear {

/// b becomes L^-1 b, of the factor's own order. work[L.maxesize]
void solve_lower(cholmod_factor const& L, Vector& b, Vector& work);
/// b becomes L^-T b.
void solve_upper(cholmod_factor const& L, Vector& b, Vector& work);
/// Those of four right sides, side by side: the factor's numbers are read once for them. What comes of one
/// does not depend on the others.
void solve_lower(cholmod_factor const& L, std::span<Pack> b, std::vector<Pack>& work);
void solve_upper(cholmod_factor const& L, std::span<Pack> b, std::vector<Pack>& work);

} // namespace stiction::linear
