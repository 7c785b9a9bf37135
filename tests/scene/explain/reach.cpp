// Whether a half space would do in place of a block: leading terms against closed forms, and scenes told
// apart.
#include <doctest/doctest.h>
#include <numbers>

#include "scene/explain/explain.hpp"
#include "scene/explain/reach.hpp"
#include "scene/scenes.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

constexpr double pi = std::numbers::pi;

/// A block of radius 20 m and height 10 m, E = 1 MPa, under a sphere of 100 m that goes down by this, m.
Input dented(double depth, double poisson = 0.3, double height = 10) {
  auto scene = make("scene");
  at(scene, "kinematics") = text("axisymmetric");
  at(scene, "bodies.block") = block({{0, -height}, {20, height}, {20, 10}}, linear_elastic(1e6, poisson));
  at(scene, "obstacles.ball") =
      make("obstacle",
           {{"shape", make("rigid.sphere", {{"centre", values({0, 100}, "m")}, {"radius", value(100, "m")}})},
            {"times", values({0, 1}, "s")},
            {"y", values({0, -depth}, "m")}});
  at(scene, "pairs.touch") = pair("block.top", "ball");
  at(scene, "motions") = list({fix("block.bottom")});
  at(scene, "scheme") = quasi_static();
  at(scene, "schedule") = schedule({{1, 1}});
  return scene;
}

/// What is said of a half space; nothing: the line is not there.
std::optional<scene::Line> said(Input const& input) {
  for (auto const& section : scene::explain(input).sections)
    for (auto const& line : section.lines)
      if (line.name == "half space")
        return line;
  return {};
}

} // namespace

TEST_CASE("what a base takes from the depth is that of a layer by elasticity") {
  CHECK(scene::base_number(0, false) == doctest::Approx(1.16758).epsilon(1e-4));
  CHECK(scene::base_number(0.4, false) == scene::base_number(0, false));
  // Dimitriadis 2002 fitted 2 c / pi = 1.133 where nothing can be compressed and the base holds
  CHECK(2 / pi * scene::base_number(0.5, true) == doctest::Approx(1.133).epsilon(0.01));
  CHECK(scene::base_number(0.5, true) == doctest::Approx(1.77022).epsilon(1e-4));
  CHECK(scene::base_number(0, true) == doctest::Approx(1.21106).epsilon(1e-4));
}

TEST_CASE("contact under JKR's adhesion is at its approach, and Hertz's without") {
  CHECK(scene::contact_radius(0.04, 25, 0) == doctest::Approx(1));
  for (double const depth : {-0.01, 0.0, 0.04}) {
    double const a = scene::contact_radius(depth, 25, 1e-4);
    CHECK(std::abs(a * a / 25 - std::sqrt(2 * pi * 1e-4 * a) - depth) < 1e-12);
  }
}

TEST_CASE("the error of a half space has the leading terms of base, sides and strain") {
  scene::Reach reach{.contact = 1,
                     .slope = 1e-9,
                     .thickness = 1e4,
                     .width = 1e9,
                     .poisson = 0.3,
                     .stuck = true,
                     .small_strain = true};
  CHECK(scene::error_of(reach).total() / (2 / pi * 1.37685e-4) == doctest::Approx(1).epsilon(1e-3));
  reach.width = 10;
  auto const narrow =
      scene::error_of(reach); // a bar of length h: P h / (pi L^2 E), less what its end is stiffer
  double const x = 2 / pi * (1e4 / 0.91 / 100 - 0.2);
  CHECK(narrow.sides == doctest::Approx(x / (1 + x)).epsilon(1e-9));
  CHECK(narrow.total() == doctest::Approx(narrow.sides).epsilon(1e-6));
  reach.width = reach.thickness = 1e9;
  reach.slope = 1e-3; // (1 - 2 nu) / (1 - nu) / pi of a/R
  CHECK(scene::error_of(reach).total() / (0.4 / 0.7 / pi * 1e-3) == doctest::Approx(1).epsilon(1e-4));
  reach.poisson = 0.5;
  CHECK(scene::error_of(reach).total() / 0.32e-6 == doctest::Approx(1).epsilon(1e-2));
  reach.balance = 3; // what pulls nearly holds what presses
  CHECK(scene::error_of(reach).larger / 0.96e-6 == doctest::Approx(1));
}

