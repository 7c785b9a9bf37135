// What a measured map owes the half space, and its heights between those that were measured.
#include "halfspace/measured.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace stiction::halfspace {

core::Schema const& Measured::schema() {
  using core::Need;
  static auto const made =
      core::Describe<Measured>{
          "measured",
          "a height map from a file, whose peaks touch first; columns along x, rows along y, unmirrored, "
          "each "
          "height in the middle of its cell. Files: text (.csv, .txt, .asc, Gwyddion's export), .npy, HDF5",
          "Keys 1981"}
          .file("file", &Measured::file, Need::required, "from the study's folder on")
          .text("dataset", &Measured::dataset, Need::optional,
                "of an HDF5 file; default the only one of two dimensions")
          .text("unit", &Measured::unit, Need::optional,
                "of the heights, such as \"um\"; where the file does not say it")
          .numbers("size", &Measured::size, "m", Need::optional,
                   "extent {x, y}, on a line {x}; where the file does not say it. It has to be that of the "
                   "half space, or of the rigid height map")
          .choice("interpolation", &Measured::interpolation, {"none", "bilinear", "bicubic"}, Need::optional,
                  "to the points; none: there have to be as many")
          .number("seam", &Measured::seam, "1", core::positive, Need::optional,
                  "a periodic surface refuses maps whose rms step over the seam, where it is repeated, is "
                  "more "
                  "than so many times that between neighbours")
          .choice("start", &Measured::start, {"touching", "mean"}, Need::optional,
                  "touching: the highest peak touches where it starts; mean: the mean plane lies on the half "
                  "space")
          .build();
  return made;
}

namespace {

[[noreturn]] void refuse(char const* key, std::string text) {
  throw core::InputError(core::Complaints{{"", key, std::move(text)}});
}

double unit_of(Measured const& measured, HeightFile const& file) {
  bool const said = !file.unit.empty();
  if (!said && measured.unit.empty())
    refuse("unit",
           fmt::format("is missing, and {} does not say in what its heights are; give it, e.g. unit = \"um\"",
                       measured.file));
  auto const of_file = length_unit(file.unit), of_script = length_unit(measured.unit);
  if (said && !of_file)
    refuse("file", fmt::format("{}: its heights are in '{}', which is no length (m, mm, um, nm)",
                               measured.file, file.unit));
  if (!measured.unit.empty() && !of_script)
    refuse("unit", fmt::format("is \"{}\", which is no length (m, mm, um, nm)", measured.unit));
  if (said && of_script && *of_file != *of_script)
    refuse("unit",
           fmt::format("is \"{}\", and {} says '{}'; leave it out", measured.unit, measured.file, file.unit));
  return said ? *of_file : *of_script;
}

/// Extents of file and half space agree.
void check_size(Measured const& measured, HeightFile const& file, Grid const& grid) {
  constexpr double rounded = 1e-6;
  std::size_t const dimensions = grid.line ? 1 : 2;
  std::array<std::optional<double>, 2> const said{file.length_x, file.length_y};
  std::array<double, 2> const wanted{grid.Lx, grid.Ly};
  if (!measured.size.empty() && measured.size.size() != dimensions)
    refuse("size",
           fmt::format("has {} numbers; give {}", measured.size.size(), grid.line ? "{x}" : "{x, y}"));
  for (std::size_t k = 0; k < dimensions; ++k) {
    auto const& of_file = said.at(k);
    if (measured.size.empty() && !of_file)
      refuse("size", fmt::format("is missing, and {} does not say how wide it is; give it", measured.file));
    double const size = of_file ? *of_file : measured.size[k];
    if (of_file && !measured.size.empty() && std::abs(measured.size[k] - size) > rounded * size)
      refuse("size", fmt::format("is {:g} m along {}, and {} says {:g} m; leave it out", measured.size[k],
                                 "xy"[k], measured.file, size));
    if (std::abs(size - wanted.at(k)) > rounded * wanted.at(k))
      refuse("size", fmt::format("of {} is {:g} m along {}; the surface is {:g} m wide: give it the same",
                                 measured.file, size, "xy"[k], wanted.at(k)));
  }
}

void check_points(Measured const& measured, HeightFile const& file, Grid const& grid) {
  if (grid.line && file.ny != 1)
    refuse("file", fmt::format("{}: has {} rows; a line of points wants one", measured.file, file.ny));
  bool const same = file.nx == grid.nx && file.ny == grid.ny;
  if (!same && measured.interpolation == Measured::Between::nothing)
    refuse("interpolation",
           fmt::format("is none, and {} has {} x {} heights, the surface {} x {} points; give it as "
                       "many, or interpolation = \"bilinear\" or \"bicubic\"",
                       measured.file, file.nx, file.ny, grid.nx, grid.ny));
}

void check_seam(Measured const& measured, HeightFile const& file, Grid const& grid) {
  double const steps = grid.periodic ? seam(file) : 0;
  if (steps > measured.seam)
    refuse("seam",
           fmt::format("{}: where it is repeated its steps are {:.3g} times those between neighbours (rms), "
                       "more than {:g}: it is not periodic; give boundary = \"free\", or a map "
                       "whose rims fit",
                       measured.file, steps, measured.seam));
}

/// The first of up to four neighbours along an axis, and their weights.
struct Stencil {
  std::array<Index, 4> at{};
  std::array<double, 4> weight{};
};

/// Keys 1981, (15): a = -1/2.
double cubic(double s) {
  s = std::abs(s);
  return s < 1 ? (1.5 * s - 2.5) * s * s + 1 : s < 2 ? ((-0.5 * s + 2.5) * s - 4) * s + 2 : 0;
}

/// Round the seam, or on from the rim at its value.
Index neighbour(Index at, Index count, bool periodic) {
  return periodic ? (at % count + count) % count : std::clamp<Index>(at, 0, count - 1);
}

std::vector<Stencil> stencils(Index from, Index to, bool periodic, Measured::Between how) {
  std::vector<Stencil> all(ix(to));
  for (Index i = 0; i < to; ++i) {
    double const place = (i + 0.5) * from / to - 0.5;
    auto const cell = static_cast<Index>(std::floor(place));
    for (Index k = 0; k < 4; ++k) {
      double const s = place - (cell + k - 1);
      all[ix(i)].at[ix(k)] = neighbour(cell + k - 1, from, periodic);
      all[ix(i)].weight[ix(k)] =
          how == Measured::Between::bicubic ? cubic(s) : std::max(0.0, 1 - std::abs(s));
    }
  }
  return all;
}

} // namespace

