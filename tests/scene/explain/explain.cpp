// Explanations: each warning in a scene made for it and not in a sound one; numbers against hand formulas.
#include <doctest/doctest.h>

#include "scene/build/fit.hpp"
#include "scene/description/human.hpp"
#include "scene/explain/explain.hpp"
#include "scene/scenes.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

scene::Line const& line(scene::Explanation const& explanation, std::string const& title,
                        std::string const& name) {
  for (auto const& section : explanation.sections)
    if (section.title == title)
      for (auto const& line : section.lines)
        if (line.name == name)
          return line;
  throw std::logic_error("no line " + title + ", " + name);
}
double number(scene::Explanation const& explanation, std::string const& title, std::string const& name) {
  return line(explanation, title, name).value;
}

/// Warnings that say `text`.
std::vector<scene::Warning> warnings(Input const& input, std::string const& text) {
  std::vector<scene::Warning> found;
  for (auto const& warning : scene::explain(input).warnings)
    if (warning.text.find(text) != std::string::npos)
      found.push_back(warning);
  return found;
}
bool contains(std::string const& text, std::string const& part) {
  return text.find(part) != std::string::npos;
}
bool warns(Input const& input, std::string const& text) {
  return !warnings(input, text).empty();
}

/// foot_on_floor with bonds.
Input bonded(double w, double C, double b) {
  auto input = foot_on_floor();
  at(input, "pairs.sole.adhesion") = rcc(w, C, b);
  return input;
}
Input elastic(char const* kind, double young, double poisson) {
  return make(std::string("material.") + kind, {{"young", value(young, "Pa")}, {"poisson", value(poisson)}});
}

} // namespace

TEST_CASE("a sound scene has nothing to change, and says what it models") {
  auto const explanation = scene::explain(foot_on_floor());
  CHECK(explanation.warnings.empty());
  CHECK(number(explanation, "Body foot", "nodes") == 25);
  CHECK(number(explanation, "Body foot", "unknowns") == 2 * 25 - 2 * 5);
  CHECK(number(explanation, "Body foot", "mass") == doctest::Approx(1));
  CHECK(number(explanation, "Pair sole", "contact points") == 5);
  CHECK(number(explanation, "Pair sole", "components") == 1);
  CHECK(number(explanation, "Pair sole", "state") == sizeof(dynamics::ContactState));
  CHECK(number(explanation, "Run", "stage 2") == 10);
  CHECK(number(explanation, "Cost", "steps") == 14);
  CHECK(number(explanation, "Cost", "unknowns") == 40);
  CHECK(number(explanation, "Cost", "contact unknowns") == 10);
  CHECK(number(explanation, "Cost", "factor") >= 40 * 41 / 2 / 4);
  CHECK(number(explanation, "Cost", "memory") > 8 * number(explanation, "Cost", "factor"));
}

TEST_CASE("constraints are told, of tied surfaces how far their nodes have moved") {
  auto input = two_blocks();
  remove(input, "pairs");
  at(input, "bodies.upper") = block({{0, 0.02}, {1, 1}, {3, 2}}, linear_elastic(1000, 0));
  at(input, "constraints") = list({tied("upper.bottom", "lower.top"), periodic("lower.left", "lower.right")});
  auto const explanation = scene::explain(input);
  CHECK(line(explanation, "Constraints", "upper.bottom").words ==
        "tied to lower.top, its nodes moved onto it by up to 20 mm");
  CHECK(line(explanation, "Constraints", "lower.left").words == "moves as lower.right");
  CHECK(number(explanation, "Constraints", "followers") == 2 * 4 + 2 * 4);
}

