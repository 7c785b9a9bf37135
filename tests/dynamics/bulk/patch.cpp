// Contact of elastic bodies: patch test, both roles, moved observers.
#include <Eigen/Geometry>
#include <doctest/doctest.h>
#include <numbers>

#include "dynamics/marching.hpp"

using namespace stiction;

namespace {

/// Largest deviation of the recovered stress from sigma_yy = `axial`, all else zero, Pa.
double deviation(scene::Scene const& scene, test::State const& state, double axial) {
  auto const& model = *scene.model;
  double worst = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    auto const first = ix(2 * model.first_node[b]), count = ix(2 * model.first_node[b + 1]) - first;
    Matrix stress = model.cells[b].stress({state.u.data() + first, count}).cauchy;
    stress.col(1).array() -= axial;
    worst = std::max(worst, stress.cwiseAbs().maxCoeff());
  }
  return worst;
}

test::State pressed(scene::Scene const& scene) {
  dynamics::Stepper stepper(*scene.model);
  return test::march(stepper, stepper.initial(), 0.25, 4);
}

/// A half disc of radius 5 mm on its back below a plate, both Blatz-Ko; the plate's top sinks by 0.3 mm.
test::Input hertz(double size, bool plate_is_secondary) {
  auto table = test::make("scene");
  auto const rubber = test::make("material.blatz_ko", {{"shear_modulus", test::value(10, "MPa")}});
  double const across = std::round(6e-3 / size), high = std::round(2e-3 / size);
  test::at(table, "bodies.plate") = test::block({{-3e-3, 0}, {6e-3, 2e-3}, {across, high}}, rubber);
  test::at(table, "bodies.disc") = test::half_disc(5e-3, size, rubber);
  test::at(table, "pairs.joint") =
      plate_is_secondary ? test::pair("plate.bottom", "disc.arc") : test::pair("disc.arc", "plate.bottom");
  test::at(table, "motions") =
      test::list({test::fix("disc.flat"), test::drive("plate.top", {0, 1}, {0, 0}, {0, -0.3e-3})});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 4}});
  return table;
}

double hertz_force(double size, bool plate_is_secondary) {
  auto const scene = scene::build(hertz(size, plate_is_secondary));
  return -test::force_on(scene, pressed(scene), "plate.top").y();
}

/// Turns a scene of driven planes about the origin. Every motion must come as x and y of one set.
void turn(dynamics::Model& model, double angle) {
  Eigen::Matrix2d const R = Eigen::Rotation2D<double>(angle).toRotationMatrix();
  model.reference *= R.transpose();
  model.velocity *= R.transpose();
  model.gravity.head<2>() = (R * model.gravity.head<2>()).eval();
  model.cells.clear();
  for (auto& body : model.bodies) {
    body->mesh.nodes *= R.transpose();
    model.cells.emplace_back(*body, model.kinematics);
  }
  for (std::size_t m = 0; m < model.motions.size(); m += 2) {
    auto &x = model.motions[m].path, &y = model.motions[m + 1].path;
    for (std::size_t k = 0; k < x.values.size(); ++k) {
      test::Vec2 const turned = R * test::Vec2(x.values[k], y.values[k]);
      x.values[k] = turned.x();
      y.values[k] = turned.y();
    }
  }
}

Vector turned(Vector u, double angle) {
  Eigen::Matrix2d const R = Eigen::Rotation2D<double>(angle).toRotationMatrix();
  for (Eigen::Index i = 0; i < u.size(); i += 2)
    u.segment<2>(i) = (R * u.segment<2>(i)).eval();
  return u;
}

} // namespace

