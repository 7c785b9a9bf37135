// The making of a Scene from a script's table, step by step; complaints are gathered before any is thrown.
#pragma once
#include <array>
#include <map>
#include <set>

#include "contact/mortar/tied.hpp"
#include "dynamics/contact/contact_system.hpp"
#include "mesh/topology/mesh.hpp"
#include "scene/build/build.hpp"

namespace stiction::scene {

using Where = std::vector<std::string>; ///< keys from the scene's table down, "name" or "name[k]"

/// What stands under "name", or under "name[k]" in a list; null if there is no such part.
[[nodiscard]] core::Input const* part_of(core::Input const& input, std::string const& key);

/// An empty path where no values are given.
[[nodiscard]] dynamics::Path path(Numbers const& times, Numbers const& values);

/// Times up to `end` at which motions are compared, s.
[[nodiscard]] std::set<double> compared_at(std::vector<dynamics::Motion const*> const& motions, double end);

/// Mean place of nodes; a place in words, "(1, 0) m".
[[nodiscard]] Vec3 middle_of(dynamics::Model const& model, Indices const& nodes);
[[nodiscard]] std::string words(Vec3 const& X, int dim);

class Builder {
public:
  Builder(core::Input const& input, linear::Ranks const* ranks) : input_(&input), ranks_(ranks) {}
  [[nodiscard]] Scene run();

private:
  void settle() const;
  void complain(Where const& where, std::string text);
  /// Complains unless an optional list has as many numbers as the scene has dimensions.
  void check_size(Where const& where, Numbers const& numbers);
  /// Complains about a third component in a plane scene.
  void check_no_z(Where const& where, Numbers const& values);
  void check_symmetry(std::string const& name, ObstaclePart const& part);
  void check_paths_alone(std::string const& name, ObstaclePart const& part);
  template<class Part> void check_components(Where const& where, Part const& part) {
    if (part.x.empty() && part.y.empty() && part.z.empty())
      complain({where[0]}, "has none of x, y, z; give the values of at least one at its times");
  }
  void check_path_end(Where const& where, Numbers const& times);
  [[nodiscard]] std::optional<Indices> resolve(Where const& where, std::string const& name);
  void unknown_name(Where const& where, char const* what, std::string const& name,
                    std::vector<std::string> const& known);

  // build_formula.cpp
  void check_model();
  void take_formula();
  void check_formula_probe(std::string const& name, ProbePart const& part);

  // build_half_space.cpp
  [[nodiscard]] Scene with_half_space();
  void check_half_space_alone();
  void refuse(Where const& where, bool given, std::string const& why);
  [[nodiscard]] bool given(Where const& where) const;
  void take_half_space(std::string const& name, HalfSpacePart const& part);
  void take_height_map(std::string const& name, HeightMapPart const& part);
  void check_mean_gives(std::string const& name, Numbers const& along_normal);
  void take_half_space_pair(std::string const& name, PairPart const& part);
  void check_half_space_scheme();
  void check_half_space_probe(std::string const& name, ProbePart const& part);

  // build_heights.cpp
  [[nodiscard]] Vector heights_of(Where const& where, halfspace::Shape const& surface,
                                  halfspace::Grid const& grid);
  void take_heights(Where const& where, halfspace::Shape const& surface, contact::RigidHeights& map);

  // build_relief.cpp
  void take_relief(std::string const& name, ReliefPart const& part, mesh::Mesh& mesh);

  void add_bodies();
  void make_body(std::string const& name, BodyPart const& part);
  void join_sets(std::string const& name, BodyPart const& part, mesh::Mesh& mesh);
  void check_radius(std::string const& name, mesh::Mesh const& mesh);
  void check_spin(Where const& where, Numbers const& spin);
  void check_velocities(std::string const& name, BodyPart const& part);
  void check_sheet(std::string const& name, BodyPart const& part);
  void set_velocities(std::size_t body);

  // build_motions.cpp
  void add_motions();
  void add_motion(Where const& where, FixPart const& part);
  void add_motion(Where const& where, DrivePart const& part);
  void add_motion(Where const& where, TurnPart const& part);
  void check_turn(Where const& where, TurnPart const& part);
  template<class Part> [[nodiscard]] Indices moved(Where const& where, Part const& part);
  void check_driven_twice();

  // build_constraints.cpp
  void add_constraints();
  void add_constraint(Where const& where, RollerPart const& part);
  void add_constraint(Where const& where, PeriodicPart const& part);
  // build_ties.cpp
  void add_constraint(Where const& where, TiedPart const& part);
  struct Tie {
    Where where;
    TiedPart const* part;
    std::vector<contact::TiedFacet> facets;
    std::set<Index> both; ///< nodes of both surfaces
  };
  [[nodiscard]] bool covered(Tie const& tie);
  [[nodiscard]] std::set<Index> kept_nodes(Tie const& tie, int component) const;
  void follow_facets(Tie const& tie, int component);
  void follow_row(Index node, std::map<Index, double> const& row, int component);
  [[nodiscard]] double move_bodies(Where const& where);