TEST_CASE("numbers of bodies and motions are those of the formulas") {
  auto const explanation = scene::explain(foot_on_floor());
  double const c = std::sqrt(500.0);
  CHECK(number(explanation, "Numbers of body foot", "c_s") == doctest::Approx(c));
  CHECK(number(explanation, "Numbers of body foot", "speed / c_s") == doctest::Approx(0.1 / c));
  CHECK(number(explanation, "Numbers of body foot", "run / transit") == doctest::Approx(2 * c));
  CHECK_THROWS(line(explanation, "Numbers of body foot", "step / transit of a cell")); // of dynamic runs
  auto dynamic = foot_on_floor();
  at(dynamic, "scheme") = make("scheme.theta_xi");
  CHECK(number(scene::explain(dynamic), "Numbers of body foot", "step / transit of a cell") ==
        doctest::Approx(0.25 * std::sqrt(1000.0) / 0.25));
  CHECK(number(explanation, "Numbers of body foot", "K / G") == doctest::Approx(2.0 / 3));
  CHECK(number(explanation, "Numbers of pair sole", "E*") == doctest::Approx(1000));
  CHECK(number(explanation, "Numbers of pair sole", "closing speed") == doctest::Approx(0.01));
  CHECK(number(explanation, "Numbers of pair sole", "opening speed") == doctest::Approx(0));
  CHECK(number(explanation, "Numbers of pair sole", "sliding speed") == doctest::Approx(0.1));
  CHECK(number(explanation, "Numbers of pair sole", "depth") == doctest::Approx(0.01));
  CHECK(number(explanation, "Numbers of pair sole", "strain") == doctest::Approx(0.01));
  CHECK(number(explanation, "Numbers of pair sole", "closing per step / cell") == doctest::Approx(0.01));
}

TEST_CASE("numbers of bonds are those of the formulas") {
  auto const explanation = scene::explain(bonded(4, 1000, 40));
  std::string const title = "Numbers of pair sole";
  double const u0 = std::sqrt(0.004);
  CHECK(number(explanation, title, "sigma0") == doctest::Approx(std::sqrt(4000.0)));
  CHECK(number(explanation, title, "u0") == doctest::Approx(u0));
  CHECK(number(explanation, title, "sigma0 / E*") == doctest::Approx(std::sqrt(4000.0) / 1000));
  CHECK(number(explanation, title, "cohesive length") == doctest::Approx(1));
  CHECK(number(explanation, title, "cohesive length / cell") == doctest::Approx(4));
  CHECK(number(explanation, title, "stiffness / (3 C_n)") == doctest::Approx(1.0 / 3));
  CHECK(number(explanation, title, "bonding time") == doctest::Approx(10));
  CHECK(number(explanation, title, "closed / bonding time") == doctest::Approx(0.2));
  CHECK(number(explanation, title, "V* normal") == doctest::Approx(0.01 * 10 / u0));
  CHECK(number(explanation, title, "V* along") == doctest::Approx(0.1 * 10 / u0));
  CHECK(number(explanation, title, "bonding per step") == doctest::Approx(0.025));
  CHECK(number(explanation, title, "sliding per step / u0") == doctest::Approx(0.01 / u0));
  CHECK(number(explanation, "Pair sole", "components") == 2);
  CHECK(explanation.warnings.empty());
  auto softer = bonded(4, 1000, 40);
  at(softer, "pairs.sole.adhesion.C_t") = value(250, "N/m^3");
  CHECK(number(scene::explain(softer), title, "V* along") ==
        doctest::Approx(0.1 * 10 / std::sqrt(4.0 / 250)));
}

TEST_CASE("closing and sliding are told apart where a motion does both at once") {
  auto input = foot_on_floor();
  at(input, "motions") = list({drive("foot.top", {0, 1, 2}, {0, 0, 0.004}, {0, -0.01, -0.02})});
  auto const explanation = scene::explain(input);
  CHECK(number(explanation, "Numbers of pair sole", "closing speed") == doctest::Approx(0.01));
  CHECK(number(explanation, "Numbers of pair sole", "sliding speed") == doctest::Approx(0.004));
}

TEST_CASE("contact lasts until the motion has gone back past the touch") {
  auto input = bonded(4, 1000, 40);
  at(input, "motions") = list({drive("foot.top", {0, 1, 2}, {0, 0, 0}, {0, -0.01, 0.01})});
  at(input, "schedule") = schedule({{1, 10}, {2, 10}});
  CHECK(number(scene::explain(input), "Numbers of pair sole", "closed / bonding time") ==
        doctest::Approx(0.15));
}

