// What is wrong with a scene is said once, at its path, with the remedy; several mistakes together.
#include <doctest/doctest.h>

#include "dynamics/space.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

core::Complaints complaints(test::Input const& table) {
  try {
    scene::validate(table);
  } catch (core::InputError const& error) {
    return error.complaints();
  }
  return {};
}

std::string all(core::Complaints const& list) {
  std::string text;
  for (auto const& complaint : list)
    text += complaint.message() + "\n";
  return text;
}

/// One complaint, at `path`, that has all of `words`.
void check_only(test::Input const& table, std::string const& path, std::vector<std::string> const& words) {
  auto const found = complaints(table);
  INFO(all(found));
  REQUIRE(found.size() == 1);
  CHECK(found[0].path == path);
  CHECK(found[0].place == "study.lua:7");
  for (auto const& word : words) {
    CAPTURE(word);
    CHECK(found[0].text.find(word) != std::string::npos);
  }
}

} // namespace

TEST_CASE("the scenes of these tests are sound") {
  CHECK(complaints(test::foot_on_floor()).empty());
  CHECK(complaints(test::two_blocks()).empty());
}

TEST_CASE("a set that does not exist is named with what was perhaps meant") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.secondary") = test::text("foot.botom");
  check_only(table, "pairs.sole.secondary", {"\"foot.botom\"", "did you mean \"foot.bottom\"", "foot.left"});
  table = test::foot_on_floor();
  test::at(table, "motions") = test::list({test::fix("fot.top")});
  auto const found = complaints(table);
  CHECK(all(found).find("did you mean \"foot.top\"") != std::string::npos);
}

TEST_CASE("an obstacle that does not exist is a surface that does not exist") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.primary") = test::text("flor");
  check_only(table, "pairs.sole.primary",
             {"no obstacle or set \"flor\"", "foot.bottom", "did you mean \"floor\"?"});
  test::at(table, "pairs.sole.primary") = test::text("foot");
  check_only(table, "pairs.sole.primary", {"\"foot\" is a whole body, not a set", "foot.top"});
  table = test::foot_on_floor();
  test::at(table, "pairs.sole.secondary") = test::text("floor");
  check_only(table, "pairs.sole.secondary", {"\"floor\" is an obstacle, not a set"});
}

TEST_CASE("a body that nothing holds in a quasi-static run") {
  auto table = test::foot_on_floor();
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "motions") = test::list({});
  check_only(table, "bodies.foot",
             {"move along x", "move along y", "turn", "no motion holds it", "stabilisation"});
  test::at(table, "motions") = test::list({test::fix("foot.top")});
  CHECK(complaints(table).empty());
  auto slides = test::fix("foot.top");
  test::at(slides, "x") = test::flag(false);
  test::at(table, "motions") = test::list({slides});
  check_only(table, "bodies.foot", {"move along x"});
}

TEST_CASE("a free obstacle in a quasi-static run, and what only a free one has") {
  auto table = test::foot_on_floor();
  test::at(table, "obstacles.floor.mass") = test::value(1, "kg");
  test::at(table, "motions") = test::list({test::fix("foot.top")});
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  CHECK(complaints(table).empty());
  test::at(table, "scheme") = test::quasi_static();
  check_only(table, "obstacles.floor", {"quasi-static", "paths"});
  table = test::foot_on_floor();
  test::at(table, "obstacles.floor.inertia") = test::value(1, "kg m^2");
  check_only(table, "obstacles.floor.inertia", {"mass"});
}

TEST_CASE("a probe of an unknown pair, set or point") {
  auto table = test::foot_on_floor();
  test::at(table, "probes.tip") = test::make("probe.contact", {{"pair", test::text("soul")}});
  check_only(table, "probes.tip.pair", {"\"soul\"", "did you mean \"sole\""});
  test::at(table, "probes.tip") = test::make("probe.force", {{"set", test::text("foot.tip")}});
  check_only(table, "probes.tip.set", {"\"foot.tip\"", "did you mean \"foot.top\""});
  test::at(table, "probes.tip") = test::make(
      "probe.contact_point", {{"pair", test::text("sole")}, {"near", test::values({1, 2, 3}, "m")}});
  check_only(table, "probes.tip.near", {"has 3 numbers", "two are wanted"});
  test::at(table, "probes.tip") = test::make("probe.contactt", {{"pair", test::text("sole")}});
  check_only(table, "probes.tip", {"\"contactt\"", "did you mean \"contact\""});
}