  using Terms = std::vector<std::pair<Index, double>>; ///< degrees of freedom and coefficients
  void constrain(Where const& where, Terms const& terms);
  [[nodiscard]] std::map<Index, double> settled(Terms const& terms) const;
  void follow(Index follower, std::map<Index, double> const& sum);
  void check_constraints();
  void check_start_velocities();

  // build_loads.cpp
  void add_loads();
  void add_load(Where const& where, TractionPart const& part);
  void add_load(Where const& where, PointForcePart const& part);
  void add_load(Where const& where, PressurePart const& part);
  void add_load(Where const& where, GasPart const& part);
  void add_load(Where const& where, SurfaceStressPart const& part);
  void add_components(Where const& where, LoadPath const& load, Vector const& shares);

  // build_cavities.cpp
  void add_seal(Where const& where, GasPart const& part, dynamics::Gas& gas);
  void check_cavity(Where const& where, dynamics::Gas& gas);
  void carry_centre(Where const& where, dynamics::Gas& gas, std::map<Index, std::size_t> const& motions);
  [[nodiscard]] std::optional<std::pair<Vec3, std::array<Index, 2>>>
  turning_arm(std::map<Index, std::size_t> const& motions) const;

  // build_springs.cpp
  void add_springs();
  void add_spring(Where const& where, SpringPart const& part);
  void check_spring(Where const& where, SpringPart const& part);
  void set_spring_way(Where const& where, SpringPart const& part, dynamics::Spring& spring);
  [[nodiscard]] std::optional<dynamics::SpringEnd> spring_end(Where const& where, std::string const& name);

  // support.cpp
  void hold_axis();
  void check_supports(dynamics::ContactSystem const& contact, dynamics::State const& start);

  // build_contact.cpp
  void add_obstacles();
  void add_obstacle(std::string const& name, ObstaclePart const& part);
  void take_tensor(dynamics::RigidBody& rigid, ObstaclePart const& part);
  void drive_rigid(dynamics::RigidBody const& rigid, ObstaclePart const& part);
  void add_pairs();
  void add_pair(std::string const& name, PairPart const& part);
  void share_border(std::size_t first, std::size_t later);
  void refuse_again(std::string const& name, PairPart const& part);
  [[nodiscard]] std::optional<mesh::Set> surface(Where const& where, std::string const& name);
  [[nodiscard]] dynamics::Pair secondary_side(std::string const& name, PairPart const& part,
                                              mesh::Set const& set);
  [[nodiscard]] bool leave_out_shared(std::string const& name, mesh::Set const& secondary,
                                      mesh::Set const& primary, dynamics::Pair& pair);
  void lend_areas(mesh::Set const& set, dynamics::Pair& pair) const;
  void share_edges(mesh::Set const& set, dynamics::Pair& pair) const;
  void share_facets(std::string const& name, mesh::Set const& set, dynamics::Pair& pair) const;
  void average_facets(PairPart const& part, mesh::Set const& set, dynamics::Pair& pair) const;
  void add_primary(PairPart const& part, mesh::Set const& set, dynamics::Pair& pair) const;
  [[nodiscard]] Vec3 first_tangent(PairPart const& part, mesh::Set const& set) const;
  void check_overlap(dynamics::State const& start);
  [[nodiscard]] bool bodies_overlap(std::string const& pair);

  // build_probes.cpp
  void check_bulk();
  void check_probes();
  void check_about(Where const& where, Numbers const& about);
  void check_momentum(Where const& where);
  void check_gas(Where const& where, GasProbe const& part);
  void check_patch(Where const& where, ContactProbe const& part);
  template<class Part> void check_probe(std::string const& name, Part const& part);

  core::Input const* input_;
  std::vector<dynamics::Motion const*> driven_; ///< [degrees of freedom]; empty without constraints
  Indices link_of_;                             ///< [degrees of freedom] that follows there; -1: none
  std::vector<bool> leads_;                     ///< [degrees of freedom]: is it a master?
  std::vector<std::size_t> linked_by_;          ///< of the model's links: number of the script's constraint
  linear::Ranks const* ranks_;
  core::Complaints complaints_;
  Scene scene_;
  /// Of the model's motions: number and set of the script's; those of rigid bodies have none.
  std::vector<std::pair<std::size_t, std::string>> origins_;
};

} // namespace stiction::scene
