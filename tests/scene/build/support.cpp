// What holds a body without inertia: motions, bonds that are whole at the start, a stabilisation that
// vanishes.
#include <doctest/doctest.h>

#include "dynamics/step/stepper.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

/// All complaints, one a line; "" for a sound scene.
std::string complaints(test::Input const& table) {
  try {
    scene::validate(table);
  } catch (core::InputError const& error) {
    return error.what();
  }
  return "";
}

/// A traction along y on a set: to its full size in the first second, constant in the next.
test::Input pressed(std::string set, double pressure) {
  return test::make("load.traction", {{"set", test::text(std::move(set))},
                                      {"times", test::values({0, 1, 2}, "s")},
                                      {"y", test::values({0, -pressure, -pressure}, "Pa")}});
}

/// A foot on the floor with no motion, on bonds of these stiffnesses that never form anew, N/m^3.
test::Input bonded_foot(double C_n, double C_t) {
  auto table = test::foot_on_floor();
  test::at(table, "motions") = test::list({});
  test::at(table, "pairs.sole.adhesion") = test::rcc(1e6, 1, 1);
  test::at(table, "pairs.sole.adhesion.C_n") = test::value(C_n, "N/m^3");
  test::at(table, "pairs.sole.adhesion.C_t") = test::value(C_t, "N/m^3");
  test::at(table, "pairs.sole.adhesion.beta0") = test::value(1);
  test::at(table, "pairs.sole.adhesion.bonding") = test::text("never");
  return table;
}

dynamics::State end_of(dynamics::Model const& model, std::vector<double> const& times) {
  dynamics::Stepper stepper(model);
  auto state = stepper.initial();
  for (double const t : times) {
    auto outcome = stepper.step(state, t - state.t);
    INFO(outcome.reason);
    REQUIRE(outcome.converged());
    state = outcome.state;
  }
  return state;
}

/// Displacement of the node of foot.top nearest to a point.
double moved(scene::Scene const& scene, dynamics::State const& state, int component,
             std::vector<double> const& point) {
  Index const node = scene.nearest(*scene.nodes_of("foot.top"), point);
  return state.u[scene.model->dim() * node + component];
}

test::Input stabilised(double part) {
  return test::make("scheme.quasi_static", {{"stabilisation", test::value(part)}});
}

} // namespace

TEST_CASE("whole bonds hold a body as far as their stiffnesses reach") {
  CHECK(complaints(bonded_foot(1e4, 1e4)).empty());
  auto const normal = complaints(bonded_foot(1e4, 0));
  CHECK(normal.find("can move along x:") != std::string::npos);
  auto const along =
      complaints(bonded_foot(0, 1e4)); // all bonds on one line: it turns about any of its points
  CHECK(along.find("move along y") != std::string::npos);
  CHECK(along.find("turn") != std::string::npos);
  CHECK(along.find("move along x") == std::string::npos);
  auto none = bonded_foot(1e4, 1e4);
  test::at(none, "pairs.sole.adhesion.beta0") = test::value(0);
  CHECK(complaints(none).find("move along x, move along y, turn") != std::string::npos);
}

TEST_CASE("bonds between two bodies hold one by the other, and none where both are loose") {
  auto table = test::two_blocks();
  test::at(table, "pairs.joint.adhesion") =
      bonded_foot(1e4, 1e4).table()->at("pairs").table()->at("sole").table()->at("adhesion");
  test::at(table, "motions") = test::list({test::fix("lower.bottom")});
  CHECK(complaints(table).empty());
  CHECK(scene::build(table).model->held_by_bonds);
  test::at(table, "motions") = test::list({});
  auto const both = complaints(table);
  CHECK(both.find("bodies.lower") != std::string::npos);
  CHECK(both.find("bodies.upper") != std::string::npos);
  test::at(table, "motions") = test::list({test::fix("lower.bottom"), test::fix("upper.top")});
  CHECK_FALSE(scene::build(table).model->held_by_bonds);
}

