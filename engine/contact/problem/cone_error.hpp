// The error of an answer over all points together, as collections of friction problems state it.
#pragma once
#include <optional>

#include "contact/problem/problem.hpp"

namespace stiction::contact {

/// |r - Proj(r - (u + mu |u_t| n))| / |q| of forces r, u = W r + q, in the units in which W has a mean
/// diagonal of 1 and q a largest component of 1: Siconos' measure. Unlike the judge's it is one norm over all
/// points and counts displacements as well as forces. None where bonds act, where a coefficient of friction
/// follows pressure or speed, or where q is zero.
[[nodiscard]] std::optional<double> cone_error(Problem const& problem, Vector const& force, Vector const& x);

} // namespace stiction::contact
