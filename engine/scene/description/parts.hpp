// The tables a script makes, as structs with their schemas; what they mean is decided in build.cpp.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "contact/obstacle/obstacle.hpp"
#include "contact/solvers/solver.hpp"
#include "core/reader.hpp"
#include "dynamics/adaptivity/accuracy.hpp"
#include "dynamics/scheme/scheme.hpp"
#include "dynamics/step/stepper.hpp"
#include "halfspace/shapes.hpp"
#include "interface/law.hpp"
#include "material/material.hpp"
#include "mesh/source/source.hpp"

namespace stiction::scene {

using contact::Vec3;
using core::Numbers;

/// The numbers of a list as a vector in space; missing ones are 0.
[[nodiscard]] Vec3 vec(Numbers const& numbers);
/// Angular velocity: one number turns in the plane.
[[nodiscard]] Vec3 spin_of(Numbers const& numbers);

/// A body's mesh made anew until it is fine enough.
struct RemeshPart {
  double target = 0.05;      ///< error of the stress, relative
  int passes = 5;            ///< meshes at most
  double cohesive_cells = 3; ///< over the cohesive length, on surfaces that adhere
  double smallest = 0;       ///< m
  static core::Schema const& schema();
};

/// Heights from which a plane boundary of a body stands back; their plane is the boundary's.
struct ReliefPart : contact::RigidHeights {
  std::string set;          ///< the boundary
  halfspace::Shape surface; ///< makes `heights`
  double depth = 0;         ///< m, below which nodes stay; 0: the far side of the body
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};

struct BodyPart {
  mesh::Generator mesh;
  material::Material material;                           ///< where there is one for all cells
  std::map<std::string, material::Material> laws_by_set; ///< by set of cells; empty: `material` everywhere
  double density = 0;                                    ///< kg/m^3
  Numbers velocity;                                      ///< m/s; empty: at rest
  Numbers spin;              ///< rad/s, about the centre of mass: one number in 2D, three in 3D; empty: none
  Numbers velocity_gradient; ///< 1/s, about the centre of mass: dim rows of dim numbers; empty: none
  solid::Interpolation interpolation = solid::Interpolation::plain;
  bool plane_stress = false; ///< in a plane scene: a thin sheet
  std::optional<material::KelvinVoigt> damping;
  std::vector<material::PronyTerm> relaxing;              ///< empty: it does not
  std::optional<RemeshPart> remesh;                       ///< only with mesh.gmsh
  std::optional<ReliefPart> relief;                       ///< none: boundaries are those of the mesh
  std::map<std::string, std::vector<std::string>> joined; ///< new sets, by the names of those they are of
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);

private:
  void read_relaxing(core::Reader& reader);
  void read_joined(core::Reader& reader);
};

enum class Boundary { periodic, free };

/// A body that is nothing but the elastic surface of a half space: its points are a regular grid.
struct HalfSpacePart {
  double young = 0, poisson = 0; ///< Pa, 1
  Numbers size, points;          ///< m, 1: {x [, y]}
  Boundary boundary = Boundary::periodic;
  double depth = 0; ///< m
  static core::Schema const& schema();
};

/// What is pressed onto a half space: heights, on a rigid body or on another half space.
struct HeightMapPart {
  halfspace::Shape surface;
  double young = 0, poisson = 0; ///< Pa, 1; young = 0: rigid
  Numbers times, x, y, z;        ///< s, m: of its displacement
  Numbers force;                 ///< N, at those times, in place of z
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};

/// A rigid obstacle and where it goes: along paths, or, with a mass, where the forces take it.
struct ObstaclePart {
  contact::Obstacle shape;
  std::optional<halfspace::Shape> surface; ///< of a height map
  Numbers times, x, y, z, angle;           ///< s, m, m, m, rad
  Numbers pivot, axis;                     ///< m; 1
  double mass = 0, inertia = 0;            ///< kg, kg m^2 (per metre of depth in plane strain)
  Numbers inertia_tensor;  ///< kg m^2: {xx, yy, zz} or {xx, yy, zz, xy, yz, zx}; empty: `inertia`
  Numbers velocity, force; ///< m/s, N; empty: none
  Numbers spin;            ///< rad/s: about the pivot, one number in 2D, three in 3D
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};

