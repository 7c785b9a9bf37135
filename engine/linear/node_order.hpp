// The order of elimination that a matrix would get, from the graph of its nodes.
#pragma once
#include "linear/pattern.hpp"

namespace stiction::linear {

/// Of nodes in whose place the matrix has `width` unknowns each; the nodes marked `last` at the end.
[[nodiscard]] Indices elimination_order(Pattern const& nodes, std::vector<bool> const& last, double width);

} // namespace stiction::linear
