// Replaces malloc and its relatives for the whole test executable by counting ones.
#include "solid/allocations.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <string_view>

namespace {
std::atomic<long> calls{0};
}

long stiction::test::allocations() {
  return calls.load();
}

bool stiction::test::counts_allocations() {
  char const* const preloaded = std::getenv("LD_PRELOAD");
  bool const valgrind =
      preloaded != nullptr && std::string_view(preloaded).find("vgpreload") != std::string_view::npos;
  return !STICTION_SANITIZED && !valgrind;
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
