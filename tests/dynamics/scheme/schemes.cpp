// Order, exact recursion and energy of every setting of the time scheme, on a bar that swings in one mode.
#include <doctest/doctest.h>
#include <numbers>

#include "dynamics/marching.hpp"

using namespace stiction;
using dynamics::ContactInertia;
using dynamics::ThetaXi;

namespace {

/// A bar of four cells, E = rho = 1, left end held, in its first mode. A wall far away only makes its right
/// end a contact surface.
struct Bar {
  scene::Scene scene;
  double omega = 0; ///< of the mode of the semi-discrete bar with its consistent mass, rad/s
  Vector mode;      ///< [2 nodes], initial velocity, m/s
  dynamics::Model& model() { return *scene.model; }
};

Bar bar(ThetaXi const& scheme) {
  auto table = test::make("scene");
  test::at(table, "bodies.bar") = test::block({{0, 0}, {1, 0.25}, {4, 1}}, test::linear_elastic(1, 0));
  test::at(table, "obstacles.wall.shape") =
      test::make("rigid.plane", {{"point", test::values({10, 0}, "m")}, {"normal", test::values({-1, 0})}});
  test::at(table, "pairs.end") = test::pair("bar.right", "wall");
  test::at(table, "motions") =
      test::list({test::fix("bar.left", true, false), test::fix("bar.all", false, true)});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  Bar made{scene::build(table), 0, {}};
  auto& model = made.model();
  model.scheme = scheme;
  model.control.force_tolerance = 1e-13;
  double const h = 0.25, k = std::numbers::pi / 2;
  made.omega = std::sqrt(6 / (h * h) * (1 - std::cos(k * h)) / (2 + std::cos(k * h)));
  made.mode.setZero(2 * model.node_count());
  for (Index i = 0; i < model.node_count(); ++i)
    model.velocity(i, 0) = made.mode[2 * i] = std::sin(k * model.reference(i, 0));
  return made;
}

Vector displacement_at(ThetaXi const& scheme, double time, int steps) {
  Bar swinging = bar(scheme);
  dynamics::Stepper stepper(swinging.model());
  return test::march(stepper, stepper.initial(), time / steps, steps).u;
}

/// Rate at which the displacement settles when the step is halved twice.
double order(ThetaXi const& scheme) {
  double const time = 5.3; // of a period of about four
  Vector const coarse = displacement_at(scheme, time, 200), middle = displacement_at(scheme, time, 400),
               fine = displacement_at(scheme, time, 800);
  return std::log2((coarse - middle).norm() / (middle - fine).norm());
}

std::string words(ThetaXi const& scheme) {
  return "theta " + std::to_string(scheme.theta) + ", xi " + std::to_string(scheme.xi) +
         ", contact inertia " + std::to_string(static_cast<int>(scheme.contact_inertia));
}

constexpr double weights[] = {0.5, 0.55, 1};

} // namespace

TEST_CASE("every weight of the scheme gives the amplification of its formula") {
  for (double const theta : weights)
    for (double const xi : weights) {
      Bar swinging = bar({theta, xi, 1, ContactInertia::full});
      CAPTURE(theta);
      CAPTURE(xi);
      dynamics::Stepper stepper(swinging.model());
      double const dt = 0.3, omega2 = swinging.omega * swinging.omega;
      double u = 0, v = 1;
      test::march(stepper, stepper.initial(), dt, 12, [&](test::State const&, test::State const& state) {
        double const u0 = u, v0 = v;
        v = (v0 - dt * omega2 * (u0 + xi * dt * (1 - theta) * v0)) / (1 + dt * dt * omega2 * xi * theta);
        u = u0 + dt * ((1 - theta) * v0 + theta * v);
        CHECK(test::largest(state.u - u * swinging.mode) < 1e-10);
        CHECK(test::largest(state.v - v * swinging.mode) < 1e-10);
      });
    }
}

TEST_CASE("the scheme tends to the exact swinging of the discrete bar") {
  Bar const swinging = bar({});
  double const time = 5.3;
  Vector const u = displacement_at({0.5, 0.5, 1, ContactInertia::full}, time, 800);
  CHECK(test::largest(u - std::sin(swinging.omega * time) / swinging.omega * swinging.mode) < 1e-4);
}

TEST_CASE("order two for theta = xi = 1/2, one otherwise") {
  for (auto const inertia : {ContactInertia::full, ContactInertia::none})
    for (double const theta : weights)
      for (double const xi : weights) {
        ThetaXi const scheme{theta, xi, 1, inertia};
        INFO(words(scheme));
        CHECK(order(scheme) == doctest::Approx(theta == 0.5 && xi == 0.5 ? 2 : 1).epsilon(0.1));
      }
}

TEST_CASE("backward Euler on the contact nodes alone makes the whole first order") {
  for (double const theta : weights) {
    ThetaXi const scheme{theta, theta, 1, ContactInertia::implicit};
    INFO(words(scheme));
    CHECK(order(scheme) == doctest::Approx(1).epsilon(0.1));
  }
}

TEST_CASE("theta = xi = 1/2 keeps the energy of a swinging bar over fifty periods") {
  Bar swinging = bar({0.5, 0.5, 1, ContactInertia::full});
  dynamics::Stepper stepper(swinging.model());
  double const period = 2 * std::numbers::pi / swinging.omega;
  auto const first = stepper.initial();
  auto const last = test::march(stepper, first, period / 20, 1000);
  CHECK(first.ledger.start > 0.05);
  CHECK(std::abs(last.ledger.kinetic + last.ledger.strain - first.ledger.start) < 1e-10 * first.ledger.start);
  CHECK(std::abs(last.ledger.scheme_loss()) < 1e-10 * first.ledger.start);
}

TEST_CASE("the work of a driven end is the energy that arrives") {
  Bar swinging = bar({0.5, 0.5, 1, ContactInertia::full});
  auto& model = swinging.model();
  for (auto& motion : model.motions)
    if (motion.component == 0)
      motion.path = {{0, 1, 2, 3}, {0, 0.2, 0.4, 0.6}};
  for (Index const node : test::nodes_of(swinging.scene, "bar.left"))
    model.velocity(node, 0) = 0.2; // as its path goes on
  dynamics::Stepper stepper(model);
  auto const state = test::march(stepper, stepper.initial(), 0.1, 30);
  CHECK(std::abs(state.ledger.motion_work) > 0.01);
  CHECK(std::abs(state.ledger.scheme_loss()) < 1e-11);
}

TEST_CASE("backward Euler only ever loses energy") {
  Bar swinging = bar({1, 1, 1, ContactInertia::full});
  dynamics::Stepper stepper(swinging.model());
  auto const state =
      test::march(stepper, stepper.initial(), 0.1, 100, [](test::State const& old, test::State const& next) {
        CHECK(next.ledger.scheme_loss() > old.ledger.scheme_loss());
      });
  CHECK(state.ledger.scheme_loss() > 0.3 * state.ledger.start);
}
