// CHOLMOD as a BulkFactor: the surface eliminated last, or wherever it fills least.
#pragma once
#include "linear/bulk_factor.hpp"

namespace stiction::linear {

/// Surface unknowns up to which all columns are made at once: that takes no longer than some.
inline constexpr Index at_once = 512;

/// skew: will there be columns beside the symmetric matrix? They want the surface last.
[[nodiscard]] std::unique_ptr<BulkFactor> make_sparse_factor(Pattern const& pattern, Index surface,
                                                             bool skew);

/// Other orders than the surface last are looked at where it takes most of the work; elsewhere none can save
/// half of it.
[[nodiscard]] bool worth_another_order(Effort const& last, double surface);
/// With the columns of the surface that are expected to be asked for.
[[nodiscard]] bool surface_goes_last(Effort const& last, Effort const& free, double surface);

} // namespace stiction::linear
