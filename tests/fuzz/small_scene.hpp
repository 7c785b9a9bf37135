// Scenes that are built in milliseconds, told from those that are not.
#pragma once
#include "core/input.hpp"

namespace stiction::fuzz {

/// Reads the scene, and builds it if its meshes are blocks and boxes of a few hundred cells. Throws what that
/// throws.
void check_small_scene(core::Input const& input);

} // namespace stiction::fuzz