TEST_CASE("names that the series keeps for itself") {
  for (std::string const name : {"time", "step"}) {
    auto table = test::foot_on_floor();
    test::at(table, "probes." + name) = test::make("probe.energy");
    check_only(table, "probes." + name, {"taken by the series"});
  }
}

TEST_CASE("names that no path could hold") {
  for (std::string const name : {"", "left/right", "a.b"}) {
    auto table = test::foot_on_floor();
    test::at(table, "probes") = {core::Table{{name, test::make("probe.energy")}}, "study.lua:7", ""};
    check_only(table, "probes", {"\"" + name + "\"", "neither dots nor slashes"});
  }
}

TEST_CASE("tables without entries, as {} is in a script") {
  auto table = test::foot_on_floor();
  for (char const* key : {"probes", "springs"})
    test::at(table, key) = test::list({});
  CHECK(complaints(table).empty());
  test::at(table, "probes") = {core::List{test::make("probe.energy")}, "study.lua:7", ""};
  check_only(table, "probes", {"is a list", "a table with names is wanted"});
}

TEST_CASE("what a scene without any of a kind says of a name") {
  auto table = test::foot_on_floor();
  test::at(table, "probes.link") = test::make("probe.spring", {{"spring", test::text("link")}});
  check_only(table, "probes.link.spring", {"there is no spring \"link\"; the scene has none"});
}

TEST_CASE("loads and motions without any component") {
  auto table = test::foot_on_floor();
  auto const times = test::values({0, 2}, "s");
  auto const foot = [&](char const* what) {
    return test::list({test::make(what, {{"set", test::text("foot.top")}, {"times", times}})});
  };
  test::at(table, "loads") = foot("load.traction");
  check_only(table, "loads[1]", {"has none of x, y, z"});
  test::at(table, "loads") = test::list({});
  test::at(table, "motions") = foot("motion.drive");
  test::at(table, "scheme") = test::make("scheme.theta_xi"); // which need not hold the foot
  check_only(table, "motions[1]", {"has none of x, y, z"});
  auto fixed = test::fix("foot.top");
  for (char const* component : {"x", "y"})
    test::at(fixed, component) = test::flag(false);
  test::at(table, "motions") = test::list({fixed});
  check_only(table, "motions[1]", {"holds no component"});
}

TEST_CASE("a free obstacle about an axis moves along it alone") {
  auto table = test::foot_on_floor();
  test::at(table, "kinematics") = test::text("axisymmetric");
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "motions") = test::list({test::fix("foot.top")});
  test::at(table, "obstacles.floor.mass") = test::value(1, "kg");
  CHECK(complaints(table).empty());
  auto const refused = [&](std::string const& key, test::Input value, std::string const& word) {
    auto other = table;
    test::at(other, key) = std::move(value);
    check_only(other, key, {"would leave the symmetry", word});
  };
  refused("obstacles.floor.spin", test::values({1}, "rad/s"), "leave it out");
  refused("obstacles.floor.inertia", test::value(1, "kg m^2"), "nothing turns");
  refused("obstacles.floor.velocity", test::values({1, -1}, "m/s"), "{0, y}");
  refused("obstacles.floor.force", test::values({1, -1}, "N"), "{0, y}");
  refused("gravity", test::values({1, 0}, "m/s^2"), "{0, y}");
}

TEST_CASE("a velocity where a path says how a free obstacle moves") {
  auto table = test::foot_on_floor();
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "motions") = test::list({test::fix("foot.top")});
  test::at(table, "obstacles.floor.mass") = test::value(1, "kg");
  test::at(table, "obstacles.floor.times") = test::values({0, 2}, "s");
  test::at(table, "obstacles.floor.x") = test::values({0, 0}, "m");
  test::at(table, "obstacles.floor.velocity") = test::values({0, -1}, "m/s");
  CHECK(complaints(table).empty());
  test::at(table, "obstacles.floor.velocity") = test::values({1, -1}, "m/s");
  check_only(table, "obstacles.floor.velocity", {"along x is what the path of x says"});
}

