// The entry point of all engine tests.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

/// HDF5 1.10 loses a buffer of its own when it closes a file whose disk is full.
extern "C" char const* __lsan_default_suppressions() {
  return "leak:libhdf5_serial";
}
