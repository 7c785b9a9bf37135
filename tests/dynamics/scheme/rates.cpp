// Contact conditions on rates: what they ask for at the step's end, and that only relative motion counts.
#include "dynamics/all_schemes.hpp"

using namespace stiction;
using test::SchemeSample;

namespace {

/// A block that comes down aslant on a floor with friction; all of it carried along by `carrier`, m/s.
scene::Scene thrown(test::Input scheme, test::Vec2 const& carrier) {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0.02}, {1, 1}, {2, 2}}, test::linear_elastic(100, 0));
  test::at(table, "bodies.foot.velocity") = test::values({0.3 + carrier.x(), -0.5 + carrier.y()}, "m/s");
  test::at(table, "obstacles.floor.times") = test::values({0, 10}, "s");
  test::at(table, "obstacles.floor.x") = test::values({0, 10 * carrier.x()}, "m");
  test::at(table, "obstacles.floor.y") = test::values({0, 10 * carrier.y()}, "m");
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "motions") = test::list({});
  test::at(table, "scheme") = std::move(scheme);
  auto made = scene::build(table);
  made.model->control.force_tolerance = 1e-12;
  return made;
}

constexpr double short_step = 2e-3; // s

/// As far as the scheme gets without making energy, 60 steps at most.
test::State flown(scene::Scene const& scene) {
  dynamics::Stepper stepper(*scene.model);
  auto state = stepper.initial();
  for (int k = 0; k < 60; ++k) {
    auto outcome = stepper.step(state, short_step);
    if (!outcome.converged())
      break;
    state = std::move(outcome.state);
  }
  return state;
}

} // namespace

TEST_CASE("every scheme: a block meets a floor that moves with it as one that stands") {
  test::Vec2 const carrier(0.7, 0.4);
  for (auto const& sample : test::scheme_samples()) {
    if (sample.order == 0) // no dynamics
      continue;
    INFO(sample.label);
    auto const at_rest = flown(thrown(sample.table, {0, 0}));
    auto const moving = thrown(sample.table, carrier);
    dynamics::Stepper stepper(*moving.model);
    auto const carried = test::march(stepper, stepper.initial(), short_step,
                                     static_cast<int>(std::lround(at_rest.t / short_step)));
    CHECK(std::abs(at_rest.ledger.friction_loss) > 1e-4); // some schemes make energy
    Vector expected = at_rest.u;
    for (Eigen::Index i = 0; i < expected.size(); i += 2)
      expected.segment<2>(i) += at_rest.t * carrier;
    CHECK(test::largest(carried.u - expected) < 1e-9);
    CHECK(carried.ledger.friction_loss == doctest::Approx(at_rest.ledger.friction_loss).epsilon(1e-6));
  }
}

TEST_CASE("under a condition on rates what presses does not go on closing, whatever weighs the step's ends") {
  auto const velocity = test::cure("full", "velocity");
  for (auto const& scheme :
       {test::make("scheme.theta_xi", test::with(test::with(velocity, "theta", 0.7), "xi", 0.7)),
        test::make("scheme.newmark", test::with(test::with(velocity, "beta", 0.5), "gamma", 0.9)),
        test::make("scheme.moreau_jean", {{"theta", test::value(0.8)}})}) {
    CAPTURE(scheme.tag);
    auto const scene = thrown(scheme, {0, 0});
    dynamics::Stepper stepper(*scene.model);
    int pressed = 0;
    test::march(stepper, stepper.initial(), short_step, 60, [&](test::State const&, test::State const& next) {
      for (std::size_t i = 0; i < next.contacts[0].size(); ++i) {
        if (next.contacts[0][i].dry[0] <= 0)
          continue;
        ++pressed;
        CHECK(std::abs(next.v[2 * scene.model->pairs[0].secondary[i] + 1]) < 1e-9);
      }
    });
    CHECK(pressed > 5);
  }
}
