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

/// Whether they can be counted: a sanitizer and valgrind bring their own malloc.
[[nodiscard]] bool counts_allocations();

/// Calls of malloc and its relatives so far; 0 where they cannot be counted.
[[nodiscard]] long allocations();

} // namespace stiction::test
