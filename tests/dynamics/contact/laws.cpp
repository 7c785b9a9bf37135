// Every interface law over whole steps: the ledger of an opening and closing cycle, what RCC's viscosity
// dissipates, friction of a dragged block.
#include <doctest/doctest.h>

#include "dynamics/marching.hpp"
#include "interface/laws.hpp"

using namespace stiction;

namespace {

/// A bar of one cell on the floor with this law, its top driven from `start` along x and y in one second.
scene::Scene bar(test::NamedAdhesion const& named, double start, std::vector<double> const& x,
                 std::vector<double> const& y) {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, start}, {1, 1}, {1, 1}}, test::linear_elastic(2e5, 0));
  std::vector<double> times;
  for (std::size_t k = 0; k < y.size(); ++k)
    times.push_back(static_cast<double>(k) / static_cast<double>(y.size() - 1));
  test::at(table, "motions") = test::list({test::drive("foot.top", times, x, y)});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  auto scene = scene::build(table);
  auto& pair = scene.model->pairs[0];
  pair.law.adhesion = named.law;
  pair.reach = std::max(pair.reach, pair.law.range());
  return scene;
}

struct Balance {
  double misfit = 0;  ///< what the audited ledger leaves open, J/m
  double largest = 0; ///< term of the ledger
  dynamics::Ledger end;
};

/// The loss of the scheme, which takes forces at the end of a step, is predicted against their work on the
/// straight way. What then is left is the step in what a bond dissipates.
Balance march(scene::Scene const& scene, int steps) {
  scene.model->audited = true;
  dynamics::Stepper stepper(*scene.model);
  auto const last = test::march(stepper, stepper.initial(), 1.0 / steps, steps);
  auto const& l = last.ledger;
  return {l.unaccounted(),
          std::max({std::abs(l.motion_work), std::abs(l.bond), std::abs(l.bonding_loss), std::abs(l.start)}),
          l};
}

/// RCC from beta = 1 at the speed of V*, w = 4, u0 = 0.2 m: int A b beta'^2 dt over w, to s = 12.
double viscous_loss(double rate_number, int steps) {
  double const w = 4, u0 = 0.2, b = 0.5, speed = rate_number * w * u0 / b, end = 12 * u0 / speed;
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0}, {1, 1}, {1, 2}}, test::linear_elastic(1000, 0));
  test::at(table, "pairs.sole.adhesion") = test::rcc(w, w / (u0 * u0), b);
  test::at(table, "pairs.sole.adhesion.beta0") = test::value(1);
  test::at(table, "motions") =
      test::list({test::fix("foot.all", true, false), test::drive("foot.bottom", {0, end}, {}, {0, 12 * u0}),
                  test::drive("foot.top", {0, end}, {}, {0, 12 * u0})});
  test::at(table, "schedule") = test::schedule({{end, steps}});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  return test::march(stepper, stepper.initial(), end / steps, steps).ledger.bonding_loss / w;
}

/// Presses a block with 10 N/m and drags it by this friction law; the force on it after each step, N/m.
std::vector<double> drag(interface::FrictionLaw const& law, int steps) {
  auto table = test::foot_on_floor();
  test::at(table, "motions") = test::list({test::drive("foot.all", {0, 1, 2}, {0, 0, 0.1}, {}),
                                           test::drive("foot.top", {0, 1, 2}, {}, {0, -0.01, -0.01})});
  auto scene = scene::build(table);
  scene.model->pairs[0].law.friction = law;
  dynamics::Stepper stepper(*scene.model);
  auto const pressed = test::march(stepper, stepper.initial(), 0.25, 4);
  std::vector<double> force;
  test::march(stepper, pressed, 1.0 / steps, steps, [&](test::State const&, test::State const& state) {
    force.push_back(test::force_on(scene, state, "foot.all").x());
  });
  return force;
}

} // namespace

TEST_CASE("every adhesion law: however far bonds open in a step, along their normal, the ledger closes") {
  for (auto const& named : test::adhesions()) {
    CAPTURE(named.name);
    auto const scene = bar(named, 0, {0, 0}, {0, 3});
    auto const balance = march(scene, 7);
    CHECK(balance.largest > 0.5);
    CHECK(std::abs(balance.misfit) < 1e-8 * balance.largest);
  }
}

