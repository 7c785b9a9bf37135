// Counts the heap allocations of the test executable.
#pragma once

namespace stiction::test {

/// Calls of malloc and its relatives so far; constant 0 under a sanitizer, which has its own.
[[nodiscard]] long allocations();

} // namespace stiction::test