TEST_CASE("both sides of a pair are soft, and both are round") {
  auto blocks = two_blocks();
  at(blocks, "bodies.lower.material.young") = value(3000, "Pa");
  CHECK(number(scene::explain(blocks), "Numbers of pair joint", "E*") == doctest::Approx(750));
  auto input = foot_on_floor();
  remove(input, "bodies.foot");
  at(input, "bodies.disc") = half_disc(1, 0.1, linear_elastic(1000, 0));
  at(input, "obstacles.floor.shape") =
      make("rigid.circle", {{"centre", values({0, 2}, "m")}, {"radius", value(2, "m")}});
  at(input, "pairs.sole") = pair("disc.arc", "floor");
  at(input, "motions") = list({fix("disc.flat")});
  CHECK(number(scene::explain(input), "Numbers of pair sole", "radius") == doctest::Approx(2.0 / 3));
}

TEST_CASE("a sphere's Tabor-like number and strain follow from its radius") {
  auto input = bonded(4, 1000, 40);
  at(input, "obstacles.floor.shape") =
      make("rigid.circle", {{"centre", values({0.5, -2}, "m")}, {"radius", value(2, "m")}});
  auto const explanation = scene::explain(input);
  CHECK(number(explanation, "Numbers of pair sole", "radius") == doctest::Approx(2));
  CHECK(number(explanation, "Numbers of pair sole", "Tabor-like") ==
        doctest::Approx(std::cbrt(2 * 16.0 / 1e6) / std::sqrt(0.004)));
  CHECK(number(explanation, "Numbers of pair sole", "strain") == doctest::Approx(0.4 * std::sqrt(0.01 / 2)));
}

TEST_CASE("a stiff flat body is to become a rigid plane") {
  auto input = two_blocks();
  at(input, "bodies.lower") = block({{-2, -1}, {5, 1}, {20, 4}}, linear_elastic(1000, 0));
  CHECK_FALSE(warns(input, "times stiffer"));
  at(input, "bodies.lower.material.young") = value(1e7, "Pa");
  auto const found = warnings(input, "body lower is 10000 times stiffer than body upper");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "rigid.plane through {500 mm, 0 m}"));
  CHECK(contains(found[0].change, "changes by at most about 0.023 %"));
  CHECK(contains(found[0].change, "168 of 208 unknowns"));
  CHECK(number(scene::explain(input), "Numbers of pair joint", "stiffness contrast") == doctest::Approx(1e4));
  at(input, "bodies.lower") = block({{0, -1}, {1, 1}, {4, 4}}, linear_elastic(1e7, 0));
  CHECK_FALSE(warns(input, "times stiffer")); // the upper one slides over its edge
}

TEST_CASE("a stiff half disc is to become a rigid circle") {
  auto input = foot_on_floor();
  at(input, "bodies.disc") = half_disc(1, 0.02, linear_elastic(1e7, 0));
  at(input, "obstacles") = make("obstacles");
  at(input, "pairs.sole") = pair("foot.bottom", "disc.arc");
  at(input, "motions") =
      list({drive("foot.top", {0, 1, 2}, {0, 0, 0.1}, {0, -0.01, -0.01}), fix("disc.flat")});
  auto const found = warnings(input, "body disc is 10000 times stiffer");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "rigid.circle{centre = {0 m, -1 m}, radius = 1 m}"));
}

TEST_CASE("a cohesive length below three cells makes the pull-off depend on the mesh") {
  CHECK_FALSE(warns(bonded(4, 1000, 40), "will depend on the mesh"));
  auto const found = warnings(bonded(4, 2000, 40), "cohesive length 500 mm, mesh 250 mm");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "cells of 83.3 mm or less at foot.bottom"));
}

