// A half space over its schedule: steps, their halving and growth, what is recorded and kept on the way.
#pragma once
#include "scene/build/build.hpp"
#include "scene/run/checkpoint.hpp"
#include "scene/run/run.hpp"

namespace stiction::scene {

/// Runs a scene with a half space, from where its checkpoint stands.
[[nodiscard]] RunResult run_half_space(core::Input const& input, Scene const& scene,
                                       RunOptions const& options, Checkpoint& checkpoint, Story& story);

} // namespace stiction::scene
