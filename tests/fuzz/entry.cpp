// Hands libFuzzer's bytes to the one target that this program is built for.
#include <cstddef>
#include <cstdint>

#include "fuzz/targets.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* bytes, std::size_t size) {
  stiction::fuzz::STICTION_FUZZ_TARGET(
      {reinterpret_cast<char const*>(bytes), size}); // NOLINT: bytes are text here
  return 0;
}
