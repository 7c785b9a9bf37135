// Slip over several facets in space: its length and direction, and its derivative by all positions.
#include <doctest/doctest.h>

#include "contact/surface/surface_path.hpp"
#include "contact/surfaces.hpp"
#include "differences.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// A sheet of n x n cells bent round the y axis: a part `angle` of a cylinder of radius 1, from the top on.
Shell drum(int n, double angle, bool triangles) {
  return sheet(n, triangles).move([&](Vec3 const& v) {
    return Vec3(std::sin(angle * v.x()), v.y(), std::cos(angle * v.x()));
  });
}

/// From one point, at which the step starts, to another: both near the surface.
struct Step {
  Shell shell;
  Vec3 from, to;
};

PointKinematics<3> after(Step const& step, Surface const& surface, std::vector<double> const& x) {
  Index const node = step.shell.free_node();
  Foot const start = kinematics(surface, node, {}, {}, step.shell.with(step.from)).foot;
  CAPTURE(step.from.transpose());
  REQUIRE(start.found());
  return kinematics(surface, node, start, {}, x);
}

/// Slip as a vector in space.
Vec3 way(Step const& step, Vec3 const& direction = Vec3(1, 0, 0)) {
  auto const surface = step.shell.surface(direction);
  auto const end = after(step, surface, step.shell.with(step.to));
  REQUIRE(end.found);
  return end.frame.rightCols<2>() * end.slip;
}

/// Steps of some facets on a sheet, a drum, a ball and waves, none along the mesh.
std::vector<Step> steps(double facets, bool triangles) {
  Vec3 const along(std::cos(0.4), std::sin(0.4), 0);
  auto const from = [](Vec3 const& at) { return Vec3(at + Vec3(0.11, 0.23, 0)); };
  std::vector<Step> all;
  Vec3 const shift = facets / 12 * along;
  all.push_back({sheet(12, triangles), from({0, 0, 0}), from({shift.x(), shift.y(), 0.01})});
  auto const wavy = waves(12, triangles);
  all.push_back({wavy, from({0, 0, 0}), from({shift.x(), shift.y(), 0.02})});
  auto const on_drum = [&](double radius, double u, double v) {
    return Vec3(radius * std::sin(1.5 * u), v, radius * std::cos(1.5 * u));
  };
  all.push_back(
      {drum(12, 1.5, triangles), on_drum(1, 0.11, 0.23), on_drum(1.01, 0.11 + shift.x(), 0.23 + shift.y())});
  Vec3 const pole = Vec3(0.3, -0.2, 1).normalized();
  Mat<3> const turn = turned(facets * 0.13 * Vec3(-0.4, 1, 0.1).normalized());
  all.push_back({ball(12, triangles), pole, 1.01 * (turn * pole)});
  return all;
}

