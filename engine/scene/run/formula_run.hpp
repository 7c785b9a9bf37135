// A closed formula over the times of a schedule.
#pragma once
#include "scene/build/build.hpp"
#include "scene/run/checkpoint.hpp"
#include "scene/run/run.hpp"

namespace stiction::scene {

/// Runs a scene that a formula answers, from the start: it takes no longer than to take up a checkpoint.
[[nodiscard]] RunResult run_formula(core::Input const& input, Scene const& scene, RunOptions const& options,
                                    Story& story);

} // namespace stiction::scene
