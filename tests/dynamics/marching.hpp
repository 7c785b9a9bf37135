// Steps of a built scene without its output: states as they come.
#pragma once
#include <doctest/doctest.h>
#include <functional>

#include "dynamics/step/stepper.hpp"
#include "scene/scenes.hpp"

namespace stiction::test {

using contact::Vec2;
using dynamics::Outcome;
using dynamics::State;
using dynamics::Stepper;

/// `steps` equal steps from `state`; each must converge. `watch` sees the old and the new state.
inline State march(Stepper& stepper, State state, double dt, int steps,
                   std::function<void(State const&, State const&)> const& watch = {}) {
  for (int k = 0; k < steps; ++k) {
    auto outcome = stepper.step(state, dt);
    INFO("t = ", state.t, " ", outcome.reason);
    REQUIRE(outcome.converged());
    if (watch)
      watch(state, outcome.state);
    state = std::move(outcome.state);
  }
  return state;
}

/// Model nodes of a set that must exist.
inline Indices nodes_of(scene::Scene const& scene, std::string const& set) {
  auto nodes = scene.nodes_of(set);
  REQUIRE(nodes.has_value());
  return *nodes;
}

/// Sum of the drive's force over a set, N.
inline Vec2 force_on(scene::Scene const& scene, State const& state, std::string const& set) {
  Vec2 sum = Vec2::Zero();
  for (Index const node : nodes_of(scene, set))
    sum += state.drive.segment<2>(2 * node);
  return sum;
}

/// Sum of the contact forces on the secondary surface of a pair, N.
inline Vec2 contact_force(scene::Scene const& scene, State const& state, std::size_t pair = 0) {
  Vec2 sum = Vec2::Zero();
  for (Index const node : scene.model->pairs[pair].nodes())
    sum += state.reaction.segment<2>(2 * node);
  return sum;
}

inline double largest(Vector const& v) {
  return v.size() == 0 ? 0.0 : v.lpNorm<Eigen::Infinity>();
}

} // namespace stiction::test
