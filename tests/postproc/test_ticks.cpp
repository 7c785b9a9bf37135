// What stands at the ticks of logarithmic axes.
#include <doctest/doctest.h>

#include "charts/ticks.hpp"

namespace {

using namespace stiction::postproc;

std::string labels(double low, double high, int wanted = 7) {
  std::string words;
  for (auto const& tick : ticks_for({low, high, true}, wanted).ticks)
    words += tick.label.empty() ? "" : (words.empty() ? "" : " ") + tick.label;
  return words;
}

} // namespace

TEST_CASE("from three powers of ten on a logarithmic axis names these alone") {
  CHECK(labels(1, 100) == "10⁰ 10¹ 10²");
  CHECK(labels(0.5, 2000) == "10⁰ 10¹ 10² 10³");
  CHECK(labels(1e-9, 1e-1, 5) == "10⁻⁹ 10⁻⁷ 10⁻⁵ 10⁻³ 10⁻¹");
}

TEST_CASE("a short logarithmic axis has no lone value beside a power of ten") {
  CHECK(labels(8, 60) == "10 20 50");
  CHECK(labels(1, 10) == "1 2 5 10");
  CHECK(labels(0.04, 0.3) == "0.05 0.1 0.2");
  CHECK(labels(8, 15) == "8 10");
  CHECK(labels(15, 45) == "20 30 40");
  CHECK(labels(2e-7, 9e-7) == "2·10⁻⁷ 5·10⁻⁷");
  CHECK(labels(9, 110, 3) == "10 100");
}

TEST_CASE("an axis within one multiple of a power of ten has the ticks of a plain one") {
  CHECK(labels(31, 38, 4) == "32 34 36 38");
}
