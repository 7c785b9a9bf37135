// What follows from a scene without running it: sizes, speeds, stiffnesses; lines and warnings are made of
// them.
#pragma once
#include <algorithm>
#include <cmath>

#include "dynamics/step/stepper.hpp"
#include "scene/build/fit.hpp"
#include "scene/explain/explain.hpp"

namespace stiction::scene {

struct BodyFacts {
  solid::Body const* body = nullptr;
  material::Moduli moduli;    ///< at rest
  double mass = 0;            ///< kg (kg/m in plane strain)
  Vec3 centre = Vec3::Zero(); ///< of its mass, m
  Vec3 sides = Vec3::Zero();  ///< of the bounding box, m
  double smallest_edge = 0;   ///< m
  double start_speed = 0;     ///< largest initial velocity, m/s
  Index free = 0, driven = 0; ///< degrees of freedom
  std::array<bool, 3> held{}; ///< is any node driven or held in x, y, z?
  std::string driven_set;     ///< of a motion.drive on it; empty: none
  [[nodiscard]] double extent() const { return sides.maxCoeff(); }
  /// E / (1 - nu^2), Pa.
  [[nodiscard]] double plane_modulus() const { return moduli.young / (1 - moduli.poisson * moduli.poisson); }
  /// sqrt(G / rho), m/s.
  [[nodiscard]] double shear_speed() const { return std::sqrt(moduli.shear() / body->density); }
  /// sqrt((lambda + 2 G) / rho), m/s.
  [[nodiscard]] double pressure_speed() const {
    return std::sqrt((moduli.lame() + 2 * moduli.shear()) / body->density);
  }
};

/// How the two sides of a pair are moved against each other, as far as paths and initial velocities say:
/// compliance is left out.
struct RelativeMotion {
  double closing = 0, opening = 0, sliding = 0;                ///< largest speeds, m/s
  double closing_step = 0, opening_step = 0, sliding_step = 0; ///< largest way of one step, m
  std::size_t opening_stage = 0, sliding_stage = 0, closing_stage = 0;
  double depth = 0;       ///< largest approach beyond the first touch, m; 0: none, or not known
  double closed_time = 0; ///< how long it lies beyond the first touch, s; 0: not known
  double travel = 0;      ///< largest way along the surface from the start, m
  bool beside = false;    ///< they take hold beside the bonds, which then open one after the other
  bool forced = false;    ///< springs, loads, gravity or a free obstacle move the sides as well
  bool unknown = false;   ///< a side moves freely or closes around: depth and travel do not say all
  [[nodiscard]] double normal_speed() const { return std::max(closing, opening); }
};

struct PairFacts {
  dynamics::Pair const* pair = nullptr;
  PairPart const* part = nullptr;
  std::size_t secondary = 0;          ///< body
  std::optional<std::size_t> primary; ///< body; nothing: an obstacle
  std::size_t rigid = 0;              ///< obstacle, where there is no primary body
  int facets = 0;                     ///< of the primary
  double modulus = 0;                 ///< E* = 1 / sum (1 - nu^2) / E, Pa
  double column = 0;                  ///< 1 / sum thickness / E along the normal, Pa/m
  double bending = 0;                 ///< of what bends 1 / sum (1 - nu^2) / (E thickness^3), N m
  double size = 0, primary_size = 0;  ///< of facets where the surfaces are nearest, and mean, m; 0: rigid
  double gap = -1;                    ///< smallest at the start, m; < 0: beyond the search
  double overlap = 0;                 ///< at the start, m
  double bond = 0;                    ///< most whole bond at the start, 1
  double radius = 0;                  ///< 1 / sum of curvatures, m; 0: flat or not known
  Vec3 normal = Vec3::Zero();         ///< mean of the secondary, outward; 0: it closes around
  double alike = 0; ///< of the mean outward normals of both sides, 1: they look the same way
  ShapeFit secondary_fit, primary_fit; ///< of deformable sides
  double tension = 0;                  ///< surface stress of the secondary, N/m
  std::array<double, 2> strain{};      ///< expected in the secondary and the primary body, 1
  RelativeMotion motion;
  /// Over which bonds fail, m: thick bodies' E* w / sigma0^2, of slender ones that bend (bending w /
  /// sigma0^2)^(1/4) where that is less (Yang and Cox 2005).
  [[nodiscard]] double thick_length() const {
    auto const scales = interface::scales(*pair->law.adhesion);
    return modulus * scales.work / (scales.strength * scales.strength);
  }
  [[nodiscard]] double elastic_length() const {
    return std::min(thick_length(), std::sqrt(std::sqrt(thick_length() * bending / modulus)));
  }
  /// The same, or stretched surfaces' sqrt(tension u0 / sigma0) where that is more.
  [[nodiscard]] double cohesive_length() const {
    auto const scales = interface::scales(*pair->law.adhesion);
    return std::max(elastic_length(), std::sqrt(tension * scales.opening / scales.strength));
  }
  /// (R w^2 / E*^2)^(1/3) sigma0 / w, of balls.
  [[nodiscard]] double tabor() const {
    auto const scales = interface::scales(*pair->law.adhesion);
    return std::cbrt(radius * scales.work * scales.work / (modulus * modulus)) * scales.strength /
           scales.work;
  }
  /// Will there be no bond at all, as none is left at the start and the law makes none?
  [[nodiscard]] bool bondless() const {
    return pair->law.lasts() && !interface::grows(*pair->law.adhesion) && bond < interface::least_beta;
  }
  /// Does any adhesion act along the normal?
  [[nodiscard]] bool adheres() const {
    return pair->law.adhesion && interface::scales(*pair->law.adhesion).work > 0 &&
           interface::scales(*pair->law.adhesion).strength > 0;
  }
};

struct Facts {
  Scene const* scene = nullptr;
  std::vector<BodyFacts> bodies;
  std::vector<PairFacts> pairs;
  int components = 2;                         ///< of the contact problem, per point
  double end = 0;                             ///< s
  double shortest_step = 0, longest_step = 0; ///< s
  double unseen_step = 0;                     ///< that a run without inertia may take where bodies relax, s
  long steps = 0;
  double speed = 0; ///< largest that motions, obstacles and initial velocities give, m/s
  [[nodiscard]] bool dynamic() const { return dynamics::weights(scene->model->scheme).inertia; }
};

/// start: the stepper's state at t = 0.
[[nodiscard]] Facts facts_of(Scene const& scene, dynamics::State const& start);
/// Of the body that a set "body.set" is of, which is there.
[[nodiscard]] BodyFacts const& body_of(Facts const& all, std::string const& set);
/// As a script says it, with the same moduli at rest.
[[nodiscard]] std::string law_of_large_strains(BodyFacts const& facts);
[[nodiscard]] PairFacts pair_facts(Facts const& facts, std::size_t pair, dynamics::State const& start);

/// Is the body one of a pair's two sides?
[[nodiscard]] inline bool is_side(Facts const& facts, PairFacts const& pair, BodyFacts const& body) {
  return &facts.bodies[pair.secondary] == &body || (pair.primary && &facts.bodies[*pair.primary] == &body);
}

/// A line of words alone.
void add(Section& section, std::string name, std::string words);
/// explain_scene.cpp: what the scene models.
void describe_scene(Facts const& facts, Explanation& explanation);
/// explain_loads.cpp: loads, one by one.
void describe_loads(Facts const& facts, Explanation& explanation);
/// explain_springs.cpp: springs, one by one; those that cost much or swing faster than the steps.
void describe_springs(Facts const& facts, Explanation& explanation);
void warn_of_springs(Facts const& facts, std::vector<Warning>& warnings);
/// explain_numbers.cpp: the numbers that decide.
void describe_numbers(Facts const& facts, Explanation& explanation);
/// explain_reach.cpp: whether a half space would do, where that can be said.
void add_half_space(Facts const& facts, PairFacts const& pair, Section& section);
/// explain_warnings.cpp: of its stiffness at rest against compression by this strain, sides held.
[[nodiscard]] double kept_stiffness(material::Material const& law, double strain);
/// explain_bonds.cpp: what bonds ask of cells and steps of a pair that has a law of adhesion.
void warn_of_bonds(Facts const& facts, PairFacts const& pair, std::vector<Warning>& warnings);
/// The same: softens a bond faster than the bodies give way, with no viscosity to slow it?
[[nodiscard]] bool snaps(Facts const& facts, PairFacts const& pair);
/// The same: "300 steps instead of 100 in the stage to 1 s", so many times what a stage has.
[[nodiscard]] std::string more_steps(SchedulePart const& schedule, std::size_t stage, double factor);
[[nodiscard]] std::string more_steps(Facts const& facts, std::size_t stage, double factor);
/// explain_cost.cpp: memory and time; returns whether a factor at rest costs next to nothing. bulk: for any
/// purpose.
bool describe_cost(Facts const& facts, dynamics::State const& start, dynamics::BulkSystem const& bulk,
                   Explanation& explanation);
/// explain_rigid.cpp: a stiff body that may be an obstacle.
void advise_rigid(Facts const& all, PairFacts const& pair, std::vector<Warning>& warnings);
/// explain_scale.cpp: mesh files whose unit is not given and whose size fits nothing.
void unit_of_meshes(Facts const& all, std::vector<Warning>& warnings);
/// explain_relief.cpp: heights that the nodes of their boundary do not show.
void warn_of_relief(Facts const& all, std::vector<Warning>& warnings);
/// explain_shared.cpp: nodes that move as one in several contact points.
void warn_of_shared_nodes(Facts const& all, std::vector<Warning>& warnings);
/// explain_turns.cpp: motions that turn bodies farther than laws of small rotations know.
void warn_of_turns(Facts const& all, std::vector<Warning>& warnings);
/// The same: motions that move nodes of the axis of a section off it.
void warn_of_holes(Facts const& all, std::vector<Warning>& warnings);
/// explain_bending.cpp: slender bodies that are bent, and whose cells are too stiff for that.
void warn_of_bending(Facts const& facts, std::vector<Warning>& warnings);
/// explain_paths.cpp: paths whose turns no step sees.
void warn_of_paths(Facts const& facts, std::vector<Warning>& warnings);
/// explain_meeting.cpp: pairs whose sides cannot meet, cannot give way or touch over few cells or steps;
/// obstacles of no pair.
void warn_of_meeting(Facts const& facts, std::vector<Warning>& warnings);
/// The same: do motions have hold of every point, before a rigid counterpart?
[[nodiscard]] bool nothing_gives_way(Facts const& facts, PairFacts const& pair);
/// The same: do motions move or hold all these nodes, numbered from `first` on, in this direction?
[[nodiscard]] bool all_held(dynamics::Model const& model, Indices const& nodes, int component,
                            Index first = 0);
/// explain_idle.cpp: parameters and probes that do nothing; those of a pair's law alone.
void warn_of_idle(Facts const& facts, std::vector<Warning>& warnings);
void warn_of_idle_law(std::string const& pair, interface::Law const& law, int dim,
                      std::vector<Warning>& warnings);
/// explain_warnings.cpp: what is likely to go wrong; assembles nothing.
void add_warnings(Facts const& facts, Explanation& explanation);
/// explain_warnings.cpp: what would cost less and come out the same; assembles and factors at rest.
void add_advice(Facts const& facts, Explanation& explanation);

} // namespace stiction::scene
