// Pictures of solids: all kinds of cells, images, cuts, spheres, and specs that are wrong.
#include <cmath>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "harness.hpp"
#include "samples.hpp"

namespace {

using namespace harness;
constexpr Colour lowest{68, 1, 84};
constexpr int single_column = 1004;

/// A figure "it" of a sample solid with further keys.
std::string solid(std::string const& kind, std::string const& keys) {
  if (!std::filesystem::exists(work / (kind + ".vtu")))
    samples::write_solid(work / (kind + ".vtu"), kind);
  return fmt::format(R"({{"name":"it","kind":"field","file":"{}.vtu","window_unit":"mm",{}}})", kind, keys);
}

std::string const stress = R"("array":"von_mises","unit":"MPa","label":"von Mises stress",)";
std::string const seen = R"("view":{"azimuth":30,"elevation":25})";

/// How many pixels are neither white nor grey within a part of the picture.
int coloured(Image const& image, std::array<double, 4> part) {
  int found = 0;
  for (int y = static_cast<int>(part[2] * image.height()); y < static_cast<int>(part[3] * image.height());
       ++y)
    for (int x = static_cast<int>(part[0] * image.width()); x < static_cast<int>(part[1] * image.width());
         ++x) {
      auto const [r, g, b] = image.at(x, y);
      found += std::abs(r - g) + std::abs(g - b) > 20 ? 1 : 0;
    }
  return found;
}

Image picture_of(std::string const& name, std::string const& figure) {
  auto const result = draw(name, figure);
  REQUIRE_MESSAGE(result.code == 0, result.messages);
  return Image(work / name / "it.png");
}

void refused(std::string const& name, std::string const& figure, int code, std::string const& word) {
  auto const result = draw(name, figure);
  CHECK_MESSAGE(result.code == code, name);
  CHECK_MESSAGE(result.messages.find(word) != std::string::npos, result.messages);
  CHECK_FALSE(std::filesystem::exists(work / name / "it.png"));
}

} // namespace

TEST_CASE("solids of every kind of cell give the same picture up to their mesh") {
  int const reference = coloured(picture_of("solid_hex8", solid("hex8", stress + seen)), {0, 1, 0.2, 1});
  for (std::string const kind : {"tet4", "tet10", "hex8", "hex20"}) {
    auto const image =
        picture_of("solid_" + kind, solid(kind, stress + R"("deformed":true,"mesh":true,)" + seen));
    CHECK(image.width() == single_column);
    CHECK(image.height() > 800);
    CHECK(image.white_rim());
    CHECK(image.colours() > 500);
    auto const plain = picture_of("plain_" + kind, solid(kind, stress + seen));
    CHECK(std::abs(coloured(plain, {0, 1, 0.2, 1}) - reference) < 0.01 * reference);
  }
}

TEST_CASE("a picture of a solid repeats bit by bit") {
  auto const figure = solid("hex20", stress + seen +
                                         R"(,"mirror":["x","y"],"mesh":true,"deformed":true,"crop":{"zmin":1},
                                         "sphere":{"centre":[0,0,9],"radius":4})");
  REQUIRE(draw("again", figure).code == 0);
  auto const first = content(work / "again/it.png");
  REQUIRE(draw("again", figure).code == 0);
  CHECK(content(work / "again/it.png") == first);
}

TEST_CASE("the image of a quarter is symmetric and has no seam") {
  auto const image = picture_of(
      "above", solid("hex8", R"("array":"beta","mirror":["x","y"],"view":{"azimuth":0,"elevation":90})"));
  int differing = 0, samples = 0;
  for (int y = image.height() / 2; y < image.height() * 9 / 10; y += 7)
    for (int x = 40; x < image.width() / 2; x += 7, ++samples) {
      auto const a = image.at(x, y), b = image.at(image.width() - 1 - x, y);
      differing += std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) > 12 ? 1 : 0;
    }
  CHECK(samples > 1000);
  CHECK(differing < 0.01 * samples);
  CHECK(image.count({38, 38, 38}, {0.3, 0.7, 0.4, 0.9}) == 0); // no line of an inner edge
}

TEST_CASE("the component of a vector along the mirrored axis changes sign in the image") {
  auto const keys = [](int component) {
    return fmt::format(
        R"("array":"displacement","component":{},"unit":"um","mirror":["x"],"show_time":false,"range":[-160,160],
      "view":{{"azimuth":0,"elevation":90}})",
        component);
  };
  auto const along = picture_of("along", solid("hex8", keys(0))); // x: negative left, positive right
  auto const across = picture_of("across", solid("hex8", keys(1)));
  auto difference = [](Image const& image) { // of blue less red between a pixel and its image, the mean
    double sum = 0;
    int count = 0;
    for (int x = image.width() / 3; x < 0.45 * image.width(); ++x, ++count) {
      auto const a = image.at(x, image.height() / 2 - 10),
                 b = image.at(image.width() - 1 - x, image.height() / 2 - 10);
      sum += (a[2] - a[0]) - (b[2] - b[0]);
    }
    return sum / count;
  };
  CHECK(difference(along) > 15);
  CHECK(std::abs(difference(across)) < 2);
}

