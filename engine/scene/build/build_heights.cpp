// Heights of a surface on the points of a half space, of a rigid map or of a body's boundary.
#include <fmt/format.h>

#include "scene/build/builder.hpp"

namespace stiction::scene {

/// At all points, m; of none where there is something to complain about, at the surface's own keys.
Vector Builder::heights_of(Where const& where, halfspace::Shape const& surface, halfspace::Grid const& grid) {
  core::Complaints all;
  Vector heights;
  try {
    all = std::visit(
        [&](auto const& shape) {
          if constexpr (requires { shape.check(grid); })
            return shape.check(grid);
          else
            return core::Complaints{};
        },
        surface);
    if (all.empty())
      heights = halfspace::heights(surface, grid);
  } catch (core::InputError const& error) {
    all = error.complaints();
  }
  auto const* map = std::get_if<halfspace::Map>(&surface);
  if (all.empty() && map != nullptr && heights.size() == 0)
    complain(where, fmt::format("has {} heights; there are {} points ({} x {})", map->heights.size(),
                                grid.size(), grid.nx, grid.ny));
  for (auto const& one : all) {
    Where at = where;
    at.push_back(one.path);
    complain(at, one.text);
  }
  return heights;
}

/// What the map fits has been seen to; it is left without heights where there is something to complain about.
void Builder::take_heights(Where const& where, halfspace::Shape const& surface, contact::RigidHeights& map) {
  halfspace::Grid grid;
  grid.line = map.size.size() == 1;
  grid.periodic = map.boundary == contact::RigidHeights::Rim::periodic;
  grid.nx = static_cast<Index>(map.points[0]);
  grid.Lx = map.size[0];
  if (!grid.line) {
    grid.ny = static_cast<Index>(map.points[1]);
    grid.Ly = map.size[1];
  }
  Vector const heights = heights_of(where, surface, grid);
  map.heights.assign(heights.data(), heights.data() + heights.size());
}

} // namespace stiction::scene
