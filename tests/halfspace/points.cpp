// Steps of half spaces that follow from the error of their bonds, against the law's own equation.
#include "halfspace/points.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <vector>

#include "halfspace/stepper.hpp"

namespace {

using namespace stiction;

constexpr double w = 1, C = 1e4, b = 0.1, speed = 0.05; // J/m^2, N/m^3, N s/m, m/s

/// Lifted off a deep periodic half space without relief: its bonds stretch by the lift, all alike.
halfspace::Model lifted_flat() {
  halfspace::Model model;
  model.grid = {4, 4, 1, 1, false, true};
  model.body = {1e6, 0.2, 0};
  model.heights = Vector::Zero(16);
  model.shift[2] = dynamics::Path{{0, 1}, {0, speed}};
  interface::Rcc law;
  law.w = w;
  law.C_n = C;
  law.b = b;
  law.beta0 = 1;
  model.law.adhesion = law;
  return model;
}

/// b beta' = w - C x^2 beta, x = speed t, while beta < 1; by Runge and Kutta.
double exact(double until) {
  double const start = std::sqrt(w / C) / speed;
  constexpr int steps = 20000;
  double const h = (until - start) / steps;
  double beta = 1;
  auto const rate = [](double t, double at) { return (w - C * speed * speed * t * t * at) / b; };
  for (int k = 0; k < steps; ++k) {
    double const t = start + k * h, k1 = rate(t, beta), k2 = rate(t + h / 2, beta + h / 2 * k1),
                 k3 = rate(t + h / 2, beta + h / 2 * k2), k4 = rate(t + h, beta + h * k3);
    beta += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return beta;
}

struct Lifted {
  halfspace::State state;
  int steps = 0, cuts = 0;
  std::vector<double> times{}; ///< of steps, s
};

Lifted lift(halfspace::Model const& model, double until, dynamics::Accuracy const& accuracy) {
  halfspace::Stepper stepper(model);
  auto pace = halfspace::pace_of(accuracy, model);
  Lifted lifted{stepper.initial()};
  pace.begin(until / 10, 20);
  while (lifted.state.t < until) {
    double const left = until - lifted.state.t, dt = pace.next(lifted.state, left);
    auto outcome = stepper.step(lifted.state, dt);
    REQUIRE_MESSAGE(outcome.converged, outcome.reason);
    auto const decision = pace.decide(lifted.state, outcome.state, dt);
    lifted.cuts += decision.accepted() ? 0 : 1;
    if (!decision.accepted())
      continue;
    ++lifted.steps;
    lifted.state = std::move(outcome.state);
    if (pace.arrives(dt, left))
      lifted.state.t = until;
    lifted.times.push_back(lifted.state.t);
  }
  return lifted;
}

TEST_CASE("bonds of a half space fade as their law says, to the tolerance of the steps") {
  auto const model = lifted_flat();
  constexpr double until = 0.3;
  double const beta = exact(until);
  CHECK(beta > 0.3);
  CHECK(beta < 0.9);
  auto const error = [&](halfspace::State const& state) {
    return (state.beta.array() - beta).abs().maxCoeff();
  };
  dynamics::Accuracy coarse, fine;
  coarse.tolerance = 1e-3;
  fine.tolerance = 1e-4;
  coarse.events = fine.events = 1e-6;
  auto const loose = lift(model, until, coarse), close = lift(model, until, fine);
  CHECK(error(loose.state) < 2 * coarse.tolerance);
  CHECK(error(close.state) < 2 * fine.tolerance);
  CHECK(close.steps > loose.steps);
  CHECK(loose.cuts > 0); // where bonds begin to fade
  auto const equal = [&] {
    halfspace::Stepper stepper(model);
    auto state = stepper.initial();
    for (int k = 0; k < close.steps; ++k)
      state = stepper.step(state, until / close.steps).state;
    return state;
  }();
  CHECK(error(equal) > 10 * error(close.state));
  double const stored = 0.5 * C * std::pow(speed * until, 2) * beta * beta - w * beta;
  CHECK(close.state.ledger.bond == doctest::Approx(stored).epsilon(5e-4));
}

TEST_CASE("a half space without bonds tells no error, and its events are located where they are asked for") {
  auto model = lifted_flat();
  model.law.adhesion.reset();
  CHECK_FALSE(halfspace::pace_of({}, model).decides());
  constexpr double touch = 0.123;
  model.shift[2] = dynamics::Path{{0, 1}, {touch * 1e-3, touch * 1e-3 - 1e-3}};
  dynamics::Accuracy accuracy;
  accuracy.events = 1e-4;
  CHECK(halfspace::pace_of(accuracy, model).decides());
  model.body.depth = 0.1;
  auto const times = lift(model, 0.5, accuracy).times;
  CHECK(std::ranges::any_of(times, [](double t) { return std::abs(t - touch) <= 1e-4; }));
  auto const blind = lift(model, 0.5, {}).times;
  CHECK(std::ranges::none_of(blind, [](double t) { return std::abs(t - touch) <= 1e-4; }));
}

} // namespace