TEST_CASE("bonds that are nowhere at the start, and that nothing makes, are told of") {
  auto const law = [](double beta0) {
    return make("adhesion.bilinear", {{"K", value(1e5, "N/m^3")},
                                      {"sigma_n", value(40, "Pa")},
                                      {"sigma_t", value(40, "Pa")},
                                      {"G_I", value(4, "J/m^2")},
                                      {"G_II", value(4, "J/m^2")},
                                      {"beta0", value(beta0)}});
  };
  auto input = bonded(4, 1000, 40);
  CHECK_FALSE(warns(input, "nothing will adhere")); // RCC's form in contact, or are there
  at(input, "pairs.sole.adhesion") = law(1);
  CHECK_FALSE(warns(input, "nothing will adhere"));
  at(input, "pairs.sole.adhesion") = law(0);
  CHECK(warns(input, "pair sole: none of its points has a bond at the start, and this law makes none"));
  at(input, "pairs.sole.adhesion") = law(1);
  at(input, "obstacles.floor.shape") = make("rigid.plane", {{"point", values({0, -0.3}, "m")}});
  auto const found =
      warnings(input, "pair sole: none of its points has a bond at the start, 300 mm or more apart");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "adhesion.rcc{bonding"));
}

TEST_CASE("a stretched surface makes the cohesive length longer") {
  auto input = bonded(4, 2000, 40);
  at(input, "loads") =
      list({make("load.surface_stress", {{"set", text("foot.bottom")}, {"gamma", value(4000, "N/m")}})});
  CHECK_FALSE(warns(input, "will depend on the mesh"));
  auto const explanation = scene::explain(input);
  auto const& told = line(explanation, "Numbers of pair sole", "cohesive length");
  CHECK(told.value == doctest::Approx(std::sqrt(2.0)));
  CHECK(contains(told.meaning, "surface stress"));
  at(input, "loads") =
      list({make("load.surface_stress", {{"set", text("foot.left")}, {"gamma", value(4000, "N/m")}})});
  CHECK(warns(input, "will depend on the mesh"));
}

TEST_CASE("steps that jump over the peak of the adhesion are named with the steps that do not") {
  auto const found = warnings(bonded(1, 1000, 10), "the motions slide by up to 0.32 u0 in a step");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "32 steps instead of 10 in the stage to 2 s"));
  auto lifted = bonded(1, 1000, 10);
  at(lifted, "motions") = list({drive("foot.top", {0, 1, 2}, {0, 0, 0}, {0, -0.01, 0.3})});
  CHECK(warns(lifted, "the motions open it by up to 0.98 u0 in a step"));
}

TEST_CASE("bonds that form within few steps are named unless they form at once") {
  CHECK(warns(bonded(4, 1000, 2), "a bond forms in 500 ms, 2 steps"));
  CHECK_FALSE(warns(bonded(4, 1000, 40), "its growth is not resolved"));
  CHECK_FALSE(warns(bonded(4, 1000, 0.04), "its growth is not resolved"));
}

TEST_CASE("bonds without viscosity that soften faster than the bodies unload snap") {
  CHECK(warns(bonded(4, 1000, 0), "snaps"));
  for (int const steps : {1, 100}) { // of 2 s; a wave takes some 1 s
    auto snapping = bonded(4, 1000, 0);
    at(snapping, "schedule") = schedule({{2, steps}});
    auto const change = warnings(snapping, "snaps").front().change;
    CHECK(contains(change, "as long as a wave goes") == (steps == 1));
  }
  CHECK_FALSE(warns(bonded(4, 300, 0), "snaps"));
  CHECK_FALSE(warns(bonded(4, 1000, 40), "snaps"));
}

TEST_CASE("nearly incompressible plain cells lock") {
  auto input = foot_on_floor();
  at(input, "bodies.foot.material") = linear_elastic(1000, 0.48);
  auto const found = warnings(input, "plain quad4 cells lock at nu = 0.48");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "mean_dilatation"));
  at(input, "bodies.foot.interpolation") = text("mean_dilatation");
  CHECK_FALSE(warns(input, "lock"));
}

