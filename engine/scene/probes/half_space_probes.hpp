// Probes of a half space as columns of a series.
#pragma once
#include "halfspace/model.hpp"
#include "scene/probes/probes.hpp"

namespace stiction::scene {

/// Appends the probe's values of one state to a row.
using HalfSpaceSampler = std::function<void(halfspace::State const&, std::vector<double>&)>;

/// Adds the columns of every probe of a scene with a half space, in the order of their names, and returns
/// their samplers.
[[nodiscard]] std::vector<HalfSpaceSampler> add_half_space_probes(Scene const& scene, Columns const& columns);

/// Declares what the probes of any scene record.
void add_columns(Scene const& scene, Columns const& columns);

/// Force on the half space along (n, x, y), N.
[[nodiscard]] contact::Vec3 total_force(halfspace::Model const& model, halfspace::State const& state);

} // namespace stiction::scene
