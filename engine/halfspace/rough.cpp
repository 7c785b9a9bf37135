// Spectra to heights and back, by transforms of FFTW.
#include "halfspace/rough.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <fftw3.h>
#include <fmt/format.h>
#include <memory>
#include <numbers>

namespace stiction::halfspace {

core::Schema const& Rough::schema() {
  using core::Need;
  static auto const made =
      core::Describe<Rough>{
          "rough",
          "self-affine roughness, isotropic and periodic in the size of what it lies over: a sum of waves "
          "with "
          "the power spectrum C = const from the longest wavelength to the roll-off, C ~ k^(-2 - 2 H) from "
          "there to the shortest (on a line k^(-1 - 2 H)), and random phases. Amplitudes are the spectrum's, "
          "not random, unless `scattered`. They belong to wavelengths, not to points: more points show the "
          "same surface",
          "Persson 2001; Jacobs 2017"}
          .number("hurst", &Rough::hurst, "1", {0, 1, true, false}, Need::required, "exponent H")
          .number("shortest", &Rough::shortest, "m", core::positive, Need::required, "wavelength of all")
          .number("longest", &Rough::longest, "m", core::non_negative, Need::optional,
                  "wavelength of all; 0: the larger extent of the points")
          .number("roll_off", &Rough::roll_off, "m", core::non_negative, Need::optional,
                  "wavelength above which the spectrum is flat; 0: `longest`")
          .number("rms_slope", &Rough::rms_slope, "1", core::non_negative, Need::optional,
                  "root mean square of the gradient of this very surface; either this or rms_height")
          .number("rms_height", &Rough::rms_height, "m", core::non_negative, Need::optional,
                  "root mean square of the heights of this very surface about their mean")
          .integer("seed", &Rough::seed, core::non_negative, Need::optional, "of the random phases")
          .flag(
              "scattered", &Rough::scattered,
              "amplitudes are random, too: the spectrum's times Rayleigh's distribution of unit mean square")
          .choice("start", &Rough::start, {"touching", "mean"}, Need::optional,
                  "touching: the lowest point touches where it starts; mean: the mean plane lies on the half "
                  "space, whatever the number of points")
          .build();
  return made;
}

core::Complaints Rough::check() const {
  core::Complaints all;
  auto const complain = [&](char const* key, std::string text) { all.push_back({"", key, std::move(text)}); };
  if ((rms_slope > 0) == (rms_height > 0))
    complain("rms_slope", rms_slope > 0
                              ? "and rms_height are both given; one follows from the other: leave one out"
                              : "is missing; give it, or rms_height");
  if (longest > 0 && longest <= shortest)
    complain("longest", fmt::format("is {:g} m; give more than shortest = {:g} m", longest, shortest));
  if (roll_off > 0 && (roll_off < shortest || (longest > 0 && roll_off > longest)))
    complain("roll_off", longest > 0
                             ? fmt::format("is {:g} m; give between shortest = {:g} m and longest = {:g} m",
                                           roll_off, shortest, longest)
                             : fmt::format("is {:g} m; give at least shortest = {:g} m", roll_off, shortest));
  return all;
}

namespace {

using Amplitude = std::complex<double>;

double extent(Grid const& grid) {
  return grid.line ? grid.Lx : std::max(grid.Lx, grid.Ly);
}

/// Numbers between 0 and 1 of a seed and whole numbers, the same wherever they are asked for: SplitMix64.
class Dice {
public:
  Dice(int seed, Index m, Index n)
      : state_(mixed(mixed(mixed(static_cast<std::uint64_t>(seed)) + static_cast<std::uint32_t>(m)) +
                     static_cast<std::uint32_t>(n))) {}
  double operator()() {
    constexpr int lost = 11; // bits more than a double has
    return (static_cast<double>(mixed(state_++) >> lost) + 0.5) * 0x1p-53;
  }

private:
  static std::uint64_t mixed(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

/// Amplitudes over those of the longest waves; 0 outside of the spectrum.
class Spectrum {
public:
  Spectrum(Rough const& rough, Grid const& grid)
      : longest_(rough.longest > 0 ? rough.longest : extent(grid)),
        roll_off_(rough.roll_off > 0 ? rough.roll_off : longest_), shortest_(rough.shortest),
        power_(-rough.hurst - (grid.line ? 0.5 : 1)) {}
  /// Of 1 / wavelength.
  [[nodiscard]] double operator()(double q) const {
    if (q * longest_ < 1 - rounded || q * shortest_ > 1 + rounded)
      return 0;
    return q * roll_off_ <= 1 ? 1 : std::pow(q * roll_off_, power_);
  }
  /// Most waves along an extent.
  [[nodiscard]] Index most(double length) const {
    constexpr double many = 1 << 20;
    return static_cast<Index>(std::floor(std::min(many, length / shortest_ * (1 + rounded))));
  }

private:
  static constexpr double rounded = 1e-9;
  double longest_, roll_off_, shortest_, power_;
};

/// act(m, n) for one of each pair of opposite wave vectors.
template<class Act> void each_wave(Spectrum const& spectrum, Grid const& grid, Act const& act) {
  Index const M = spectrum.most(grid.Lx), N = grid.line ? 0 : spectrum.most(grid.Ly);
  for (Index m = 0; m <= M; ++m)
    for (Index n = m == 0 ? 1 : -N; n <= N; ++n)
      act(m, n);
}

double wave_number(Grid const& grid, Index m, Index n) { // over 2 pi
  return grid.line ? m / grid.Lx : std::hypot(m / grid.Lx, n / grid.Ly);
}

struct Free {
  void operator()(void* data) const { fftw_free(data); }
};
using Waves = std::unique_ptr<Amplitude[], Free>;
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, void (*)(fftw_plan)>;

std::size_t wave_count(Grid const& grid) {
  return ix(grid.ny) * (ix(grid.nx) / 2 + 1);
}

Waves no_waves(Grid const& grid) {
  auto* data = reinterpret_cast<Amplitude*>(fftw_alloc_complex(wave_count(grid)));
  if (data == nullptr)
    throw core::RunError("not enough memory for the waves of a height map");
  std::fill_n(data, wave_count(grid), Amplitude{});
  return Waves(data);
}

fftw_complex* raw(Waves const& waves) {
  return reinterpret_cast<fftw_complex*>(waves.get());
}

/// Where the wave (m, n), m >= 0, stands among those of a transform.
std::size_t place(Grid const& grid, Index m, Index n) {
  return ix(n < 0 ? n + grid.ny : n) * (ix(grid.nx) / 2 + 1) + ix(m);
}

/// Of the first point, in parts of a turn: there the waves have their phases of the origin no more.
double turned(Grid const& grid, Index m, Index n) {
  return m * (0.5 / grid.nx - 0.5) + (grid.line ? 0 : n * (0.5 / grid.ny - 0.5));
}

Vector sum_of(Waves const& waves, Grid const& grid) {
  Vector sum(grid.size());
  Plan const plan(fftw_plan_dft_c2r_2d(grid.ny, grid.nx, raw(waves), sum.data(), FFTW_ESTIMATE),
                  fftw_destroy_plan);
  core::expect(plan != nullptr, "FFTW to have a plan for every length");
  fftw_execute(plan.get());
  return sum;
}

} // namespace

core::Complaints Rough::check(Grid const& grid) const {
  core::Complaints all;
  auto const complain = [&](char const* key, std::string text) { all.push_back({"", key, std::move(text)}); };
  double const size = extent(grid);
  for (auto const& [key, value] :
       {std::pair{"longest", longest}, {"roll_off", roll_off}, {"shortest", shortest}})
    if (value > size * (1 + 1e-9))
      complain(key,
               fmt::format("is {:g} m; the surface is {:g} m wide, in which waves repeat: give at most that",
                           value, size));
  Spectrum const spectrum(*this, grid);
  if (2 * spectrum.most(grid.Lx) >= grid.nx || (!grid.line && 2 * spectrum.most(grid.Ly) >= grid.ny))
    complain("shortest",
             fmt::format("is {:g} m; points {:g} m apart show waves longer than twice that: give more "
                         "points (eight a wave are some), or a longer one",
                         shortest, grid.line ? grid.dx() : std::max(grid.dx(), grid.dy())));
  if (!all.empty())
    return all;
  bool any = false;
  each_wave(spectrum, grid, [&](Index m, Index n) { any = any || spectrum(wave_number(grid, m, n)) > 0; });
  if (!any)
    complain("shortest",
             fmt::format("is {:g} m: no wave between that and the longest fits the surface a whole "
                         "number of times; give less",
                         shortest));
  return all;
}

Vector stand(Vector heights, Start start) {
  heights.array() -= start == Start::mean ? heights.mean() : heights.minCoeff();
  return heights;
}

Vector heights(Rough const& rough, Grid const& grid) {
  Spectrum const spectrum(rough, grid);
  auto const waves = no_waves(grid);
  double squares = 0;
  each_wave(spectrum, grid, [&](Index m, Index n) {
    double const q = wave_number(grid, m, n);
    double amplitude = spectrum(q);
    if (!(amplitude > 0))
      return;
    Dice dice(rough.seed, m, n);
    double const phase = dice();
    if (rough.scattered)
      amplitude *= std::sqrt(-std::log(dice()));
    double const weight = rough.rms_slope > 0 ? 2 * std::numbers::pi * q : 1;
    squares += 0.5 * amplitude * amplitude * weight * weight;
    auto const wave = std::polar(0.5 * amplitude, 2 * std::numbers::pi * (phase + turned(grid, m, n)));
    waves[place(grid, m, n)] = wave;
    if (m == 0)
      waves[place(grid, m, -n)] = std::conj(wave);
  });
  double const scale = (rough.rms_slope > 0 ? rough.rms_slope : rough.rms_height) / std::sqrt(squares);
  return stand(scale * sum_of(waves, grid), rough.start);
}

Moments moments(Vector const& heights, Grid const& grid) {
  auto const waves = no_waves(grid);
  Vector copy = heights;
  Plan const plan(fftw_plan_dft_r2c_2d(grid.ny, grid.nx, copy.data(), raw(waves), FFTW_ESTIMATE),
                  fftw_destroy_plan);
  core::expect(plan != nullptr, "FFTW to have a plan for every length");
  fftw_execute(plan.get());
  double height = 0, slope = 0, curvature = 0;
  Index const last = grid.nx / 2;
  for (Index j = 0; j < grid.ny; ++j)
    for (Index m = 0; m <= last; ++m) {
      Index const n = 2 * j > grid.ny ? j - grid.ny : j;
      double const twice = m == 0 || 2 * m == grid.nx ? 1 : 2,
                   k = 2 * std::numbers::pi * wave_number(grid, m, n);
      double const square = m + j == 0 ? 0 : twice * std::norm(waves[ix(j) * (ix(last) + 1) + ix(m)]);
      height += square;
      slope += k * k * square;
      curvature += k * k * k * k * square;
    }
  double const n = grid.size();
  return {std::sqrt(height) / n, std::sqrt(slope) / n, std::sqrt(curvature) / n};
}

} // namespace stiction::halfspace