TEST_CASE("a block under a sphere is told to what share a half space would do") {
  auto const thick = said(dented(1e-4)); // a = 0.1
  REQUIRE(thick);
  CHECK(thick->words == "would do to 1 %");
  double const base = 2 / pi * scene::base_number(0.3, true) * 0.01;
  CHECK(thick->value / (base + 7.0 / 6 * base * base + 0.4 / 0.7 / pi * 1e-3) ==
        doctest::Approx(1).epsilon(1e-3));
  auto const thin = said(dented(0.04)); // a = 2
  REQUIRE(thin);
  CHECK(thin->words == "would not do");
  CHECK(thin->value > 0.2);
  CHECK(thin->meaning.find("larger by the base, at most about 2") != std::string::npos);
  auto const tall = said(dented(0.01, 0.3, 200)); // a = 1, a bar
  REQUIRE(tall);
  CHECK(tall->words == "would not do");
  CHECK(tall->meaning.find("smaller by the sides, 2") != std::string::npos);
}

TEST_CASE("a base that slides is softer than one that is stuck") {
  auto input = dented(1e-3, 0.49);
  auto const stuck = said(input);
  at(input, "motions") = list({fix("block.bottom", false, true)});
  auto const slides = said(input);
  REQUIRE(stuck);
  REQUIRE(slides);
  CHECK(slides->value < 0.8 * stuck->value);
}

TEST_CASE("adhesion and large strains add to the error") {
  auto input = dented(1e-4);
  double const dry = said(input)->value;
  at(input, "bodies.block.material") =
      make("material.neo_hookean", {{"young", value(1e6, "Pa")}, {"poisson", value(0.3)}});
  double const large = said(input)->value;
  CHECK((large - dry) / 0.06e-3 == doctest::Approx(1));
  at(input, "pairs.touch.adhesion") = make(
      "adhesion.dugdale", {{"sigma0", value(1000, "Pa")}, {"h0", value(1e-3, "m")}, {"ramp", value(0.2)}});
  CHECK(said(input)->value > 2 * large);
}

TEST_CASE("a punch is as wide as it lies within the depth") {
  auto input = dented(1e-3);
  at(input, "obstacles.ball.shape") =
      make("rigid.polyline", {{"points", values({0, 0, 0.5, 0, 1.5, 0.01}, "m")}});
  auto const punch = said(input);
  REQUIRE(punch);
  scene::Reach const reach{.contact = 0.6,
                           .slope = 1e-3 / 0.6,
                           .thickness = 10,
                           .width = 20,
                           .poisson = 0.3,
                           .stuck = true,
                           .small_strain = true};
  CHECK(punch->value / scene::error_of(reach).total() == doctest::Approx(1));
}

TEST_CASE("where the estimate does not hold nothing is said of a half space") {
  CHECK(said(dented(1e-3)));
  auto plane = dented(1e-3);
  at(plane, "kinematics") = text("plane_strain");
  at(plane, "motions") = list({fix("block.bottom"), fix("block.left", true, false)});
  CHECK(!said(plane));
  auto held = dented(1e-3);
  at(held, "motions") = list({fix("block.bottom"), fix("block.right", true, false)});
  CHECK(!said(held));
  auto rubbed = dented(1e-3);
  at(rubbed, "pairs.touch.friction") = coulomb(0.3);
  CHECK(!said(rubbed));
  auto swelling = dented(1e-3, -0.1);
  CHECK(!said(swelling));
  auto foam = dented(1e-3);
  at(foam, "bodies.block.material") = make("material.blatz_ko", {{"shear_modulus", value(1e6, "Pa")}});
  CHECK(!said(foam));
  auto rubber = dented(1e-3);
  auto const mooney = [](double c10, double c01) {
    return make("material.mooney_rivlin",
                {{"C10", value(c10, "Pa")}, {"C01", value(c01, "Pa")}, {"bulk_modulus", value(1e7, "Pa")}});
  };
  at(rubber, "bodies.block.material") = mooney(2e5, 1e5);
  CHECK(said(rubber));
  at(rubber, "bodies.block.material") = mooney(4e5, -1e5);
  CHECK(!said(rubber));
  auto ring = dented(1e-3);
  at(ring, "obstacles.ball.shape") =
      make("rigid.circle", {{"centre", values({3, 2}, "m")}, {"radius", value(2, "m")}});
  CHECK(!said(ring));
  auto heavy = dented(1e-3);
  at(heavy, "gravity") = values({0, -10}, "m/s^2");
  CHECK(!said(heavy));
}
