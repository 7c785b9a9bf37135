// The manifest of a run of a scene: what was asked, with which settings, on which meshes, by which program.
#pragma once
#include <nlohmann/json.hpp>

#include "scene/build/build.hpp"
#include "scene/description/catalog.hpp"
#include "scene/run/checkpoint.hpp"
#include "scene/run/run.hpp"

namespace stiction::scene {

/// Every parameter that the schema of the part's kind names, given or not: {"value" (SI), "unit", "meaning",
/// "given"} by name, and "is", its kind; parts within as they stand in the script, null where there is
/// none.
[[nodiscard]] nlohmann::json describe_part(core::Input const& part, Category const& category);

/// The scene in that way, with what the program takes where the script says nothing.
[[nodiscard]] nlohmann::json describe_parts(core::Input const& scene, ScenePart const& part);

[[nodiscard]] nlohmann::json manifest_of(core::Input const& input, Scene const& scene,
                                         RunOptions const& options);
/// With its story, and what it was warned of.
[[nodiscard]] nlohmann::json manifest_of(core::Input const& asked, Scene const& scene,
                                         RunOptions const& options, Story const& story,
                                         std::vector<Warning> const& warnings);

} // namespace stiction::scene
