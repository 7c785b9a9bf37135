// Green's functions of the surfaces of two half spaces in Fourier space, as tables over the wave numbers.
#pragma once
#include "halfspace/grid.hpp"

namespace stiction::halfspace {

/// A linear elastic half space.
struct Elastic {
  double young = 0;   ///< Pa
  double poisson = 0; ///< 1
  double depth = 0;   ///< m of it that gives under the mean traction too, in a periodic one; 0: as if rigid
};

/// What two half spaces give together, per shear modulus. Johnson 1985, 3.2, 3.6 and appendix 1.
struct Compliance {
  double normal = 0;   ///< sum of (1 - nu) / G, 1/Pa
  double shear = 0;    ///< sum of 1 / G, 1/Pa
  double coupling = 0; ///< difference of (1 - 2 nu) / (2 G), of the first less the second, 1/Pa
  double mean_normal = 0, mean_shear = 0; ///< of what lies beneath a periodic surface, m/Pa
  /// counterpart: null where rigid.
  [[nodiscard]] static Compliance of(Elastic const& body, Elastic const* counterpart);
  [[nodiscard]] double poisson() const { return shear - normal; } ///< sum of nu / G, 1/Pa
  /// 1 / E* = sum of (1 - nu^2) / E, 1/Pa.
  [[nodiscard]] double plane() const { return 0.5 * normal; }
};

/// Displacement per force of a point, m/N, for the waves (a, b) of the grid: with u_n = i u' and p_n = i p'
/// it is the real symmetric matrix {{nn, nx, ny}, {nx, xx, xy}, {ny, xy, yy}}. For b below zero ny and xy
/// change their sign. Tables are [waves along x, waves along y]; those not needed are empty.
struct Symbols {
  Index rows = 0, columns = 0; ///< of waves along x, and along y from 0 on
  Index px = 0, py = 0;        ///< points of the transforms, padding included
  Vector nn, xx, yy, xy, nx, ny;
  Eigen::Matrix3d block = Eigen::Matrix3d::Zero(); ///< of a point on itself, (n, x, y), m/N
};

/// components: 1 (nothing acts along the surface), 2 (a line) or 3. Periodic: continuous waves up to those
/// that the points resolve (Stanley and Kato 1997). Free: rectangles under uniform traction (Love 1929; Pohrt
/// and Li 2014), at all distances between points, with as many points of padding (Hockney 1970). A free line
/// sinks against points as far off as it is long.
[[nodiscard]] Symbols symbols(Grid const& grid, Compliance const& compliance, int components);

} // namespace stiction::halfspace
