// A store of freed blocks, one list per power of two.
#include "linear/recycling.hpp"

#include <SuiteSparse_config.h>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <mutex>

namespace stiction::linear {

namespace {

/// Stands before each block; keeps the alignment of malloc.
struct alignas(64) Header {
  std::size_t size_class;
  Header* next;
};

std::mutex guard; ///< of both
std::array<Header*, 64> freed{};
std::size_t from_system = 0;

void* take(std::size_t bytes) {
  auto const size_class = static_cast<std::size_t>(std::bit_width(bytes + sizeof(Header)));
  std::lock_guard const lock(guard);
  if (auto* header = freed[size_class]) {
    freed[size_class] = header->next;
    return header + 1;
  }
  auto* header = static_cast<Header*>(
      std::aligned_alloc(sizeof(Header), std::size_t{1} << std::max<std::size_t>(size_class, 7)));
  if (header == nullptr)
    return nullptr;
  ++from_system;
  header->size_class = size_class;
  return header + 1;
}

void give(void* block) {
  if (block == nullptr)
    return;
  auto* header = static_cast<Header*>(block) - 1;
  std::lock_guard const lock(guard);
  header->next = freed[header->size_class];
  freed[header->size_class] = header;
}

void* take_zeroed(std::size_t count, std::size_t size) {
  void* block = take(count * size);
  if (block != nullptr)
    std::memset(block, 0, count * size);
  return block;
}

void* resize(void* block, std::size_t bytes) {
  if (block == nullptr)
    return take(bytes);
  auto* header = static_cast<Header*>(block) - 1;
  std::size_t const room = (std::size_t{1} << header->size_class) - sizeof(Header);
  if (bytes <= room)
    return block;
  void* larger = take(bytes);
  if (larger == nullptr)
    return nullptr;
  std::memcpy(larger, block, room);
  give(block);
  return larger;
}

} // namespace

void recycle_suitesparse_memory() {
  static bool const done = [] {
    SuiteSparse_config.malloc_func = take;
    SuiteSparse_config.calloc_func = take_zeroed;
    SuiteSparse_config.realloc_func = resize;
    SuiteSparse_config.free_func = give;
    return true;
  }();
  static_cast<void>(done);
}

std::size_t blocks_from_system() {
  return from_system;
}

} // namespace stiction::linear
