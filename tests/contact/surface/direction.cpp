// The first tangent's direction where a pair says none.
#include <Eigen/Geometry>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "contact/surface/direction.hpp"

using namespace stiction;
using contact::Vec3;

namespace {

using std::numbers::pi;

struct Skin {
  std::vector<mesh::Facet> facets;
  Matrix nodes;
};

/// Part of a cylinder about y, of so many facets, turned about z: from the angle `from` below to `to`.
Skin cylinder(int count, double from, double to, double turned) {
  Skin skin;
  skin.nodes.resize(2 * (count + 1), 3);
  Eigen::AngleAxisd const turn(turned, Vec3::UnitZ());
  for (int k = 0; k <= count; ++k) {
    double const angle = from + (to - from) * k / count;
    for (int side = 0; side < 2; ++side)
      skin.nodes.row(2 * k + side) = turn * Vec3(std::sin(angle), side, -std::cos(angle));
  }
  for (int k = 0; k < count; ++k)
    skin.facets.push_back({{2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2}});
  return skin;
}

} // namespace

TEST_SUITE_BEGIN("contact");

TEST_CASE(
    "where no facet lies across it the first tangent goes along the axis least in line with the normals") {
  Skin flat;
  flat.nodes.resize(4, 3);
  flat.nodes << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0;
  flat.facets = {{{0, 1, 2, 3}}};
  CHECK(contact::first_direction(flat.facets, flat.nodes) == Vec3::UnitX());
  auto const slope = cylinder(8, pi / 6, pi / 3, 0); // normals along x and z
  CHECK(contact::first_direction(slope.facets, slope.nodes).isApprox(Vec3::UnitY()));
}

TEST_CASE("round a drum the first tangent goes along it, as far as an axis does") {
  for (double const turned : {0.0, 0.5 * pi, 0.3, 0.3 + 0.5 * pi}) {
    auto const drum = cylinder(40, -pi, pi, turned);
    Vec3 const along = contact::first_direction(drum.facets, drum.nodes);
    CHECK(along == (std::abs(std::sin(turned)) < 0.5 ? Vec3(Vec3::UnitY()) : Vec3(Vec3::UnitX())));
  }
}

TEST_CASE("round a ball, of which some facet lies across any direction, it stays an axis") {
  Skin skin;
  skin.nodes.resize(18, 3);
  Index row = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (double const side : {-1.0, 1.0}) {
      Vec3 const n = side * Vec3::Unit(axis), a = Vec3::Unit((axis + 1) % 3), b = n.cross(a);
      std::array const corners{Vec3(n - a - b), Vec3(n + a - b), Vec3(n + b)};
      for (Vec3 const& corner : corners)
        skin.nodes.row(row++) = corner;
      skin.facets.push_back({{row - 3, row - 2, row - 1}});
    }
  CHECK(contact::first_direction(skin.facets, skin.nodes).cwiseAbs().maxCoeff() == 1);
}

TEST_SUITE_END();
