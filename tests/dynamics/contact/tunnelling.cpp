// Steps so long that they would carry one body through another: refused, or solved all the same.
#include "dynamics/contact/tunnelling.hpp"

#include <algorithm>
#include <doctest/doctest.h>

#include "dynamics/marching.hpp"

using namespace stiction;

namespace {

/// A foot of 1 m that is driven down by `depth` in a second onto a bed 2 m thick, 0.1 m below it.
test::Input stamp(double depth, char const* discretisation) {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.bed") = test::block({{-1, -2.1}, {3, 2}, {12, 8}}, test::linear_elastic(1000, 0));
  test::at(table, "pairs.sole") = test::pair("foot.bottom", "bed.top");
  test::at(table, "pairs.sole.discretisation") = test::text(discretisation);
  test::at(table, "motions") = test::list(
      {test::drive("foot.top", {0, 1, 2}, {0, 0, 0}, {0, -depth, -depth}), test::fix("bed.bottom")});
  return table;
}

} // namespace

TEST_CASE("a step that carries a body through another is refused") {
  auto const scene = scene::build(stamp(10, "node_to_segment"));
  dynamics::Stepper stepper(*scene.model);
  auto const outcome = stepper.step(stepper.initial(), 1);
  CHECK(outcome.verdict == dynamics::StepVerdict::passed);
  CHECK(outcome.reason.find("pair sole went through") != std::string::npos);
}

TEST_CASE("no step ends with bodies inside each other and no force between them") {
  for (auto const* discretisation : {"node_to_segment", "mortar"})
    for (double const depth : {0.5, 1.0, 2.0, 3.0, 10.0}) {
      INFO(discretisation << ", depth " << depth);
      auto const scene = scene::build(stamp(depth, discretisation));
      dynamics::Stepper stepper(*scene.model);
      auto const outcome = stepper.step(stepper.initial(), 1);
      CHECK((!outcome.converged() || test::contact_force(scene, outcome.state).y() > 0));
    }
}

TEST_CASE("a point in reach that cuts through the last corner of a body is noticed however short its way") {
  auto table = stamp(1, "node_to_segment");
  test::at(table, "bodies.bed") =
      test::block({{-1.99, -2.02}, {3, 2}, {12, 8}}, test::linear_elastic(1000, 0)); // ends at x = 1.01
  auto const scene = scene::build(table);
  auto const& pair = scene.model->pairs[0];
  dynamics::Stepper stepper(*scene.model);
  auto old = stepper.initial();
  auto next = old;
  auto const corner = scene.nearest(pair.secondary, {1, 0});
  auto const lost = static_cast<std::size_t>(std::find(pair.secondary.begin(), pair.secondary.end(), corner) -
                                             pair.secondary.begin());
  for (auto* state : {&old, &next})
    for (auto& point : state->contacts[0])
      point.in_reach = true;
  next.contacts[0][lost].in_reach = false;
  dynamics::Tunnelling const tunnelling(*scene.model);
  test::Vec2 const way(0.015, -0.09); // through (1.0075, -0.045), past the end and below it
  REQUIRE(way.norm() < pair.reach);
  next.u.segment<2>(2 * corner) = way;
  CHECK(tunnelling.passed(old, next) == "sole");
  next.u.segment<2>(2 * corner) = test::Vec2(0.05, -0.01);
  CHECK(tunnelling.passed(old, next).empty());
}

TEST_CASE("a point that lies on its counterpart again after a way deep through it is noticed") {
  auto const scene = scene::build(stamp(1, "node_to_segment"));
  auto const& pair = scene.model->pairs[0];
  dynamics::Stepper stepper(*scene.model);
  auto const old = stepper.initial();
  auto next = old;
  for (auto& point : next.contacts[0])
    point.in_reach = true;
  dynamics::Tunnelling const tunnelling(*scene.model);
  auto const node = scene.nearest(pair.secondary, {0.5, 0});
  for (double const depth : {0.5, 2.0}) {
    next.u.segment<2>(2 * node) = test::Vec2(0.01, -0.1 - depth * pair.reach);
    CHECK(tunnelling.passed(old, next) == (depth > 1 ? "sole" : ""));
  }
}

TEST_CASE("a step that presses or parts bodies is not refused however long it is") {
  for (double const depth : {0.2, -1e6}) {
    auto const scene = scene::build(stamp(depth, "node_to_segment"));
    dynamics::Stepper stepper(*scene.model);
    auto const outcome = stepper.step(stepper.initial(), 1);
    CHECK(outcome.converged());
    CHECK((test::contact_force(scene, outcome.state).y() > 0) == (depth > 0));
  }
}

TEST_CASE("a body that would fall through a rigid floor in one step lands on it") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.mesh.origin") = test::values({0, 5}, "m");
  test::at(table, "bodies.foot.velocity") = test::values({0, -100}, "m/s");
  test::at(table, "motions") = test::list({});
  test::at(table, "scheme") =
      test::make("scheme.theta_xi", {{"theta", test::value(1)}, {"xi", test::value(1)}});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const outcome = stepper.step(stepper.initial(), 1);
  REQUIRE(outcome.converged());
  for (Index const node : scene.model->pairs[0].secondary)
    CHECK(5 + outcome.state.u[2 * node + 1] > -1e-6);
}

TEST_CASE("a step that carries a body through a rigid disc that moves or stands is refused") {
  for (bool const moving : {false, true}) {
    auto table = test::foot_on_floor();
    test::at(table, "obstacles.floor.shape") = test::make(
        "rigid.circle", {{"centre", test::values({0.5, -1}, "m")}, {"radius", test::value(0.9, "m")}});
    double const way = moving ? 0 : -4;
    test::at(table, "motions") = test::list({test::drive("foot.top", {0, 1, 2}, {0, 0, 0}, {0, way, way})});
    if (moving) {
      test::at(table, "obstacles.floor.times") = test::values({0, 1, 2}, "s");
      test::at(table, "obstacles.floor.y") = test::values({0, 4, 4}, "m");
    }
    auto const scene = scene::build(table);
    dynamics::Stepper stepper(*scene.model);
    auto const outcome = stepper.step(stepper.initial(), 1);
    CHECK(outcome.verdict == dynamics::StepVerdict::passed);
    CHECK(outcome.reason.find("pair sole went through") != std::string::npos);
  }
}
