// Obstacles that are carried or free: objectivity, balance of forces, and stiffness over node, position and
// turn.
#include <Eigen/Geometry>

#include "contact/obstacles.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// exp of the turn: in the plane its first component is the angle, in space it is the rotation vector.
Mat<2> turn_by(Vec2 const& d) {
  return Eigen::Rotation2Dd(d[0]).toRotationMatrix();
}
Mat<3> turn_by(Vec3 const& d) {
  double const angle = d.norm();
  return angle == 0 ? Mat<3>::Identity() : Eigen::AngleAxisd(angle, d / angle).toRotationMatrix();
}

template<int D> Pose<D> some_pose() {
  Pose<D> pose;
  pose.pivot = Vec<D>::LinSpaced(0.3, -0.4);
  pose.position = Vec<D>::LinSpaced(1.7, 2.9);
  pose.rotation = turn_by(Vec<D>(Vec<D>::LinSpaced(1.1, -0.7)));
  return pose;
}

/// Three nodes, the last of which may touch; the second and third unknowns of a free body are 0 and 1.
template<int D> std::vector<double> with(Vec<D> const& p) {
  std::vector<double> x(3 * D, 9.0);
  std::copy(p.begin(), p.end(), x.begin() + 2 * D);
  return x;
}

/// A node and a free obstacle that it meets.
template<int D> struct Meeting {
  Encounter<D> met;
  Pose<D> pose;
  Vec<D> node;
  Foot start;
  explicit Meeting(Encounter<D> const& m)
      : met(m), pose(some_pose<D>()), node(pose.position + pose.rotation * (m.point - pose.pivot)) {
    pose.translation = 0;
    pose.turn = 1;
    start = kinematics_at(Vector::Zero(3 * D)).foot;
  }
  [[nodiscard]] PosedObstacle<D> posed(Vector const& move) const {
    PosedObstacle<D> obstacle{&met.shape, pose, {1, 0.2, -0.3}};
    obstacle.pose.position += move.segment<D>(D);
    obstacle.pose.rotation = turn_by(Vec<D>(move.tail<D>())) * pose.rotation;
    return obstacle;
  }
  /// After the node and the body have moved by `move`: (node, translation, turn).
  [[nodiscard]] PointKinematics<D> kinematics_at(Vector const& move) const {
    return kinematics(posed(move), 2, start, start, with<D>(node + move.head<D>()));
  }
};

/// In space, after a long way.
void check_motion(Meeting<3> const& m) {
  Vector const here = Vector::Zero(9);
  Foot const start = m.kinematics_at(Vector::LinSpaced(9, 0.3, -0.2)).foot;
  auto const x = with<3>(m.node);
  auto const at = kinematics(m.posed(here), 2, start, m.start, x);
  auto const moves = [&](Vector const& move) {
    auto const seen = kinematics(m.posed(move), 2, start, m.start, with<3>(m.node + move.head<3>()));
    return Vector(Vec3(seen.gap, seen.slip[0], seen.slip[1]));
  };
  check_rate(rate(moves, Dense(motion_rows(m.posed(here), at, start, x)), here, 1e-3, 4), "motion");
}
void check_motion(Meeting<2> const& /*m*/) {}

/// The pair's force seen from (node, translation, turn): no resultant, no moment about the origin.
void check_balance(Meeting<2> const& m, Vector const& f) {
  CHECK((f.head<2>() + f.segment<2>(2)).norm() < 1e-14);
  auto const moment = [](Vec2 const& a, Vec2 const& b) { return a.x() * b.y() - a.y() * b.x(); };
  CHECK(std::abs(moment(m.node, f.head<2>()) + moment(m.pose.position, f.segment<2>(2)) + f[4]) < 1e-13);
  CHECK(f[5] == 0);
}
void check_balance(Meeting<3> const& m, Vector const& f) {
  CHECK((f.head<3>() + f.segment<3>(3)).norm() < 1e-14);
  Vec3 const here = f.head<3>(), there = f.segment<3>(3), own = f.tail<3>();
  CHECK((m.node.cross(here) + m.pose.position.cross(there) + own).norm() < 1e-13);
}

template<int D> void check_free(Encounter<D> const& met) {
  Meeting<D> const m(met);
  Vector const here = Vector::Zero(3 * D);
  auto const at = m.kinematics_at(here);
  REQUIRE(at.found);
  CHECK(at.count == 3);
  CHECK(at.nodes[1] == 0);
  CHECK(at.nodes[2] == 1);
  auto const gap_and_slip = [&](Vector const& move) {
    auto const seen = m.kinematics_at(move);
    Vector both(D);
    both << seen.gap, seen.slip;
    return both;
  };
  check_rate(rate(gap_and_slip, Dense(at.H), here, 1e-3, 4), "H");
  Local<D> const force = Local<D>::LinSpaced(2, -0.7);
  auto const nodal = [&](Vector const& move) { return Vector(m.kinematics_at(move).H.transpose() * force); };
  Dense const K = geometric_stiffness<D>(m.posed(here), at, with<D>(m.node), force);
  check_rate(rate(nodal, K, here, 1e-3, 4), "stiffness");
  check_balance(m, nodal(here));
  check_motion(m);
}

template<int D> void check_objectivity(Encounter<D> const& met) {
  Vec<D> const from = met.point + Vec<D>::LinSpaced(0.1, -0.2);
  auto const pose = some_pose<D>();
  auto const carried_point = [&](Pose<D> const& p, Vec<D> const& X) -> Vec<D> {
    return p.position + p.rotation * (X - p.pivot);
  };
  auto const kinematics_at = [&](Pose<D> const& p, Vec<D> const& X, Foot start) {
    PosedObstacle<D> const obstacle{&met.shape, p, {1, 0.2, -0.3}};
    return kinematics(obstacle, 2, start, {}, with<D>(carried_point(p, X)));
  };
  auto const still = kinematics_at({}, met.point, kinematics_at({}, from, {}).foot);
  auto const carried = kinematics_at(pose, met.point, kinematics_at(pose, from, {}).foot);
  CHECK(carried.count == 1);
  CHECK(carried.gap == doctest::Approx(still.gap).epsilon(1e-12));
  CHECK((carried.slip - still.slip).norm() < 1e-12);
  CHECK(still.slip.norm() > 1e-3);
  CHECK((carried.frame - pose.rotation * still.frame).norm() < 1e-12);
  CHECK((carried.H - still.H * pose.rotation.transpose()).norm() < 1e-12);
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("carrying an obstacle and the point with it changes neither gap nor slip") {
    for (auto const& met : encounters(std::integral_constant<int, 2>{}))
      check_objectivity(met);
    for (auto const& met : encounters(std::integral_constant<int, 3>{}))
      check_objectivity(met);
  }

  TEST_CASE("a free body feels the opposite of the node's force, and the stiffness of both is a derivative") {
    for (auto const& met : encounters(std::integral_constant<int, 2>{}))
      check_free(met);
    for (auto const& met : encounters(std::integral_constant<int, 3>{}))
      check_free(met);
  }
}
