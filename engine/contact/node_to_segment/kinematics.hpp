// Node-to-segment kinematics of one contact point: gap, slip, their rows of H and the geometric stiffness.
#pragma once
#include "contact/obstacle/obstacle.hpp"
#include "contact/surface/curve.hpp"
#include "contact/surface/search.hpp"
#include "contact/surface/surface.hpp"
#include "interface/cone.hpp"

namespace stiction::contact {

using interface::Local;

/// H of one point, row by row (n, t1 [, t2]) over (x, y [, z]) of its nodes: d(gap, slip) = H . du. [D, D
/// count]
template<int D> using Rows = Eigen::Matrix<double, D, Eigen::Dynamic>;
/// Most rows of a Block held without allocation; in 3D they would not fit the stack.
template<int D> inline constexpr int block_rows = D == 2 ? D* max_nodes<D> : Eigen::Dynamic;
/// A matrix over the unknowns of one point. [D count, D count]
template<int D>
using Block =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::ColMajor, block_rows<D>, block_rows<D>>;

/// Gap and slip of one point at the current positions.
template<int D> struct PointKinematics {
  bool found = false;
  Foot foot;                                ///< counterpart P2
  double gap = 0;                           ///< x_n, m
  Local<D - 1> slip = Local<D - 1>::Zero(); ///< s over the step, m: path of P2 along the surface, (t1 [, t2])
  Mat<D> frame = Mat<D>::Zero(); ///< columns n, t1 [, t2]: unit normal of the primary at P2, tangents; (t1,
                                 ///< n) or (t1, t2, n) right-handed
  double spin = 0; ///< of P2's material about n, against a mortar point's frame since the step's start, rad
  Indices nodes;   ///< model nodes behind the columns of H, [count]
  int count = 0;
  Rows<D> H;
  [[nodiscard]] int unknowns() const { return D * count; }
  [[nodiscard]] Vec<D> normal() const { return frame.col(0); }
};

/// Against a deformable curve. `start`: foot at the step's start, or not found if there was none (slip 0).
[[nodiscard]] PointKinematics<2> kinematics(Curve const& curve, Index node, Foot start, Foot guess,
                                            std::span<double const> x);
/// f_n d2(x_n)/du2 + f_t d2(s)/du2: what turning and sliding of the counterpart adds to the stiffness, N/m.
[[nodiscard]] Block<2> geometric_stiffness(Curve const& curve, PointKinematics<2> const& point,
                                           std::span<double const> x, Vec2 const& force_nt);

/// With a search for new feet, which also knows the node's own part of a curve that may touch itself.
[[nodiscard]] PointKinematics<2> kinematics(Search<2> const& search, Index node, Start const& start,
                                            Foot guess, std::span<double const> x);

/// Against a deformable surface; slip is the way of P2 along it (SurfacePath), from x2(start) to x2(foot),
/// both at the present positions, in the frame at its end. The rows of H are those of the forces: they
/// balance forces and moments and are blind to rigid motions. Columns of the nodes beyond the facet's are
/// zero in the row of the gap; those of the slip hold the couple of a force across an open gap, which the
/// nodes that make the nodal normals carry. Where the way is short and the field of normals is that of the
/// facet H is the derivative of gap and slip, elsewhere `motion_rows` is.
[[nodiscard]] PointKinematics<3> kinematics(Surface const& surface, Index node, Foot start, Foot guess,
                                            std::span<double const> x);
[[nodiscard]] PointKinematics<3> kinematics(Search<3> const& search, Index node, Start const& start,
                                            Foot guess, std::span<double const> x);
/// The derivative of gap and slip by the positions of all nodes that they depend on, those of the point
/// first.
struct MotionRows {
  Indices nodes;
  Rows<3> by_x; ///< [3, 3 nodes]; 1
};
[[nodiscard]] MotionRows motion_rows(Surface const& surface, PointKinematics<3> const& point, Foot start,
                                     std::span<double const> x);
/// Derivative of H^T force at fixed force (n, t1, t2) by the positions of all nodes of the point, N/m.
[[nodiscard]] Block<3> geometric_stiffness(Surface const& surface, PointKinematics<3> const& point,
                                           std::span<double const> x, Vec3 const& force_ntt);

/// Where an obstacle is: the material point X of its description lies at position + rotation (X - pivot).
template<int D> struct Pose {
  Vec<D> pivot = Vec<D>::Zero(), position = Vec<D>::Zero(); ///< m
  Mat<D> rotation = Mat<D>::Identity();
  /// Of a free body: the nodes whose unknowns are its translation and its turn (in 2D the first component);
  /// -1 if the obstacle follows a path.
  Index translation = -1, turn = -1;
  [[nodiscard]] bool free() const { return translation >= 0; }
  [[nodiscard]] Vec<D> local(Vec<D> const& x) const { return pivot + rotation.transpose() * (x - position); }
};

/// An obstacle at its pose; direction as in view(), in the obstacle's frame.
template<int D> struct PosedObstacle {
  Obstacle const* shape = nullptr;
  Pose<D> pose;
  Vec3 direction = Vec3::UnitX();
};

/// Against an obstacle; the force on a free body acts where the node is, so that moments balance.
template<int D>
[[nodiscard]] PointKinematics<D> kinematics(PosedObstacle<D> const& obstacle, Index node, Start const& start,
                                            Foot guess, std::span<double const> x);
/// The derivative of gap and slip by the positions of the point's nodes, [3, 3 count]; H are the rows of the
/// forces.
[[nodiscard]] Rows<3> motion_rows(PosedObstacle<3> const& obstacle, PointKinematics<3> const& point,
                                  Start const& start, std::span<double const> x);
template<int D>
[[nodiscard]] Block<D> geometric_stiffness(PosedObstacle<D> const& obstacle, PointKinematics<D> const& point,
                                           std::span<double const> x, Local<D> const& force);

} // namespace stiction::contact