Vector resampled(HeightFile const& file, Grid const& grid, Measured::Between how) {
  Vector all(grid.size());
  auto const along = stencils(file.nx, grid.nx, grid.periodic, how),
             across = stencils(file.ny, grid.ny, grid.periodic, how);
  for (Index i = 0; i < grid.size(); ++i) {
    auto const& x = along[ix(i % grid.nx)];
    auto const& y = across[ix(i / grid.nx)];
    double sum = 0;
    for (std::size_t k = 0; k < 16; ++k)
      sum +=
          x.weight[k % 4] * y.weight[k / 4] * file.heights[ix(y.at[k / 4]) * ix(file.nx) + ix(x.at[k % 4])];
    all[i] = sum;
  }
  return all;
}

double seam(HeightFile const& file) {
  auto const step = [&](Index i, Index j, bool along) {
    Index const next = along ? (i + 1) % file.nx : i, above = along ? j : (j + 1) % file.ny;
    return file.heights[ix(above) * ix(file.nx) + ix(next)] - file.heights[ix(j) * ix(file.nx) + ix(i)];
  };
  double worst = 0;
  for (bool const along : {true, false}) {
    Index const last = (along ? file.nx : file.ny) - 1;
    double at_seam = 0, inside = 0;
    for (Index i = 0; i < file.nx; ++i)
      for (Index j = 0; j < file.ny; ++j)
        ((along ? i : j) == last ? at_seam : inside) += std::pow(step(i, j, along), 2);
    if (last > 0 && inside > 0)
      worst = std::max(worst, std::sqrt(at_seam * last / inside));
  }
  return worst;
}

Vector heights(Measured const& measured, Grid const& grid) {
  auto const file = read_heights(measured.file, measured.dataset);
  double const unit = unit_of(measured, file);
  check_size(measured, file, grid);
  check_points(measured, file, grid);
  check_seam(measured, file, grid);
  bool const same = file.nx == grid.nx && file.ny == grid.ny;
  Vector const off = same ? Vector(Eigen::Map<Vector const>(file.heights.data(), grid.size()))
                          : resampled(file, grid, measured.interpolation);
  return stand(-unit * off, measured.start); // peaks towards the half space
}

} // namespace stiction::halfspace