TEST_CASE("points at the nodes of quadratic cells in space are advised against between bodies") {
  auto input = foot_on_floor();
  at(input, "kinematics") = text("three_dimensional");
  auto const box = [](double below) {
    return make("mesh.box", {{"origin", values({0, 0, below}, "m")},
                             {"size", values({1, 1, 1}, "m")},
                             {"cells", values({1, 1, 1})},
                             {"kind", text("hex20")}});
  };
  at(input, "bodies.foot.mesh") = box(0);
  at(input, "motions") = list({make("motion.fix", {{"set", text("foot.top")}})});
  CHECK_FALSE(warns(input, "contact points at the nodes"));
  at(input, "bodies.ground") = at(input, "bodies.foot");
  at(input, "bodies.ground.mesh") = box(-1);
  at(input, "motions") = list({make("motion.fix", {{"set", text("foot.top")}}),
                               make("motion.fix", {{"set", text("ground.bottom")}})});
  at(input, "pairs.sole.primary") = text("ground.top");
  auto const found = warnings(input, "contact points at the nodes of hex20 cells");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "mortar"));
  at(input, "pairs.sole.discretisation") = text("mortar");
  CHECK_FALSE(warns(input, "contact points at the nodes"));
  at(input, "pairs.sole.discretisation") = text("node_to_segment");
  at(input, "bodies.foot.mesh.kind") = text("hex8");
  CHECK_FALSE(warns(input, "contact points at the nodes"));
}

TEST_CASE("points far apart on a finer primary are advised against, but not under mortar") {
  auto input = two_blocks(); // the upper one carries the points
  at(input, "bodies.upper.mesh.cells") = values({8, 2});
  CHECK_FALSE(warns(input, "node to segment with points"));
  at(input, "bodies.lower.mesh.cells") = values({16, 2});
  auto const found = warnings(input, "node to segment with points");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "secondary = \"lower.top\", primary = \"upper.bottom\""));
  CHECK(contains(found[0].change, "mortar"));
  at(input, "pairs.joint.discretisation") = text("mortar");
  CHECK_FALSE(warns(input, "node to segment with points"));
}

TEST_CASE("a plane of symmetry that is free to open is named with the motion that holds it") {
  auto input = make("scene");
  at(input, "kinematics") = text("three_dimensional");
  at(input, "bodies.foot") = block({}, linear_elastic(1000, 0));
  at(input, "bodies.foot.mesh") = make("mesh.quarter_cylinder", {{"radius", value(1, "m")},
                                                                 {"height", value(1, "m")},
                                                                 {"fine", values({0.5, 0.5}, "m")},
                                                                 {"fine_size", value(0.25, "m")},
                                                                 {"coarse_size", value(0.5, "m")}});
  at(input, "schedule") = schedule({{1, 1}});
  auto const bottom = make("motion.fix", {{"set", text("foot.bottom")}});
  auto const half =
      make("motion.fix", {{"set", text("foot.symmetry_x")}, {"y", flag(false)}, {"z", flag(false)}});
  auto const other =
      make("motion.fix", {{"set", text("foot.symmetry_y")}, {"x", flag(false)}, {"z", flag(false)}});
  at(input, "motions") = list({bottom, half});
  auto const found = warnings(input, "plane of symmetry");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "stiction.motion.fix { set = \"foot.symmetry_y\", x = false, z = false }"));
  at(input, "motions") = list({bottom, half, other});
  CHECK_FALSE(warns(input, "plane of symmetry"));
}

TEST_CASE("large strains and laws of small ones do not go together") {
  auto input = foot_on_floor();
  auto const press = [&](double depth, Input law) {
    at(input, "motions") = list({drive("foot.top", {0, 1, 2}, {0, 0, 0}, {0, -depth, -depth})});
    at(input, "bodies.foot.material") = std::move(law);
    return input;
  };
  CHECK(warns(press(0.1, linear_elastic(1000, 0)), "strained by about 10 %"));
  CHECK_FALSE(warns(press(0.04, linear_elastic(1000, 0)), "strained"));
  CHECK(warns(press(0.3, elastic("st_venant_kirchhoff", 1000, 0)),
              "compressed by about 30 %, where st_venant_kirchhoff keeps 23 % of its stiffness"));
  CHECK(warns(press(0.3, elastic("st_venant_kirchhoff", 1000, 0)), "it has none at 42 %"));
  auto const yeoh = [](double c20) { // pressed to 0.7: 6.32 C10 + 5.03 C20 + K over the 2.67 C10 + K at rest
    return make("material.yeoh", {{"C10", value(1000, "Pa")},
                                  {"C20", value(c20, "Pa")},
                                  {"C30", value(0, "Pa")},
                                  {"bulk_modulus", value(1000, "Pa")}});
  };
  CHECK(warns(press(0.3, yeoh(-1200)),
              "compressed by about 30 %, where yeoh keeps 35 % of its stiffness; it has"));
  CHECK_FALSE(warns(press(0.3, yeoh(-1000)), "compressed"));
  CHECK_FALSE(warns(press(0.15, elastic("st_venant_kirchhoff", 1000, 0)), "compressed"));
  CHECK_FALSE(warns(press(0.3, elastic("neo_hookean", 1000, 0)), "compressed"));
}