TEST_CASE("a cut opens the solid and a window enlarges it") {
  auto const front = R"("view":{"azimuth":0,"elevation":0},"range":[0,5],)";
  auto const whole = picture_of("whole", solid("tet10", stress + front + R"("mirror":["x","y"])"));
  auto const open =
      picture_of("open", solid("tet10", stress + front + R"("mirror":["x"],"crop":{"ymin":0})"));
  CHECK(whole.count(lowest, {0, 1, 0.35, 1}) == 0); // light from aside
  auto const warm = [](Image const& image) {        // what only the inside has: more than 3 MPa
    int found = 0;
    for (int y = image.height() / 2; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x)
        found += image.at(x, y)[1] > 130 && image.at(x, y)[2] < 110 ? 1 : 0;
    return found;
  };
  CHECK(warm(whole) == 0);
  CHECK(warm(open) > 3000);
  auto const near =
      picture_of("near", solid("tet10", stress + front + R"("mirror":["x"],"window":[-2,2,2,5])"));
  CHECK(warm(near) > 5 * warm(open));
}

TEST_CASE("a sphere is drawn where its path has taken it") {
  auto const figure = [](std::string const& z) {
    return solid("hex8", stress +
                             R"("mirror":["x","y"],"view":{"azimuth":0,"elevation":0},"window":[-9,9,0,19],
      "sphere":{"centre":[0,0,8],"radius":2,"path":{"times":[0,2e-3],"z":)" +
                             z + "}}");
  };
  auto grey = [](Image const& image, std::array<double, 4> part) {
    return image.count({110, 110, 110}, part);
  };
  auto const low = picture_of("low", figure("[0,0]")),
             high = picture_of("high", figure("[0,16]")); // half at 1 ms
  CHECK(grey(low, {0.3, 0.7, 0.45, 0.72}) > 300);
  CHECK(grey(low, {0.3, 0.7, 0.78, 0.97}) == 0);
  CHECK(grey(high, {0.3, 0.7, 0.78, 0.97}) > 300);
  CHECK(grey(high, {0.3, 0.7, 0.45, 0.72}) == 0);
}

TEST_CASE("a half of a plane mesh is completed, and a rigid circle drawn over it") {
  samples::write_curved(work / "half.vtu"); // x from 0 to 1
  std::string const keys = R"("name":"it","kind":"field","file":"half.vtu","array":"beta","range":[0,1])";
  auto const whole =
      picture_of("plane", "{" + keys + R"(,"mirror":["x"],"sphere":{"centre":[0,2],"radius":1}})");
  auto const yellow = [&whole](std::array<double, 4> part) { return whole.count({253, 231, 37}, part); };
  CHECK(yellow({0.1, 0.4, 0.2, 0.5}) > 5000);
  int differing = 0;
  for (int x = 0; x < whole.width() / 2; ++x)
    differing +=
        whole.at(x, whole.height() / 3) == whole.at(whole.width() - 1 - x, whole.height() / 3) ? 0 : 1;
  CHECK(differing <= 5); // the line along the rim, of 2.5 pixels and their smoothing
  CHECK(whole.count({110, 110, 110}, {0, 1, 0.5, 1}) > 2000);
}

TEST_CASE("wrong keys of a solid end with 2 and say what is wanted") {
  refused("azimut", solid("hex8", stress + R"("view":{"azimut":3})"), 2, "did you mean \"azimuth\"");
  refused("steep", solid("hex8", stress + R"("view":{"elevation":100})"), 2, "elevation");
  refused("axis", solid("hex8", stress + seen + R"(,"mirror":["w"])"), 2, "mirror");
  refused("twice", solid("hex8", stress + seen + R"(,"mirror":["x","x"])"), 2, "each once");
  refused("box", solid("hex8", stress + seen + R"(,"crop":{"xmin":2,"xmax":1})"), 2, "greater than xmin");
  refused("plane_crop", solid("hex8", stress + R"("crop":{"xmin":2})"), 2, "view");
  refused("centre", solid("hex8", stress + seen + R"(,"sphere":{"centre":[0,1],"radius":1})"), 2,
          "[x, y, z]");
  refused("radius", solid("hex8", stress + seen + R"(,"sphere":{"centre":[0,1,2],"radius":-1})"), 2,
          "radius");
  refused("path", solid("hex8", stress + seen + R"(,"sphere":{"centre":[0,1,2],"radius":1,
    "path":{"times":[0,1],"z":[0]}})"),
          2, "times has 2");
  refused("no_view", solid("hex8", stress + R"("mesh":true)"), 2, "solid");
}

TEST_CASE("what cannot be cut or mirrored ends with 1") {
  refused("nothing", solid("hex8", stress + seen + R"(,"crop":{"xmin":50})"), 1, "crop");
  samples::write_grid(work / "sides.vtu", 1e-3);
  refused("sides", R"({"name":"it","kind":"field","file":"sides.vtu","array":"beta","mirror":["x"]})", 1,
          "both sides of x = 0");
}
