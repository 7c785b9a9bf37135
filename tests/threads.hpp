// Results that must not depend on the number of threads.
#pragma once
#include <doctest/doctest.h>

#include "core/threads.hpp"

namespace stiction::test {

/// So many threads while it lives.
struct Threads {
  explicit Threads(int count) { core::use_threads(count); }
  Threads(Threads const&) = delete;
  Threads& operator=(Threads const&) = delete;
  ~Threads() { core::use_threads(1); }
};

/// make() by one, two and three threads, to the last bit.
template<class Make> void same_by_threads(Make const& make) {
  auto const alone = make();
  for (int const count : {2, 3}) {
    Threads const threads(count);
    CHECK(make() == alone);
  }
}

} // namespace stiction::test
