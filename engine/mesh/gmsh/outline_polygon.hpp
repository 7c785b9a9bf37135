// Outlines as polygons, to see whether a hole lies in its region.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "mesh/gmsh/gmsh.hpp"

namespace stiction::mesh {

using PlanePoint = std::array<double, 2>;

/// Corners of an outline, of arcs every 64th part, of splines the points they go through, m.
[[nodiscard]] std::vector<PlanePoint> polygon_of(Outline const& outline);

/// A corner of the hole that lies outside of the region's outline by more than polygons tell; nothing if none
/// does.
[[nodiscard]] std::optional<PlanePoint> outside(Outline const& region, Outline const& hole);

} // namespace stiction::mesh
