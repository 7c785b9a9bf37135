// What a grid of points cannot hold of waves.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "halfspace/shapes.hpp"

namespace stiction::halfspace {

namespace {
constexpr double of_waves = 1e-6; // rounding of how many there are

/// Calls act(axis, length, size, points) for every axis along which a wave goes.
void each_axis(Wave const& wave, Grid const& grid, auto const& act) {
  std::array const sizes{grid.Lx, grid.Ly};
  std::array const points{grid.nx, grid.ny};
  for (std::size_t k = 0; k < std::min<std::size_t>(grid.line ? 1 : 2, wave.wavelengths.size()); ++k)
    if (wave.wavelengths[k] > 0)
      act("xy"[k], wave.wavelengths[k], sizes[k], points[k]);
}

} // namespace

core::Complaints Wave::check(Grid const& grid) const {
  constexpr double fewest = 3; // points a wave, or it is another one
  core::Complaints all;
  each_axis(*this, grid, [&](char axis, double length, double size, Index points) {
    double const count = size / length;
    if (points < fewest * count * (1 - of_waves))
      all.push_back({"", "wavelengths",
                     fmt::format("along {} of {:g} m has {:.3g} points, and looks like a longer wave; give "
                                 "at least {:.0f} points along {}, better {:.0f}",
                                 axis, length, points / count, std::ceil(fewest * count), axis,
                                 std::ceil(16 * count))});
  });
  return all;
}

core::Complaints Wave::check_period(Grid const& grid) const {
  core::Complaints all;
  each_axis(*this, grid, [&](char axis, double length, double size, Index) {
    double const count = size / length;
    if (std::abs(count - std::round(count)) > of_waves * std::max(1.0, count))
      all.push_back(
          {"", "wavelengths",
           fmt::format("along {} of {:g} m goes {:.4g} times into the period of {:g} m, so that it "
                       "has a step where it is repeated; give a whole fraction of that, e.g. {:g} m",
                       axis, length, count, size, size / std::max(1.0, std::round(count)))});
  });
  return all;
}

} // namespace stiction::halfspace