TEST_CASE("reversible laws that are felt and cohesive laws hold along their normal") {
  auto table = bonded_foot(1e4, 1e4);
  test::at(table, "motions") = test::list({test::fix("foot.top", true, false)});
  CHECK(complaints(table).empty());
  test::at(table, "pairs.sole.adhesion") =
      test::make("adhesion.potential", {{"w", test::value(1, "J/m^2")}, {"delta", test::value(10, "mm")}});
  CHECK(complaints(table).empty());
  test::at(table, "pairs.sole.adhesion") =
      test::make("adhesion.dugdale", {{"sigma0", test::value(100, "Pa")}, {"h0", test::value(1, "mm")}});
  CHECK(complaints(table).empty());
  test::at(table, "bodies.foot.mesh.origin") = test::values({0, 1}, "m"); // beyond what they are felt
  auto const far = complaints(table);
  INFO(far);
  CHECK(far.find("move along y") != std::string::npos);
}

TEST_CASE("a body that bonds alone hold moves as they give and no stabilisation is left in its balance") {
  double const C = 1e4, p = 50, E = 1000;
  auto table = bonded_foot(C, C);
  test::at(table, "loads") = test::list({pressed("foot.top", -p)});
  auto const scene = scene::build(table);
  REQUIRE(scene.model->held_by_bonds);
  auto const state = end_of(*scene.model, {0.5, 1, 1.5});
  for (double const x : {0.0, 1.0})
    CHECK(moved(scene, state, 1, {x, 1}) == doctest::Approx(p / C + p / E).epsilon(1e-8));
  CHECK(std::abs(moved(scene, state, 0, {0, 1})) < 1e-9);
  CHECK(state.ledger.stabilisation_loss == 0);
}

TEST_CASE("a body that contact alone holds is refused with the way out, and stands with it") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({}, test::linear_elastic(1000, 0.3));
  test::at(table, "motions") = test::list({});
  test::at(table, "loads") = test::list({pressed("foot.top", 50)});
  CHECK(complaints(table).find("scheme.quasi_static{stabilisation = 1e-6}") != std::string::npos);
  test::at(table, "scheme") = stabilised(1e-6);
  auto const scene = scene::build(table);
  auto const state = end_of(*scene.model, {0.25, 0.5, 0.75, 1, 1.25, 1.5});
  double const sunk = 50 * (1 - 0.09) / 1000; // plane strain, free to widen
  for (double const x : {0.0, 0.5, 1.0})
    CHECK(moved(scene, state, 1, {x, 1}) == doctest::Approx(-sunk).epsilon(1e-6));
  CHECK(moved(scene, state, 0, {0, 1}) == doctest::Approx(-moved(scene, state, 0, {1, 1})).epsilon(1e-6));
  for (auto const& point : state.contacts[0])
    CHECK(point.dry[0] == doctest::Approx(50).epsilon(1e-6));
  auto const& ledger = state.ledger;
  CHECK(ledger.stabilisation_loss > 0);
  CHECK(ledger.stabilisation_loss < 1e-6 * ledger.strain);
  // ramps meet the trapezium of a linear body but for what the stabilisation took
  CHECK(ledger.load_work - ledger.strain ==
        doctest::Approx(ledger.stabilisation_loss + ledger.scheme_loss()).epsilon(1e-9));
}

TEST_CASE(
    "a body between two plates finds its place and what it then shows does not know its stabilisation") {
  std::vector<double> tops;
  for (double const part : {1e-4, 1e-6}) {
    auto table = test::foot_on_floor();
    test::at(table, "motions") = test::list({});
    test::at(table, "bodies.foot.mesh.origin") = test::values({0, 0.02}, "m");
    auto lid = test::make("obstacle",
                          {{"shape", test::make("rigid.plane", {{"normal", test::values({0, -1})},
                                                                {"point", test::values({0, 1.03}, "m")}})},
                           {"times", test::values({0, 1, 2}, "s")},
                           {"y", test::values({0, -0.1, -0.1}, "m")}});
    test::at(table, "obstacles.lid") = lid;
    test::at(table, "pairs.head") = test::pair("foot.top", "lid");
    CHECK(complaints(table).find("bodies.foot") != std::string::npos);
    test::at(table, "scheme") = stabilised(part);
    auto const scene = scene::build(table);
    auto const state = end_of(*scene.model, {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2});
    tops.push_back(moved(scene, state, 1, {0.5, 1.02}));
    for (auto const& pair : state.contacts)
      for (auto const& point : pair)
        CHECK(point.dry[0] == doctest::Approx(70).epsilon(1e-6)); // 1.02 - 0.95 by E over its height
  }
  CHECK(tops[0] == doctest::Approx(tops[1]).epsilon(1e-6));
  CHECK(tops[1] == doctest::Approx(0.93 - 1.02).epsilon(1e-6));
}