TEST_CASE("every adhesion law: an opening and closing cycle of a bar closes its ledger at its order") {
  for (auto const& named : test::adhesions()) {
    CAPTURE(named.name);
    double const high = test::reversible(named.law) ? 0.05 : 0.12;
    auto const scene =
        bar(named, 0, {0, 0.004, 0.01, 0.002, 0.01, 0.02}, {0, 0.012, 0.004, -1e-5, 0.02, high});
    auto const coarse = march(scene, 500), fine = march(scene, 4000), finest = march(scene, 8000);
    CHECK(finest.largest > 0.5);
    double const allowed = interface::evolves(named.law) ? 1e-9 : 1e-8; // by a formula, by quadrature
    CHECK(std::abs(coarse.misfit) < allowed * coarse.largest);
    CHECK(std::abs(finest.misfit) < allowed * finest.largest);
    bool const viscous = interface::bond_time(named.law) > 0;
    CHECK(finest.end.bonding_loss >= 0);
    CHECK((finest.end.bonding_loss > 0) == (viscous || test::irreversible(named.law)));
    CHECK(finest.end.scheme_loss() == doctest::Approx(0.5 * fine.end.scheme_loss()).epsilon(0.02));
  }
}

TEST_CASE("a reversible law is felt from afar and gives back what it took") {
  for (auto const& named : test::adhesions()) {
    if (!test::reversible(named.law))
      continue;
    CAPTURE(named.name);
    double const range = interface::Law { {}, named.law }.range(), far = 1.1 * range, w = 3; // of one metre
    double const cut = 1e-11 * w; // what a law may have left where its range ends
    auto const scene = bar(named, far, {0, 0, 0, 0}, {0, -far, -far, 0});
    auto const turn = march(scene, 3000);
    CHECK(std::abs(turn.end.start) < cut);
    CHECK(turn.end.start <= 0);
    CHECK(std::abs(turn.end.bond - turn.end.start) < 1e-6 * cut);
    CHECK(turn.end.strain < 1e-12);
    CHECK(std::abs(turn.misfit) < cut); // trapezia err alike on the way down and up
    dynamics::Stepper stepper(*scene.model);
    double least = 0;
    auto const closed = test::march(stepper, stepper.initial(), 1.0 / 3000, 1500,
                                    [&](test::State const&, test::State const& state) {
                                      least = std::min(least, test::force_on(scene, state, "foot.top").y());
                                      least = std::min(least, state.contacts[0][0].adhesion[0]);
                                    });
    CHECK(least == doctest::Approx(-interface::scales(named.law).strength).epsilon(2e-2));
    CHECK(closed.ledger.bond == doctest::Approx(-w).epsilon(1e-3));
    CHECK(closed.contacts[0][0].bond.beta == doctest::Approx(1).epsilon(1e-3));
  }
}

TEST_CASE("the viscosity of RCC dissipates the work beyond w, to first order in the step") {
  struct Wanted {
    double rate_number, loss; ///< work/w - 1 by quadrature
  };
  for (auto const& wanted : {Wanted{0.1, 0.07261}, Wanted{1, 0.51453}}) {
    CAPTURE(wanted.rate_number);
    double const coarse = viscous_loss(wanted.rate_number, 3000) - wanted.loss,
                 fine = viscous_loss(wanted.rate_number, 6000) - wanted.loss,
                 finest = viscous_loss(wanted.rate_number, 12000) - wanted.loss;
    CHECK(std::abs(finest) < 2e-3 * wanted.loss);
    CHECK((coarse - fine) / (fine - finest) == doctest::Approx(2).epsilon(0.05));
    CHECK(2 * finest - fine == doctest::Approx(0).epsilon(2e-5)); // extrapolated to no step
  }
}

TEST_CASE("a dragged block feels the friction law: strength, pressure, speed, what it did before") {
  auto const last = [](interface::FrictionLaw const& law) { return drag(law, 10).back(); };
  CHECK(last(interface::Coulomb{0.3}) == doctest::Approx(3).epsilon(1e-6));
  CHECK(last(interface::Tresca{0.3, 2}) == doctest::Approx(2).epsilon(1e-6)); // over 1 m
  CHECK(last(interface::Tresca{0.3, 4}) == doctest::Approx(3).epsilon(1e-6));
  CHECK(last(interface::PressureFriction{0.6, 0.1, 5}) ==
        doctest::Approx(10 * (0.1 + 0.5 * std::exp(-2.0))).epsilon(1e-6));
  CHECK(last(interface::VelocityFriction{0.6, 0.1, 0.1}) ==
        doctest::Approx(10 * (0.1 + 0.5 * std::exp(-1.0))).epsilon(1e-6)); // at 0.1 m/s
  auto const force = drag(interface::StaticKinetic{0.6, 0.2}, 10);
  CHECK(force.front() == doctest::Approx(6).epsilon(1e-6));
  CHECK(force[1] == doctest::Approx(2).epsilon(1e-6));
  CHECK(force.back() == doctest::Approx(2).epsilon(1e-6));
}