TEST_CASE("slow dynamic runs are to be quasi-static and fast quasi-static ones dynamic") {
  auto input = foot_on_floor();
  at(input, "motions") = list({drive("foot.top", {0, 5, 10}, {0, 0, 0.01}, {0, -0.01, -0.01})});
  at(input, "schedule") = schedule({{5, 10}, {10, 10}});
  CHECK(scene::explain(input).warnings.empty());
  at(input, "scheme") = make("scheme.theta_xi");
  CHECK(warns(input, "nothing is fast: the bodies as they are held swing in"));
  at(input, "bodies.foot.velocity") = values({0, -1}, "m/s");
  CHECK_FALSE(warns(input, "nothing is fast"));
  CHECK_FALSE(warns(input, "do nothing in a quasi-static run"));
  at(input, "scheme") = quasi_static();
  CHECK(warns(input, "bodies are given velocities, which do nothing in a quasi-static run"));

  input = foot_on_floor();
  at(input, "motions") = list({drive("foot.top", {0, 0.001, 0.02}, {0, 0, 0.1}, {0, -0.01, -0.01})});
  at(input, "schedule") = schedule({{0.001, 10}, {0.02, 10}});
  CHECK(warns(input, "the motions are fast: 10 m/s"));
}

TEST_CASE("the plain scheme rings in contact") {
  auto input = foot_on_floor();
  at(input, "scheme") = make("scheme.theta_xi", {{"theta", value(0.5)}, {"contact_inertia", text("full")}});
  CHECK(warns(input, "swings at every step"));
  at(input, "scheme") = make("scheme.theta_xi");
  CHECK_FALSE(warns(input, "swings at every step"));
}

TEST_CASE("motions that close a pair by many cells in a step ask for more steps") {
  auto input = foot_on_floor();
  auto const moved = [&](double way) {
    at(input, "obstacles.floor") =
        make("obstacle",
             {{"shape", make("rigid.plane")}, {"times", values({0, 2}, "s")}, {"y", values({0, way}, "m")}});
  };
  moved(12); // six cells
  CHECK_FALSE(warns(input, "the motions close it by"));
  moved(20);
  auto const found = warnings(input, "the motions close it by");
  REQUIRE(found.size() == 1);
  CHECK(contains(found[0].change, "steps instead of 4 in the stage to 1 s"));
}

TEST_CASE("bad input is refused with its complaints") {
  auto input = foot_on_floor();
  at(input, "pairs.sole.primary") = text("flor");
  CHECK_THROWS_AS(static_cast<void>(scene::explain(input)), core::InputError);
}

TEST_CASE("fits find centre and radius and say by how much they miss") {
  Matrix arc(9, 2);
  for (int i = 0; i < 9; ++i)
    arc.row(i) << 1 + 3 * std::cos(0.1 * i), -2 + 3 * std::sin(0.1 * i);
  auto fit = scene::fit_shape(arc);
  REQUIRE(fit.kind == scene::ShapeFit::round);
  CHECK((fit.centre - scene::Vec3(1, -2, 0)).norm() < 1e-10);
  CHECK(fit.radius == doctest::Approx(3));
  CHECK(fit.error < 1e-10);

  Matrix ball(27, 3), plane(9, 3), corner(5, 2);
  for (int i = 0; i < 27; ++i) {
    double const a = 0.2 * (i % 9), b = 0.3 * (i / 9);
    ball.row(i) << 2 * std::cos(a) * std::cos(b), 2 * std::sin(a) * std::cos(b), 5 + 2 * std::sin(b);
  }
  fit = scene::fit_shape(ball);
  REQUIRE(fit.kind == scene::ShapeFit::round);
  CHECK((fit.centre - scene::Vec3(0, 0, 5)).norm() < 1e-10);
  ball(13, 2) += 0.01;
  fit = scene::fit_shape(ball);
  REQUIRE(fit.kind == scene::ShapeFit::round);
  CHECK(fit.error > 0.001);
  CHECK(fit.error < 0.01);

  for (int i = 0; i < 9; ++i)
    plane.row(i) << i % 3, i / 3, 1 + i % 3;
  fit = scene::fit_shape(plane);
  REQUIRE(fit.kind == scene::ShapeFit::flat);
  CHECK(std::abs(std::abs(fit.normal.dot(scene::Vec3(1, 0, -1).normalized())) - 1) < 1e-12);
  corner << 0, 0, 1, 0, 2, 0, 2, 1, 2, 2;
  CHECK(scene::fit_shape(corner).kind == scene::ShapeFit::none);
}

