// What a point sees of rigid shapes: closed forms, derivatives, tangents, sides.
#include "contact/obstacles.hpp"

#include <Eigen/Geometry>
#include <numbers>

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

Vec3 const direction(1, 0.2, -0.3);

template<int D> ObstacleView<D> seen(Obstacle const& shape, Vec<D> const& point, Foot start = {}) {
  return view<D>(shape, point, start, {}, direction);
}

/// by_x against differences of the gap and, where slip starts anew, of slip; curvature_stiffness against
/// those of by_x^T force.
template<int D> void check_derivatives(Encounter<D> const& met) {
  auto const at = seen<D>(met.shape, met.point);
  REQUIRE(at.found);
  auto const view_at = [&](Vector const& x) { return view<D>(met.shape, x, at.foot, at.foot, direction); };
  Vector const here = met.point;
  auto const gap = [&](Vector const& x) { return Vector(Vector::Constant(1, view_at(x).gap)); };
  check_rate(rate(gap, Dense(at.by_x.row(0)), here, 1e-3, 1), "gap");
  auto const slip = [&](Vector const& x) { return Vector(view_at(x).slip); };
  check_rate(rate(slip, Dense(at.by_x.template bottomRows<D - 1>()), here, 1e-3, 1), "slip");
  CHECK(slip(here).isZero(1e-15));
  for (int k = 0; k < D; ++k) {
    Local<D> const force = Local<D>::Unit(k);
    auto const row = [&](Vector const& x) { return Vector(view_at(x).by_x.row(k)); };
    Mat<D> const K = curvature_stiffness<D>(met.shape, at.foot, met.point, force, direction);
    check_rate(rate(row, Dense(K), here, 1e-3, 1), "stiffness");
  }
}

template<int D> void check_frame(Encounter<D> const& met) {
  auto const at = seen<D>(met.shape, met.point);
  CHECK((at.frame.transpose() * at.frame).isIdentity(1e-14));
  CHECK((at.by_x.row(0).transpose() - at.frame.col(0)).norm() < 1e-14);
  // (t1, n) or (t1, t2, n): moving n from the end to the front is one swap in the plane, two in space
  CHECK(at.frame.determinant() == doctest::Approx(D == 2 ? -1 : 1));
}

/// As if the shape were touched from the other side.
Obstacle turned_inside_out(Obstacle shape) {
  std::visit(
      [](auto& s) {
        if constexpr (requires { s.side; })
          s.side = s.side == Side::outside ? Side::inside : Side::outside;
      },
      shape);
  return shape;
}

bool has_side(Obstacle const& shape) {
  return std::visit(
      [](auto const& s) {
        return requires {
          s.side;
        };
      },
      shape);
}

