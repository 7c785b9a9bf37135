// Bonds over whole steps: growth at rest, separation, sliding across facets.
#include <doctest/doctest.h>

#include "dynamics/all_schemes.hpp"
#include "dynamics/marching.hpp"

using namespace stiction;

namespace {

/// A block bonded to the floor (beta0 = 1, b = 0) and lifted by its top.
test::Input lifted(double w, double C, double height) {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.material") = test::linear_elastic(1e4, 0);
  test::at(table, "pairs.sole.adhesion") = test::rcc(w, C, 0);
  test::at(table, "pairs.sole.adhesion.beta0") = test::value(1);
  test::at(table, "motions") = test::list({test::drive("foot.top", {0, 1}, {0, 0}, {0, height})});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

struct Travel {
  double path = 0, stretch = 0, arc = 0; ///< m
};

/// Drags one contact point over a fixed half disc of radius 5 m from the crown by 0.7 rad; arc is the exact
/// length between its first and last position.
Travel drag_over_arc(double size, int steps) {
  double const radius = 5, angle = 0.7;
  auto table = test::make("scene");
  test::at(table, "bodies.disc") = test::half_disc(radius, size, test::linear_elastic(1e4, 0));
  test::at(table, "bodies.finger") = test::block({{0, 0}, {0.5, 0.5}, {1, 1}}, test::linear_elastic(1e3, 0));
  test::at(table, "pairs.tip") = test::pair("finger.bottom", "disc.arc");
  test::at(table, "pairs.tip.reach") = test::value(0.5, "m");
  test::at(table, "pairs.tip.adhesion") = test::rcc(1e-6, 1e-3, 1);
  test::at(table, "pairs.tip.adhesion.beta0") = test::value(1);
  std::vector<double> times, x, y;
  for (int k = 0; k <= steps; ++k) {
    double const phi = angle * k / steps;
    times.push_back(static_cast<double>(k) / steps);
    x.push_back(radius * std::sin(phi));
    y.push_back(radius * (std::cos(phi) - 1) - 0.05);
  }
  y.front() = 0;
  test::at(table, "motions") = test::list({test::fix("disc.all"), test::drive("finger.top", times, x, y)});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, steps}});
  auto const scene = scene::build(table);
  auto& pair = scene.model->pairs[0];
  Index const tip = scene.nearest(pair.secondary, {0, 0});
  pair.secondary = {tip};
  pair.areas = {0.25};
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 1.0 / steps, steps);
  auto const& point = state.contacts[0][0];
  CHECK(std::abs(point.gap) < 1e-9);
  test::Vec2 const position = scene.model->reference.row(tip).transpose() + state.u.segment<2>(2 * tip);
  return {point.path[0], point.bond.stretch[0], radius * std::atan2(position.x(), position.y() + radius)};
}

} // namespace

TEST_CASE("a bond at rest grows as w t / b on every closed point, up to one") {
  double const w = 20, b = 50;
  for (bool const rigid : {true, false}) {
    auto table = rigid ? test::foot_on_floor() : test::two_blocks();
    test::at(table, rigid ? "pairs.sole.adhesion" : "pairs.joint.adhesion") = test::rcc(w, 1e3, b);
    CAPTURE(rigid);
    auto const scene = scene::build(table);
    dynamics::Stepper stepper(*scene.model);
    auto state = stepper.initial();
    for (double const dt : {0.1, 0.3, 0.25, 0.35}) {
      state = test::march(stepper, state, dt, 1);
      for (auto const& point : state.contacts[0])
        CHECK(point.bond.beta == doctest::Approx(w * state.t / b).epsilon(1e-12));
      CHECK(state.ledger.bonding_loss == doctest::Approx(w * w * state.t / b).epsilon(1e-12));
      CHECK(state.ledger.bond == doctest::Approx(-w * w * state.t / b).epsilon(1e-12));
    }
  }
}

TEST_CASE("a saturated bond stays at one") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.adhesion") = test::rcc(20, 1e3, 5);
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.1, 5);
  for (auto const& point : state.contacts[0])
    CHECK(point.bond.beta == 1);
}

TEST_CASE("lifting a bonded block: peak traction sqrt(w C), work of separation w") {
  double const w = 4, C = 100; // sigma0 = 20 Pa, u0 = 0.2 m
  auto const scene = scene::build(lifted(w, C, 4));
  double loss[2] = {};
  for (int const refined : {0, 1}) {
    int const steps = refined != 0 ? 4000 : 2000;
    dynamics::Stepper stepper(*scene.model);
    double peak = 0, opening = 0;
    auto const first = stepper.initial();
    auto const last =
        test::march(stepper, first, 1.0 / steps, steps, [&](test::State const&, test::State const& state) {
          double const pull = test::force_on(scene, state, "foot.top").y();
          opening = pull > peak ? state.contacts[0][0].gap : opening;
          peak = std::max(peak, pull);
        });
    CHECK(peak == doctest::Approx(std::sqrt(w * C)).epsilon(0.01));
    CHECK(opening == doctest::Approx(std::sqrt(w / C)).epsilon(0.02));
    double const rest = 0.5 * w * w / C / (4 * 4); // int of w^2 / (C x^3) beyond the end
    CHECK(last.ledger.motion_work + rest == doctest::Approx(w).epsilon(0.01));
    CHECK(last.ledger.bonding_loss == 0);
    loss[refined] = std::abs(last.ledger.scheme_loss());
  }
  CHECK(loss[1] < 0.6 * loss[0]);
}

