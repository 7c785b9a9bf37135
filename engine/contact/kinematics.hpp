// Node-to-segment kinematics of one contact point: gap, slip, their rows of H and the geometric stiffness.
#pragma once
#include "contact/curve.hpp"
#include "contact/obstacle.hpp"

namespace stiction::contact {

/// Unknowns of one point: (x, y) of the secondary node, then of up to four primary nodes.
using Row = Eigen::Matrix<double, 10, 1>;
using Block = Eigen::Matrix<double, 10, 10>;

/// Gap and slip of one point at the current positions, with H row by row: dx_n = normal . du, ds = tangential
/// . du.
struct PointKinematics {
  bool found = false;
  Foot foot;       ///< counterpart P2; for obstacles xi is the material coordinate, m
  double gap = 0;  ///< x_n, m
  double slip = 0; ///< s over the step, m: path of P2 along the surface since the step's start
  Vec2 n = Vec2::Zero(), t = Vec2::Zero(); ///< unit normal of the primary at P2, tangent; (t, n) right-handed
  std::array<Index, 5> nodes{};            ///< model nodes behind Row, [count]
  int count = 1;
  Row normal = Row::Zero(), tangential = Row::Zero();
  [[nodiscard]] int unknowns() const { return 2 * count; }
};

/// Against a deformable curve. `start`: foot at the step's start, or not found if there was none (slip 0).
[[nodiscard]] PointKinematics kinematics(Curve const& curve, Index node, Foot start, Foot guess,
                                         std::span<double const> x);
/// f_n d2(x_n)/du2 + f_t d2(s)/du2: what turning and sliding of the counterpart adds to the stiffness, N/m.
[[nodiscard]] Block geometric_stiffness(Curve const& curve, PointKinematics const& point,
                                        std::span<double const> x, Vec2 const& force_nt);

/// Against an obstacle displaced by `offset`; start.xi is the coordinate at the step's start.
[[nodiscard]] PointKinematics kinematics(Obstacle const& obstacle, Index node, Foot start,
                                         std::span<double const> x, Vec2 const& offset);
[[nodiscard]] Block geometric_stiffness(Obstacle const& obstacle, PointKinematics const& point,
                                        std::span<double const> x, Vec2 const& offset, Vec2 const& force_nt);

} // namespace stiction::contact
