// Kelvin-Voigt damping over time: decay, order, energy account.
#include "dynamics/space.hpp"

using namespace stiction;

namespace {

constexpr double young = 1000, density = 3, speed = 1e-4, duration = 0.5; // Pa, kg/m^3, m/s, s
constexpr double eta = 3, zeta = 2;                                       // Pa s
/// One linear cell of 1 m with its foot held, nu = 0: m q'' + c q' + k q = 0.
constexpr double m = density / 3, c = 4 * eta / 3 + zeta, k = young;

test::Input viscous(double shear, double bulk) {
  return test::make("damping.kelvin_voigt", {{"shear_viscosity", test::value(shear, "Pa s")},
                                             {"bulk_viscosity", test::value(bulk, "Pa s")}});
}

/// The bar's top starts with `speed`; after `duration` in equal steps.
struct Swing {
  double q = 0, v = 0;
  dynamics::Ledger ledger;
};
Swing swing(bool in_space, int steps, double theta = 0.5, double xi = 0.5) {
  auto table = in_space ? test::space() : test::make("scene");
  auto const material = test::linear_elastic(young, 0);
  test::at(table, "bodies.bar") = in_space ? test::box({{0, 0, 0}, {1, 1, 1}, {1, 1, 1}}, material, density)
                                           : test::block({{0, 0}, {1, 1}, {1, 1}}, material, density);
  test::at(table, "bodies.bar.damping") = viscous(eta, zeta);
  test::at(table, "scheme") = test::theta_xi(theta, xi);
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "motions") =
      in_space ? test::list({test::fix_in("bar.bottom", "xyz"), test::fix_in("bar.top", "xy")})
               : test::list({test::fix("bar.bottom"), test::fix("bar.top", true, false)});
  auto const scene = scene::build(table);
  auto& model = *scene.model;
  int const up = model.dim() - 1;
  auto const top = test::nodes_of(scene, "bar.top");
  for (Index const node : top)
    model.velocity(node, up) = speed;
  model.control.force_tolerance = 1e-12;
  dynamics::Stepper stepper(model);
  auto const end = test::march(stepper, stepper.initial(), duration / steps, steps);
  auto const dof = model.dim() * top[0] + up;
  return {end.u[dof], end.v[dof], end.ledger};
}

/// The same by the scheme's own recurrence for one degree of freedom, (44), (46).
Swing recurrence(int steps, double theta, double xi) {
  double const dt = duration / steps;
  Swing s{0, speed, {}};
  for (int i = 0; i < steps; ++i) {
    // q1 = q + dt ((1 - theta) v + theta v1); m (v1 - v) / dt = -k q_xi - c v_xi
    double const q_known = s.q + dt * (1 - theta) * s.v;
    double const right = m * s.v / dt - k * ((1 - xi) * s.q + xi * q_known) - c * (1 - xi) * s.v;
    double const v1 = right / (m / dt + xi * theta * dt * k + xi * c);
    s.q = q_known + dt * theta * v1;
    s.v = v1;
  }
  return s;
}

/// m q'' + c q' + k q = 0 exactly.
Swing exact() {
  double const rate = c / (2 * m), omega = std::sqrt(k / m - rate * rate), t = duration;
  double const fade = std::exp(-rate * t);
  return {speed / omega * fade * std::sin(omega * t),
          speed * fade * (std::cos(omega * t) - rate / omega * std::sin(omega * t)),
          {}};
}

double error(Swing const& s) {
  auto const e = exact();
  return std::hypot(s.v - e.v, std::sqrt(k / m) * (s.q - e.q));
}

/// A viscous cube of rubber pulled and let go, without contact; after 1 s.
dynamics::Ledger rubber(int steps) {
  auto table = test::space();
  test::at(table, "bodies.cube") =
      test::box({}, test::make("material.blatz_ko", {{"shear_modulus", test::value(100, "Pa")}}), 5);
  test::at(table, "bodies.cube.damping") = viscous(8, 3);
  test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
  test::at(table, "motions") = test::list({test::fix_in("cube.bottom", "xyz")});
  auto const scene = scene::build(table);
  for (Index const node : test::nodes_of(scene, "cube.all"))
    scene.model->velocity.row(node) = 1.5 * scene.model->reference(node, 2) * Eigen::RowVector3d(0.3, 0, 1);
  scene.model->control.force_tolerance = 1e-11;
  dynamics::Stepper stepper(*scene.model);
  return test::march(stepper, stepper.initial(), 1.0 / steps, steps).ledger;
}

} // namespace

TEST_CASE("a viscous bar swings as the scheme's one degree of freedom does") {
  for (bool const in_space : {false, true})
    for (double const theta : {0.5, 0.8})
      for (double const xi : {0.5, 1.0}) {
        CAPTURE(in_space);
        CAPTURE(theta);
        CAPTURE(xi);
        auto const bar = swing(in_space, 40, theta, xi), one = recurrence(40, theta, xi);
        double const scale = speed * std::sqrt(m / k);
        CHECK(std::abs(bar.q - one.q) < 1e-5 * scale); // the strain is not quite linear
        CHECK(std::abs(bar.v - one.v) < 1e-5 * speed);
      }
}

TEST_CASE("the swing of a viscous bar nears its closed form as dt^2") {
  double const a = error(swing(false, 80)), b = error(swing(false, 160)), c2 = error(swing(false, 320));
  CHECK(std::log2(a / b) == doctest::Approx(2).epsilon(0.1));
  CHECK(std::log2(b / c2) == doctest::Approx(2).epsilon(0.1));
}

TEST_CASE("viscosity takes the energy that a linear swing loses and the ledger closes") {
  for (bool const in_space : {false, true}) {
    auto const ledger = swing(in_space, 60).ledger;
    double const left = ledger.kinetic + ledger.strain, start = 0.5 * m * speed * speed;
    CHECK(ledger.start == doctest::Approx(start).epsilon(1e-12));
    CHECK(ledger.damping_loss > 0.3 * start);
    CHECK(ledger.damping_loss == doctest::Approx(start - left).epsilon(1e-6));
  }
}

TEST_CASE("large motions of viscous rubber: the ledger closes as dt^2") {
  auto const coarse = rubber(100), fine = rubber(200);
  CHECK(fine.damping_loss > 0.3 * fine.start);
  CHECK(std::abs(coarse.scheme_loss()) < 2e-3 * coarse.start);
  CHECK(std::log2(std::abs(coarse.scheme_loss() / fine.scheme_loss())) > 1.7);
}

TEST_CASE("a viscous block on the floor converges though viscosity outweighs all else") {
  for (double const shear : {1.0, 1e2, 1e5}) {
    auto table = test::foot_on_floor();
    test::at(table, "bodies.foot.damping") = viscous(shear, 0);
    test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
    test::at(table, "scheme") = test::make("scheme.theta_xi");
    CAPTURE(shear);
    auto const scene = scene::build(table);
    scene.model->control.iterations = 4;
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), 0.05, 20);
    CHECK(test::contact_force(scene, state).y() > 1);
    for (auto const& point : state.contacts[0])
      CHECK(point.gap > -1e-9);
  }
}