/// Where the gap is measured: at the secondary's nodes, or averaged around them over facets.
enum class Discretisation { node_to_segment, mortar };

struct PairPart {
  std::string secondary, primary; ///< "body.set", or the name of an obstacle
  Discretisation discretisation = Discretisation::node_to_segment;
  contact::Smoothing smoothing = contact::Smoothing::spline;
  double reach = 0;  ///< m; 0: half a facet
  Numbers direction; ///< t1 is its part along the primary surface (3D); empty: the engine's choice
  interface::Law law;
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};

/// Displacements of a set along a path; a component without values stays free.
struct DrivePart {
  std::string set;
  Numbers near; ///< m; empty: all nodes of the set
  Numbers times, x, y, z;
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};
/// A set held where it is.
struct FixPart {
  std::string set;
  Numbers near; ///< m; empty: all nodes of the set
  bool x = true, y = true, z = true;
  void read_nested(core::Reader& reader); ///< where any is named true, those not named are free
  static core::Schema const& schema();
};
/// A set that turns as a rigid body about an axis, which may be carried along.
struct TurnPart {
  std::string set;
  Numbers near;                  ///< m; empty: all nodes of the set
  Numbers times, angle, x, y, z; ///< s, rad, m, m, m
  Numbers centre, axis;          ///< m; 1
  [[nodiscard]] Vec3 direction() const { return axis.empty() ? Vec3::UnitZ() : vec(axis).normalized(); }
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};
using MotionPart = std::variant<DrivePart, FixPart, TurnPart>;
[[nodiscard]] std::string const& set_of(MotionPart const& motion);

/// A set that stays in the plane across `normal` that each of its nodes is in.
struct RollerPart {
  std::string set;
  Numbers normal; ///< 1, of any length
  static core::Schema const& schema();
};
/// A set whose nodes move as those of another set, where that has been shifted.
struct PeriodicPart {
  std::string set, to;
  static core::Schema const& schema();
};
/// A surface that follows another one whose nodes lie elsewhere.
struct TiedPart {
  std::string set, to;
  static core::Schema const& schema();
};
using ConstraintPart = std::variant<RollerPart, PeriodicPart, TiedPart>;

/// Values of dead forces along times; a component without values is 0.
struct LoadPath {
  Numbers times, x, y, z;
};
/// A traction per reference area on a surface.
struct TractionPart : LoadPath {
  std::string set;
  static core::Schema const& schema();
};
/// A force at one node.
struct PointForcePart : LoadPath {
  std::string set;
  Numbers near; ///< m
  static core::Schema const& schema();
};
/// A pressure along the normal, of the deformed surface or of the first one.
struct PressurePart {
  std::string set;
  Numbers times, pressure; ///< s, Pa
  bool follows = true;
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};
/// Gas in a cavity, by its amount or by its volume.
struct GasPart {
  std::string set;
  Numbers times, pressure, volume;  ///< s, Pa, 1: over that of the start
  double outside = 0, exponent = 1; ///< Pa, 1
  Numbers centre;                   ///< m; empty: the origin
  Numbers seal;                     ///< normal of the plane that the wall stands on; empty: none
  double leaks_at = 0;              ///< m off it
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};
/// Energy per present area of a surface.
struct SurfaceStressPart {
  std::string set;
  double gamma = 0; ///< N/m
  static core::Schema const& schema();
};
using LoadPart = std::variant<TractionPart, PointForcePart, PressurePart, GasPart, SurfaceStressPart>;

