// CHOLMOD as a BulkFactor: the surface eliminated last, or wherever it fills least.
#pragma once
#include "linear/bulk_factor.hpp"

namespace stiction::linear {

/// skew: will there be columns beside the symmetric matrix? They want the surface last.
[[nodiscard]] std::unique_ptr<BulkFactor> make_sparse_factor(Pattern const& pattern, Index surface,
                                                             bool skew);

} // namespace stiction::linear
