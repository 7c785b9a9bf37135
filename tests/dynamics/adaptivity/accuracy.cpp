// The estimate of a step's error against the error itself, on bodies that swing and on bonds that grow and
// break.
#include "dynamics/adaptivity/step_error.hpp"

#include <doctest/doctest.h>

#include "dynamics/adaptivity/pace.hpp"
#include "dynamics/marching.hpp"

using namespace stiction;
using dynamics::History;
using dynamics::StepError;

namespace {

/// A heavy block on a fixed base, let go at t = 0: it swings about its own weight.
test::Input swinging(test::Input scheme) {
  auto table = test::foot_on_floor();
  for (char const* part : {"pairs", "obstacles"})
    test::remove(table, part);
  test::at(table, "bodies.foot") = test::block({{0, 0}, {1, 1}, {1, 1}}, test::linear_elastic(1000, 0));
  test::at(table, "gravity") = test::values({0, -10}, "m/s^2");
  test::at(table, "motions") = test::list({test::fix("foot.bottom"), test::fix("foot.top", true, false)});
  test::at(table, "scheme") = std::move(scheme);
  return table;
}

test::Input theta(double value) {
  return test::make("scheme.theta_xi", {{"theta", test::value(value)}, {"xi", test::value(value)}});
}

/// A block bonded to the floor by beta0 and lifted by its top, quasi-statically; 0.1 m in 1 s.
test::Input peeled(double b) {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.material") = test::linear_elastic(1e4, 0);
  test::at(table, "pairs.sole.adhesion") = test::rcc(1, 1e3, b);
  test::at(table, "pairs.sole.adhesion.beta0") = test::value(0.9);
  test::at(table, "motions") = test::list({test::drive("foot.top", {0, 1}, {0, 0}, {0, 0.1})});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

/// The same block pressed against the floor, where it bonds; beyond beta = 1 if b is small.
test::Input pressed(double b) {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.adhesion") = test::rcc(1, 1e3, b);
  return table;
}

/// What one step of size dt is off by, against 64 steps, and what is thought of it.
struct Compared {
  StepError real, estimate;
};

double mean_square(dynamics::BulkSystem const& bulk, Vector const& u) {
  if (bulk.mass().values.empty())
    return 0;
  Vector momentum;
  bulk.mass().times(u, momentum);
  return u.dot(momentum);
}

double bond_distance(test::State const& a, test::State const& b) {
  double largest = 0;
  for (std::size_t p = 0; p < a.contacts.size(); ++p)
    for (std::size_t i = 0; i < a.contacts[p].size(); ++i)
      largest = std::max(largest, std::abs(a.contacts[p][i].bond.beta - b.contacts[p][i].bond.beta));
  return largest;
}

/// After `steps` steps of dt, so that a step before is known.
Compared compare(test::Input const& table, double dt, int steps) {
  auto const scene = scene::build(table);
  scene.model->control.force_tolerance = 1e-10;
  dynamics::Stepper stepper(*scene.model);
  History history(stepper.bulk(), *scene.model);
  double scale = 0;
  auto const before = test::march(stepper, stepper.initial(), dt, steps,
                                  [&](test::State const& old, test::State const& next) {
                                    history.accept(old, next, 0);
                                    scale = std::max(scale, mean_square(stepper.bulk(), next.u));
                                  });
  auto const once = test::march(stepper, before, dt, 1), fine = test::march(stepper, before, dt / 64, 64);
  scale = std::max(scale, mean_square(stepper.bulk(), once.u));
  Compared result;
  result.estimate = history.error(before, once);
  if (scale > 0)
    result.real.displacement = std::sqrt(mean_square(stepper.bulk(), once.u - fine.u) / scale);
  result.real.bond = bond_distance(once, fine);
  return result;
}

} // namespace

TEST_CASE("the estimate for u is the local error of the scheme and has its order") {
  struct Row {
    test::Input scheme;
    double order;
  };
  for (auto const& [scheme, order] :
       {Row{theta(0.5), 3}, Row{theta(0.6), 2}, Row{theta(1), 2}, Row{test::make("scheme.newmark"), 3}}) {
    CAPTURE(scheme.tag);
    CAPTURE(order);
    double last = 0;
    for (double const dt : {2e-3, 1e-3, 5e-4}) { // of a period of 115 ms, at the same moment
      auto const compared = compare(swinging(scheme), dt, static_cast<int>(std::lround(0.04 / dt)));
      double const estimate = compared.estimate.displacement;
      CAPTURE(dt);
      CAPTURE(estimate);
      CHECK(compared.real.displacement > 0);
      CHECK(estimate / compared.real.displacement == doctest::Approx(1).epsilon(0.15));
      if (last > 0)
        CHECK(std::log2(last / estimate) == doctest::Approx(order).epsilon(0.1));
      last = estimate;
    }
  }
}

TEST_CASE("where a swing is on its way back its error is still over how far it went") {
  double const dt = 1e-3, time = 0.085; // of a period of 115 ms: half of the way is left
  auto const compared = compare(swinging(theta(0.5)), dt, static_cast<int>(std::lround(time / dt)));
  double const estimate = compared.estimate.displacement;
  CHECK(compared.real.displacement > 0);
  CHECK(estimate / compared.real.displacement == doctest::Approx(1).epsilon(0.15));
}

TEST_CASE("the estimate for a breaking bond is its local error and of second order") {
  double last = 0;
  for (double const dt : {0.01, 0.005, 0.0025}) {
    auto const compared = compare(peeled(0.5), dt, static_cast<int>(std::lround(0.6 / dt)));
    double const estimate = compared.estimate.bond;
    CAPTURE(dt);
    CAPTURE(estimate);
    CHECK(compared.real.bond > 0);
    CHECK(estimate / compared.real.bond == doctest::Approx(1).epsilon(0.15));
    if (last > 0)
      CHECK(std::log2(last / estimate) == doctest::Approx(2).epsilon(0.1));
    last = estimate;
  }
}

TEST_CASE("a bond at rest grows without error and so it is thought") {
  auto const compared = compare(pressed(4), 0.05, 4);
  CHECK(compared.real.bond < 1e-12);
  CHECK(compared.estimate.bond < 1e-12);
  CHECK(compared.estimate.beta_change == doctest::Approx(0.05 / 4));
}

/// The peeled block in so many steps.
dynamics::State march_peeled(int steps, bool advance) {
  auto const scene = scene::build(peeled(0.5));
  scene.model->control.force_tolerance = 1e-10;
  scene.model->audited = true;
  dynamics::Stepper stepper(*scene.model);
  History history(stepper.bulk(), *scene.model);
  auto state = stepper.initial();
  for (int k = 0; k < steps; ++k) {
    auto outcome = stepper.step(state, 0.8 / steps);
    REQUIRE(outcome.converged());
    auto next = outcome.state;
    if (advance)
      history.advance_bonds(state, next);
    history.accept(state, outcome.state, 0);
    state = std::move(next);
  }
  return state;
}

TEST_CASE(
    "bonds that are advanced by their error converge with the second order at least instead of the first") {
  auto const last_beta = [](int steps, bool advance) {
    return march_peeled(steps, advance).contacts[0][0].bond.beta;
  };
  double const exact = last_beta(6400, true);
  CHECK(exact > 0.05);
  CHECK(exact < 0.85);
  for (bool const advance : {false, true}) {
    CAPTURE(advance);
    double const coarse = std::abs(last_beta(100, advance) - exact),
                 fine = std::abs(last_beta(400, advance) - exact);
    double const order = std::log2(coarse / fine) / 2;
    CAPTURE(order);
    CHECK(order > (advance ? 1.8 : 0.85));
    CHECK((advance || order < 1.15));
  }
}

TEST_CASE("the ledger follows bonds that are advanced by their error") {
  auto const fine = march_peeled(3200, false).ledger;
  double const work = std::abs(fine.motion_work);
  for (bool const advance : {false, true}) {
    auto const ledger = march_peeled(50, advance).ledger;
    CAPTURE(advance);
    CHECK(std::abs(ledger.unaccounted()) < 1e-8 * work);
    CHECK(std::abs(ledger.bonding_loss - fine.bonding_loss) < (advance ? 0.01 : 0.05) * fine.bonding_loss);
  }
}

TEST_CASE("of two points that touch within a step the one that does so first is aimed at") {
  for (std::size_t const first : {0, 1}) {
    auto const scene = scene::build(test::foot_on_floor());
    dynamics::Stepper stepper(*scene.model);
    History history(stepper.bulk(), *scene.model);
    auto before = stepper.initial();
    auto old = before, next = before;
    old.t = 1, next.t = 2;
    auto const set = [&](std::size_t i, double gap_before, double gap_old) {
      before.contacts[0][i].gap = gap_before, old.contacts[0][i].gap = gap_old;
      for (auto* state : {&before, &old})
        state->contacts[0][i].in_reach = true;
      next.contacts[0][i].status = interface::Status::stick;
    };
    set(first, 1, 0.25);       // falls by 0.75 a second: touches after a third
    set(1 - first, 1.25, 0.5); // after two thirds
    history.accept(before, old, 0.01);
    auto const event = history.unlocated(old, next, 0.01);
    REQUIRE(event.has_value());
    CHECK(event->kind == dynamics::EventKind::touch);
    CHECK(event->point == first);
    CHECK(event->after == doctest::Approx(1.0 / 3));
  }
}

TEST_CASE("statics have no error of u beside that of the bonds") {
  auto const compared = compare(peeled(0.5), 0.02, 5);
  CHECK(compared.estimate.displacement == 0);
}
