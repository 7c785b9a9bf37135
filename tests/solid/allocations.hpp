// Counts the heap allocations of the test executable.
#pragma once

#if defined(__has_feature) // clang's
#define STICTION_SANITIZED __has_feature(address_sanitizer)
#elif defined(__SANITIZE_ADDRESS__)
#define STICTION_SANITIZED 1
#else
#define STICTION_SANITIZED 0
#endif

namespace stiction::test {

/// Whether this build can count: a sanitizer brings its own malloc.
inline constexpr bool counts_allocations = !STICTION_SANITIZED;

/// Calls of malloc and its relatives so far; 0 where they cannot be counted.
[[nodiscard]] long allocations();

} // namespace stiction::test
