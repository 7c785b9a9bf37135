// Kinematics against rigid obstacles, carried along a path or free.
#include <Eigen/Geometry>

#include "contact/node_to_segment/kinematics.hpp"

namespace stiction::contact {

namespace {

template<int D> Vec<D> node_position(std::span<double const> x, Index node) {
  return Eigen::Map<Vec<D> const>(&x[ix(D * node)]);
}

/// a x: the derivative of a turn's motion by its angle, in the plane and in space. Columns beyond the plane's
/// one angle are zero.
template<int D> Mat<D> cross(Vec<D> const& a) {
  Mat<D> A = Mat<D>::Zero();
  if constexpr (D == 2)
    A.col(0) = Vec2(a.y(), -a.x()); // a x e_z
  else
    A << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return A;
}

/// Motion of the node relative to the body's material there, by the unknowns of (node, position, turn).
template<int D> Rows<D> relative(Pose<D> const& pose, Vec<D> const& arm) {
  Rows<D> B(D, pose.free() ? 3 * D : D);
  B.template leftCols<D>().setIdentity();
  if (pose.free()) {
    B.template middleCols<D>(D) = -Mat<D>::Identity();
    B.template rightCols<D>() = cross<D>(arm); // - dphi x arm
  }
  return B;
}

} // namespace

template<int D>
PointKinematics<D> kinematics(PosedObstacle<D> const& obstacle, Index node, Start const& start, Foot guess,
                              std::span<double const> x) {
  auto const& pose = obstacle.pose;
  Vec<D> const p1 = node_position<D>(x, node);
  auto const seen = view<D>(*obstacle.shape, pose.local(p1), start, guess, obstacle.direction);
  PointKinematics<D> point;
  point.found = seen.found;
  point.foot = seen.foot;
  if (!seen.found)
    return point;
  point.gap = seen.gap;
  point.slip = seen.slip;
  point.frame = pose.rotation * seen.frame;
  point.nodes = pose.free() ? Indices{node, pose.translation, pose.turn} : Indices{node};
  point.count = static_cast<int>(point.nodes.size());
  point.H = (seen.by_x * pose.rotation.transpose()).eval() * relative(pose, Vec<D>(p1 - pose.position));
  return point;
}

Rows<3> motion_rows(PosedObstacle<3> const& obstacle, PointKinematics<3> const& point, Start const& start,
                    std::span<double const> x) {
  auto const& pose = obstacle.pose;
  Vec3 const p1 = node_position<3>(x, point.nodes[0]);
  Mat<3> const by_x = motion_by_x(*obstacle.shape, point.foot, pose.local(p1), start, obstacle.direction);
  return (by_x * pose.rotation.transpose()).eval() * relative(pose, Vec3(p1 - pose.position));
}

template<int D>
Block<D> geometric_stiffness(PosedObstacle<D> const& obstacle, PointKinematics<D> const& point,
                             std::span<double const> x, Local<D> const& force) {
  auto const& pose = obstacle.pose;
  Mat<D> const& R = pose.rotation;
  Vec<D> const p1 = node_position<D>(x, point.nodes[0]), local = pose.local(p1);
  Mat<D> const turned =
      R * curvature_stiffness<D>(*obstacle.shape, point.foot, local, force, obstacle.direction) *
      R.transpose();
  auto const B = relative(pose, Vec<D>(p1 - pose.position));
  Block<D> K = B.transpose() * turned * B;
  if (!pose.free())
    return K;
  // f turns with the body, and so does the arm of its moment
  Vec<D> const f = point.H.template leftCols<D>().transpose() * force;
  Mat<D> const by_turn = -cross<D>(f); // dphi x f
  K.template rightCols<D>() += B.transpose() * by_turn;
  K.template block<D, D>(2 * D, 0) += by_turn.transpose();
  K.template block<D, D>(2 * D, D) -= by_turn.transpose();
  return K;
}

template PointKinematics<2> kinematics(PosedObstacle<2> const&, Index, Start const&, Foot,
                                       std::span<double const>);
template Block<2> geometric_stiffness(PosedObstacle<2> const&, PointKinematics<2> const&,
                                      std::span<double const>, Local<2> const&);
template PointKinematics<3> kinematics(PosedObstacle<3> const&, Index, Start const&, Foot,
                                       std::span<double const>);
template Block<3> geometric_stiffness(PosedObstacle<3> const&, PointKinematics<3> const&,
                                      std::span<double const>, Local<3> const&);

} // namespace stiction::contact
