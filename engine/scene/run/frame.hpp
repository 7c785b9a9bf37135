// The fields of one state, ready to be written.
#pragma once
#include "record/fields.hpp"
#include "scene/build/build.hpp"

namespace stiction::scene {

/// Displacement, velocity, Cauchy stress, von Mises stress and, on contact nodes, the interface's fields.
[[nodiscard]] record::FieldFrame frame_of(Scene const& scene, dynamics::State const& state);

} // namespace stiction::scene
