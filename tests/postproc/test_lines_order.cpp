// Ordered families of curves: colours in their order.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "harness.hpp"

namespace {

using namespace harness;

/// `count` level curves, the first at the bottom.
std::string levels(std::string const& name, int count, std::string const& more) {
  std::string curves;
  for (int i = 0; i < count; ++i)
    curves += fmt::format(R"({}{{"label":"r = {} mm","x":[0,1],"y":[{},{}]}})", i == 0 ? "" : ",", i, i, i);
  return fmt::format(R"({{"name":"{}","kind":"lines","x":{{"label":"time","unit":"ms"}},
    "y":{{"label":"traction","unit":"MPa","range":[-1,{}]}},{}"curves":[{}]}})",
                     name, count, more, curves);
}

} // namespace

TEST_CASE("sequential colours run from the dark end to the light one without dashes") {
  auto const result =
      draw("order", levels("seq", 12, "\"colours\":\"sequential\",") + "," + levels("pal", 12, ""));
  CHECK_MESSAGE(result.code == 0, result.messages);
  Image const image(work / "order/seq.png");
  CHECK(image.count({68, 1, 84}) > 2000);    // r = 0 and its legend
  CHECK(image.count({188, 223, 41}) > 2000); // r = 11 at 0.9 of the map
  CHECK(image.count({0, 114, 178}) == 0);
  CHECK(image.white_rim());
  Image const palette(work / "order/pal.png");
  CHECK(palette.count({0, 114, 178}) > 2000);
  CHECK(palette.count({68, 1, 84}) == 0);
}

TEST_CASE("an unknown order of colours is refused") {
  auto const result = draw("rainbow", levels("it", 2, "\"colours\":\"rainbow\","));
  CHECK(result.code == 2);
  CHECK(result.messages.find("sequential") != std::string::npos);
}
