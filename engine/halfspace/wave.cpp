// What a grid of points cannot hold of waves.
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "halfspace/shapes.hpp"

namespace stiction::halfspace {

core::Complaints Wave::check(Grid const& grid) const {
  constexpr double fewest = 3;      // points a wave, or it is another one
  constexpr double rounding = 1e-6; // of waves on a period
  std::array const sizes{grid.Lx, grid.Ly};
  std::array const points{grid.nx, grid.ny};
  core::Complaints all;
  for (std::size_t k = 0; k < std::min<std::size_t>(grid.line ? 1 : 2, wavelengths.size()); ++k) {
    char const axis = "xy"[k];
    double const length = wavelengths[k], count = length > 0 ? sizes[k] / length : 0;
    if (length > 0 && points[k] < fewest * count * (1 - rounding))
      all.push_back({"", "wavelengths",
                     fmt::format("along {} of {:g} m has {:.3g} points, and looks like a longer wave; give "
                                 "at least {:.0f} points along {}, better {:.0f}",
                                 axis, length, points[k] / count, std::ceil(fewest * count), axis,
                                 std::ceil(16 * count))});
    else if (grid.periodic && std::abs(count - std::round(count)) > rounding * std::max(1.0, count))
      all.push_back(
          {"", "wavelengths",
           fmt::format("along {} of {:g} m goes {:.4g} times into the period of {:g} m, so that it "
                       "has a step where it is repeated; give a whole fraction of that, e.g. {:g} m",
                       axis, length, count, sizes[k], sizes[k] / std::max(1.0, std::round(count)))});
  }
  return all;
}

} // namespace stiction::halfspace