template<int D> int check_sides() {
  int checked = 0;
  for (auto const& met : encounters(std::integral_constant<int, D>{})) {
    if (!has_side(met.shape))
      continue;
    auto const one = seen<D>(met.shape, met.point), other = seen<D>(turned_inside_out(met.shape), met.point);
    CHECK(other.gap == -one.gap);
    CHECK(other.frame.col(0) == -one.frame.col(0));
    ++checked;
  }
  return checked;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("rows and curvature of obstacles are derivatives of gap and slip") {
    for (auto const& met : encounters(std::integral_constant<int, 2>{}))
      check_derivatives(met);
    for (auto const& met : encounters(std::integral_constant<int, 3>{}))
      check_derivatives(met);
  }

  TEST_CASE(
      "frames at obstacles are orthonormal and right-handed, their first column is the gap's gradient") {
    for (auto const& met : encounters(std::integral_constant<int, 2>{}))
      check_frame(met);
    for (auto const& met : encounters(std::integral_constant<int, 3>{}))
      check_frame(met);
  }

  TEST_CASE("gaps of obstacles in the plane have their closed forms") {
    CHECK(seen<2>(RigidPlane{{0.2, 0.1}, {-3, 4}}, {0.8, 1.6}).gap ==
          doctest::Approx((-3 * 0.6 + 4 * 1.5) / 5));
    CHECK(seen<2>(RigidPlane{}, {0.8, 1.6}).gap == 1.6); // the last axis
    auto const above = seen<2>(RigidCircle{{0.5, -1}, 2}, {0.5, 2});
    CHECK(above.gap == doctest::Approx(1));
    CHECK(above.frame.col(0) == Vec2(0, 1));
    CHECK(above.frame.col(1) == Vec2(1, 0));
    auto const within = seen<2>(RigidCircle{{0.5, -1}, 2, Side::inside}, {0.5, 0});
    CHECK(within.gap == doctest::Approx(1));
    CHECK(within.frame.col(0) == Vec2(0, -1));
    CHECK(seen<2>(RigidSphere{{}, 2}, {3, 4}).gap == doctest::Approx(3));
    CHECK(seen<2>(RigidTorus{{0, 1}, {}, 5, 2}, {5, 4}).gap == doctest::Approx(1));
  }

  TEST_CASE("gaps of obstacles in space have their closed forms") {
    CHECK(seen<3>(RigidPlane{{0, 0, 1}, {1, 2, 2}}, {3, 3, 4}).gap == doctest::Approx(5));
    CHECK(seen<3>(RigidPlane{}, {3, 3, 4}).frame.col(0) == Vec3(0, 0, 1));
    CHECK(seen<3>(RigidSphere{{1, 1, 1}, 2}, {2, 3, 3}).gap == doctest::Approx(1));
    CHECK(seen<3>(RigidSphere{{}, 2, Side::inside}, {0, 0, -1.5}).gap == doctest::Approx(0.5));
    CHECK(seen<3>(RigidSphere{{}, 2, Side::inside}, {0, 0, -1.5}).frame.col(0) == Vec3(0, 0, 1));
    CHECK(seen<3>(RigidCylinder{{1, 0, 7}, {}, 2}, {4, 4, -3}).gap == doctest::Approx(3));
    RigidTorus const torus{{}, {0, 0, 3}, 5, 1};
    CHECK(seen<3>(torus, {0, 5, 3}).gap == doctest::Approx(2));
    CHECK(seen<3>(torus, {0, 8, 4}).gap == doctest::Approx(4));
    CHECK(seen<3>(torus, {0, 3, 0}).frame.col(0) == Vec3(0, -1, 0)); // the hole
  }

  TEST_CASE("inside and outside of a shape differ in the sign of gap and normal") {
    CHECK(check_sides<2>() == 18);
    CHECK(check_sides<3>() == 18);
  }

  TEST_CASE("shapes of space cut by a plane are the shapes of the plane") {
    RigidTorus const flat{{0, 0.5}, {}, 2, 0.7}, ring{{0, 0.5, 0}, {0, 1, 0}, 2, 0.7};
    for (auto const& p : {Vec2(1.5, 2.0), Vec2(1.9, -0.4), Vec2(0.9, 0.9)}) {
      Vec3 const q(p.x(), p.y(), 0);
      CHECK(seen<2>(flat, p).gap == doctest::Approx(seen<3>(ring, q).gap));
      CHECK(seen<2>(RigidSphere{{1, 2}, 3}, p).gap ==
            doctest::Approx(seen<3>(RigidSphere{{1, 2, 0}, 3}, q).gap));
      CHECK(seen<2>(RigidCircle{{1, 2}, 3}, p).gap ==
            doctest::Approx(seen<3>(RigidCylinder{{1, 2, 0}, {}, 3}, q).gap));
    }
  }

  TEST_CASE("the first tangent follows the direction, or the next axis where that is normal") {
    RigidPlane const ground;
    auto const t1 = [&](Vec3 const& along, Obstacle const& shape) {
      return Vec3(view<3>(shape, {0, 0, 1}, {}, {}, along).frame.col(1));
    };
    CHECK((t1({3, 4, 7}, ground) - Vec3(0.6, 0.8, 0)).norm() < 1e-15);
    CHECK((t1({0, 0.01, -1}, ground) - Vec3(0, 1, 0)).norm() < 1e-15); // still follows
    CHECK((t1({0, 0.0005, -1}, ground) - Vec3(1, 0, 0)).norm() < 1e-15);
    Vec3 const diagonal = Vec3::Ones(); // largest in x first: the next axis is y
    Vec3 const expected = Vec3(-1, 2, -1).normalized();
    CHECK((t1(diagonal, RigidPlane{{}, {1, 1, 1}}) - expected).norm() < 1e-15);
  }

  TEST_CASE("slip on a circle goes the short way round and along the tangent") {
    double const pi = std::numbers::pi;
    auto const position = [](double angle) { return Vec2(2.5 * std::cos(angle), 2.5 * std::sin(angle)); };
    for (double const from : {0.3, pi - 0.05, -pi / 2}) {
      RigidCircle circle{{}, 2};
      auto const start = seen<2>(circle, position(from));
      CHECK(seen<2>(circle, position(from - 0.1), start.foot).slip[0] == doctest::Approx(0.2)); // clockwise
      circle.side = Side::inside; // the other way: the normal points to the centre
      auto const within = seen<2>(circle, position(from));
      CHECK(seen<2>(circle, position(from + 0.1), within.foot).slip[0] == doctest::Approx(0.2));
    }
  }

  TEST_CASE("slip in space is the part of the way along the surface") {
    RigidPlane const ground{{0, 0, 0.5}, {}};
    auto const start = view<3>(ground, {1, 2, 3}, {}, {}, Vec3::UnitY());
    CHECK(start.slip.isZero(0));
    auto const end = view<3>(ground, {1.5, 4, 7}, start.foot, {}, Vec3::UnitY());
    CHECK(end.slip[0] == doctest::Approx(2));    // t1 = y
    CHECK(end.slip[1] == doctest::Approx(-0.5)); // t2 = n x t1 = -x
  }

  TEST_CASE("where no point of a shape is nearest there is no counterpart") {
    CHECK_FALSE(seen<2>(RigidCircle{{0.5, -1}, 2}, {0.5, -1}).found);
    CHECK_FALSE(seen<3>(RigidSphere{{1, 2, 3}, 2, Side::inside}, {1, 2, 3}).found);
    CHECK_FALSE(seen<3>(RigidCylinder{{1, 2, 0}, {}, 2}, {1, 2, 3}).found);
    RigidTorus const torus{{}, {}, 2, 1};
    CHECK_FALSE(seen<3>(torus, {0, 0, 3}).found); // on the axis
    CHECK_FALSE(seen<3>(torus, {0, 2, 0}).found); // in the middle of the tube
  }
}
