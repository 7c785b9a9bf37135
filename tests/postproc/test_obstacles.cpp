// Rigid obstacles behind plane meshes: where they are, what is seen of them, specs that are wrong.
#include <cmath>
#include <doctest/doctest.h>

#include "harness.hpp"
#include "samples.hpp"

namespace {

using namespace harness;

constexpr Colour grey{226, 226, 226},
    line{110, 110, 110}; // a few pixels at rims of letters have the grey too

/// The sample's block and half-disc, 18 mm wide and 7 mm high, with obstacles in mm.
std::string field(std::string const& obstacles, std::string const& more = "") {
  samples::write_steps(work / "rigid");
  return R"({"name":"it","kind":"field","file":"rigid/fields.pvd","array":"von_mises","unit":"MPa","show_time":false,)"
         R"("window_unit":"mm","obstacles":[)" +
         obstacles + "]" + more + "}";
}

Image picture_of(std::string const& name, std::string const& figure) {
  auto const result = draw(name, figure);
  REQUIRE_MESSAGE(result.code == 0, result.messages);
  return Image(work / name / "it.png");
}

} // namespace

TEST_CASE("a half-plane is grey on its inner side, as far as a strip beside the mesh") {
  auto const without = picture_of("no_floor", field(""));
  auto const image = picture_of("floor", field(R"({"point":[0,0],"normal":[0,1]})"));
  CHECK(without.count(grey) < 5);
  CHECK(image.count(grey, {0.05, 0.95, 0.25, 0.5}) > 20000); // below the mesh, above the bar
  CHECK(image.count(grey, {0, 1, 0.55, 1}) == 0);
  auto const roof = picture_of("roof", field(R"({"point":[0,7],"normal":[0,-1]})"));
  CHECK(roof.count(grey, {0, 1, 0.8, 1}) > 20000);
  CHECK(roof.count(grey, {0, 1, 0, 0.7}) < 5);
}

TEST_CASE("an obstacle is drawn where its path has taken it, and turned about its pivot") {
  auto const window = R"(,"window":[-12,12,-6,10])";
  auto const disc = [&](std::string const& name, std::string const& more) {
    return picture_of(name, field(R"({"centre":[-10,-4],"radius":1.5)" + more + "}", window));
  };
  auto const left = disc("start", ""), right = disc("end", R"(,"path":{"times":[0,1e-3],"x":[0,20]})");
  std::array<double, 4> const at_left{0, 0.3, 0.2, 0.6}, at_right{0.7, 1, 0.2, 0.6};
  CHECK(left.count(grey, at_left) > 5000);
  CHECK(left.count(grey, at_right) == 0);
  CHECK(right.count(grey, at_left) == 0);
  CHECK(std::abs(right.count(grey, at_right) - left.count(grey, at_left)) < 100);
  auto const turned = disc("turned", R"(,"pivot":[0,-4],"path":{"times":[0,1e-3],"angle":[0,3.14159265]})");
  CHECK(std::abs(turned.count(grey, at_right) - left.count(grey, at_left)) < 100);
}

TEST_CASE("a hollow shape and an open outline are lines, a closed outline is an area behind the mesh") {
  auto const hollow = picture_of("hollow", field(R"({"centre":[0,0],"radius":9,"hollow":true})"));
  CHECK(hollow.count(grey) < 5);
  CHECK(hollow.count(line) > 1000);
  auto const open = picture_of("outline", field(R"({"points":[9,-0.5,0,-0.3,-9,-0.5]})"));
  CHECK(open.count(grey) < 5);
  CHECK(open.count(line) > 500);
  auto const notch = picture_of(
      "notch", field(R"({"points":[-9,-3,9,-3,9,0,0,-2,-9,0],"closed":true})", R"(,"window":[-9,9,-3,7])"));
  CHECK(notch.count(grey, {0.05, 0.3, 0.25, 0.5}) > 2000);
  CHECK(notch.count(grey, {0.4, 0.6, 0.4, 0.6}) == 0); // within the notch, and behind the mesh
}

TEST_CASE("wrong obstacles end with 2 and say what is wanted") {
  auto const refused = [](std::string const& obstacle, std::string const& word) {
    auto const result = draw("bad_obstacle", field(obstacle));
    CHECK_MESSAGE(result.code == 2, obstacle);
    CHECK_MESSAGE(result.messages.find(word) != std::string::npos, result.messages);
  };
  refused(R"({"centre":[0,0,0],"radius":1})", "has 3 numbers; [x, y] is wanted");
  refused(R"({"point":[0,0],"normal":[0,0]})", "normal: is zero");
  refused(R"({"points":[0,0,1]})", "has 3 numbers; at least two points");
  refused(R"({"point":[0,0],"normal":[0,1],"path":{"times":[0,1],"y":[1]}})", "times has 2");
  refused(R"({"radius":1})", "centre");
}