TEST_CASE("directions in space that a plane scene has not") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.direction") = test::values({1, 0});
  check_only(table, "pairs.sole.direction", {"is for scenes in space", "leave it out"});
  table = test::foot_on_floor();
  test::at(table, "obstacles.floor.axis") = test::values({0, 1, 0});
  check_only(table, "obstacles.floor.axis", {"leaves the plane"});
  test::at(table, "obstacles.floor.axis") = test::values({0, 0, 1});
  CHECK(complaints(table).empty());
}

TEST_CASE("a spin that no inertia would carry") {
  auto table = test::foot_on_floor();
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "obstacles.floor.mass") = test::value(1, "kg");
  test::at(table, "obstacles.floor.spin") = test::values({3}, "rad/s");
  check_only(table, "obstacles.floor.spin", {"no inertia", "give it an inertia"});
  test::at(table, "obstacles.floor.inertia") = test::value(1, "kg m^2");
  CHECK(complaints(table).empty());
}

TEST_CASE("a node driven two ways") {
  auto table = test::foot_on_floor();
  test::at(table, "scheme") = test::make("scheme.theta_xi"); // which need not hold the foot
  auto motions =
      core::List{test::drive("foot.top", {0, 2}, {}, {0, -0.01}), test::fix("foot.left", false, true)};
  test::at(table, "motions") = test::list(motions);
  check_only(table, "motions[2]",
             {"foot.left", "motions[1] moves foot.top", "node at (0, 1) m", "in y",
              "at t = 2 s to 0 m and to -0.01 m"});
  motions[1] = test::drive("foot.left", {0, 2}, {}, {0, -0.01});
  test::at(table, "motions") = test::list(motions);
  CHECK(complaints(table).empty());
  motions[1] = test::fix("foot.left", true, false);
  test::at(table, "motions") = test::list(motions);
  CHECK(complaints(table).empty());
}

TEST_CASE("two motions may prescribe the same for a node however it is written") {
  auto table = test::foot_on_floor();
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  std::vector<core::List> const agreeing{
      {test::fix("foot.left", true, false), test::drive("foot.top", {0, 2}, {0, 0}, {0, -0.01})},
      {test::drive("foot.left", {0, 1, 2}, {}, {0, -0.005, -0.01}),
       test::drive("foot.top", {0, 2}, {}, {0, -0.01})},
      {test::drive("foot.left", {0, 3}, {}, {0, -0.015}), test::drive("foot.top", {0, 2}, {}, {0, -0.01})},
      {test::fix("foot.left"), test::fix("foot.left"), test::fix("foot.top")}};
  for (auto const& motions : agreeing) {
    test::at(table, "motions") = test::list(motions);
    INFO(all(complaints(table)));
    CHECK(complaints(table).empty());
  }
  auto near = test::drive("foot.all", {0, 2}, {}, {0, 0.01});
  test::at(near, "near") = test::values({0, 1}, "m");
  test::at(table, "motions") = test::list({test::fix("foot.top"), near});
  check_only(table, "motions[2]", {"foot.all", "foot.top", "(0, 1) m", "at t = 2 s to 0.01 m and to 0 m"});
  test::at(table, "motions") = test::list({test::drive("foot.left", {0, 1, 2}, {}, {0, 0, -0.01}),
                                           test::drive("foot.top", {0, 2}, {}, {0, -0.01})});
  check_only(table, "motions[2]", {"at t = 1 s to -0.005 m and to 0 m", "same path"});
}

