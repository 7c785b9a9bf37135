// Rigid obstacles of plane pictures, and the paths of what moves.
#pragma once
#include "core/reader.hpp"
#include "spec/spec.hpp"

namespace stiction::postproc {

/// Displacements in units of `metres` and angles in rad at times in s.
[[nodiscard]] PathSpec read_path(core::Reader& path, double metres);

/// The list "obstacles" of a field, lengths in units of `metres`.
[[nodiscard]] std::vector<ObstacleSpec> read_obstacles(core::Reader& reader, double metres, bool solid);

} // namespace stiction::postproc