TEST_CASE("patch test: matching meshes carry a uniform stress, whichever surface is secondary") {
  for (bool const upper_is_secondary : {true, false}) {
    auto table = test::two_blocks();
    if (!upper_is_secondary)
      test::at(table, "pairs.joint") = test::pair("lower.top", "upper.bottom");
    test::at(table, "motions") = test::list({test::fix("lower.bottom"), test::fix("lower.all", true, false),
                                             test::fix("upper.all", true, false),
                                             test::drive("upper.top", {0, 1, 2}, {}, {0, -0.01, -0.01})});
    CAPTURE(upper_is_secondary);
    auto const scene = scene::build(table);
    auto const state = pressed(scene);
    double const axial = -1000 * 0.01 / 2;
    CHECK(deviation(scene, state, axial) < 1e-8 * -axial);
    for (auto const& point : state.contacts[0]) {
      CHECK(point.dry[0] == doctest::Approx(-axial).epsilon(1e-8));
      CHECK(std::abs(point.gap) < 1e-12);
    }
  }
}

TEST_CASE("patch test: a rigid plane carries a uniform stress") {
  auto const scene = scene::build(test::foot_on_floor());
  auto const state = pressed(scene);
  CHECK(deviation(scene, state, -10) < 1e-7);
  CHECK(test::contact_force(scene, state).y() == doctest::Approx(10).epsilon(1e-9));
}

TEST_CASE("patch test: large strains of rubber stay uniform over a rigid plane") {
  auto table = test::foot_on_floor();
  double const G = 400, squeezed = 0.7;
  test::at(table, "bodies.foot.material") =
      test::make("material.blatz_ko", {{"shear_modulus", test::value(G, "Pa")}});
  test::at(table, "motions") = test::list(
      {test::fix("foot.all", true, false), test::drive("foot.top", {0, 1, 2}, {}, {0, squeezed - 1, 0})});
  auto const scene = scene::build(table);
  auto const state = pressed(scene);
  for (Index i = 0; i < scene.model->node_count(); ++i)
    CHECK(state.u[2 * i + 1] == doctest::Approx((squeezed - 1) * scene.model->reference(i, 1)).epsilon(1e-7));
  // W = G/2 (1/L^2 + 2 L - 3) of the confined stretch L
  CHECK(test::contact_force(scene, state).y() ==
        doctest::Approx(G * (std::pow(squeezed, -3) - 1)).epsilon(1e-7));
}

TEST_CASE("a press gives the same force from either role, the closer the finer the mesh") {
  double const coarse = hertz_force(1e-3, true) / hertz_force(1e-3, false) - 1;
  double const fine = hertz_force(0.25e-3, true) / hertz_force(0.25e-3, false) - 1;
  CAPTURE(coarse);
  CAPTURE(fine);
  CHECK(std::abs(coarse) < 0.03);
  CHECK(std::abs(fine) < 0.6 * std::abs(coarse));
}

TEST_CASE("a big quasi-static contact step converges in few iterations") {
  auto const scene = scene::build(hertz(0.5e-3, true));
  dynamics::Stepper stepper(*scene.model);
  auto const outcome = stepper.step(stepper.initial(), 0.25); // 75 um of cells of 0.5 mm
  INFO(outcome.reason);
  REQUIRE(outcome.converged());
  CHECK(outcome.iterations <= 8);
  CHECK(stepper.cost().factorizations <= 3);
}

TEST_CASE("with a fresh factor the step's Newton is quadratic, contact geometry included") {
  auto const scene = scene::build(hertz(0.5e-3, true));
  auto& control = scene.model->control;
  control.force_tolerance = 1e-9;
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.25, 3);
  control.iterations = 1;
  double left[3] = {};
  for (int k = 0; k < 3; ++k) {
    dynamics::Stepper fresh(*scene.model);
    left[k] = fresh.step(state, 0.004 / (1 << k)).out_of_balance;
  }
  CHECK(std::log2(left[0] / left[1]) == doctest::Approx(2).epsilon(0.15));
  CHECK(std::log2(left[1] / left[2]) == doctest::Approx(2).epsilon(0.15));
}

