// Rigid triangulated surfaces: convergence to the shape they run through, edges, borders, derivatives.
#include <filesystem>
#include <fstream>
#include <map>

#include "contact/obstacles.hpp"
#include "core/error.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

Vec3 const direction(1, 0.2, -0.3);

ObstacleView<3> seen(Obstacle const& shape, Vec3 const& point, Foot start = {}) {
  return view<3>(shape, point, start, {}, direction);
}

/// A sphere about the origin: the octahedron with each triangle cut into four, `times` times.
RigidSurface ball(double radius, int times) {
  std::vector<Vec3> nodes{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  Indices cells{0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
  for (int round = 0; round < times; ++round) {
    std::map<std::pair<Index, Index>, Index> middles;
    auto const middle = [&](Index a, Index b) {
      auto const [found, made] =
          middles.emplace(std::pair(std::min(a, b), std::max(a, b)), static_cast<Index>(nodes.size()));
      if (made)
        nodes.push_back((nodes[ix(a)] + nodes[ix(b)]).normalized());
      return found->second;
    };
    Indices finer;
    for (std::size_t c = 0; c < cells.size(); c += 3) {
      Index const i = cells[c], j = cells[c + 1], k = cells[c + 2];
      Index const ij = middle(i, j), jk = middle(j, k), ki = middle(k, i);
      finer.insert(finer.end(), {i, ij, ki, ij, j, jk, ki, jk, k, ij, jk, ki});
    }
    cells = finer;
  }
  Matrix positions(static_cast<Index>(nodes.size()), 3);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    positions.row(static_cast<Index>(i)) = radius * nodes[i].transpose();
  return surface_of(positions, mesh::CellKind::tri3, cells);
}

std::vector<Vec3> const around{{1.3, 1.05, 0.7}, {-1.1, 0.6, -1.2}, {0.5, -0.9, 1.6}, {0.3, 0.4, -2.2}};

struct Distance {
  double gap = 0, frame = 0;
};

/// The largest differences between the sphere and its triangulation.
Distance between(RigidSphere const& sphere, RigidSurface const& surface) {
  Distance most;
  for (auto const& p : around) {
    auto const one = seen(sphere, p), other = seen(surface, p);
    REQUIRE(other.found);
    most.gap = std::max(most.gap, std::abs(one.gap - other.gap));
    most.frame = std::max(most.frame, (one.frame - other.frame).norm());
  }
  return most;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("a triangulated sphere sees what the sphere sees, better the finer it is") {
    RigidSphere const sphere{{}, 1.8};
    auto const coarse = between(sphere, ball(1.8, 2)), fine = between(sphere, ball(1.8, 4));
    CHECK(coarse.gap < 0.1);
    CHECK(fine.gap < coarse.gap / 8); // second order would give 16
    CHECK(fine.frame < coarse.frame / 4);
  }

  TEST_CASE("the stiffness of a curved triangulation is the derivative of its frame") {
    auto const surface = ball(1.8, 2);
    for (auto const& p : around) {
      auto const at = seen(surface, p);
      for (int k = 0; k < 3; ++k) {
        auto const row = [&](Vector const& x) {
          return Vector(view<3>(surface, x, {}, at.foot, direction).by_x.row(k));
        };
        Mat<3> const K = curvature_stiffness<3>(surface, at.foot, p, Vec3::Unit(k), direction);
        check_rate(rate(row, Dense(K), Vector(p), 1e-3, 1), "stiffness");
      }
    }
  }

  TEST_CASE("a cube sees points off its faces as a plane does, points off edges and corners by distance") {
    for (auto const kind : {mesh::CellKind::tri3, mesh::CellKind::quad4}) {
      auto const box = cube(1, kind);
      auto const top = seen(box, {0.3, -0.2, 1.5}), plane = seen(RigidPlane{{0, 0, 1}, {}}, {0.3, -0.2, 1.5});
      CHECK(top.gap == doctest::Approx(0.5));
      CHECK(top.frame.isApprox(plane.frame));
      CHECK(seen(box, {0.3, -0.2, 0.9}).gap == doctest::Approx(-0.1));
      auto const edge = seen(box, {0.3, 1.3, 1.4}), corner = seen(box, {1.1, 1.2, 1.2});
      CHECK(edge.gap == doctest::Approx(0.5));
      CHECK(edge.frame.col(0).isApprox(Vec3(0, 0.6, 0.8)));
      CHECK(corner.gap == doctest::Approx(0.3));
      CHECK(corner.frame.col(0).isApprox(Vec3(1, 2, 2) / 3));
      Vec3 const way(0.4, 0.1, 0.05);
      auto const later = seen(box, Vec3(0.3, -0.2, 1.5) + way, top.foot);
      CHECK((later.slip - Vec2(top.frame.col(1).dot(way), top.frame.col(2).dot(way))).norm() < 1e-14);
    }
  }

  TEST_CASE("the wall of a cubic cavity is passed by the distance from its edges and corners") {
    Matrix nodes(8, 3);
    for (int i = 0; i < 8; ++i) // mirrored, so that the sides face inward
      nodes.row(i) << ((i & 1) != 0 ? -1 : 1), ((i & 2) != 0 ? 1 : -1), ((i & 4) != 0 ? 1 : -1);
    auto const cavity = surface_of(nodes, mesh::CellKind::quad4,
                                   {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5});
    CHECK(seen(cavity, {0.3, -0.2, 0.9}).gap == doctest::Approx(0.1));
    auto const edge = seen(cavity, {0.3, 1.3, 1.4}), corner = seen(cavity, {1.1, 1.2, 1.2});
    CHECK(edge.gap == doctest::Approx(-0.5));
    CHECK(edge.frame.col(0).isApprox(Vec3(0, -0.6, -0.8)));
    CHECK(corner.gap == doctest::Approx(-0.3));
  }

  TEST_CASE("a point that leaves one piece of a surface is taken up by another") {
    Matrix nodes(8, 3);
    nodes << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 3, 0, 0, 4, 0, 0, 4, 1, 0, 3, 1, 0;
    auto const steps = surface_of(nodes, mesh::CellKind::quad4, {0, 1, 2, 3, 4, 5, 6, 7});
    auto const first = seen(steps, {0.5, 0.5, 0.1});
    auto const later = view<3>(steps, {3.5, 0.5, 0.2}, {}, first.foot, direction);
    REQUIRE(later.found);
    CHECK(later.gap == doctest::Approx(0.2));
    CHECK(later.foot.segment != first.foot.segment);
  }

  TEST_CASE("a surface is read from its file and scaled") {
    auto const file = std::filesystem::temp_directory_path() / "stiction-test-patch.stl";
    std::ofstream(file) << "solid patch\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1\nvertex 4 0 1\n"
                           "vertex 0 4 1\nendloop\nendfacet\nendsolid patch\n";
    Obstacle patch{RigidSurface{file.string(), 0.5, {}}};
    prepare(patch);
    CHECK(seen(patch, {0.5, 0.5, 0.7}).gap == doctest::Approx(0.2));
    std::filesystem::remove(file);
    CHECK_THROWS_AS(prepare(patch), core::InputError);
  }

  TEST_CASE("an open surface ends at its border") {
    Matrix nodes(4, 3);
    nodes << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
    auto const patch = surface_of(nodes, mesh::CellKind::quad4, {0, 1, 2, 3});
    CHECK(seen(patch, {1, 0.5, 0.1}).gap == doctest::Approx(0.1));
    CHECK_FALSE(seen(patch, {1.1, 0.5, 0.1}).found);
    CHECK_FALSE(seen(patch, {0.5, -0.1, -0.1}).found);
  }
}
