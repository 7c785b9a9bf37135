// Points that slide off the border of their counterpart as a run ends.
#pragma once
#include <string>

#include "dynamics/contact/contact_system.hpp"
#include "scene/build/build.hpp"

namespace stiction::scene {

/// What to say of a point of node to segment that is pressed at the border of its counterpart in `old` and
/// has none in the attempt that failed after it; or empty.
[[nodiscard]] std::string slid_off(Scene const& scene, dynamics::State const& old,
                                   dynamics::ContactSystem const& failed);

} // namespace stiction::scene
