// Obstacles and points near them for the tests of rigid shapes.
#pragma once
#include <doctest/doctest.h>

#include "contact/node_to_segment/kinematics.hpp"
#include "differences.hpp"

namespace stiction::test {

using contact::Obstacle;
using contact::Side;
using contact::Vec;
using contact::Vec2;
using contact::Vec3;

/// A shape and a point that may touch it, both in the shape's frame.
template<int D> struct Encounter {
  Obstacle shape;
  Vec<D> point;
};

inline contact::RigidPolyline polyline(core::Numbers points, bool closed, contact::Smoothing smoothing) {
  contact::RigidPolyline line{std::move(points), closed, smoothing, {}};
  contact::prepare(line);
  return line;
}

/// Points on an ellipse about the origin, the solid inside.
inline core::Numbers ellipse(int count, double a, double b, double turn = 6.283185307179586) {
  core::Numbers points;
  for (int i = 0; i < count; ++i) {
    double const angle = turn * i / count;
    points.insert(points.end(), {a * std::cos(angle), b * std::sin(angle)});
  }
  return points;
}

/// Corners and cells of one kind, as a rigid surface.
inline contact::RigidSurface surface_of(Matrix nodes, mesh::CellKind kind, Indices const& cells) {
  mesh::SurfaceMesh mesh{std::move(nodes), {}};
  auto const count = kind == mesh::CellKind::tri3 ? 3 : 4;
  for (auto first = cells.begin(); first != cells.end(); first += count)
    mesh.facets.push_back({Indices(first, first + count)});
  contact::RigidSurface surface;
  surface.prepared = std::make_shared<contact::FixedSurface const>(mesh);
  return surface;
}

/// The cube |x|, |y|, |z| <= half.
inline contact::RigidSurface cube(double half, mesh::CellKind kind) {
  Matrix nodes(8, 3);
  for (int i = 0; i < 8; ++i)
    nodes.row(i) << ((i & 1) != 0 ? half : -half), ((i & 2) != 0 ? half : -half),
        ((i & 4) != 0 ? half : -half);
  Indices const sides{0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  if (kind == mesh::CellKind::quad4)
    return surface_of(nodes, kind, sides);
  Indices halves;
  for (std::size_t q = 0; q < sides.size(); q += 4)
    for (std::size_t const k : {0, 1, 2, 0, 2, 3})
      halves.push_back(sides[q + k]);
  return surface_of(nodes, kind, halves);
}

/// height(x, y) on equally many points along each axis, about the origin.
template<class Height>
contact::RigidHeights height_map(core::Numbers size, int points, contact::RigidHeights::Rim rim,
                                 Height const& height, core::Numbers normal = {}) {
  contact::RigidHeights map;
  map.size = std::move(size);
  map.points.assign(map.size.size(), points);
  map.boundary = rim;
  map.normal = std::move(normal);
  auto const middle = [&](int i, double length) { return ((i + 0.5) / points - 0.5) * length; };
  for (int j = 0; j < (map.size.size() > 1 ? points : 1); ++j)
    for (int i = 0; i < points; ++i)
      map.heights.push_back(height(middle(i, map.size[0]), map.size.size() > 1 ? middle(j, map.size[1]) : 0));
  contact::prepare(map);
  return map;
}

/// Three waves along x and y, no two alike.
inline double rolling(double x, double y) {
  return 0.1 * std::cos(x + 0.3) + 0.05 * std::sin(2 * x - y) + 0.08 * std::cos(y - 1);
}

/// Every shape of the plane, from both sides, with open and penetrating points.
inline std::vector<Encounter<2>> encounters(std::integral_constant<int, 2> /*D*/) {
  using namespace contact;
  std::vector<Obstacle> shapes{RigidPlane{{0.2, 0.1}, {-3, 4}}, RigidPlane{}};
  for (auto const side : {Side::outside, Side::inside}) {
    shapes.emplace_back(RigidCircle{{0.5, -1}, 2, side});
    shapes.emplace_back(RigidSphere{{-0.4, 0.3}, 1.5, side});
    shapes.emplace_back(RigidTorus{{0, 0.5}, {}, 2, 0.7, side});
  }
  for (auto const smoothing : {Smoothing::spline, Smoothing::polyline})
    for (bool const closed : {true, false})
      shapes.emplace_back(polyline(ellipse(16, 3, 2), closed, smoothing));
  for (auto const rim : {RigidHeights::Rim::periodic, RigidHeights::Rim::free})
    for (core::Numbers const& normal : {core::Numbers{0, 1}, {-3, -4}})
      shapes.emplace_back(height_map({6.283185307179586}, 11, rim, rolling, normal));
  std::vector<Encounter<2>> all;
  for (auto const& shape : shapes)
    for (auto const& p : {Vec2(1.3, 2.05), Vec2(-1.9, 1.4), Vec2(-0.9, -2.9)})
      all.push_back({shape, p});
  return all;
}

/// Every shape of space, from both sides, with open and penetrating points.
inline std::vector<Encounter<3>> encounters(std::integral_constant<int, 3> /*D*/) {
  using namespace contact;
  std::vector<Obstacle> shapes{RigidPlane{{0.2, 0.1, -0.3}, {-3, 4, 2}}, RigidPlane{}};
  for (auto const side : {Side::outside, Side::inside}) {
    shapes.emplace_back(RigidSphere{{-0.4, 0.3, 0.2}, 1.5, side});
    shapes.emplace_back(RigidCylinder{{0.1, -0.2, 5}, {1, 0.5, -2}, 1.2, side});
    shapes.emplace_back(RigidTorus{{0.1, 0.5, -0.2}, {0.3, 1, 0.4}, 2, 0.7, side});
  }
  for (double const half : {0.65, 1.0, 1.45, 2.2}) { // corners, edges, faces, from inside
    shapes.emplace_back(cube(half, mesh::CellKind::tri3));
    shapes.emplace_back(cube(half, mesh::CellKind::quad4));
  }
  for (auto const rim : {RigidHeights::Rim::periodic, RigidHeights::Rim::free})
    for (core::Numbers const& normal : {core::Numbers{0, 0, 1}, {-3, 1, -4}})
      shapes.emplace_back(height_map({6.283185307179586, 6.283185307179586}, 11, rim, rolling, normal));
  std::vector<Encounter<3>> all;
  for (auto const& shape : shapes)
    for (auto const& p : {Vec3(1.3, 2.05, 0.7), Vec3(-1.9, 0.6, -1.2), Vec3(0.5, -0.9, 1.6)})
      all.push_back({shape, p});
  return all;
}

} // namespace stiction::test
