// Which kernels OpenBLAS computes with.
#include "bind/kernels.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <unistd.h>

extern "C" char* openblas_get_corename();

namespace stiction::bind {

namespace {

constexpr char const* chosen = "OPENBLAS_CORETYPE";

/// Kernels with fused products of 256 bits and more.
constexpr std::array<std::string_view, 5> wide{"Haswell", "Zen", "SkylakeX", "Cooperlake", "SapphireRapids"};

/// The kernels whose instructions this processor has; nothing if it has none of the wide ones.
char const* fitting() {
#ifdef __x86_64__
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") != 0 && __builtin_cpu_supports("avx512dq") != 0 &&
      __builtin_cpu_supports("avx512bw") != 0 && __builtin_cpu_supports("avx512vl") != 0)
    return "SkylakeX";
  if (__builtin_cpu_supports("avx2") != 0 && __builtin_cpu_supports("fma") != 0)
    return "Haswell";
#endif
  return nullptr;
}

} // namespace

void take_kernels_of_processor(char** words) {
  if (getenv(chosen) != nullptr || std::ranges::find(wide, openblas_get_corename()) != wide.end())
    return;
  if (auto const* kernels = fitting()) {
    setenv(chosen, kernels, 1);
    execv("/proc/self/exe", words); // returns only where that is not allowed: then the old kernels compute
  }
}

} // namespace stiction::bind