TEST_CASE("bonds that grow in a gap are felt as far as the law says, whatever the cells") {
  double const w = 1, C = 1e2, u0 = std::sqrt(w / C), stiff = 1e6;
  for (double const cells : {1., 2., 8.}) {
    auto table = test::foot_on_floor();
    test::at(table, "bodies.foot") =
        test::block({{0, 0}, {1, 1}, {cells, 1}}, test::linear_elastic(stiff, 0));
    test::at(table, "pairs.sole.adhesion") = test::rcc(w, C, 0);
    test::at(table, "pairs.sole.adhesion.bonding") = test::text("proximity");
    test::at(table, "motions") = test::list({test::fix("foot.top")});
    for (double const gap : {2 * u0, 8 * u0, 18 * u0}) {
      CAPTURE(cells);
      CAPTURE(gap / u0);
      test::at(table, "obstacles.floor.shape.point") = test::values({0, -gap}, "m");
      auto const scene = scene::build(table);
      dynamics::Stepper stepper(*scene.model);
      auto const state = test::march(stepper, stepper.initial(), 1, 1);
      double const pull = w * w / (C * gap * gap * gap); // per area, on a foot that hardly stretches
      CHECK(test::force_on(scene, state, "foot.top").y() == doctest::Approx(pull).epsilon(1e-4));
    }
  }
}

TEST_CASE("reversible attraction is felt before the surfaces touch, at the velocity level as well") {
  double const w = 1, delta = 0.05, gap = 0.03, pull = w * gap / (delta * delta) * std::exp(-gap / delta);
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.adhesion") =
      test::make("adhesion.potential", {{"w", test::value(w, "J/m^2")}, {"delta", test::value(delta, "m")}});
  test::at(table, "obstacles.floor.shape.point") = test::values({0, -gap}, "m");
  test::at(table, "motions") = test::list({test::fix("foot.all")});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  std::vector<test::Input> const schemes{test::make("scheme.theta_xi", test::cure("implicit", "position")),
                                         test::make("scheme.theta_xi", test::cure("implicit", "velocity")),
                                         test::make("scheme.moreau_jean")};
  for (auto const& scheme : schemes) {
    test::at(table, "scheme") = scheme;
    auto const scene = scene::build(table);
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), 0.1, 2);
    for (auto const& point : state.contacts[0]) {
      CHECK(point.adhesion[0] == doctest::Approx(-pull).epsilon(1e-9));
      CHECK(std::abs(point.dry[0]) < 1e-9 * pull);
    }
  }
}

TEST_CASE("points without a counterpart have no bond from the start, and no energy of one") {
  auto table = test::two_blocks();
  test::at(table, "bodies.upper.mesh.origin") = test::values({0.5, 0}, "m"); // half of it overhangs
  test::at(table, "pairs.joint.adhesion") = test::rcc(4, 100, 1);
  test::at(table, "pairs.joint.adhesion.beta0") = test::value(1);
  test::at(table, "motions") = test::list({test::fix("lower.all"), test::fix("upper.all")});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const start = stepper.initial();
  double bonded = 0;
  for (auto const& point : start.contacts[0]) {
    CHECK(point.bond.beta == (point.foot.found() ? 1 : 0));
    bonded += point.area * point.bond.beta;
  }
  CHECK(bonded > 0.4);
  CHECK(bonded < 0.7);
  CHECK(start.ledger.bond == doctest::Approx(-4 * bonded).epsilon(1e-12));
  auto const end = test::march(stepper, start, 0.1, 2);
  CHECK(end.ledger.bond == doctest::Approx(start.ledger.bond).epsilon(1e-12));
  CHECK(std::abs(end.ledger.scheme_loss()) < 1e-12);
}

TEST_CASE("the slip of a point dragged across facets is the arc it covered, and so is its bond's stretch") {
  auto const coarse = drag_over_arc(0.5, 60), fine = drag_over_arc(0.25, 60);
  for (auto const& travel : {coarse, fine}) {
    CHECK(travel.arc > 3);
    CHECK(travel.path == doctest::Approx(travel.arc).epsilon(1e-3));
    CHECK(travel.stretch == doctest::Approx(travel.path).epsilon(1e-10));
  }
  CHECK(std::abs(fine.path - fine.arc) < 0.3 * std::abs(coarse.path - coarse.arc) + 1e-9);
}