TEST_CASE("paths shorter than the run, unsorted, or of unequal length") {
  auto table = test::foot_on_floor();
  test::at(table, "motions") = test::list({test::drive("foot.top", {0, 1}, {}, {0, -0.01})});
  check_only(table, "motions[1].set", {"ends at 1 s", "before the run does at 2 s"});
  test::at(table, "motions") = test::list({test::drive("foot.top", {0, 2, 1}, {}, {0, 0, 0})});
  CHECK(all(complaints(table)).find("must grow; entry 3 does not") != std::string::npos);
  test::at(table, "motions") = test::list({test::drive("foot.top", {0, 2}, {}, {0, 1, 2})});
  check_only(table, "motions[1].y", {"3 values for 2 times"});
  test::at(table, "motions") = test::list({test::drive("foot.top", {1, 2}, {0, 0}, {-0.01, -0.02})});
  check_only(table, "motions[1].times", {"begin at 1 s, where y is -0.01, not 0", "first point at 0 s"});
  test::at(table, "motions") = test::list({test::drive("foot.top", {1, 2}, {0, 0}, {0, -0.02})});
  CHECK(complaints(table).empty());

  table = test::foot_on_floor();
  test::at(table, "obstacles.floor.times") = test::values({0, 1}, "s");
  test::at(table, "obstacles.floor.x") = test::values({0, 1}, "m");
  check_only(table, "obstacles.floor.times", {"ends at 1 s"});
}

TEST_CASE("surfaces that overlap at the start") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.mesh.origin") = test::values({0, -0.1}, "m");
  check_only(table, "pairs.sole", {"overlap by 0.1 m", "before the run starts"});
}

TEST_CASE("bodies deep inside each other where their surfaces do not see each other") {
  auto table = test::foot_on_floor();
  auto bed = [](double top) {
    return test::block({{-1, top - 2}, {3, 2}, {12, 8}}, test::linear_elastic(1000, 0));
  };
  test::at(table, "bodies.bed") = bed(0);
  test::at(table, "pairs.sole") = test::pair("foot.bottom", "bed.top");
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 2}, {0, 0}, {0, -0.01}), test::fix("bed.bottom")});
  CHECK(complaints(table).empty());
  test::at(table, "bodies.bed") = bed(1.9); // the sole is 1.9 m below its top, beyond all search
  check_only(table, "pairs.sole",
             {"the bodies of foot.bottom and bed.top overlap by 0.9 m", "before the run"});
  test::at(table, "bodies.bed") = bed(2.5); // the sole has come out below the bed
  check_only(table, "pairs.sole", {"the bodies of foot.bottom and bed.top overlap by 0.5 m"});
  test::at(table, "bodies.bed") = bed(-5);
  CHECK(complaints(table).empty());
}

TEST_CASE("an axisymmetric body left of the axis") {
  auto table = test::foot_on_floor();
  test::at(table, "kinematics") = test::text("axisymmetric");
  CHECK(complaints(table).empty());
  test::at(table, "bodies.foot.mesh.origin") = test::values({-0.5, 0}, "m");
  check_only(table, "bodies.foot.mesh", {"-0.5 m", "x >= 0"});
}

TEST_CASE("vectors with too few or too many components") {
  for (std::string const path : {"gravity", "bodies.foot.velocity"}) {
    auto table = test::foot_on_floor();
    std::string const unit = path == "gravity" ? "m/s^2" : "m/s";
    test::at(table, path) = test::values({1, 2, 3}, unit);
    check_only(table, path, {"has 3 numbers", "two are wanted"});
    test::at(table, path) = test::values({1}, unit);
    check_only(table, path, {"has 1 numbers", "two are wanted"});
  }
  auto table = test::foot_on_floor();
  test::at(table, "obstacles.floor.shape.normal") = test::values({1, 2, 3});
  check_only(table, "obstacles.floor.shape", {"normal has 3 components", "give 2"});
  test::at(table, "obstacles.floor.shape.normal") = test::values({0, 0});
  check_only(table, "obstacles.floor.shape", {"normal"});
}

TEST_CASE("a run needs bodies, a schedule and stages that follow each other") {
  auto table = test::foot_on_floor();
  test::at(table, "schedule.stages") = test::list({});
  check_only(table, "schedule.stages", {"empty", "at least one stage"});
  test::remove(table, "schedule");
  check_only(table, "schedule", {"missing"});
  test::at(table, "schedule") = test::schedule({{2, 1}, {2, 1}});
  check_only(table, "schedule.stages", {"stage 2 ends at 2 s"});
  auto const nothing =
      test::make("scene", {{"bodies", test::make("")}, {"schedule", test::schedule({{1, 1}})}});
  check_only(nothing, "bodies", {"at least one body"});
}

