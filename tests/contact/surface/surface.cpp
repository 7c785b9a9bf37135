// Surfaces in space: topology, the field of normals, feet on facets, edges, vertices and borders.
#include <doctest/doctest.h>

#include "contact/surface/search.hpp"
#include "contact/surfaces.hpp"
#include "core/error.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// Where the pairing x1 = x2 + g n fails, m.
double mismatch(Surface const& surface, Foot foot, Vec3 const& point, std::vector<double> const& x) {
  auto const at = surface.evaluate(foot, x);
  Vec3 const d = point - at.x;
  return (d - at.normal * at.normal.dot(d)).norm();
}

/// Largest jumps of gap, normal and foot over a walk in `steps` steps along `path`, 0 <= s <= 1.
std::array<double, 3> largest_jumps(Shell const& shell, std::function<Vec3(double)> const& path, int steps) {
  auto const surface = shell.surface();
  Foot foot;
  std::array<double, 3> jumps{};
  PointKinematics<3> last;
  for (int i = 0; i <= steps; ++i) {
    auto const x = shell.with(path(static_cast<double>(i) / steps));
    auto const now = kinematics(surface, shell.free_node(), {}, foot, x);
    REQUIRE(now.found);
    if (i > 0) {
      jumps[0] = std::max(jumps[0], std::abs(now.gap - last.gap));
      jumps[1] = std::max(jumps[1], (now.normal() - last.normal()).norm());
      jumps[2] = std::max(jumps[2], (surface.position(now.foot, x) - surface.position(last.foot, x)).norm());
    }
    last = now;
    foot = now.foot;
  }
  return jumps;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("quadratic facets are split through their mid-side nodes") {
    Matrix nodes(9, 3);
    nodes << 0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0, 1, 0, 0, 2, 1, 0, 1, 2, 0, 0, 1, 0, 1, 1, 0;
    Surface const quad8({{{0, 1, 2, 3, 4, 5, 6, 7}}}, nodes, Vec3::UnitX());
    CHECK(quad8.size() == 5);
    Surface const tri6({{{0, 1, 3, 4, 8, 7}}}, nodes, Vec3::UnitX());
    CHECK(tri6.size() == 4);
    for (auto const* surface : {&quad8, &tri6}) {
      double area = 0;
      for (auto const& facet : surface->facets()) {
        Vec3 const vector = area_vector(facet.reference, facet.count);
        CHECK(vector.z() == doctest::Approx(vector.norm()));
        area += vector.z();
      }
      CHECK(area == doctest::Approx(surface == &quad8 ? 4 : 2));
    }
    CHECK(quad8.nodes() == Indices{0, 1, 2, 3, 4, 5, 6, 7});
    CHECK(tri6.nodes() == Indices{0, 1, 3, 4, 7, 8});
  }

  TEST_CASE("neighbours are mutual, edges are where the reference turns, normals differ across them") {
    for (bool const triangles : {false, true}) {
      auto const shell = cube(3, triangles);
      auto const surface = shell.surface();
      int sharp = 0;
      for (int f = 0; f < surface.size(); ++f) {
        auto const& facet = surface.facets()[ix(f)];
        for (int k = 0; k < facet.count; ++k) {
          REQUIRE(facet.neighbour[ix(k)] >= 0);
          auto const& other = surface.facets()[ix(facet.neighbour[ix(k)])];
          CHECK(other.neighbour[ix(facet.across[ix(k)])] == f);
          CHECK(other.nodes[ix(facet.across[ix(k)])] == facet.nodes[ix((k + 1) % facet.count)]);
          sharp += facet.sharp[ix(k)] ? 1 : 0;
        }
        Vec3 const flat = area_vector(facet.reference, facet.count).normalized();
        auto const now = surface.now(f, shell.with(Vec3::Zero()));
        for (int k = 0; k < facet.count; ++k)
          CHECK((now.normals[ix(k)] - flat).norm() < 1e-14);
      }
      CHECK(sharp == 2 * 12 * 3);
    }
  }

  TEST_CASE("what is no surface is refused with the nodes where it fails") {
    Matrix nodes = Matrix::Zero(61, 3);
    for (Index i = 1; i <= 60; ++i)
      nodes.row(i) << std::cos(i * std::numbers::pi / 30), std::sin(i * std::numbers::pi / 30), 0;
    auto const made = [&](std::vector<mesh::Facet> const& facets) {
      static_cast<void>(Surface(facets, nodes, Vec3::UnitX()));
    };
    CHECK_THROWS_WITH_AS(made({{{0, 1}}}), doctest::Contains("a facet has 2 nodes"), core::InputError);
    CHECK_THROWS_WITH_AS(made({{{0, 1, 2}}, {{0, 1, 3}}}),
                         doctest::Contains("two facets run from node 0 to node 1"), core::InputError);
    std::vector<mesh::Facet> fan;
    for (Index i = 0; i < 60; ++i)
      fan.push_back({{0, i + 1, (i + 1) % 60 + 1}});
    CHECK_THROWS_WITH_AS(made(fan), doctest::Contains("up to 60 facets meet at a node"), core::InputError);
  }

  TEST_CASE("no corner of a triangle is on the point's side of what is nearest to it") {
    Shell shell;
    shell.nodes = {{0, 0, 0}, {1, 0.1, 0.2}, {0.3, 0.9, -0.1}};
    shell.facets = {{{0, 1, 2}}};
    auto const surface = shell.surface();
    auto const x = shell.with(Vec3::Zero());
    for (auto const& point : points_in({-1, -1, -1}, {2, 2, 1}, 300)) {
      double distance2 = 0;
      Vec3 const way = point - surface.position(surface.sample(0, point, x, distance2), x);
      CHECK(way.squaredNorm() == doctest::Approx(distance2));
      for (auto const& corner : shell.nodes)
        CHECK(way.dot(corner - (point - way)) < 1e-12);
    }
  }

  TEST_CASE("the normal from the foot points at the point, from any guess") {
    for (bool const triangles : {false, true}) {
      auto const shell = waves(8, triangles);
      auto const surface = shell.surface();
      int found = 0;
      for (auto const& point : points_in({0.1, 0.1, -0.1}, {0.9, 0.9, 0.15}, 200)) {
        auto const x = shell.with(point);
        Foot const foot = surface.project(point, {}, x);
        REQUIRE(foot.found());
        ++found;
        CHECK(mismatch(surface, foot, point, x) < 1e-12);
        for (int k = 0; k < surface.facets()[ix(foot.segment)].count; ++k)
          CHECK(inside(surface.facets()[ix(foot.segment)].count, k, {foot.xi, foot.eta}) > -1e-8);
        Foot const again = surface.follow(point, {(7 * found) % surface.size(), 0.2, 0.1}, x);
        REQUIRE(again.found());
        CHECK((surface.position(again, x) - surface.position(foot, x)).norm() < 1e-9);
      }
    }
  }

  TEST_CASE("gap and normal and foot do not jump when a point slides over facets") {
    for (bool const triangles : {false, true}) {
      auto const across = [](double s) { return Vec3(0.1 + 0.8 * s, 0.15 + 0.7 * s, 0.06); };
      auto const through_nodes = [](double s) { return Vec3(0.1 + 0.8 * s, 0.5, -0.02); };
      for (auto const& path :
           {std::function<Vec3(double)>(across), std::function<Vec3(double)>(through_nodes)}) {
        auto const coarse = largest_jumps(waves(8, triangles), path, 400);
        auto const fine = largest_jumps(waves(8, triangles), path, 4000);
        for (std::size_t k = 0; k < 3; ++k) {
          CAPTURE(k);
          CHECK(fine[k] > 0);
          CHECK(fine[k] < 0.15 * coarse[k]); // proportional to the step
        }
      }
    }
  }

  TEST_CASE("around a ball all is continuous and the gap converges at order 2 and the mean normal beyond 1") {
    for (bool const triangles : {false, true}) {
      auto const errors = [&](int n) {
        auto const shell = ball(n, triangles);
        auto const surface = shell.surface();
        std::array<double, 2> largest{};
        for (auto const& at : points_in({-1, -1, -1}, {1, 1, 1}, 300)) {
          Vec3 const point = 1.1 * at.normalized();
          auto const k = kinematics(surface, shell.free_node(), {}, {}, shell.with(point));
          REQUIRE(k.found);
          largest[0] = std::max(largest[0], std::abs(k.gap - 0.1));
          largest[1] += (k.normal() - point.normalized()).norm(); // first order near irregular nodes
        }
        return largest;
      };
      auto const coarse = errors(6), fine = errors(12);
      for (std::size_t k = 0; k < 2; ++k) {
        CAPTURE(coarse[k]);
        CAPTURE(fine[k]);
        CHECK(std::log2(coarse[k] / fine[k]) > (k == 0 ? 1.8 : 1.2));
      }
      CHECK(fine[0] < 0.01);
      auto const shell = ball(6, triangles);
      auto const path = [](double s) {
        double const a = 6 * s, b = 2 * s;
        return Vec3(1.05 * Vec3(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)));
      };
      auto const jumps = largest_jumps(shell, path, 1000), smaller = largest_jumps(shell, path, 10000);
      for (std::size_t k = 0; k < 3; ++k)
        CHECK(smaller[k] < 0.15 * jumps[k]);
    }
  }

  TEST_CASE("beyond the border there is no counterpart, with one hundredth of a facet to spare") {
    for (bool const triangles : {false, true}) {
      auto const shell = sheet(4, triangles);
      auto const surface = shell.surface();
      auto const found = [&](Vec3 const& point) {
        auto const x = shell.with(point);
        bool const first = surface.project(point, {}, x).found();
        for (int f = 0; f < surface.size(); ++f)
          CHECK(surface.follow(point, {f, 0.3, 0.3}, x).found() == first);
        return first;
      };
      for (double const z : {-0.1, 0.0, 0.3}) {
        CHECK(found({0.5, 1.002, z}));
        CHECK(found({-0.002, 0.6, z}));
        CHECK(found({0.3, 0.999, z}));
        CHECK_FALSE(found({0.5, 1.01, z}));
        CHECK_FALSE(found({-0.02, 0.6, z}));
        CHECK_FALSE(found({0.7, -0.3, z}));
        CHECK_FALSE(found({1.3, 1.2, z}));
        CHECK_FALSE(found({-5, 0.2, z}));
      }
    }
  }

  TEST_CASE("outside a cube: the nearest point of sides and edges and vertices, from any guess") {
    for (bool const triangles : {false, true}) {
      auto const shell = cube(3, triangles);
      auto const surface = shell.surface();
      int wedges = 0;
      for (auto const& point : points_in({-1.6, -1.6, -1.6}, {1.6, 1.6, 1.6}, 400)) {
        Vec3 const nearest = point.cwiseMax(-1).cwiseMin(1);
        double const distance = (point - nearest).norm();
        if (distance < 1e-3)
          continue;
        wedges += ((point.array().abs() > 1).count() > 1) ? 1 : 0;
        auto const x = shell.with(point);
        CAPTURE(point.transpose());
        auto const k = kinematics(surface, shell.free_node(), {}, {}, x);
        REQUIRE(k.found);
        CHECK((surface.position(k.foot, x) - nearest).norm() < 1e-9);
        CHECK(k.gap == doctest::Approx(distance));
        CHECK((k.normal() - (point - nearest) / distance).norm() < 1e-9);
        for (int f = 0; f < surface.size(); f += 5) {
          Foot const other = surface.follow(point, {f, 0.2, 0.2}, x);
          bool const through = other.found() && (surface.position(other, x) - point).norm() > 1.5;
          if (!through) { // a side seen from behind keeps its point: it may have gone through
            REQUIRE(other.found());
            CHECK((surface.position(other, x) - nearest).norm() < 1e-9);
          }
        }
      }
      CHECK(wedges > 100);
    }
  }

  TEST_CASE("in the walls of a cavity beyond its edges the gap is negative and the edge is nearest") {
    for (bool const triangles : {false, true}) {
      auto shell = cube(3, triangles);
      for (auto& facet : shell.facets)
        std::reverse(facet.nodes.begin(), facet.nodes.end());
      auto const surface = shell.surface();
      for (auto const& point : {Vec3(1.2, 0.1, 1.3), Vec3(-1.1, -1.2, 0.5), Vec3(1.1, 1.2, -1.3)}) {
        Vec3 const nearest = point.cwiseMax(-1).cwiseMin(1), d = point - nearest;
        auto const k = kinematics(surface, shell.free_node(), {}, {}, shell.with(point));
        REQUIRE(k.found);
        CHECK((surface.position(k.foot, shell.with(point)) - nearest).norm() < 1e-12);
        CHECK(k.gap == doctest::Approx(-d.norm()));
        CHECK((k.normal() + d.normalized()).norm() < 1e-12);
      }
    }
  }

  TEST_CASE("inside a cube the side with the smaller penetration is taken first") {
    auto const shell = cube(4, false);
    auto const surface = shell.surface();
    auto const gap = [&](Vec3 const& point) {
      return kinematics(surface, shell.free_node(), {}, {}, shell.with(point)).gap;
    };
    CHECK(gap({0.95, 0.2, 0.98}) == doctest::Approx(-0.02));
    CHECK(gap({0.99, 0.2, 0.98}) == doctest::Approx(-0.01));
    CHECK(gap({0.99, 0.995, 0.98}) == doctest::Approx(-0.005));
  }

  TEST_CASE("round an edge and a vertex of a cube gap and normal and foot do not jump") {
    for (bool const triangles : {false, true}) {
      auto const shell = cube(3, triangles);
      auto const edge = [](double s) { // parallel to the surface at a distance of 0.1
        double const a = 0.5 * std::numbers::pi * std::clamp(3 * s - 1, 0.0, 1.0);
        Vec3 const centre(1 - std::max(0.0, 1 - 3 * s), 0.13, 1 - std::max(0.0, 3 * s - 2));
        return Vec3(centre + 0.1 * Vec3(std::sin(a), 0, std::cos(a)));
      };
      auto const vertex = [](double s) {
        double const a = 0.2 + s;
        return Vec3(1 + 0.1 * std::cos(a) * std::cos(2 * a - 1), 1 + 0.1 * std::sin(a) * std::cos(2 * a - 1),
                    1 + 0.1 * std::sin(2 * a - 1));
      };
      for (auto const& path : {std::function<Vec3(double)>(edge), std::function<Vec3(double)>(vertex)}) {
        auto const coarse = largest_jumps(shell, path, 300), fine = largest_jumps(shell, path, 3000);
        CHECK(fine[0] < 0.15 * coarse[0] + 1e-12);
        CHECK(fine[1] < 0.15 * coarse[1]);
        CHECK(fine[2] < 0.15 * coarse[2]);
      }
    }
  }
}
