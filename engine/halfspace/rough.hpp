// Self-affine roughness: a sum of waves whose amplitudes follow a spectrum and whose phases are random.
#pragma once
#include "core/error.hpp"
#include "core/schema.hpp"
#include "halfspace/grid.hpp"

namespace stiction::halfspace {

/// Where a surface of no lowest point of its own stands at the start.
enum class Start { touching, mean };

/// Waves of all wave vectors (2 pi m / Lx, 2 pi n / Ly) between a longest and a shortest wavelength,
/// isotropic. Amplitudes and phases belong to wave vectors: a grid of other points samples the same surface.
struct Rough {
  double hurst = 0;
  double shortest = 0;   ///< m
  double longest = 0;    ///< m; 0: the larger extent of the grid
  double roll_off = 0;   ///< m; 0: longest
  double rms_height = 0; ///< m; 0: follows from rms_slope
  double rms_slope = 0;  ///< of the gradient; 0: follows from rms_height
  int seed = 1;
  bool scattered = false; ///< amplitudes are random, too
  Start start = Start::touching;
  static core::Schema const& schema();
  /// What does not fit together, at the key that is its path.
  [[nodiscard]] core::Complaints check() const;
  /// What the grid cannot hold.
  [[nodiscard]] core::Complaints check(Grid const& grid) const;
};

/// At all points, m.
[[nodiscard]] Vector heights(Rough const& rough, Grid const& grid);

/// Heights off the half space where it starts.
[[nodiscard]] Vector stand(Vector heights, Start start);

/// Root mean squares of the trigonometric polynomial through the points, periodic along both axes.
struct Moments {
  double height = 0;    ///< about the mean, m
  double slope = 0;     ///< of the gradient
  double curvature = 0; ///< of the Laplacian, 1/m
};
[[nodiscard]] Moments moments(Vector const& heights, Grid const& grid);

} // namespace stiction::halfspace
