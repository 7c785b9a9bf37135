// Height maps that were measured, on the points of a half space.
#pragma once
#include "halfspace/height_file.hpp"
#include "halfspace/rough.hpp"

namespace stiction::halfspace {

struct Measured {
  enum class Between { nothing, bilinear, bicubic };
  std::string file, dataset, unit;
  core::Numbers size; ///< m; none: as the file says
  Between interpolation = Between::nothing;
  double seam = 3; ///< most rms step over the seam of a periodic surface, over that of neighbours
  Start start = Start::touching;
  static core::Schema const& schema();
};

/// At all points, m. Throws InputError, its complaints at the keys of `schema`.
[[nodiscard]] Vector heights(Measured const& measured, Grid const& grid);

/// Heights of a file of the grid's extent at the grid's points, in the file's unit: bilinear, or by Keys'
/// cubic convolution (a = -1/2). Periodic grids go on round the seam; others, half a cell from the rim,
/// straight out.
[[nodiscard]] Vector resampled(HeightFile const& file, Grid const& grid, Measured::Between how);

/// Root mean square of the steps over the seam, over that between neighbours, the larger of both axes; 0
/// where there are no steps.
[[nodiscard]] double seam(HeightFile const& file);

} // namespace stiction::halfspace
