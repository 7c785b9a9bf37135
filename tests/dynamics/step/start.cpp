// What a run starts from: accelerations, energies, the stability limit of a cell.
#include <doctest/doctest.h>

#include "dynamics/bulk/critical_step.hpp"
#include "dynamics/marching.hpp"
#include "scene/run/work.hpp"

using namespace stiction;

namespace {

/// A block under gravity whose bottom is held, bonded to the floor beside it that it does not need.
test::Input standing(char const* scheme) {
  auto table = test::foot_on_floor();
  test::at(table, "motions") = test::list({test::fix("foot.bottom")});
  test::at(table, "gravity") = test::values({0, -10}, "m/s^2");
  test::at(table, "scheme") = test::make(scheme);
  return table;
}

} // namespace

TEST_CASE("the first acceleration is that of the balance: held nodes have none and push nobody") {
  auto const scene = scene::build(standing("scheme.newmark"));
  dynamics::Stepper stepper(*scene.model);
  auto const start = stepper.initial();
  for (Index const node : test::nodes_of(scene, "foot.bottom"))
    for (int c = 0; c < 2; ++c)
      CHECK(start.a[2 * node + c] == 0);
  Vector inertia;
  auto const& mass = stepper.bulk().mass();
  mass.times(start.a, inertia);
  auto const held = test::nodes_of(scene, "foot.bottom");
  for (Index node = 0; node < scene.model->node_count(); ++node)
    if (std::ranges::find(held, node) == held.end())
      for (int c = 0; c < 2; ++c)
        CHECK(inertia[2 * node + c] == doctest::Approx(mass.dead_load[2 * node + c]).epsilon(1e-9));
}

TEST_CASE("the ledger starts with the motion and the bonds there are") {
  auto table = standing("scheme.theta_xi");
  test::at(table, "motions") = test::list({test::fix("foot.top", true, false)});
  test::at(table, "bodies.foot.velocity") = test::values({0, 3}, "m/s");
  test::at(table, "pairs.sole.adhesion") = test::rcc(2, 1e3, 1);
  test::at(table, "pairs.sole.adhesion.beta0") = test::value(0.5);
  auto const scene = scene::build(table);
  auto const ledger = dynamics::Stepper(*scene.model).initial().ledger;
  CHECK(ledger.bond == doctest::Approx(-2 * 0.5)); // -w beta over one metre
  CHECK(ledger.kinetic == doctest::Approx(0.5 * 9));
  CHECK(ledger.start == doctest::Approx(ledger.bond + ledger.kinetic));
}

TEST_CASE("nodes driven by more than a cell take their neighbourhood along") {
  auto table = test::foot_on_floor();
  auto rubber =
      test::make("material.neo_hookean", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
  test::at(table, "bodies.foot") = test::block({{0, 0}, {1, 1}, {4, 20}}, std::move(rubber));
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 1, 2}, {0, 0, 0.2}, {0, -0.1, -0.1})}); // cells are 0.05 high
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const pressed = test::march(stepper, stepper.initial(), 1, 1);
  long const down = stepper.cost().newton_iterations;
  auto const dragged = test::march(stepper, pressed, 1, 1);
  CHECK(down <= 6);
  for (Index const node : test::nodes_of(scene, "foot.top")) {
    CHECK(pressed.u[2 * node + 1] == -0.1);
    CHECK(dragged.u[2 * node] == 0.2);
  }
}

TEST_CASE("the longest stable step of one square cell is its side over the speed of waves") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0}, {2, 2}, {1, 1}}, test::linear_elastic(1000, 0), 4);
  test::at(table, "motions") = test::list({});
  test::at(table, "scheme") = test::make("scheme.central_difference");
  auto const scene = scene::build(table);
  Vector const u = Vector::Zero(scene.model->dofs());
  CHECK(dynamics::critical_step(*scene.model, u) == doctest::Approx(2 / std::sqrt(1000.0 / 4)));
}

TEST_CASE("the work of a run holds that of its factorizations") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0}, {1, 1}, {80, 1}}, test::linear_elastic(1000, 0));
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  test::march(stepper, stepper.initial(), 0.25, 1);
  double const each = stepper.bulk().effort().operations;
  auto const& cost = stepper.cost();
  REQUIRE(cost.factorizations > 0);
  REQUIRE(cost.compliance_operations > each); // nearly all that is unknown lies on the surface
  CHECK(scene::operations(*scene.model, stepper) >
        each * static_cast<double>(cost.factorizations) + cost.compliance_operations);
}
