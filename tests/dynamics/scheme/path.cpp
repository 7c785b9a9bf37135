// Paths between their knots, on them, and beyond them by rounding.
#include "dynamics/scheme/path.hpp"

#include <doctest/doctest.h>

using stiction::dynamics::Path;

namespace {
Path const bent{{0, 1, 3}, {0, -2, 4}};
}

TEST_CASE("a path runs straight between its knots and rests outside them") {
  CHECK(bent.value(-1) == 0);
  CHECK(bent.value(0.25) == -0.5);
  CHECK(bent.value(1) == -2);
  CHECK(bent.value(2) == 1);
  CHECK(bent.value(3) == 4);
  CHECK(bent.value(9) == 4);
  CHECK(Path{}.constant());
  CHECK(Path{}.value(7) == 0);
  CHECK(Path{}.rate_before(7) == 0);
}

TEST_CASE("a knot belongs to the line before it, also when a sum of steps overshoots it by rounding") {
  for (double const off : {0.0, 1e-15, 1e-12}) {
    CAPTURE(off);
    CHECK(bent.rate_before(1 - off) == -2);
    CHECK(bent.rate_before(1 + off) == -2);
    CHECK(bent.rate_before(3 - off) == 3);
    CHECK(bent.rate_before(3 + off) == 3);
    CHECK(bent.value(1 + off) == doctest::Approx(-2).epsilon(1e-10));
    CHECK(bent.value(3 + off) == doctest::Approx(4).epsilon(1e-10));
  }
  CHECK(bent.rate_before(1.001) == 3);
  CHECK(bent.rate_before(3.001) == 0);
}
