// Says which planted fault is switched on and notes which have been reached; opens each rewritten file.
#pragma once
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <type_traits>
#include <unistd.h>

namespace stiction::mutants {

inline constexpr int most = 4096;

/// STICTION_MUTANT: the number of the one that is on; 0: none.
inline int chosen() {
  char const* text = std::getenv("STICTION_MUTANT");
  return text == nullptr ? 0 : std::atoi(text);
}

/// STICTION_MUTANTS_REACHED: a file of `most` bytes, one a fault, shared by all processes that inherit it.
inline unsigned char* reached_by_all() {
  char const* path = std::getenv("STICTION_MUTANTS_REACHED");
  int const file = path == nullptr ? -1 : open(path, O_RDWR | O_CLOEXEC);
  if (file < 0)
    return nullptr;
  void* const map = mmap(nullptr, most, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  close(file);
  return map == MAP_FAILED ? nullptr : static_cast<unsigned char*>(map);
}

inline int const on = chosen();
inline unsigned char* const reached = reached_by_all();

} // namespace stiction::mutants

constexpr bool stiction_mutant(int k) {
  if (std::is_constant_evaluated())
    return false;
  if (stiction::mutants::reached != nullptr)
    stiction::mutants::reached[k] = 1;
  return k == stiction::mutants::on;
}
