// What a scene with a half space models, what it costs, and what its grid cannot resolve.
#pragma once
#include "scene/explain/explain.hpp"

namespace stiction::scene {

[[nodiscard]] Explanation explain_half_space(Scene const& scene);

} // namespace stiction::scene