TEST_CASE("mistakes of one table are reported together, each at its path") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.density") = test::value(-1, "kg/m^3");
  test::at(table, "bodies.foot.material.young") = test::value(1, "kg");
  test::at(table, "bodies.foot.colour") = test::text("red");
  test::at(table, "pairs.sole.frictoin") = test::coulomb(0.3);
  test::at(table, "pairs.sole.smoothing") = test::text("splin");
  test::at(table, "gravity") = test::values({1}, "m/s^2");
  test::remove(table, "schedule");
  auto const found = complaints(table);
  INFO(all(found));
  CHECK(found.size() == 7);
  for (std::string const path : {"bodies.foot.density", "bodies.foot.material.young", "bodies.foot.colour",
                                 "pairs.sole.frictoin", "pairs.sole.smoothing", "gravity", "schedule"})
    CHECK(std::ranges::count(found, path, &core::Complaint::path) == 1);
}

TEST_CASE("contradictions between parts are reported together") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.secondary") = test::text("foot.botom");
  test::at(table, "probes.a") = test::make("probe.contact", {{"pair", test::text("soul")}});
  test::at(table, "motions") = test::list({test::fix("foot.tip")});
  CHECK(complaints(table).size() >= 3);
}

TEST_CASE("multigrid that a scene cannot have says why") {
  auto const multigrid = test::make("control", {{"bulk", test::text("multigrid")}});
  auto table = test::foot_on_floor();
  test::at(table, "control") = multigrid;
  check_only(table, "control.bulk", {"bodies in space", "\"direct\""});
  table = test::cube_on_floor();
  test::at(table, "motions") = test::list({test::drive("foot.top", {0, 1}, {{{0, 0}, {0, 0}, {0, -0.02}}})});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "control") = multigrid;
  CHECK(complaints(table).empty());
  test::at(table, "solver") = test::make("solver.uzawa");
  check_only(table, "control.bulk", {"not newton"});
  test::at(table, "solver") = test::make("solver.newton");
  test::at(table, "bodies.foot.material") = test::linear_elastic(1000, 0.495);
  check_only(table, "control.bulk", {"foot", "nearly incompressible", "0.495", "0.49"});
  test::at(table, "bodies.foot.material") = test::linear_elastic(1000, 0.49);
  CHECK(complaints(table).empty());
  test::at(table, "output") = test::make("output", {{"problems_every", test::value(1)}});
  check_only(table, "control.bulk", {"problems_every"});
}

TEST_CASE("an adhesion that is felt beyond the reach of its pair is said so and without a reach the pair "
          "takes it") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.adhesion") =
      test::make("adhesion.potential", {{"w", test::value(1, "J/m^2")}, {"delta", test::value(10, "mm")}});
  CHECK(complaints(table).empty());
  CHECK(scene::build(table).model->pairs[0].reach == doctest::Approx(0.3));
  test::at(table, "pairs.sole.reach") = test::value(200, "mm");
  check_only(table, "pairs.sole.reach", {"0.2 m", "0.3 m"});
  test::at(table, "pairs.sole.reach") = test::value(400, "mm");
  CHECK(complaints(table).empty());
}

TEST_CASE("parameters of an adhesion law that do not fit together are named") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.adhesion") =
      test::make("adhesion.bilinear", {{"K", test::value(1e3, "N/m^3")},
                                       {"sigma_n", test::value(100, "Pa")},
                                       {"sigma_t", test::value(50, "Pa")},
                                       {"G_I", test::value(3, "J/m^2")},
                                       {"G_II", test::value(3, "J/m^2")}});
  check_only(table, "pairs.sole.adhesion.G_I", {"3 J/m^2", "5 J/m^2", "raise"});
  test::at(table, "pairs.sole.adhesion") = test::make("adhesion.bilinea");
  check_only(table, "pairs.sole.adhesion", {"bilinear", "potential"});
}