TEST_CASE("a circle pressed into a block is the block pressed against a resting circle") {
  auto table = test::make("scene");
  test::at(table, "bodies.foot") = test::block({}, test::linear_elastic(1000, 0.3));
  test::at(table, "obstacles.ball.shape") = test::make(
      "rigid.circle", {{"centre", test::values({0.45, 1.5}, "m")}, {"radius", test::value(0.5, "m")}});
  test::at(table, "pairs.top") = test::pair("foot.top", "ball");
  test::at(table, "pairs.top.friction") = test::coulomb(0.4);
  test::at(table, "pairs.top.adhesion") = test::rcc(0.1, 100, 1);
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{2, 1}});
  std::vector<double> const times{0, 1, 2}, along{0, 0, 0.1}, down{0, -0.05, -0.05};
  auto moving_ball = table, moving_block = table;
  test::at(moving_ball, "obstacles.ball.times") = test::values(times, "s");
  test::at(moving_ball, "obstacles.ball.x") = test::values(along, "m");
  test::at(moving_ball, "obstacles.ball.y") = test::values(down, "m");
  test::at(moving_ball, "motions") = test::list({test::fix("foot.bottom")});
  test::at(moving_block, "motions") =
      test::list({test::drive("foot.bottom", times, {0, 0, -0.1}, {0, 0.05, 0.05})});

  auto const ball = scene::build(moving_ball), foot = scene::build(moving_block);
  for (auto const* scene : {&ball, &foot})
    scene->model->control.force_tolerance = 1e-9;
  dynamics::Stepper ball_stepper(*ball.model), foot_stepper(*foot.model);
  auto const a = test::march(ball_stepper, ball_stepper.initial(), 0.1, 20);
  auto const b = test::march(foot_stepper, foot_stepper.initial(), 0.1, 20);
  CHECK(test::contact_force(ball, a).norm() > 1);
  CHECK((test::contact_force(ball, a) - test::contact_force(foot, b)).norm() < 1e-7);
  for (std::size_t i = 0; i < a.contacts[0].size(); ++i) {
    CHECK(a.contacts[0][i].path[0] == doctest::Approx(b.contacts[0][i].path[0]).epsilon(1e-7));
    CHECK(a.contacts[0][i].bond.beta == doctest::Approx(b.contacts[0][i].bond.beta).epsilon(1e-7));
  }
  CHECK(a.ledger.friction_loss == doctest::Approx(b.ledger.friction_loss).epsilon(1e-6));
  CHECK(a.ledger.motion_work == doctest::Approx(b.ledger.motion_work).epsilon(1e-6));
}

TEST_CASE("a set-up turned by thirty degrees gives turned results") {
  auto table = test::two_blocks();
  test::at(table, "bodies.upper.mesh.cells") = test::values({3, 3}); // nodes off each other
  test::at(table, "bodies.upper.mesh.origin") = test::values({0.1, 0}, "m");
  test::at(table, "bodies.upper.mesh.size") = test::values({0.7, 1}, "m");
  for (std::string const body : {"lower", "upper"})
    test::at(table, "bodies." + body + ".material") = test::make(
        "material.neo_hookean", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  test::at(table, "pairs.joint.adhesion") = test::rcc(0.1, 100, 1);
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "gravity") = test::values({1, -3}, "m/s^2");
  double const angle = std::numbers::pi / 6;
  auto const upright = scene::build(table);
  auto const tilted = scene::build(table);
  turn(*tilted.model, angle);
  for (auto const* scene : {&upright, &tilted})
    scene->model->control.force_tolerance = 1e-9;
  dynamics::Stepper one(*upright.model), other(*tilted.model);
  auto const a = test::march(one, one.initial(), 0.05, 30);
  auto const b = test::march(other, other.initial(), 0.05, 30);
  CHECK(a.contacts[0][1].path[0] != doctest::Approx(0));
  CHECK(a.ledger.friction_loss > 1e-3);
  CHECK(test::largest(turned(a.u, angle) - b.u) < 1e-8);
  CHECK(test::largest(turned(a.reaction, angle) - b.reaction) < 1e-5);
  CHECK(a.ledger.friction_loss == doctest::Approx(b.ledger.friction_loss).epsilon(1e-6));
}