TEST_CASE("numbers for people have three digits and a short unit") {
  CHECK(scene::human(2.5e-4, "m") == "250 um");
  CHECK(scene::human(5e6, "Pa") == "5 MPa");
  CHECK(scene::human(1e9, "N/m^3") == "1e+09 N/m^3");
  CHECK(scene::human(0, "s") == "0 s");
  CHECK(scene::human(-0.0015, "m") == "-1.5 mm");
  CHECK(scene::human(14000, "1") == "14000");
  CHECK(scene::human(0.48, "") == "0.48");
  CHECK(scene::human(3600, "s") == "1 h");
  CHECK(scene::percent(0.083) == "8.3 %");
  CHECK(scene::percent(0.994) == "99 %");
  CHECK(scene::percent(2.2004) == "220 %");
}

TEST_CASE("times of relaxation are held against the steps and the run") {
  auto table = foot_on_floor(); // 2 s in steps of 0.25 s and 0.1 s
  auto const term = [](double share, double time) {
    return make("prony", {{"share", value(share)}, {"time", value(time, "s")}});
  };
  at(table, "bodies.foot.relaxing") = list({term(0.5, 1e-3), term(0.25, 1), term(2, 1e6)});
  auto const explanation = scene::explain(table);
  CHECK(number(explanation, "Body foot", "at once") == doctest::Approx(3.75));
  CHECK(contains(line(explanation, "Body foot", "relaxes in 1 ms").words,
                 "G_k = 250 Pa, 0.004 of the longest step"));
  CHECK(contains(line(explanation, "Body foot", "relaxes in 1 ms").words, "gone within a step"));
  CHECK(contains(line(explanation, "Body foot", "relaxes in 1 s").words,
                 "4 of the longest step, 0.5 of the run"));
  CHECK_FALSE(contains(line(explanation, "Body foot", "relaxes in 1 s").words, ":"));
  CHECK(contains(line(explanation, "Body foot", "relaxes in " + scene::human(1e6, "s")).words, "a spring"));
  auto both = term(0.5, 1);
  at(both, "bulk_share") = value(2);
  auto volume = make("prony", {{"bulk_share", value(1.5)}, {"time", value(3, "s")}});
  at(table, "bodies.foot.relaxing") = list({both, volume});
  auto const pressed = scene::explain(table);
  CHECK(number(pressed, "Body foot", "at once") == doctest::Approx(1.5));
  CHECK(number(pressed, "Body foot", "at once in volume") == doctest::Approx(4.5));
  CHECK(contains(line(pressed, "Body foot", "relaxes in 1 s").words, "G_k = 250 Pa, K_k = "));
  CHECK(line(pressed, "Body foot", "relaxes in 3 s").words.rfind("K_k = ", 0) == 0);
}

TEST_CASE("numbers of a law are those that were given") {
  auto input = foot_on_floor();
  at(input, "bodies.foot.material") = linear_elastic(1000, 0.4999);
  auto const explanation = scene::explain(input);
  CHECK(contains(line(explanation, "Body foot", "material").words, "poisson = 0.4999"));
  CHECK(contains(line(explanation, "Body foot", "at rest").words, "nu = 0.4999,"));
}
