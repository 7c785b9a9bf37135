// Counts the heap allocations of the test executable.
#pragma once

namespace stiction::test {

/// Whether this build can count: a sanitizer brings its own malloc.
#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
inline constexpr bool counts_allocations = true;
#else
inline constexpr bool counts_allocations = false;
#endif

/// Calls of malloc and its relatives so far; 0 where they cannot be counted.
[[nodiscard]] long allocations();

} // namespace stiction::test
