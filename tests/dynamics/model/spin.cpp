// A free rigid body with an inertia tensor against what is known of tops.
#include "dynamics/model/spin.hpp"

#include "differences.hpp"
#include "dynamics/space.hpp"

using namespace stiction;
using test::Vec3;

namespace {

/// A body that turns far from anything, in a scheme that is of second order for it, or the default.
test::Input top(std::vector<double> const& tensor, std::vector<double> const& spin, bool full = true) {
  auto table = test::make("scene");
  auto shape =
      test::make("rigid.sphere", {{"centre", test::values({0, 0, 9}, "m")}, {"radius", test::value(1, "m")}});
  test::at(table, "kinematics") = test::text("three_dimensional");
  test::at(table, "bodies.bed") =
      test::box({{-1, -1, -1}, {2, 2, 1}, {1, 1, 1}}, test::linear_elastic(1e5, 0.3), 10);
  test::at(table, "obstacles.ball") =
      test::make("obstacle", {{"shape", std::move(shape)},
                              {"mass", test::value(1, "kg")},
                              {"inertia_tensor", test::values(tensor, "kg m^2")},
                              {"spin", test::values(spin, "rad/s")}});
  test::at(table, "pairs.joint") = test::pair("bed.top", "ball");
  test::at(table, "motions") = test::list({test::fix("bed.bottom")});
  test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
  if (full)
    test::at(table, "scheme.contact_inertia") = test::text("full");
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "probes.momentum") = test::make("probe.momentum");
  test::at(table, "probes.energy") = test::make("probe.energy", {{"audit", test::flag(true)}});
  return table;
}

struct Turn {
  Vec3 momentum, rate;
  Eigen::Matrix3d turned;
  double kinetic = 0, unaccounted = 0;
};

Turn of(scene::Scene const& scene, test::State const& state) {
  Vec3 const w = state.v.segment<3>(scene.model->rigids[0].turn());
  return {dynamics::inertia_in_space(*scene.model, 0, state) * w, w, state.turned[0], state.ledger.kinetic,
          state.ledger.unaccounted()};
}

test::State spin(
    scene::Scene const& scene, double dt, int steps,
    std::function<void(test::State const&)> const& each = [](auto const&) {}) {
  dynamics::Stepper stepper(*scene.model);
  return test::march(stepper, stepper.initial(), dt, steps,
                     [&](test::State const&, test::State const& after) { each(after); });
}

} // namespace

TEST_CASE("the torque of a step has its derivative") {
  Eigen::Matrix3d A;
  A << 2, 0.2, -0.3, 0.2, 1.5, 0.1, -0.3, 0.1, 1;
  for (double const rate : {0.05, 0.1})
    for (double const size : {0.0, 1e-3, 0.4, 2.0}) {
      dynamics::Spin const spin{A, Vec3(1, -2, 0.5), 0.1, rate};
      Vector const d = size * Vec3(0.3, 0.8, -0.5);
      auto const torque = [&](Vector const& x) { return Vector(spin.torque(Vec3(x))); };
      auto const found = test::rate(torque, Dense(spin.stiffness(Vec3(d))), d, 1e-2);
      CHECK_MESSAGE(found.second_order, found.words());
    }
}

TEST_CASE("a symmetric top precesses about its angular momentum by L over its transverse moment") {
  double const across = 1, along = 1.8, time = 2;
  Vec3 const rate(0.6, 0, 2);
  Vec3 const L(across * rate.x(), 0, along * rate.z());
  Vec3 const axis = Eigen::AngleAxisd(L.norm() / across * time, L.normalized()) * Vec3::UnitZ();
  double last = 0;
  for (int const steps : {40, 80}) {
    auto const scene = scene::build(top({across, across, along}, {rate.x(), rate.y(), rate.z()}));
    auto const end = of(scene, spin(scene, time / steps, steps));
    CHECK((end.momentum - L).norm() < 1e-6);
    double const error = (end.turned * Vec3::UnitZ() - axis).norm();
    CHECK(error < 0.05);
    if (last > 0)
      CHECK(error == doctest::Approx(last / 4).epsilon(0.15));
    last = error;
  }
}

