// All that a step reads: bodies, pairs, motions, loads, scheme and solver settings.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contact/curve.hpp"
#include "contact/obstacle.hpp"
#include "contact/solver.hpp"
#include "dynamics/path.hpp"
#include "dynamics/scheme.hpp"
#include "interface/law.hpp"
#include "solid/cells.hpp"

namespace stiction::dynamics {

using contact::Vec2;

/// A displacement component of some nodes driven along a path.
struct Motion {
  Indices nodes; ///< model numbers
  int component = 0;
  Path path; ///< m
};

/// A rigid obstacle carried along a path.
struct MovingObstacle {
  contact::Obstacle shape;
  Path x, y; ///< m, relative to the described place
  [[nodiscard]] Vec2 offset(double t) const { return {x.value(t), y.value(t)}; }
};

/// A secondary surface, its primary counterpart and the law between them.
struct Pair {
  std::string name;
  Indices secondary;         ///< model nodes, in walking order
  std::vector<double> areas; ///< tributary reference areas, m^2 (m in plane strain)
  std::variant<contact::Curve, MovingObstacle> primary;
  interface::Law law;
  double reach = 0; ///< points farther than this are left out of the contact problem, m
  [[nodiscard]] Index size() const { return static_cast<Index>(secondary.size()); }
};

/// When a step counts as converged and how far it may go.
struct StepControl {
  double force_tolerance = 1e-7; ///< out-of-balance force over the largest nodal force
  int iterations = 20;           ///< Newton iterations at most
  [[nodiscard]] static core::Schema const& schema();
};

struct Model {
  solid::Kinematics kinematics = solid::Kinematics::plane_strain;
  std::vector<std::unique_ptr<solid::Body>> bodies; ///< addresses stay: Cells point to them
  std::vector<solid::Cells> cells;                  ///< [bodies]
  std::vector<Index> first_node;                    ///< [bodies + 1], model number of each body's first node
  Matrix reference;                                 ///< [nodes, 2], m
  Matrix velocity;                                  ///< [nodes, 2], initial, m/s
  Vec2 gravity = Vec2::Zero();                      ///< m/s^2
  std::vector<Motion> motions;
  std::vector<Pair> pairs;
  Scheme scheme;
  contact::SolverChoice solver;
  StepControl control;
  [[nodiscard]] Index node_count() const { return static_cast<Index>(reference.rows()); }
};

} // namespace stiction::dynamics
