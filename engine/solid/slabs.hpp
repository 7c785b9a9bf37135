// Cells divided among threads.
#pragma once
#include "core/types.hpp"

namespace stiction::solid {

/// Which slab each cell of so many nodes is in, [cells]; a few cells are one slab. Slabs that are not
/// neighbours share no node.
[[nodiscard]] Indices slabs(Indices const& connectivity, int nodes);

} // namespace stiction::solid
