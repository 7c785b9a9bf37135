// What a picture makes of the values in the files: units, components, times, ranges, the words at ticks.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "harness.hpp"
#include "samples.hpp"

namespace {

using namespace harness;

constexpr Colour blue{0, 114, 178}, vermilion{213, 94, 0}, lowest{68, 1, 84}, highest{253, 231, 37},
    axis{38, 38, 38};

/// Made by the samples of the other tests, and here again, as tests run in any order.
struct Samples {
  Samples() {
    samples::write_series(work / "values/series.h5", 0);
    samples::write_steps(work / "values");
  }
};

Image drawn(std::string const& name, std::string const& spec) {
  static Samples const made;
  auto const result = draw(name, "{\"name\":\"it\"," + spec + "}");
  CHECK_MESSAGE(result.code == 0, result.messages);
  return Image(work / name / "it.png");
}

Image lines(std::string const& name, std::string const& y, std::string const& curves) {
  return drawn(name, fmt::format(R"("kind":"lines","legend":"none","x":{{"label":"x","unit":"ms"}},
    "y":{{{}}},"curves":[{}])",
                                 y, curves));
}

std::string field(std::string const& more) {
  return R"("kind":"field","file":"values/fields.pvd",)" + more;
}

} // namespace

TEST_CASE("a dataset in another unit than the axis is converted") {
  auto const image = lines("kilopascal", R"("label":"p","unit":"kPa","range":[0,4000])",
                           R"({"file":"values/series.h5","x":"/time","y":"/crown/pressure"})");
  CHECK(image.count(blue, {0.2, 0.45, 0.15, 0.55}) > 500); // the diagonal: 1 MPa each ms
  CHECK(image.count(blue, {0.7, 0.98, 0.7, 0.98}) > 500);
}

TEST_CASE("a component is read from its own column") {
  auto const image = lines(
      "component", R"("label":"p","unit":"kPa","range":[0,10])",
      R"({"file":"values/series.h5","x":"/time","y":"/crown/traction","component":1})"); // 8.8 kPa at 2 ms
  CHECK(image.count(blue, {0.4, 0.7, 0.8, 0.98}) > 200);
  CHECK(image.count(blue, {0.5, 0.98, 0.1, 0.4}) == 0);
}

TEST_CASE("an axis shows all curves, whichever comes last") {
  for (auto const* values : {"[3,3]},{\"x\":[0,1],\"y\":[1,1]", "[3,3]},{\"x\":[0,1],\"y\":[5,5]"}) {
    auto const image =
        lines("all", R"("label":"y","unit":"1")", fmt::format(R"({{"x":[0,1],"y":{}}})", values));
    CHECK(image.count(blue) > 1000);
    CHECK(image.count(vermilion) > 1000);
  }
}

TEST_CASE("ticks say the value, of large numbers over the power that the axis names") {
  auto const room = [](std::string const& end) { // what the words at ticks take, in pixels
    auto const image =
        lines("ticks", R"("label":"y","unit":"Pa","range":[0,)" + end + "]", R"({"x":[0,1],"y":[1,2]})");
    int column = 0; // the curve begins at the axis
    auto const begins = [&](int x) {
      for (int y = 0; y < image.height(); ++y)
        if (image.at(x, y) == blue)
          return true;
      return false;
    };
    while (column < image.width() && !begins(column))
      ++column;
    return column;
  };
  int const one_digit = room("8");
  CHECK(one_digit > 40);
  CHECK(room("8e6") == one_digit);
  CHECK(room("80") > one_digit + 10);
}

TEST_CASE("a field is that of the step nearest to the time asked for") {
  auto const at = [](std::string const& time) {
    static_cast<void>(
        drawn("time", field(R"("array":"von_mises","unit":"MPa","range":[0,4],"time":)" + time)));
    return content(work / "time/it.png");
  };
  auto const last = at("\"last\"");
  CHECK(at("6e-4") == last);
  CHECK(at("4e-4") != last);
}

TEST_CASE("a vector without component is drawn by its length") {
  auto const image = drawn("length", field(R"("array":"displacement","unit":"mm","range":[0,0.9])"));
  CHECK(image.count(highest, {0, 1, 0.5, 1}) > 5000); // the block above has sunk by 1 mm
}

TEST_CASE("the colour bar spans what the window shows") {
  auto const image =
      drawn("span", field(R"("array":"displacement","unit":"mm","window":[-9,9,1,4],"window_unit":"mm")"));
  CHECK(image.count(highest, {0, 1, 0.5, 1}) > 50); // the block above is not seen
  CHECK(image.count(lowest, {0, 1, 0.5, 1}) > 300);
}
