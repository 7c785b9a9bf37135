// Obstacles and points near them for the tests of rigid shapes.
#pragma once
#include <doctest/doctest.h>

#include "contact/kinematics.hpp"
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
  std::vector<Encounter<3>> all;
  for (auto const& shape : shapes)
    for (auto const& p : {Vec3(1.3, 2.05, 0.7), Vec3(-1.9, 0.6, -1.2), Vec3(0.5, -0.9, 1.6)})
      all.push_back({shape, p});
  return all;
}

inline void check_rate(Rate const& rate, char const* what) {
  CHECK_MESSAGE(rate.second_order, what << ": " << rate.words());
  CHECK(rate.errors[2] <= 1e-5 * (1 + rate.scale));
}

} // namespace stiction::test