TEST_CASE("about its middle axis a body turns over and over, momentum and energy stay") {
  auto const scene = scene::build(top({1, 2, 3}, {1e-3, 3, 0}));
  int flips = 0;
  double side = 1, worst = 0, drift = 0;
  auto const end = spin(scene, 0.05, 400, [&](test::State const& state) {
    auto const now = of(scene, state);
    double const middle = (now.turned.transpose() * now.rate).y();
    flips += middle * side < 0 && std::abs(middle) > 2 ? 1 : 0;
    side = std::abs(middle) > 2 ? std::copysign(1.0, middle) : side;
    worst = std::max(worst, (now.momentum - Vec3(1e-3, 6, 0)).norm());
    drift = std::max(drift, std::abs(now.kinetic - (9 + 0.5e-6)));
  });
  CHECK(flips >= 2);
  CHECK(worst < 1e-6);
  CHECK(drift < 1e-6);
  CHECK(std::abs(of(scene, end).unaccounted) < 1e-6);
  for (double const twist : {1e-3, 0.0}) { // about the others it stays
    auto const steady = scene::build(top({1, 2, 3}, {twist, twist, 3}));
    auto const state = of(steady, spin(steady, 0.05, 200));
    CHECK((state.turned.transpose() * state.rate).z() > 2.99);
  }
}

TEST_CASE("the default scheme keeps angular momentum and loses energy that its audit foretells") {
  auto const scene = scene::build(top({2, 2.5, 3, 0.1, -0.2, 0.3}, {1, 2, 3}, false));
  Eigen::Matrix3d J;
  J << 2, 0.1, 0.3, 0.1, 2.5, -0.2, 0.3, -0.2, 3;
  Vec3 const w(1, 2, 3);
  auto const start = dynamics::Stepper(*scene.model).initial();
  CHECK(start.ledger.kinetic == doctest::Approx(0.5 * w.dot(J * w)));
  auto const state = spin(scene, 0.01, 100);
  auto const end = of(scene, state);
  CHECK((end.momentum - J * w).norm() < 1e-6);
  CHECK(end.kinetic < start.ledger.kinetic);
  CHECK(std::abs(end.unaccounted) < 1e-6);
  auto const total = state.momenta.bodies.back();
  CHECK((total.angular - J * w).norm() < 1e-6);
}

TEST_CASE("an inertia tensor that no body has is refused") {
  auto const refused = [](std::vector<double> const& tensor) {
    try {
      static_cast<void>(scene::build(top(tensor, {0, 0, 1})));
    } catch (core::InputError const& error) {
      return std::string(error.what()).find("inertia_tensor") != std::string::npos;
    }
    return false;
  };
  CHECK(refused({1, 1, 2.1}));
  CHECK(refused({1, 1, -1}));
  CHECK(refused({1, 1}));
  CHECK(refused({1, 1, 1, 2, 0, 0}));
}

TEST_CASE("a spinning ball that lands is the same in small units") {
  auto const landed = [](double m) { // lengths times m: stresses over m, moments of inertia times m^2
    auto table = test::make("scene");
    auto shape = test::make("rigid.sphere", {{"centre", test::values({0, 0, 0.011 * m}, "m")},
                                             {"radius", test::value(0.01 * m, "m")}});
    double const J = 1e-8 * m * m;
    test::at(table, "kinematics") = test::text("three_dimensional");
    test::at(table, "bodies.bed") =
        test::box({{-0.01 * m, -0.01 * m, -0.01 * m}, {0.02 * m, 0.02 * m, 0.01 * m}, {2, 2, 1}},
                  test::linear_elastic(1e5 / m, 0.3), 1000 / (m * m * m));
    test::at(table, "obstacles.ball") =
        test::make("obstacle", {{"shape", std::move(shape)},
                                {"mass", test::value(1e-3, "kg")},
                                {"inertia_tensor", test::values({J, 1.5 * J, 2 * J}, "kg m^2")},
                                {"velocity", test::values({0, 0, -0.1 * m}, "m/s")},
                                {"spin", test::values({3, 5, 20}, "rad/s")}});
    test::at(table, "pairs.joint") = test::pair("bed.top", "ball");
    test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
    test::at(table, "motions") = test::list({test::fix("bed.bottom")});
    test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
    test::at(table, "schedule") = test::schedule({{0.1, 1}});
    test::at(table, "probes.momentum") = test::make("probe.momentum");
    auto const scene = scene::build(table);
    double off = 0; // of its own momentum and what contact gave it, at any step
    auto const end = spin(scene, 2e-3, 25, [&](test::State const& state) {
      Vec3 const gained = state.momenta.bodies.back().linear - Vec3(0, 0, -1e-4 * m);
      off = std::max(off, (gained - state.momenta.pairs[0].primary.linear).norm());
    });
    CHECK(off < 1e-6 * 1e-4 * m);
    auto const& ball = end.momenta.bodies.back();
    return std::pair{Vec3(ball.linear / (1e-3 * 0.1 * m)), Vec3(ball.angular / (20 * J))};
  };
  auto const ordinary = landed(1), small = landed(1e-9);
  CHECK(ordinary.first.z() > -0.9); // it has landed
  CHECK((ordinary.first - small.first).norm() < 1e-6);
  CHECK((ordinary.second - small.second).norm() < 1e-6);
}
