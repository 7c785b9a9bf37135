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
std::vector<double> moved(std::vector<double> x, PointKinematics<2> const& point, Vector const& move) {
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
Eigen::Vector3d resultant(PointKinematics<2> const& point, Vector const& row, std::vector<double> const& x) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < point.count; ++k) {
    double const fx = row[2 * k], fy = row[2 * k + 1];
    auto const node = ix(2 * point.nodes[ix(k)]);
    sum += Eigen::Vector3d(fx, fy, x[node] * fy - x[node + 1] * fx);
  }
  return sum;
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
      auto const after = [&](Vector const& move) {
        return kinematics(curve, node, at.foot, at.foot, moved(x, at, move));
      };
      Vector const here = Vector::Zero(n);
      check_rate(rate([&](Vector const& m) { return Vector::Constant(1, after(m).gap).eval(); },
                      Dense(at.H.row(0)), here, 1e-3, 1),
                 "gap");
      check_rate(rate([&](Vector const& m) { return Vector::Constant(1, after(m).slip[0]).eval(); },
                      Dense(at.H.row(1)), here, 1e-3, 1),
                 "slip");
      check_rate(rate([&](Vector const& m) { return Vector(after(m).H.row(0)); },
                      Dense(geometric_stiffness(curve, at, x, {1, 0})), here, 1e-3, 1),
                 "turn of the normal row");
      check_rate(rate([&](Vector const& m) { return Vector(after(m).H.row(1)); },
                      Dense(geometric_stiffness(curve, at, x, {0, 1})), here, 1e-3, 1),
                 "turn of the tangential row");
      Block<2> const both = geometric_stiffness(curve, at, x, {2, -3});
      Block<2> const sum =
          2 * geometric_stiffness(curve, at, x, {1, 0}) - 3 * geometric_stiffness(curve, at, x, {0, 1});
      CHECK((both - sum).norm() <= 1e-12 * sum.norm());
      Block<2> const normal = geometric_stiffness(curve, at, x, {1, 0}); // a second derivative of the gap
      CHECK((normal - normal.transpose()).norm() <= 1e-12 * (1 + normal.norm()));
    }
    CHECK(checked >= 18);
  }

  TEST_CASE("gap, normal and slip have the signs of the physics") {
    Arc const arc(15, 0, 3);
    auto const curve = arc.curve();
    auto const out = kinematics(curve, arc.free_node(), {}, {}, arc.with({0, 1.1}));
    CHECK(out.gap == doctest::Approx(0.1).epsilon(1e-4));
    CHECK(out.normal().y() == doctest::Approx(1).epsilon(1e-4));
    CHECK(out.frame(0, 1) == doctest::Approx(1).epsilon(1e-4)); // (t, n) right-handed
    CHECK(out.slip[0] == 0);
    CHECK(kinematics(curve, arc.free_node(), {}, {}, arc.with({0, 0.95})).gap < 0);
    auto const right = kinematics(curve, arc.free_node(), out.foot, out.foot, arc.with({0.3, 1.0}));
    CHECK(right.slip[0] == doctest::Approx(std::atan(0.3)).epsilon(1e-4)); // along +t
    CHECK(out.H.row(1).head<2>().dot(out.frame.col(1)) > 0);
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
      CHECK(after.slip[0] == doctest::Approx(at.slip[0]).epsilon(1e-10));
      Vec2 const turned(std::cos(2.2) * at.normal().x() - std::sin(2.2) * at.normal().y(),
                        std::sin(2.2) * at.normal().x() + std::cos(2.2) * at.normal().y());
      CHECK((after.normal() - turned).norm() < 1e-9);
    }
  }

  TEST_CASE("contact forces balance: no resultant and no moment, open or closed") {
    for (auto const& c : cases()) {
      auto const curve = c.arc.curve(c.smoothing);
      auto const x = c.arc.with(c.point);
      auto const at = kinematics(curve, c.arc.free_node(), {}, {}, x);
      REQUIRE(at.found);
      CHECK(resultant(at, at.H.row(0), x).norm() < 1e-12);
      CHECK(resultant(at, at.H.row(1), x).norm() < 1e-12);
      CHECK(at.H.row(0).head<2>().norm() == doctest::Approx(1));
    }
  }
}
