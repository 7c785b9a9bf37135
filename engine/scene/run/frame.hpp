// The fields of one state, ready to be written.
#pragma once
#include <functional>

#include "halfspace/model.hpp"
#include "record/fields.hpp"
#include "scene/build/build.hpp"

namespace stiction::scene {

/// Displacement, velocity, Cauchy stress, von Mises stress and, on contact nodes, the interface's fields.
[[nodiscard]] record::FieldFrame frame_of(Scene const& scene, dynamics::State const& state);

/// What fields over the points of a half space are made of.
struct GridFields {
  double time = 0;                                  ///< s
  std::function<contact::Vec3(Index)> displacement; ///< along (n, x, y), n into the half space, m
  std::function<dynamics::ContactState(Index)> at;
};
/// Fields over the grid, as those of bodies are called.
[[nodiscard]] record::GridFrame frame_of(halfspace::Model const& model, GridFields const& fields);

} // namespace stiction::scene
