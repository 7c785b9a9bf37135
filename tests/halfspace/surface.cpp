// Green's functions of half spaces against known answers, and the product that they are used by.
#include "halfspace/surface.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <random>

#include "threads.hpp"

namespace {

using namespace stiction;
using halfspace::Compliance;
using halfspace::Elastic;
using halfspace::Grid;
using halfspace::Surface;
using std::numbers::pi;

Vector random_forces(Index size, unsigned seed) {
  std::mt19937 dice(seed);
  std::uniform_real_distribution<double> between(-1, 1);
  Vector force(size);
  for (double& one : force)
    one = between(dice);
  return force;
}

Vector product(Surface const& surface, Vector const& force) {
  Vector x = Vector::Zero(force.size());
  surface.add_product(force, x);
  return x;
}

/// Displacement (n, x, y) at (x, y) of a rigid-backed half space of Poisson's ratio nu and G = 1 under a
/// point force: Johnson 1985, (3.75), (3.18), (3.19); n and the normal force point into it.
Eigen::Matrix3d point_force(double nu, double x, double y) {
  double const r = std::hypot(x, y), c = (1 - 2 * nu) / (4 * pi * r * r);
  Eigen::Matrix3d u;
  u << (1 - nu) / (2 * pi * r), c * x, c * y, -c * x, (1 - nu + nu * x * x / (r * r)) / (2 * pi * r),
      nu * x * y / (2 * pi * r * r * r), -c * y, nu * x * y / (2 * pi * r * r * r),
      (1 - nu + nu * y * y / (r * r)) / (2 * pi * r);
  return u;
}

constexpr double nu = 0.2;
Elastic body_of_unit_shear() {
  return {2 * (1 + nu), nu, 0};
}

TEST_CASE("the middle of a square under uniform pressure sinks as Love says") {
  Grid const grid{9, 9, 0.9, 0.9, false, false};
  Surface const surface(grid, Compliance::of({3, 0.4, 0}, nullptr), 1);
  Vector pressure = Vector::Zero(81);
  for (Index j = 2; j < 7; ++j)
    for (Index i = 2; i < 7; ++i)
      pressure[9 * j + i] = grid.area();
  double const half = 0.25, plane = (1 - 0.4 * 0.4) / 3;
  CHECK(product(surface, pressure)[40] ==
        doctest::Approx(8 / pi * std::log(std::sqrt(2.0) + 1) * plane * half).epsilon(1e-12));
}

TEST_CASE("every pair of points of a free half space gives what point forces over a rectangle give") {
  Grid const grid{4, 3, 0.4, 0.6, false, false};
  Surface const surface(grid, Compliance::of(body_of_unit_shear(), nullptr), 3);
  auto const delassus = surface.delassus();
  Dense const W = delassus.dense();
  constexpr int parts = 200;
  for (Index from = 0; from < grid.size(); ++from)
    for (Index at = 0; at < grid.size(); ++at) {
      Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
      for (int k = 0; k < parts * parts && at != from; ++k)
        sum += point_force(nu, grid.x(at) - grid.x(from) + ((k % parts + 0.5) / parts - 0.5) * grid.dx(),
                           grid.y(at) - grid.y(from) + ((k / parts + 0.5) / parts - 0.5) * grid.dy()) /
               (parts * parts);
      if (at != from)
        CHECK((W.block<3, 3>(3 * at, 3 * from) - sum).norm() <= 3e-5 * sum.norm());
      else
        CHECK((W.block<3, 3>(3 * at, 3 * from) - surface.block()).norm() <= 1e-13 * surface.block().norm());
    }
}

TEST_CASE("a pressed strip of a free line draws its surface inwards") {
  Grid const grid{31, 1, 3.1, 1, true, false};
  double const young = 2.5;
  Surface const surface(grid, Compliance::of({young, nu, 0}, nullptr), 2);
  Vector force = Vector::Zero(62);
  for (Index i = 10; i < 21; ++i)
    force[2 * i] = grid.area();
  Vector const x = product(surface, force);
  double const half = 0.55, plane = (1 - nu * nu) / young;
  for (Index i = 0; i < 31; ++i) {
    double const s = grid.x(i), inward = -(1 - 2 * nu) * (1 + nu) / young; // Johnson 1985, (2.30)
    CHECK(x[2 * i + 1] == doctest::Approx(inward * std::clamp(s, -half, half)).epsilon(1e-11).scale(1e-3));
    auto const part = [&](double d) { return d * std::log((d / half) * (d / half)); };
    double const sunk = -plane / pi * (part(half + s) + part(half - s)); // but for a constant
    double const middle = -plane / pi * 2 * part(half);
    CHECK(x[2 * i] - x[30] == doctest::Approx(sunk - middle).epsilon(1e-11).scale(1e-2));
  }
}

TEST_CASE("a wave of traction gives the wave of displacements that elasticity says") {
  Grid const grid{12, 10, 2, 3, false, true};
  double const young = 5, shear = young / (2 * (1 + nu));
  Surface const surface(grid, Compliance::of({young, nu, 0}, nullptr), 3);
  double const kx = 2 * pi * 2 / grid.Lx, ky = -2 * pi * 3 / grid.Ly, k = std::hypot(kx, ky);
  Vector force(360), across(360);
  for (Index i = 0; i < grid.size(); ++i) {
    double const wave = grid.area() * std::cos(kx * grid.x(i) + ky * grid.y(i));
    force.segment<3>(3 * i) << wave, 0, 0;
    across.segment<3>(3 * i) << 0, -ky / k * wave, kx / k * wave;
  }
  Vector const x = product(surface, force), twisted = product(surface, across);
  for (Index i = 0; i < grid.size(); ++i) {
    double const phase = kx * grid.x(i) + ky * grid.y(i);
    CHECK(x[3 * i] == doctest::Approx(2 * (1 - nu * nu) / (young * k) * std::cos(phase)).epsilon(1e-12));
    double const along = -(1 - 2 * nu) / (2 * shear * k) * std::sin(phase);
    CHECK(x[3 * i + 1] == doctest::Approx(along * kx / k).epsilon(1e-12).scale(0.01));
    CHECK(x[3 * i + 2] == doctest::Approx(along * ky / k).epsilon(1e-12).scale(0.01));
    CHECK(twisted[3 * i + 1] == doctest::Approx(-ky / k * std::cos(phase) / (shear * k)).epsilon(1e-12));
  }
}

struct Kind {
  Grid grid;
  int components;
};
Kind const kinds[] = {{{8, 6, 1, 2, false, true}, 3},  {{7, 5, 1, 2, false, true}, 3},
                      {{8, 6, 1, 2, false, false}, 3}, {{7, 5, 1, 2, false, false}, 1},
                      {{16, 1, 1, 1, true, true}, 2},  {{9, 1, 1, 1, true, false}, 2},
                      {{8, 8, 1, 1, false, true}, 1}};

TEST_CASE("compliances of half spaces are reciprocal, positive, and know their own block") {
  Elastic const other{0.4, 0.45, 0.1};
  for (auto const& [grid, components] : kinds) {
    Surface const surface(grid, Compliance::of({1, 0.1, 0.3}, &other), components);
    auto const delassus = surface.delassus();
    Dense const W = delassus.dense();
    CHECK((W - W.transpose()).norm() <= 1e-13 * W.norm());
    if (grid.periodic || !grid.line) // a free line sinks against points at some distance
      CHECK(Eigen::SelfAdjointEigenSolver<Dense>(W).eigenvalues().minCoeff() > 0);
    CHECK((W.topLeftCorner(components, components) - surface.block()).norm() <= 1e-13 * W.norm());
    CHECK(delassus.diagonal(components + 0) == doctest::Approx(W(components, components)).epsilon(1e-12));
    Vector const force = random_forces(surface.rows(), 8001);
    CHECK((product(surface, force) - W * force).norm() <= 1e-13 * (W * force).norm());
  }
}

TEST_CASE("alike half spaces do not couple pressure and shear") {
  Elastic const body{1, 0.3, 0};
  Surface const surface({8, 6, 1, 2, false, false}, Compliance::of(body, &body), 3);
  Vector force = Vector::Zero(144);
  force[60] = 1;
  Vector const x = product(surface, force);
  for (Index i = 0; i < 48; ++i)
    CHECK(x.segment<2>(3 * i + 1).norm() <= 1e-15 * x.norm());
}

TEST_CASE("what undoes a periodic half space does so, that of a free one nearly") {
  for (auto const& [grid, components] : kinds) {
    Surface const surface(grid, Compliance::of({1, 0.1, 0.3}, nullptr), components);
    Vector const force = random_forces(surface.rows(), 8002);
    double const shift = 0.3 * surface.block()(0, 0);
    Vector const x = product(surface, force) + shift * force;
    Vector back(force.size());
    surface.solve(shift, x, back);
    if (grid.periodic)
      CHECK((back - force).norm() <= 1e-11 * force.norm());
    else
      CHECK(back.dot(x) > 0);
  }
}

TEST_CASE("products with half spaces do not depend on threads") {
  for (auto const& [grid, components] : kinds) {
    Grid larger = grid;
    larger.nx *= 9;
    if (!grid.line)
      larger.ny *= 7;
    Surface const surface(larger, Compliance::of({1, 0.1, 0.3}, nullptr), components);
    Vector const force = random_forces(surface.rows(), 8003);
    Vector const alone = product(surface, force);
    test::Threads const several(3);
    CHECK((product(surface, force).array() == alone.array()).all());
  }
}

TEST_CASE("a half space keeps a few numbers a point") {
  Grid const free{128, 128, 1, 1, false, false}, periodic{128, 128, 1, 1, false, true};
  auto const compliance = Compliance::of({1, 0.1, 0}, nullptr);
  auto const arrays = [&](Grid const& grid, int components) {
    return double(Surface(grid, compliance, components).memory()) / grid.size();
  };
  CHECK(arrays(periodic, 1) < 2.5);
  CHECK(arrays(free, 1) < 8);
  CHECK(arrays(free, 3) < 28);
}

} // namespace
