// Springs and dashpots between means of nodes, free rigid bodies and places that follow paths.
#pragma once
#include <Eigen/Core>
#include <array>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "dynamics/scheme/path.hpp"

namespace stiction::dynamics {

/// The mean place of some nodes, or a place that follows paths.
struct SpringEnd {
  Indices nodes;                                ///< model numbers; empty: it follows `shift`
  std::vector<double> shares;                   ///< [nodes] in the mean, of sum 1
  Eigen::Vector3d at = Eigen::Vector3d::Zero(); ///< in the reference, m
  std::array<Path, 3> shift;                    ///< displacement, m
};

/// axes: along each axis by itself; line: along the line from end to end; direction: along a fixed one.
enum class SpringAlong { axes, line, direction };

/// A linear spring with a linear dashpot beside it. Elongations are 0 at the start along axes, `stretch`
/// else.
struct Spring {
  std::string name;
  SpringEnd from, to; ///< `from` has nodes
  SpringAlong along = SpringAlong::axes;
  double stiffness = 0, damping = 0;                   ///< N/m and N s/m (in plane strain per metre of depth)
  Eigen::Vector3d axes = Eigen::Vector3d::Ones();      ///< parts of these along x, y, z
  Eigen::Vector3d direction = Eigen::Vector3d::Zero(); ///< unit; of a line: at the start
  double stretch = 0;                                  ///< elongation at the start, m
  bool spread = false; ///< each node of `from` has its share of the spring, from where it is
  [[nodiscard]] Eigen::Vector3d start() const { return to.at - from.at; }
  /// Is the force linear in displacements?
  [[nodiscard]] bool linear() const { return along != SpringAlong::line; }
};

/// What a spring does at one moment: energy E, J; force on `from`, dE by the way from end to end, N; its
/// tangent, N/m.
struct SpringPull {
  double elongation = 0, energy = 0; ///< along axes: length of the three elongations, m
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  Eigen::Matrix3d tangent = Eigen::Matrix3d::Zero();
};

/// apart: the way from `from` to `to`, m.
[[nodiscard]] SpringPull pull_of(Spring const& spring, Eigen::Vector3d const& apart);
/// C of the dashpot's force C d(apart)/dt on `from`, N s/m.
[[nodiscard]] Eigen::Matrix3d drag_of(Spring const& spring, Eigen::Vector3d const& apart);

} // namespace stiction::dynamics