/// A spring and a dashpot between two ends.
struct SpringPart {
  std::string from, to;              ///< "body.set", or the name of an obstacle; to: empty: a place
  Numbers anchor;                    ///< m; empty: where `from` is
  Numbers times, x, y, z;            ///< s, m: of the place
  double stiffness = 0, damping = 0; ///< N/m, N s/m
  dynamics::SpringAlong along = dynamics::SpringAlong::axes; ///< axes or line
  Numbers axes, direction;                                   ///< 1; empty: all axes, none
  double rest = 0;                                           ///< m
  bool rests = false;                                        ///< `rest` is given
  bool spread = false;
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};

/// A stretch of the run with equal steps.
struct StagePart {
  double until = 0; ///< s
  int steps = 0;
  static core::Schema const& schema();
};
struct SchedulePart {
  std::vector<StagePart> stages;
  int halvings = 10;  ///< the floor of the step: its nominal size / 2^halvings
  int cuts = 100;     ///< of one nominal step, after which the run ends
  double work = 40;   ///< lost on one nominal step, after which the run ends, 1e9 operations
  double seconds = 0; ///< of the machine, after which the run ends; 0: never
  std::optional<dynamics::Accuracy> accuracy; ///< none: steps are equal but for halving
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
};

struct OutputPart {
  int frames = 1;         ///< field frames per stage, its end included
  int problems_every = 0; ///< saves the contact problem of every n-th step; 0: none
  static core::Schema const& schema();
};

struct PointProbe {
  std::string pair;
  Numbers near; ///< m
  static core::Schema const& schema();
};
struct ContactProbe {
  std::string pair;
  std::string set; ///< empty: the whole secondary surface
  static core::Schema const& schema();
};
struct LineProbe {
  std::string pair;
  static core::Schema const& schema();
};
struct ForceProbe {
  std::string set;
  Numbers near;  ///< m; empty: all nodes of the set
  Numbers about; ///< m; empty: the origin
  static core::Schema const& schema();
};
struct NodeProbe {
  std::string set;
  Numbers near;
  static core::Schema const& schema();
};
struct RigidProbe {
  std::string obstacle;
  static core::Schema const& schema();
};
struct EnergyProbe {
  bool audit = false;
  static core::Schema const& schema();
};
struct SpringProbe {
  std::string spring;
  static core::Schema const& schema();
};
struct GasProbe {
  std::string set;
  static core::Schema const& schema();
};
struct MomentumProbe {
  Numbers about; ///< m; empty: the origin
  static core::Schema const& schema();
};
using ProbePart = std::variant<PointProbe, ContactProbe, LineProbe, ForceProbe, NodeProbe, RigidProbe,
                               EnergyProbe, MomentumProbe, SpringProbe, GasProbe>;

/// What answers a scene: its bodies as they are, a formula in their place, or bodies that have to be of a
/// kind.
enum class ModelKind { bodies, formula, half_space, section, space };

struct ScenePart {
  ModelKind model = ModelKind::bodies;
  solid::Kinematics kinematics = solid::Kinematics::plane_strain;
  Numbers gravity; ///< m/s^2; empty: none
  std::map<std::string, BodyPart> bodies;
  std::map<std::string, HalfSpacePart> half_spaces; ///< those of `bodies` that are
  std::map<std::string, ObstaclePart> obstacles;
  std::map<std::string, HeightMapPart> height_maps; ///< those of `obstacles` that are
  std::map<std::string, PairPart> pairs;
  std::vector<MotionPart> motions;
  std::vector<ConstraintPart> constraints;
  std::vector<LoadPart> loads;
  std::map<std::string, SpringPart> springs;
  std::map<std::string, ProbePart> probes;
  dynamics::Scheme scheme;
  contact::SolverChoice solver;
  dynamics::StepControl control;
  SchedulePart schedule;
  OutputPart output;
  static core::Schema const& schema();
  void read_nested(core::Reader& reader);
  [[nodiscard]] int dim() const { return solid::dimension(kinematics); }
};

} // namespace stiction::scene
