// Replaces malloc and its relatives for the whole test executable by counting ones.
#include "solid/allocations.hpp"

#include <atomic>
#include <cstddef>

namespace {
std::atomic<long> calls{0};
}

long stiction::test::allocations() {
  return calls.load();
}

#if !STICTION_SANITIZED
extern "C" {

void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);

void* malloc(std::size_t size) noexcept {
  ++calls;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  ++calls;
  return __libc_calloc(count, size);
}
void* realloc(void* block, std::size_t size) noexcept {
  ++calls;
  return __libc_realloc(block, size);
}

} // extern "C"
#endif
