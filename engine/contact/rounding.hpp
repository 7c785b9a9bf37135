// How far the tolerance of a contact solver can be met at all.
#pragma once
#include "contact/problem.hpp"

namespace stiction::contact {

/// The largest natural-map residual over the largest traction that the judge takes for the rounding of x =
/// free
/// + W p; 0 where no point's residual is as small as that. A tolerance below it is met as far as it can be.
[[nodiscard]] double excused(Problem const& problem, Vector const& force);

} // namespace stiction::contact
