// Keeps the blocks that SuiteSparse frees and hands them out again, so that refactoring allocates nothing.
#pragma once
#include <cstddef>

namespace stiction::linear {

/// Routes SuiteSparse's allocations through a store of freed blocks by size class. Not for use from several
/// threads at once: the engine runs one case per process.
void recycle_suitesparse_memory();

/// Blocks taken from the system so far: constant from step to step once all sizes have been seen.
[[nodiscard]] std::size_t blocks_from_system();

} // namespace stiction::linear
