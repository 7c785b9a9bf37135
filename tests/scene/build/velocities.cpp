// Initial velocities of bodies: carried, spinning and stretching about the centre of mass.
#include <doctest/doctest.h>

#include "dynamics/space.hpp"
#include "scene/complaints.hpp"

using namespace stiction;
using test::Vec3;

TEST_SUITE_BEGIN("scene");

TEST_CASE("a body starts with a velocity, a spin and a velocity gradient about its centre of mass") {
  auto table = test::cube_on_floor();
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "bodies.foot") = test::box({{1, 2, 0}, {1, 2, 4}}, test::linear_elastic(1000, 0));
  test::at(table, "bodies.foot.velocity") = test::values({1, -2, 3}, "m/s");
  test::at(table, "bodies.foot.spin") = test::values({0.1, 0.2, 0.3}, "rad/s");
  test::at(table, "bodies.foot.velocity_gradient") = test::values({1, 2, 3, 4, 5, 6, 7, 8, 9}, "1/s");
  auto const scene = scene::build(table);
  Eigen::Matrix3d L;
  L << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  Vec3 const centre(1.5, 3, 2), spin(0.1, 0.2, 0.3);
  for (Index i = 0; i < scene.model->node_count(); ++i) {
    Vec3 const arm = scene.model->reference.row(i).transpose() - centre;
    Vec3 const expected = Vec3(1, -2, 3) + L * arm + spin.cross(arm);
    CHECK((scene.model->velocity.row(i).transpose() - expected).norm() < 1e-12);
  }
}

TEST_CASE("a block that spins freely keeps its angular momentum, to the order of its scheme") {
  auto table = test::foot_on_floor();
  auto const rubber =
      test::make("material.neo_hookean", {{"young", test::value(200, "Pa")}, {"poisson", test::value(0.3)}});
  test::at(table, "bodies.foot") = test::block({{0, 10}, {2, 1}, {4, 2}}, rubber);
  test::at(table, "bodies.foot.spin") = test::values({2}, "rad/s");
  test::at(table, "motions") = test::list({});
  test::at(table, "pairs") = test::Input{core::Table{}, "", ""}; // contact nodes have a scheme of their own
  test::at(table, "scheme") = test::make("scheme.newmark");
  test::at(table, "probes.momentum") = test::make("probe.momentum");
  auto const scene = scene::build(table);
  scene.model->control.force_tolerance = 1e-11;
  dynamics::Stepper stepper(*scene.model);
  auto const start = stepper.initial();
  auto const spin = [](dynamics::State const& state) { return state.momenta.bodies[0].angular.z(); };
  CHECK(start.momenta.bodies[0].linear.norm() < 1e-13);
  CHECK(spin(start) == doctest::Approx(2 * 2.0 * (4 + 1) / 12).epsilon(0.1)); // masses are lumped at nodes
  auto const change = [&](int steps) {
    return std::abs(spin(test::march(stepper, start, 0.2 / steps, steps)) / spin(start) - 1);
  };
  double const coarse = change(50), fine = change(100);
  CHECK(fine < 2e-3);
  CHECK(std::log2(coarse / fine) > 1.5);
}

TEST_CASE("spins and gradients that a scene cannot have") {
  auto table = test::foot_on_floor();
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "bodies.foot.spin") = test::values({1, 2, 3}, "rad/s");
  CHECK(test::complaints(table).at(0).find("bodies.foot.spin: wants one number in the plane") !=
        std::string::npos);
  test::at(table, "bodies.foot.spin") = test::values({1}, "rad/s");
  CHECK(test::complaints(table).empty());
  test::at(table, "bodies.foot.velocity_gradient") = test::values({1, 2}, "1/s");
  CHECK(test::complaints(table).at(0).find("has 2 numbers; 4 are wanted") != std::string::npos);
  test::at(table, "bodies.foot.velocity_gradient") = test::values({1, 2, 3, 4}, "1/s");
  CHECK(test::complaints(table).empty());
  test::at(table, "kinematics") = test::text("axisymmetric");
  CHECK(test::complaints(table).at(0).find("leave the symmetry") != std::string::npos);
}

TEST_SUITE_END();
