// Rows of H and the geometric stiffness as derivatives, invariance under rigid motion, balance of forces.
#include <doctest/doctest.h>

#include "contact/helpers.hpp"
#include "differences.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// A free node near a wavy arc: open, closed and penetrating, on spline and polyline, at the ends too.
struct Case {
  Arc arc;
  Smoothing smoothing;
  Vec2 point;
};
std::vector<Case> cases() {
  std::vector<Case> all;
  for (auto const smoothing : {Smoothing::spline, Smoothing::polyline})
    for (double const angle : {0.07, 0.71, 1.56, 2.03})
      for (double const radius : {0.93, 1.0, 1.25}) {
        Arc arc(9, 0, 2.1);
        Vec2 const point = radius * Vec2(std::cos(angle), std::sin(angle));
        arc.nodes = Eigen::Map<Matrix>(shaken(flat(arc.nodes), 0.02).data(), arc.nodes.rows(), 2);
        all.push_back({arc, smoothing, point});
      }
  return all;
}

/// Adds a move of the point's own unknowns to all positions.
std::vector<double> moved(std::vector<double> x, PointKinematics const& point, Vector const& move) {
  for (int k = 0; k < point.unknowns(); ++k)
    x[ix(2 * point.nodes[ix(k / 2)] + k % 2)] += move[k];
  return x;
}

std::vector<double> carried(std::vector<double> const& x, double angle, Vec2 const& shift) {
  auto result = x;
  for (std::size_t i = 0; i < x.size(); i += 2) {
    result[i] = std::cos(angle) * x[i] - std::sin(angle) * x[i + 1] + shift.x();
    result[i + 1] = std::sin(angle) * x[i] + std::cos(angle) * x[i + 1] + shift.y();
  }
  return result;
}

/// Resultant (x, y) and moment about the origin of the nodal forces `row`.
Eigen::Vector3d resultant(PointKinematics const& point, Row const& row, std::vector<double> const& x) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < point.count; ++k) {
    double const fx = row[2 * k], fy = row[2 * k + 1];
    auto const node = ix(2 * point.nodes[ix(k)]);
    sum += Eigen::Vector3d(fx, fy, x[node] * fy - x[node + 1] * fx);
  }
  return sum;
}

