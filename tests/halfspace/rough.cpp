// Rough heights: the spectrum and the moments that were asked for, on any grid the same surface.
#include "halfspace/rough.hpp"

#include <cmath>
#include <complex>
#include <doctest/doctest.h>
#include <numbers>

#include "halfspace/shapes.hpp"
#include "halfspace/solver.hpp"

namespace {

using namespace stiction;
using halfspace::Grid;
using halfspace::Rough;
using std::numbers::pi;

Rough asked() {
  Rough rough;
  rough.hurst = 0.7;
  rough.shortest = 0.125;
  rough.rms_slope = 0.02;
  rough.seed = 5;
  rough.start = halfspace::Start::mean;
  return rough;
}

Grid plane(Index nx, Index ny) {
  return {nx, ny, 2, 1, false, true};
}
Grid line(Index n) {
  return {n, 1, 2, 1, true, true};
}

/// Amplitude of the wave (m, n), by its definition.
double amplitude(Vector const& heights, Grid const& grid, int m, int n) {
  std::complex<double> sum = 0;
  for (Index i = 0; i < grid.size(); ++i)
    sum += heights[i] * std::polar(1.0, -2 * pi * (m * grid.x(i) / grid.Lx + n * grid.y(i) / grid.Ly));
  return 2 * std::abs(sum) / grid.size();
}

TEST_CASE("rough heights have the root mean square of slope or of height that was asked for") {
  for (bool const scattered : {false, true})
    for (auto const& grid : {plane(60, 25), plane(128, 128), line(64), line(81)}) {
      auto rough = asked();
      rough.scattered = scattered;
      CHECK(moments(heights(rough, grid), grid).slope == doctest::Approx(0.02).epsilon(1e-12));
      rough.rms_slope = 0;
      rough.rms_height = 3e-3;
      auto const all = heights(rough, grid);
      CHECK(moments(all, grid).height == doctest::Approx(3e-3).epsilon(1e-12));
      CHECK(std::sqrt(all.squaredNorm() / grid.size()) == doctest::Approx(3e-3).epsilon(1e-12));
    }
}

TEST_CASE("slope and curvature of a wave are those of its derivatives") {
  auto const grid = plane(16, 8);
  Vector wave(grid.size());
  double const kx = 2 * pi * 3 / grid.Lx, ky = -2 * pi * 2 / grid.Ly, k = std::hypot(kx, ky);
  for (Index i = 0; i < grid.size(); ++i)
    wave[i] = 7 + 0.1 * std::cos(kx * grid.x(i) + ky * grid.y(i));
  auto const m = moments(wave, grid);
  CHECK(m.height == doctest::Approx(0.1 / std::sqrt(2)).epsilon(1e-12));
  CHECK(m.slope == doctest::Approx(0.1 * k / std::sqrt(2)).epsilon(1e-12));
  CHECK(m.curvature == doctest::Approx(0.1 * k * k / std::sqrt(2)).epsilon(1e-12));
}

TEST_CASE("more points show the same rough surface") {
  for (auto const& [coarse, fine] : {std::pair{plane(36, 20), plane(108, 60)}, {line(40), line(120)}}) {
    auto const few = heights(asked(), coarse), many = heights(asked(), fine);
    for (Index i = 0; i < coarse.size(); ++i) {
      Index const column = 3 * (i % coarse.nx) + 1, row = coarse.line ? 0 : 3 * (i / coarse.nx) + 1;
      REQUIRE(fine.x(row * fine.nx + column) == doctest::Approx(coarse.x(i)).epsilon(1e-12));
      CHECK(std::abs(many[row * fine.nx + column] - few[i]) <= 1e-12 * few.cwiseAbs().maxCoeff());
    }
  }
}

TEST_CASE("amplitudes of a rough surface follow its spectrum, wave by wave") {
  auto rough = asked();
  rough.longest = 1;
  rough.roll_off = 0.5;
  auto const grid = plane(48, 24);
  auto const all = heights(rough, grid);
  double const flat = amplitude(all, grid, 2, 0);
  CHECK(amplitude(all, grid, 0, 1) == doctest::Approx(flat).epsilon(1e-10)); // 1 m long, along y
  CHECK(amplitude(all, grid, 4, 0) == doctest::Approx(flat).epsilon(1e-10)); // the roll-off
  CHECK(amplitude(all, grid, 8, 0) == doctest::Approx(flat * std::pow(2, -1.7)).epsilon(1e-10));
  CHECK(amplitude(all, grid, 6, -4) == doctest::Approx(flat * std::pow(2.5, -1.7)).epsilon(1e-10));
  CHECK(amplitude(all, grid, 16, 0) == doctest::Approx(flat * std::pow(4, -1.7)).epsilon(1e-10)); // shortest
  for (auto const& [m, n] : {std::pair{1, 0}, {17, 0}, {12, 6}}) // longer and shorter ones
    CHECK(amplitude(all, grid, m, n) < 1e-12 * flat);
  auto const profile = heights(rough, line(64));
  CHECK(amplitude(profile, line(64), 8, 0) ==
        doctest::Approx(amplitude(profile, line(64), 4, 0) * std::pow(2, -1.2)).epsilon(1e-10));
}

/// Rigid waves pressed by a mean pressure onto a half space with E* = 1 Pa.
halfspace::Answer pressed(Vector const& gaps, Grid const& grid, double pressure) {
  halfspace::Surface const surface(grid, halfspace::Compliance::of({1, 0, 0}, nullptr), 1);
  halfspace::Problem problem(surface, {});
  halfspace::State old;
  old.status.assign(ix(grid.size()), 0);
  problem.old = &old;
  problem.shared.free = gaps;
  halfspace::Wanted wanted;
  wanted.force = pressure * grid.area() * grid.size();
  return halfspace::Solver(surface).solve(problem, Vector::Zero(grid.size()), wanted);
}

TEST_CASE("where all of a rough surface touches, each wave has its own pressure") {
  for (auto const& grid : {plane(40, 24), line(80)}) {
    auto const gaps = heights(asked(), grid);
    auto const answer = pressed(gaps, grid, 0.08);
    REQUIRE_MESSAGE(answer.converged, answer.reason);
    REQUIRE(answer.force.minCoeff() > 0);
    Vector expected = Vector::Constant(grid.size(), 0.08);
    for (int m = 0; m <= 16; ++m)
      for (int n = grid.line || m == 0 ? int(!grid.line) : -8; n <= (grid.line ? 0 : 8); ++n) {
        std::complex<double> sum = 0;
        auto const turn = [&](Index i) {
          return std::polar(1.0, 2 * pi * (m * grid.x(i) / grid.Lx + n * grid.y(i) / grid.Ly));
        };
        for (Index i = 0; i < grid.size(); ++i)
          sum += gaps[i] * std::conj(turn(i));
        double const k = 2 * pi * (grid.line ? m / grid.Lx : std::hypot(m / grid.Lx, n / grid.Ly));
        for (Index i = 0; i < grid.size(); ++i)
          expected[i] -= 0.5 * k * 2 * (sum * turn(i)).real() / grid.size();
      }
    CHECK((answer.force / grid.area() - expected).cwiseAbs().maxCoeff() < 1e-9);
  }
}

TEST_CASE("a force finds what it presses of a rough surface at once") {
  Grid const grid{256, 256, 1, 1, false, true};
  Rough rough;
  rough.hurst = 0.8;
  rough.longest = 0.5;
  rough.shortest = 1.0 / 16;
  rough.rms_slope = 0.05;
  rough.seed = 2;
  auto const answer = pressed(heights(rough, grid), grid, 5e-4);
  CHECK_MESSAGE(answer.converged, answer.reason);
  CHECK(answer.force.minCoeff() >= 0);
}

TEST_CASE("seeds give other surfaces, and the same seed the same bits") {
  auto const grid = plane(64, 32);
  auto one = asked();
  one.longest = 0.5; // many waves alike
  auto other = one;
  other.seed = 6;
  Vector const first = heights(one, grid), again = heights(one, grid), second = heights(other, grid);
  CHECK(first == again);
  CHECK(std::abs(first.dot(second)) < 0.5 * first.norm() * second.norm());
  one.start = halfspace::Start::touching;
  CHECK(heights(one, grid).minCoeff() == 0);
}

void check_told(Rough const& rough, Grid const& grid, char const* key, char const* words) {
  auto told = rough.check();
  if (told.empty())
    told = rough.check(grid);
  REQUIRE(told.size() == 1);
  CHECK(told[0].path == key);
  CHECK_MESSAGE(told[0].text.find(words) != std::string::npos, told[0].text);
}

TEST_CASE("what a rough surface lacks is told at its place") {
  auto const grid = plane(64, 32);
  CHECK(asked().check().empty());
  CHECK(asked().check(grid).empty());
  auto const changed = [](double Rough::*member, double value) {
    auto rough = asked();
    rough.*member = value;
    return rough;
  };
  check_told(changed(&Rough::rms_height, 1), grid, "rms_slope", "leave one out");
  check_told(changed(&Rough::rms_slope, 0), grid, "rms_slope", "give it, or rms_height");
  check_told(changed(&Rough::longest, 0.1), grid, "longest", "more than shortest");
  check_told(changed(&Rough::longest, 3), grid, "longest", "at most that");
  check_told(changed(&Rough::roll_off, 0.1), grid, "roll_off", "at least shortest");
  check_told(changed(&Rough::shortest, 0.0625), grid, "shortest", "give more points");
  auto none = asked();
  none.longest = 0.95;
  none.shortest = 0.94;
  check_told(none, grid, "shortest", "no wave");
}

} // namespace
