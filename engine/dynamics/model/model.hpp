// All that a step reads: bodies, pairs, motions, loads, springs, scheme and solver settings.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "contact/mortar/mortar.hpp"
#include "contact/solvers/solver.hpp"
#include "dynamics/model/link.hpp"
#include "dynamics/model/motion.hpp"
#include "dynamics/model/share.hpp"
#include "dynamics/model/spring.hpp"
#include "dynamics/model/surface_load.hpp"
#include "dynamics/scheme/path.hpp"
#include "dynamics/scheme/scheme.hpp"
#include "interface/law.hpp"
#include "mesh/topology/hats.hpp"
#include "solid/cells.hpp"

namespace stiction::dynamics {

using contact::Vec2;
using contact::Vec3;

/// Dead nodal forces that follow a path.
struct Load {
  Vector force; ///< per unit of the path, [degrees of freedom], N
  Path path;
};

/// A rigid obstacle, carried along its paths or free. In 2D third components are unused.
struct RigidBody {
  std::string name;
  contact::Obstacle shape;
  Vec3 pivot = Vec3::Zero(); ///< point that the paths move and the body turns about, m
  std::array<Path, 3> shift; ///< of an obstacle that is not free: displacement, m
  Path angle;                ///< of an obstacle that is not free: turn about `axis`, rad
  Vec3 axis = Vec3::UnitZ(); ///< unit
  double mass = 0;           ///< kg (kg/m in plane strain); > 0: free, with unknowns of its own
  double inertia = 0; ///< of a free body about its pivot, the same about every axis, kg m^2; 0: never turns
  /// Of a free body in space, about its pivot at the start, kg m^2; `inertia` is then a third of its trace.
  /// Zero: `inertia` is all.
  Eigen::Matrix3d tensor = Eigen::Matrix3d::Zero();
  Vec3 force = Vec3::Zero(); ///< constant load on a free body, N
  Index node = -1;           ///< of a free body: model node of its translation; node + 1 is its turn
  [[nodiscard]] bool free() const { return node >= 0; }
  /// In space: the first degree of freedom of the turn.
  [[nodiscard]] Index turn() const { return 3 * (node + 1); }
  /// Displacement of an obstacle that is not free.
  [[nodiscard]] Vec3 offset(double t) const {
    return {shift[0].value(t), shift[1].value(t), shift[2].value(t)};
  }
  /// Of its material point that is at x at time t, on the stretch of the paths that ends there, m/s.
  [[nodiscard]] Vec3 velocity(Vec3 const& x, double t) const {
    Vec3 const turn = angle.rate_before(t) * axis, arm = x - pivot - offset(t);
    return Vec3(shift[0].rate_before(t), shift[1].rate_before(t), shift[2].rate_before(t)) + turn.cross(arm);
  }
};

/// A primary that is one of the model's rigid bodies.
struct RigidSide {
  std::size_t body = 0;
  Vec3 direction = Vec3::UnitX(); ///< t1 is its part along the surface (3D)
};

/// A secondary surface, its primary counterpart and the law between them.
struct Pair {
  std::string name;
  Indices secondary;         ///< model nodes of the contact points, in walking order
  std::vector<double> areas; ///< tributary reference areas, m^2 (m in plane strain)
  /// Cell facets for mortar, else a curve or a surface.
  std::variant<contact::Curve, contact::Surface, RigidSide, contact::CellSurface> primary;
  interface::Law law;
  double reach = 0;  ///< points farther than this are left out of the contact problem, m
  bool self = false; ///< secondary and primary are the same curve (2D)
  std::optional<contact::CellSurface> mortar = {}; ///< the secondary of a mortar pair; none: node to segment
  /// Of a pair of node to segment whose points are means over its nodes, [points]; empty: each is its node.
  std::vector<std::vector<mesh::NodeShare>> means = {};
  [[nodiscard]] Index size() const { return static_cast<Index>(secondary.size()); }
  /// Forces of a point may act on other nodes than its own.
  [[nodiscard]] bool shared() const { return mortar || !means.empty(); }
  /// All nodes that may bear a force of the pair on its secondary side.
  [[nodiscard]] Indices const& nodes() const { return mortar ? mortar->nodes() : secondary; }
};

/// How the bodies' matrix is solved with; automatic: by its size.
enum class BulkSolver { automatic, direct, multigrid };

/// When a step counts as converged, how far it may go, and how its linear systems are solved.
struct StepControl {
  double force_tolerance = 1e-7; ///< out-of-balance force over the largest nodal force
  int iterations = 20;           ///< Newton iterations at most
  BulkSolver bulk = BulkSolver::automatic;
  [[nodiscard]] static core::Schema const& schema();
};

struct Model {
  solid::Kinematics kinematics = solid::Kinematics::plane_strain;
  std::vector<std::unique_ptr<solid::Body>> bodies; ///< addresses stay: Cells point to them
  std::vector<solid::Cells> cells;                  ///< [bodies]
  std::vector<Index> first_node;                    ///< [bodies + 1], model number of each body's first node
  std::vector<RigidBody> rigids;
  /// [nodes, dim], m. After the bodies' nodes come two for each free rigid body: its pivot, and the origin
  /// for its turn.
  Matrix reference;
  Matrix velocity;             ///< [nodes, dim], initial, m/s
  Vec3 gravity = Vec3::Zero(); ///< m/s^2
  std::vector<Motion> motions;
  std::vector<Load> loads;
  std::vector<Spring> springs;
  std::vector<Pressure> pressures;
  std::vector<Gas> gases;
  std::vector<SurfaceStress> surface_stresses;
  std::vector<Link> links;
  std::vector<Pair> pairs;
  Scheme scheme;
  contact::SolverChoice solver;
  StepControl control;
  std::optional<Share> share = {}; ///< of the bodies among the ranks of a case; none: one process has it all
  bool held_by_bonds = false;      ///< quasi-static: motions alone do not hold every body, intact bonds do
  bool tallied = false;            ///< momenta and impulses are kept
  bool audited = false; ///< the ledger predicts the scheme's loss: a force pass per step where not linear
  [[nodiscard]] Index node_count() const { return static_cast<Index>(reference.rows()); }
  [[nodiscard]] int dim() const { return solid::dimension(kinematics); }
  [[nodiscard]] Index dofs() const { return dim() * node_count(); }
};

/// The cells of a body: those of this process's share.
[[nodiscard]] solid::Cells cells_of(Model const& model, std::size_t body);

/// What a turn counts for as a way, and a moment as a force: the radius of gyration of free rigid bodies, m,
/// and 1 for displacements, [degrees of freedom]; empty where nothing turns freely.
[[nodiscard]] Vector arms(Model const& model);

/// Puts a free rigid body's two nodes at the end of the model; holds the components that it has not.
void add_unknowns(Model& model, RigidBody& rigid, Vec3 const& velocity, Vec3 const& spin);

} // namespace stiction::dynamics
