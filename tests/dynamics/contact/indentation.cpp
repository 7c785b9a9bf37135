// A rigid ball pressed into a wide block against Hertz, in space and as a body of revolution.
#include "dynamics/space.hpp"

using namespace stiction;
using test::Vec3;

namespace {

constexpr double young = 1000, poisson = 0.3, depth = 9e-4; // Pa, 1, m; contact radius 0.03 m of a 1 m ball
constexpr double extent = 3;                                // of the block: radius and height, m

/// The ball of radius 1 m at the crown of the block's top, which is at height 0; `up` is its axis.
test::Input ball(std::vector<double> const& centre, std::string const& up) {
  auto shape =
      test::make("rigid.sphere", {{"centre", test::values(centre, "m")}, {"radius", test::value(1, "m")}});
  return test::make("obstacle", {{"shape", std::move(shape)},
                                 {"times", test::values({0, 1}, "s")},
                                 {up, test::values({0, -depth}, "m")}});
}

/// Fine zone of 0.045 m in cells of `size`, growing outward.
core::Table zone(double size) {
  return {{"fine", test::values({0.045, 0.03}, "m")},
          {"fine_size", test::value(size, "m")},
          {"coarse_size", test::value(0.6, "m")},
          {"growth", test::value(1.5)}};
}

test::Input body(std::string const& kind, core::Table mesh) {
  return test::make("body", {{"mesh", test::make(kind, std::move(mesh))},
                             {"material", test::linear_elastic(young, poisson)},
                             {"density", test::value(1, "kg/m^3")}});
}

/// Force on the ball over the whole circle, N, after two steps.
double force_in_space(double size, double mu = 0) {
  auto mesh = zone(size);
  mesh["radius"] = mesh["height"] = test::value(extent, "m");
  auto table = test::space();
  test::at(table, "schedule") = test::schedule({{1, 2}});
  test::at(table, "bodies.block") = body("mesh.quarter_cylinder", std::move(mesh));
  test::at(table, "obstacles.ball") = ball({0, 0, 1}, "z");
  test::at(table, "pairs.top") = test::pair("block.top", "ball");
  if (mu > 0)
    test::at(table, "pairs.top.friction") = test::coulomb(mu);
  test::at(table, "motions") =
      test::list({test::fix_in("block.bottom", "xyz"), test::fix_in("block.symmetry_x", "x"),
                  test::fix_in("block.symmetry_y", "y")});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.5, 2);
  return -4 * test::contact_on(scene, state).z();
}

double force_of_revolution(double size, double mu = 0) {
  auto mesh = zone(size);
  mesh["origin"] = test::values({0, -extent}, "m");
  mesh["size"] = test::values({extent, extent}, "m");
  auto table = test::make("scene");
  test::at(table, "kinematics") = test::text("axisymmetric");
  test::at(table, "bodies.block") = body("mesh.graded_block", std::move(mesh));
  test::at(table, "obstacles.ball") = ball({0, 1}, "y");
  test::at(table, "pairs.top") = test::pair("block.top", "ball");
  if (mu > 0)
    test::at(table, "pairs.top.friction") = test::coulomb(mu);
  test::at(table, "motions") = test::list({test::fix("block.bottom")});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 2}});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.5, 2);
  return -test::contact_force(scene, state).y();
}

} // namespace

TEST_CASE("a ball pressed into a block meets the force of Hertz") {
  double const hertz = 4.0 / 3 * young / (1 - poisson * poisson) * std::pow(depth, 1.5);
  double const coarse = force_in_space(0.015) / hertz - 1, fine = force_in_space(0.0075) / hertz - 1;
  CAPTURE(coarse);
  CAPTURE(fine);
  CHECK(std::abs(fine) < 0.03);
  CHECK(std::abs(fine) < 0.6 * std::abs(coarse));
}

TEST_CASE("a ball pressed into a block in space meets the force of the body of revolution") {
  for (double const mu : {0.0, 0.3}) {
    CAPTURE(mu);
    double const solid = force_in_space(0.0075, mu), revolved = force_of_revolution(0.0075, mu);
    CHECK(solid == doctest::Approx(revolved).epsilon(0.015));
  }
}

TEST_CASE("a free ball on the axis stays there, though what it touches pushes it outwards") {
  for (double const mu : {0.0, 0.3}) {
    auto table = test::make("scene");
    test::at(table, "kinematics") = test::text("axisymmetric");
    test::at(table, "bodies.block") =
        test::block({{0, -1}, {1, 1}, {8, 8}}, test::linear_elastic(1, 0.3), 0.02);
    test::at(table, "obstacles.ball") = test::make(
        "obstacle", {{"shape", test::make("rigid.circle", {{"centre", test::values({0, 1.05}, "m")},
                                                           {"radius", test::value(1, "m")}})},
                     {"mass", test::value(0.1, "kg")},
                     {"velocity", test::values({0, -1}, "m/s")}});
    test::at(table, "pairs.joint") = test::pair("block.top", "ball");
    if (mu > 0)
      test::at(table, "pairs.joint.friction") = test::coulomb(mu);
    test::at(table, "motions") =
        test::list({test::fix("block.bottom"), test::fix("block.left", true, false)});
    test::at(table, "scheme") = test::make("scheme.theta_xi");
    test::at(table, "schedule") = test::schedule({{1, 1}});
    auto const scene = scene::build(table);
    dynamics::Stepper stepper(*scene.model);
    auto const end = test::march(stepper, stepper.initial(), 0.01, 30);
    Index const node = scene.model->rigids[0].node;
    CHECK(end.u[2 * node] == 0);
    CHECK(end.v[2 * node + 1] > -0.9); // it was slowed down
  }
}