std::vector<double> moved(std::vector<double> x, Indices const& nodes, Vector const& move) {
  for (Index k = 0; k < move.size(); ++k)
    x[ix(3 * nodes[ix(k / 3)] + k % 3)] += move[k];
  return x;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("round a drum slip is the length of the facets passed, also where it winds along the axis") {
    double const angle = 1.5, phi = angle / 12, side = 2 * std::sin(phi / 2);
    auto const at = [&](double u, double v) { // in parts of a facet
      double const whole = std::floor(u), part = u - whole, a = whole * phi, b = a + phi;
      return Vec3((1 - part) * std::sin(a) + part * std::sin(b), v,
                  (1 - part) * std::cos(a) + part * std::cos(b));
    };
    for (bool const triangles : {false, true})
      for (int const facets : {1, 3, 5, 10})
        for (double const rise : {0.0, 0.31})
          for (double const from : {1.0, 1.37}) {
            CAPTURE(facets);
            CAPTURE(rise);
            Step const step{drum(12, angle, triangles), at(from, 0.35), at(from + facets, 0.35 + rise)};
            double const length = std::hypot(facets * side, rise);
            // from border to border exactly, elsewhere up to the turn of the normal within a facet
            bool const exact = !triangles && from == 1.0 && rise == 0;
            Vec3 const slip = way(step);
            CHECK(std::abs(slip.norm() - length) < (exact ? 1e-9 : phi * phi / 24) * length);
            CHECK(slip.y() == doctest::Approx(rise).epsilon(1e-9));
          }
  }

  TEST_CASE("round a ball slip converges to the arc and arrives along it, at second order") {
    for (bool const triangles : {false, true}) {
      Vec3 const from = Vec3(0.3, -0.2, 1).normalized(), axis = from.cross(Vec3(0.8, 0.5, -0.1)).normalized();
      double const angle = 0.9;
      Vec3 const to = turned(angle * axis) * from, arc = angle * axis.cross(to);
      double last = 0;
      for (int const n : {8, 16, 32}) {
        double const error = (way({ball(n, triangles), from, to}) - arc).norm();
        CHECK(error < 2.0 / (n * n));
        if (last > 0)
          CHECK(error < 0.4 * last);
        last = error;
      }
    }
  }

  TEST_CASE("slip there and slip back are opposite once turned, and grow with the parts of a way") {
    auto const shell = waves(12, true);
    auto const surface = shell.surface();
    auto const x = shell.with(Vec3::Zero());
    Foot const a{30, 0.3, 0.3}, b{150, 0.2, 0.5};
    auto const n = [&](Foot foot) { return surface.evaluate(foot, x).normal; };
    SurfacePath const there(surface, a, {b, n(b)}, x), back(surface, b, {a, n(a)}, x);
    CHECK(there.stations().size() > 5);
    CHECK(there.stations().size() == back.stations().size());
    CHECK(there.slip().norm() == doctest::Approx(back.slip().norm()).epsilon(1e-12));
    CHECK(std::abs(there.slip().dot(n(b))) < 1e-14);
    double straight = (surface.position(b, x) - surface.position(a, x)).norm();
    CHECK(there.slip().norm() > straight);
  }

  TEST_CASE("in space the motion rows are the derivatives of gap and slip over any number of facets") {
    for (bool const triangles : {false, true})
      for (double const facets : {0.3, 1.0, 3.0, 5.0})
        for (auto const& step : steps(facets, triangles)) {
          auto const surface = step.shell.surface({1, 0.3, 0.2});
          Index const node = step.shell.free_node();
          Foot const start = kinematics(surface, node, {}, {}, step.shell.with(step.from)).foot;
          auto const x = step.shell.with(step.to);
          CAPTURE(facets);
          CAPTURE(triangles);
          CAPTURE(step.to.transpose());
          auto const end = after(step, surface, x);
          REQUIRE(end.found);
          auto const rows = motion_rows(surface, end, start, x);
          auto const moves = [&](Vector const& m) {
            auto const k = kinematics(surface, node, start, end.foot, moved(x, rows.nodes, m));
            return Vector(Vec3(k.gap, k.slip[0], k.slip[1]));
          };
          Vector const here = Vector::Zero(3 * static_cast<Index>(rows.nodes.size()));
          auto const found = rate(moves, Dense(rows.by_x), here, 1e-4, 1);
          CHECK_MESSAGE(found.second_order, found.words());
          CHECK(found.errors[2] <= 1e-6 * (1 + found.scale));
          // nothing else takes part
          std::vector<double> elsewhere = x;
          for (Index other = 0; other < node; ++other)
            if (std::find(rows.nodes.begin(), rows.nodes.end(), other) == rows.nodes.end())
              elsewhere[ix(3 * other)] += 1e-3;
          auto const same = kinematics(surface, node, start, end.foot, elsewhere);
          CHECK((same.slip - end.slip).norm() < 1e-14);
        }
  }

  TEST_CASE("in space the slip over several facets is the same for every observer") {
    Mat<3> const turn = turned({1.1, -0.4, 2.0});
    for (bool const triangles : {false, true})
      for (auto const& step : steps(4, triangles)) {
        Step carried = step;
        carried.shell.move([&](Vec3 const& v) { return Vec3(turn * v + Vec3(3, -2, 5)); });
        carried.from = turn * step.from + Vec3(3, -2, 5);
        carried.to = turn * step.to + Vec3(3, -2, 5);
        CHECK((way(carried, turn * Vec3(1, 0, 0)) - turn * way(step)).norm() < 1e-10);
      }
  }
}