void check_rate(Rate const& rate, char const* what) {
  CHECK_MESSAGE(rate.second_order, what << ": " << rate.words());
  CHECK(rate.errors[2] <= 1e-5 * (1 + rate.scale));
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("rows of H are the derivatives of gap and slip, the geometric stiffness that of the rows") {
    int checked = 0;
    for (auto const& c : cases()) {
      CAPTURE(c.point.transpose());
      auto const curve = c.arc.curve(c.smoothing);
      auto const x = c.arc.with(c.point);
      Index const node = c.arc.free_node();
      auto const at = kinematics(curve, node, {}, {}, x);
      REQUIRE(at.found);
      if (at.foot.xi < 0.02 || at.foot.xi > 0.98)
        continue; // differences would leave the segment
      ++checked;
      int const n = at.unknowns();
      auto const look = [&](Vector const& move) {
        return kinematics(curve, node, at.foot, at.foot, moved(x, at, move));
      };
      Vector const here = Vector::Zero(n);
      check_rate(rate([&](Vector const& m) { return Vector::Constant(1, look(m).gap).eval(); },
                      Dense(at.normal.head(n).transpose()), here, 1e-3, 1),
                 "gap");
      check_rate(rate([&](Vector const& m) { return Vector::Constant(1, look(m).slip).eval(); },
                      Dense(at.tangential.head(n).transpose()), here, 1e-3, 1),
                 "slip");
      check_rate(rate([&](Vector const& m) { return Vector(look(m).normal.head(n)); },
                      Dense(geometric_stiffness(curve, at, x, {1, 0}).topLeftCorner(n, n)), here, 1e-3, 1),
                 "turn of the normal row");
      check_rate(rate([&](Vector const& m) { return Vector(look(m).tangential.head(n)); },
                      Dense(geometric_stiffness(curve, at, x, {0, 1}).topLeftCorner(n, n)), here, 1e-3, 1),
                 "turn of the tangential row");
      Block const both = geometric_stiffness(curve, at, x, {2, -3});
      Block const sum =
          2 * geometric_stiffness(curve, at, x, {1, 0}) - 3 * geometric_stiffness(curve, at, x, {0, 1});
      CHECK((both - sum).norm() <= 1e-12 * sum.norm());
      Block const normal = geometric_stiffness(curve, at, x, {1, 0}); // a second derivative of the gap
      CHECK((normal - normal.transpose()).norm() <= 1e-12 * (1 + normal.norm()));
    }
    CHECK(checked >= 18);
  }

  TEST_CASE("gap, normal and slip have the signs of the physics") {
    Arc const arc(15, 0, 3);
    auto const curve = arc.curve();
    auto const out = kinematics(curve, arc.free_node(), {}, {}, arc.with({0, 1.1}));
    CHECK(out.gap == doctest::Approx(0.1).epsilon(1e-4));
    CHECK(out.n.y() == doctest::Approx(1).epsilon(1e-4));
    CHECK(out.t.x() == doctest::Approx(1).epsilon(1e-4)); // (t, n) right-handed
    CHECK(out.slip == 0);
    CHECK(kinematics(curve, arc.free_node(), {}, {}, arc.with({0, 0.95})).gap < 0);
    auto const right = kinematics(curve, arc.free_node(), out.foot, out.foot, arc.with({0.3, 1.0}));
    CHECK(right.slip == doctest::Approx(std::atan(0.3)).epsilon(1e-4)); // along +t
    CHECK(out.tangential.head<2>().dot(out.t) > 0);
    CHECK_FALSE(kinematics(curve, arc.free_node(), {}, {}, arc.with({1.1, -0.5})).found);
  }

  TEST_CASE("a rigid motion of everything changes neither gap nor slip, and turns the frame with it") {
    for (auto const& c : cases()) {
      auto const curve = c.arc.curve(c.smoothing);
      auto const x = c.arc.with(c.point);
      Foot const start{2, 0.4};
      auto const at = kinematics(curve, c.arc.free_node(), start, {}, x);
      auto const after = kinematics(curve, c.arc.free_node(), start, at.foot, carried(x, 2.2, {7, -3}));
      CHECK(after.gap == doctest::Approx(at.gap).epsilon(1e-10));
      CHECK(after.slip == doctest::Approx(at.slip).epsilon(1e-10));
      Vec2 const turned(std::cos(2.2) * at.n.x() - std::sin(2.2) * at.n.y(),
                        std::sin(2.2) * at.n.x() + std::cos(2.2) * at.n.y());
      CHECK((after.n - turned).norm() < 1e-9);
    }
  }

  TEST_CASE("contact forces balance: no resultant and no moment, open or closed") {
    for (auto const& c : cases()) {
      auto const curve = c.arc.curve(c.smoothing);
      auto const x = c.arc.with(c.point);
      auto const at = kinematics(curve, c.arc.free_node(), {}, {}, x);
      REQUIRE(at.found);
      CHECK(resultant(at, at.normal, x).norm() < 1e-12);
      CHECK(resultant(at, at.tangential, x).norm() < 1e-12);
      CHECK(at.normal.head<2>().norm() == doctest::Approx(1));
    }
  }

  TEST_CASE("obstacles: closed forms, rows and stiffness as derivatives, motion of the obstacle") {
    RigidPlane plane;
    plane.point = {0.2, 0.1};
    plane.normal = {-3, 4};
    RigidCircle circle;
    circle.centre = {0.5, -1};
    circle.radius = 2;
    Vec2 const offset(0.3, -0.4);
    for (Obstacle const& obstacle : {Obstacle{plane}, Obstacle{circle}})
      for (auto const& p : {Vec2(1.5, 2.0), Vec2(-1.9, 0.4), Vec2(0.9, -3.9)}) {
        std::vector<double> const x{9, 9, p.x(), p.y()};
        auto const at = kinematics(obstacle, 1, {}, x, offset);
        auto const look = [&](Vector const& m) {
          return kinematics(obstacle, 1, at.foot, std::vector<double>{9, 9, p.x() + m[0], p.y() + m[1]},
                            offset);
        };
        Vector const here = Vector::Zero(2);
        CHECK(at.count == 1);
        CHECK(at.nodes[0] == 1);
        CHECK(look(here).slip == 0);
        CHECK(at.t.x() * at.n.y() - at.t.y() * at.n.x() == doctest::Approx(1));
        check_rate(rate([&](Vector const& m) { return Vector::Constant(1, look(m).gap).eval(); },
                        Dense(at.normal.head<2>().transpose()), here, 1e-3, 1),
                   "gap");
        check_rate(rate([&](Vector const& m) { return Vector::Constant(1, look(m).slip).eval(); },
                        Dense(at.tangential.head<2>().transpose()), here, 1e-3, 1),
                   "slip");
        for (auto const& force : {Vec2(1, 0), Vec2(0, 1)}) {
          auto const row = [&](Vector const& m) {
            auto const k = look(m);
            return Vector(force[0] * k.normal.head<2>() + force[1] * k.tangential.head<2>());
          };
          Block const K = geometric_stiffness(obstacle, at, x, offset, force);
          check_rate(rate(row, Dense(K.topLeftCorner<2, 2>()), here, 1e-3, 1), "stiffness");
          CHECK(K.bottomRightCorner<8, 8>().isZero(0));
        }
      }
    std::vector<double> const above{0.8, 1.6}; // 3 m above the circle's displaced centre
    auto const seen = kinematics(Obstacle{circle}, 0, {}, above, offset);
    CHECK(seen.gap == doctest::Approx(1));
    CHECK((seen.n - Vec2(0, 1)).norm() < 1e-15);
    CHECK(kinematics(Obstacle{plane}, 0, {}, above, {0, 0}).gap == doctest::Approx((-3 * 0.6 + 4 * 1.5) / 5));
  }

  TEST_CASE("slip on a circle goes the short way round and along the tangent") {
    RigidCircle circle;
    circle.radius = 2;
    auto const place = [](double angle) {
      return std::vector<double>{2 * std::cos(angle), 2 * std::sin(angle)};
    };
    double const pi = std::numbers::pi;
    for (double const from : {0.3, pi - 0.05, -pi / 2}) {
      auto const start = kinematics(Obstacle{circle}, 0, {}, place(from), {0, 0});
      auto const end = kinematics(Obstacle{circle}, 0, start.foot, place(from - 0.1), {0, 0});
      CHECK(end.slip == doctest::Approx(0.2)); // clockwise is along t
    }
  }
}