TEST_CASE("a sheet in plane stress outside the plane, averaged, damped or relaxing") {
  auto in_space = test::cube_on_floor();
  test::at(in_space, "motions") = test::list({test::fix_in("foot.top", "xyz")});
  test::at(in_space, "bodies.foot.plane_stress") = test::flag(true);
  check_only(in_space, "bodies.foot.plane_stress", {"plane_strain", "leave it out"});
  auto const sheet = [](std::string const& what, test::Input value) {
    auto table = test::foot_on_floor();
    test::at(table, "bodies.foot.plane_stress") = test::flag(true);
    test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
    test::at(table, "bodies.foot." + what) = std::move(value);
    return table;
  };
  check_only(sheet("interpolation", test::text("mean_dilatation")), "bodies.foot.interpolation",
             {"thickness", "leave it out"});
  check_only(
      sheet("damping", test::make("damping.kelvin_voigt", {{"shear_viscosity", test::value(1, "Pa s")}})),
      "bodies.foot.damping", {"sheet", "leave one"});
  check_only(
      sheet("relaxing",
            test::list({test::make("prony", {{"share", test::value(0.4)}, {"time", test::value(1, "s")}})})),
      "bodies.foot.relaxing", {"sheet", "leave one"});
}

TEST_CASE("a surface that touches itself and is averaged by mortar") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole") = test::pair("foot.bottom", "foot.bottom");
  test::at(table, "pairs.sole.discretisation") = test::text("mortar");
  test::at(table, "motions") = test::list({test::fix("foot.top")});
  check_only(table, "pairs.sole.discretisation", {"touches itself", "node_to_segment"});
}

TEST_CASE("terms of relaxation that say too little or too much are named") {
  auto const term = [](std::vector<std::pair<std::string, double>> const& numbers) {
    core::Table table;
    for (auto const& [name, number] : numbers)
      table[name] = test::value(number, name == "time"                              ? "s"
                                        : name.find("modulus") != std::string::npos ? "Pa"
                                                                                    : "1");
    return test::make("prony", std::move(table));
  };
  auto table = test::foot_on_floor();
  auto& relaxing = test::at(table, "bodies.foot.relaxing");
  relaxing = test::list({term({{"share", 0.4}, {"time", 1}}), term({{"modulus", 100}, {"time", 1e3}})});
  CHECK(complaints(table).empty());
  relaxing = test::list({term({{"share", 0.4}, {"time", 1}}), term({{"time", 1}})});
  check_only(table, "bodies.foot.relaxing[2].share", {"modulus", "more than 0"});
  relaxing = test::list({term({{"share", 0.4}, {"modulus", 100}, {"time", 1}})});
  check_only(table, "bodies.foot.relaxing[1].share", {"leave one of them out"});
  relaxing = test::list({term({{"bulk_share", 0.4}, {"time", 1}}), term({{"bulk_modulus", 1}, {"time", 1}})});
  CHECK(complaints(table).empty());
  relaxing = test::list({term({{"share", 1}, {"bulk_share", 0.4}, {"bulk_modulus", 100}, {"time", 1}})});
  check_only(table, "bodies.foot.relaxing[1].bulk_share", {"bulk_modulus", "leave one of them out"});
  relaxing = test::list({term({{"share", 1}, {"bulk_share", -0.4}, {"time", 1}})});
  check_only(table, "bodies.foot.relaxing[1].bulk_share", {"-0.4", ">= 0"});
  relaxing = test::list({term({{"share", 0.4}, {"time", 0}})});
  check_only(table, "bodies.foot.relaxing[1].time", {"0 s", "> 0 s"});
  relaxing = test::list({});
  check_only(table, "bodies.foot.relaxing", {"0 terms", "1 to 20"});
  relaxing = test::list(core::List(21, term({{"share", 0.4}, {"time", 1}})));
  check_only(table, "bodies.foot.relaxing", {"21 terms", "1 to 20"});
  relaxing = test::list({term({{"share", 0.4}, {"time", 1}})});
  test::at(table, "scheme") = test::make("scheme.theta_xi", {{"contact_inertia", test::text("cells")}});
  check_only(table, "bodies.foot.relaxing", {"\"cells\"", "\"implicit\""});
}
