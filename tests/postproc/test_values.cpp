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
  auto const image = drawn(
      "span",
      field(
          R"("array":"displacement","unit":"mm","window":[-9,9,1,4],"window_unit":"mm","show_time":false)"));
  CHECK(image.count(highest, {0, 1, 0.5, 1}) > 50); // the block above is not seen
  CHECK(image.count(lowest, {0, 1, 0.5, 1}) > 300);
}

TEST_CASE("error bars have the length of their errors, and the axis has room for them") {
  auto const image = lines("bars", R"("label":"y","unit":"1","range":[0,10])",
                           R"({"x":[1,2,3],"y":[5,5,5],"error":[0,3,0],"style":"points"})");
  CHECK(image.count(blue, {0.5, 0.6, 0.72, 0.78}) > 100); // up to 8
  CHECK(image.count(blue, {0.5, 0.6, 0.86, 0.98}) == 0);
  CHECK(image.count(blue, {0.15, 0.3, 0.65, 0.9}) == 0);
  auto const high = lines("high_bar", R"("label":"y","unit":"1")",
                          R"({"x":[1,2,3],"y":[0,1,0],"x_error":[0,0,1],"error":[0,9,0],"style":"points"})");
  CHECK(high.count(blue, {0.3, 0.7, 0.85, 0.98}) > 100);
  auto const below = lines("bar_below", R"("label":"y","unit":"1","log":true,"range":[0.01,100])",
                           R"({"x":[1,2,3],"y":[1,1,1],"error":[0,2,0],"style":"points"})");
  CHECK(below.count(blue, {0.5, 0.6, 0.25, 0.45}) > 50); // past 0 it goes on down
  auto const wrong = draw("few_bars", R"({"name":"it","kind":"lines","x":{"label":"x"},"y":{"label":"y"},
    "curves":[{"x":[1,2],"y":[1,2],"error":[1]}]})");
  CHECK(wrong.code == 2);
  CHECK(wrong.messages.find("has 1 numbers but the curve has 2 given points") != std::string::npos);
}

TEST_CASE("labels longer than the picture are written smaller, with their lines and their ends") {
  auto const image = drawn(
      "long_label", fmt::format(R"("kind":"lines","x":{{"label":"x"}},"y":{{"label":"y"}},
    "curves":[{{"x":[1,2],"y":[1,2],"label":"{0} a"}},{{"x":[1,2],"y":[2,1],"label":"{0} b"}}])",
                                "E with a very long label that hardly fits into any legend at all = 1 MPa"));
  CHECK(image.count(blue, {0, 0.3, 0, 0.2}) > 30); // the line in the legend, below
  CHECK(image.white_rim());
}

TEST_CASE("a line of one point is a point") {
  auto const image = lines("alone", R"("label":"y","unit":"1","range":[0,10])", R"({"x":[2],"y":[5]})");
  CHECK(image.count(blue, {0.15, 0.98, 0.2, 0.9}) > 30);
}

TEST_CASE("a field tells the time of its frame, not the time asked for") {
  auto const with = drawn("with_time", field(R"("array":"von_mises","unit":"MPa")"));
  auto const without = drawn("without_time", field(R"("array":"von_mises","unit":"MPa","show_time":false)"));
  int const strip = with.height() - without.height();
  CHECK(strip > 20);
  double const below = 1 - static_cast<double>(strip) / with.height();
  CHECK(with.count(axis, {0.75, 1, below, 1}) > 50);
  CHECK(with.count(axis, {0, 0.75, below, 1}) == 0);
  auto const picture = [](std::string const& time) {
    static_cast<void>(drawn("same_frame", field(R"("array":"beta","range":[0,1],"time":)" + time)));
    return content(work / "same_frame/it.png");
  };
  CHECK(picture("9e-4") == picture("1e-3"));
}

TEST_CASE("lines of the mesh are light on dark colours and dark on light ones") {
  auto const shades = [](std::string const& name, std::string const& range) {
    auto const image = drawn(
        name, field(R"("array":"beta","mesh":true,"window":[-3,3,5.2,6.8],"window_unit":"mm",)" + range));
    std::pair<int, int> found; // light, dark
    for (int y = image.height() / 2; y < image.height() * 0.8; ++y)
      for (int x = image.width() / 10; x < image.width() * 0.9; ++x) {
        auto const [r, g, b] = image.at(x, y);
        found.first += r > 120 && g > 120 && b > 120 ? 1 : 0;
        found.second += r < 110 && g < 110 && b < 50 ? 1 : 0;
      }
    return found;
  };
  auto const [light, none] = shades("dark", R"("range":[0,1])");
  CHECK(light > 500);
  CHECK(none == 0);
  auto const [no, dark] = shades("bright", R"("range":[-1,0])");
  CHECK(no == 0);
  CHECK(dark > 500);
}

TEST_CASE("points bear their names, and triangles where the value is at most what they show") {
  auto const shown = [](std::string const& name, std::string const& more) {
    auto const image = lines(name, R"("label":"y","unit":"1","range":[0,10])",
                             R"({"x":[1,2,3],"y":[5,5,5],"style":"points")" + more + "}");
    return std::pair(image.count(blue, {0.53, 0.58, 0.53, 0.539}),
                     image.count(blue, {0.562, 0.6, 0.565, 0.6}));
  };
  CHECK(shown("discs", "") == std::pair(0, 0));
  auto const [tip, none] = shown("triangle", R"(,"at_most":[0,1,0])"); // reaches lower than the disc
  CHECK(tip > 3);
  CHECK(none == 0);
  auto const [disc, letter] = shown("named", R"(,"names":["a","M","c"])");
  CHECK(disc == 0);
  CHECK(letter > 50);
  auto const refused = [](std::string const& more, std::string const& word) {
    auto const wrong = draw("bad_point", R"({"name":"it","kind":"lines","x":{"label":"x"},"y":{"label":"y"},
    "curves":[{"x":[1,2],"y":[1,2])" + more + "}]}");
    CHECK(wrong.code == 2);
    CHECK_MESSAGE(wrong.messages.find(word) != std::string::npos, wrong.messages);
  };
  refused(R"(,"names":["a"])", "names: has 1 texts but the curve has 2 given points");
  refused(R"(,"names":["a",2])", "names: has 1 texts");
  refused(R"(,"at_most":[1])", "at_most: wants 0 or 1 for each given point");
}
