// Schemas of the script's tables and the reading of those that hold other tables.
#include "scene/description/parts.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

#include "scene/description/catalog.hpp"
#include "scene/description/check_path.hpp"

namespace stiction::scene {

using core::Describe;
using core::Need;
using core::Reader;

namespace {

/// Every entry of a named table by `read`.
template<class Part, class Read>
std::map<std::string, Part> named(Reader& reader, char const* key, Need need, Read&& read) {
  std::map<std::string, Part> parts;
  if (need == Need::optional && !reader.has(key)) {
    static_cast<void>(reader.at(key, need));
    return parts;
  }
  Reader table = reader.child(key, need);
  if (!table.tag().empty() && table.tag() != key) {
    reader.complain_at(key,
                       fmt::format("is one {0} by itself; name it, as in {1} = {{ one = {0} {{ ... }} }}",
                                   table.tag().substr(table.tag().rfind('.') + 1), key));
    return parts;
  }
  for (auto const& name : table.keys())
    parts.emplace(name, read(table.child(name)));
  return parts;
}

/// Entries of two kinds, each by its tag; those without one are of the first.
template<class One, class Other>
std::pair<std::map<std::string, One>, std::map<std::string, Other>> named_of_two(Reader& reader,
                                                                                 char const* key, Need need) {
  std::map<std::string, Other> others;
  std::map<std::string, One> ones;
  auto const all = named<std::variant<One, Other>>(reader, key, need, [](Reader r) {
    return r.tag().ends_with("." + Other::schema().name) ? std::variant<One, Other>(r.record<Other>())
                                                         : std::variant<One, Other>(r.record<One>());
  });
  for (auto const& [name, part] : all)
    if (auto const* one = std::get_if<One>(&part))
      ones.emplace(name, *one);
    else
      others.emplace(name, std::get<Other>(part));
  return {std::move(ones), std::move(others)};
}

/// Names stand in "body.set" and in the paths of series.h5.
void check_names(Reader& reader, char const* key, auto const& parts) {
  for (auto const& [name, part] : parts)
    if (name.empty() || name.find_first_of("./") != std::string::npos)
      reader.complain_at(key, fmt::format("has the name \"{}\"; names are wanted that are not empty and have "
                                          "neither dots nor slashes",
                                          name));
}

template<class Part> Part nested_record(Reader& reader, char const* key) {
  if (!reader.has(key)) {
    static_cast<void>(reader.at(key, Need::optional));
    return {};
  }
  return reader.child(key, Need::optional).record<Part>();
}

template<class Choice> Choice nested_choice(Reader& reader, char const* key, Need need) {
  if (!reader.has(key)) {
    static_cast<void>(reader.at(key, need));
    return {};
  }
  return reader.child(key, need).alternative<Choice>();
}

} // namespace

namespace {

/// Is `material` a plain table of tables, laws by the names of sets?
bool names_sets(Reader const& reader) {
  auto const* table = reader.input().table();
  auto const found = table == nullptr ? core::Table::const_iterator{} : table->find("material");
  if (table == nullptr || found == table->end() || !found->second.tag.empty())
    return false;
  auto const* laws = found->second.table();
  return laws != nullptr && !laws->empty() &&
         std::ranges::all_of(*laws, [](auto const& law) { return law.second.table() != nullptr; });
}

} // namespace

Vec3 vec(Numbers const& numbers) {
  Vec3 v = Vec3::Zero();
  for (std::size_t i = 0; i < std::min<std::size_t>(3, numbers.size()); ++i)
    v[static_cast<Eigen::Index>(i)] = numbers[i];
  return v;
}

Vec3 spin_of(Numbers const& numbers) {
  return numbers.size() == 1 ? Vec3(0, 0, numbers[0]) : vec(numbers);
}

core::Schema const& BodyPart::schema() {
  static auto const made =
      Describe<BodyPart>{"body", "a deformable body", "physics.md 4"}
          .nested("mesh", "mesh", Need::required, "its mesh")
          .nested("material", "material", Need::required,
                  "its bulk law, or { SET = law, ... } where sets of cells of its mesh file have laws of "
                  "their own")
          .number("density", &BodyPart::density, "kg/m^3", core::positive, Need::required,
                  "mass density of the reference body")
          .numbers("velocity", &BodyPart::velocity, "m/s", Need::optional, "initial velocity {x, y [, z]}")
          .numbers("spin", &BodyPart::spin, "rad/s", Need::optional,
                   "initial angular velocity about its centre of mass: one number in 2D, three in 3D")
          .numbers("velocity_gradient", &BodyPart::velocity_gradient, "1/s", Need::optional,
                   "initial velocity grows by so much per distance from its centre of mass: {dvx/dx, dvx/dy, "
                   "dvy/dx, dvy/dy}, in 3D nine numbers by rows")
          .choice("interpolation", &BodyPart::interpolation, {"plain", "mean_dilatation"}, Need::optional,
                  "mean_dilatation: volume change averaged over each cell, against locking of quad4 and hex8 "
                  "near nu = 1/2")
          .flag(
              "plane_stress", &BodyPart::plane_stress,
              "a thin sheet, free to change its thickness, in a scene of kinematics plane_strain; forces are "
              "per metre of its thickness; without damping or relaxing, which would want a history of it")
          .nested("damping", "damping", Need::optional, "viscosity beside the bulk law; none: elastic")
          .nested(
              "relaxing", "prony", Need::optional,
              "list of terms {share = or modulus =, time =} of a Prony series beside the bulk law, in volume "
              "too with bulk_share = or bulk_modulus =; none: elastic")
          .nested("remesh", "remesh", Need::optional, "its mesh.gmsh is made anew until it is fine enough")
          .nested("relief", "relief", Need::optional,
                  "heights of one of its boundaries; none: as the mesh is")
          .nested("joined", plain_table, Need::optional,
                  "sets of its mesh under one new name, { NAME = { \"SET\", \"SET\", ... }, ... }: a surface "
                  "that goes round an edge of a box")
          .build();
  return made;
}

void BodyPart::read_nested(Reader& reader) {
  mesh = nested_choice<mesh::Generator>(reader, "mesh", Need::required);
  if (names_sets(reader))
    laws_by_set = named<material::Material>(reader, "material", Need::required,
                                            [](Reader r) { return r.alternative<material::Material>(); });
  else
    material = nested_choice<material::Material>(reader, "material", Need::required);
  if (reader.has("damping"))
    damping = std::get<material::KelvinVoigt>(
        nested_choice<std::variant<material::KelvinVoigt>>(reader, "damping", Need::optional));
  static_cast<void>(reader.at("damping", Need::optional));
  read_relaxing(reader);
  if (reader.has("remesh")) {
    remesh = reader.child("remesh", Need::optional).record<RemeshPart>();
    if (!std::holds_alternative<mesh::GmshGeometry>(mesh))
      reader.complain_at("remesh", "needs a mesh that gmsh makes from outlines; give the body a mesh.gmsh");
  }
  static_cast<void>(reader.at("remesh", Need::optional));
  if (reader.has("relief"))
    relief = reader.child("relief", Need::optional).record<ReliefPart>();
  static_cast<void>(reader.at("relief", Need::optional));
  read_joined(reader);
}

void BodyPart::read_joined(Reader& reader) {
  auto const& given = reader.at("joined", Need::optional);
  auto const* all = given.list();
  if (!reader.has("joined") || (all != nullptr && all->empty()))
    return;
  auto const refuse = [&](std::string const& key) {
    reader.complain_at(key, "is no list of names of sets; give { NAME = { \"SET\", \"SET\", ... }, ... }");
  };
  if (given.table() == nullptr)
    return refuse("joined");
  for (auto const& [name, names] : *given.table()) {
    auto& own = joined[name];
    auto const* list = names.list();
    if (list == nullptr || !std::ranges::all_of(*list, [](auto const& one) { return one.text() != nullptr; }))
      refuse("joined." + name);
    else
      for (auto const& one : *list)
        own.push_back(*one.text());
  }
  check_names(reader, "joined", joined);
}

void BodyPart::read_relaxing(Reader& reader) {
  if (!reader.has("relaxing")) {
    static_cast<void>(reader.at("relaxing", Need::optional));
    return;
  }
  for (auto& term : reader.children("relaxing"))
    relaxing.push_back(term.record<material::PronyTerm>());
  if (relaxing.empty() || relaxing.size() > material::most_prony_terms)
    reader.complain_at(
        "relaxing", fmt::format("has {} terms; give 1 to {} of {{share = 0.4, time = 1*s}}, or leave it out",
                                relaxing.size(), material::most_prony_terms));
}

core::Schema const& RemeshPart::schema() {
  static auto const made =
      Describe<RemeshPart>{"remesh",
                           "the run is repeated with other cell sizes until the stress is exact enough",
                           "Zienkiewicz and Zhu 1987"}
          .number("target", &RemeshPart::target, "1", {0, 1, true, true}, Need::optional,
                  "error of the stress over its size, from the jumps between cells, at every end of a stage")
          .integer("passes", &RemeshPart::passes, {1, 20, false, false}, Need::optional,
                   "meshes at most; the last one counts")
          .number("cohesive_cells", &RemeshPart::cohesive_cells, "1", core::non_negative, Need::optional,
                  "cells over the cohesive length E* / C, where a surface adheres; 0: any size")
          .number("smallest", &RemeshPart::smallest, "m", core::non_negative, Need::optional,
                  "no cell is asked to be smaller")
          .build();
  return made;
}

core::Schema const& ObstaclePart::schema() {
  static auto const made =
      Describe<ObstaclePart>{"obstacle",
                             "a rigid body without mesh: carried along paths, or free if it has a mass", ""}
          .nested("shape", "rigid", Need::required, "its shape and position at the start")
          .numbers("times", &ObstaclePart::times, "s", Need::optional, "times of the paths")
          .numbers("x", &ObstaclePart::x, "m", Need::optional, "displacement in x at those times")
          .numbers("y", &ObstaclePart::y, "m", Need::optional, "displacement in y at those times")
          .numbers("z", &ObstaclePart::z, "m", Need::optional, "displacement in z at those times (3D)")
          .numbers("angle", &ObstaclePart::angle, "rad", Need::optional,
                   "turn about `axis` through `pivot` at those times")
          .numbers("axis", &ObstaclePart::axis, "1", Need::optional,
                   "axis {x, y, z} of the turn in 3D; default z")
          .numbers("pivot", &ObstaclePart::pivot, "m", Need::optional,
                   "point it turns about and its centre of mass; default the shape's centre")
          .number("mass", &ObstaclePart::mass, "kg", core::non_negative, Need::optional,
                  "mass (per metre of depth in plane strain); > 0: components without a path are free")
          .number("inertia", &ObstaclePart::inertia, "kg m^2", core::non_negative, Need::optional,
                  "moment of inertia about the pivot, the same about every axis; 0: it does not turn")
          .numbers("inertia_tensor", &ObstaclePart::inertia_tensor, "kg m^2", Need::optional,
                   "3D, instead of inertia: {xx, yy, zz} or {xx, yy, zz, xy, yz, zx} about the pivot at the "
                   "start, xy = -int x y dm; with Jean's schemes")
          .numbers("velocity", &ObstaclePart::velocity, "m/s", Need::optional, "at the start, if free")
          .numbers("spin", &ObstaclePart::spin, "rad/s", Need::optional,
                   "angular velocity at the start, if free: one number in 2D, three in 3D")
          .numbers("force", &ObstaclePart::force, "N", Need::optional, "constant load on it, if free")
          .build();
  return made;
}

void ObstaclePart::read_nested(Reader& reader) {
  shape = nested_choice<contact::Obstacle>(reader, "shape", Need::required);
  if (std::holds_alternative<contact::RigidHeights>(shape)) {
    auto map = reader.child("shape", Need::required);
    surface = nested_choice<halfspace::Shape>(map, "surface", Need::required);
  }
  check_paths(reader, *this);
  check_path(reader, times, angle, "angle");
  if (mass > 0)
    return;
  for (char const* key : {"inertia", "inertia_tensor", "velocity", "spin", "force"})
    if (reader.has(key))
      reader.complain_at(key, "needs a free body; give it a mass, or paths without this");
}

core::Schema const& PairPart::schema() {
  static auto const made =
      Describe<PairPart>{"pair", "two surfaces that may touch, and the law between them", "physics.md 1"}
          .text("secondary", &PairPart::secondary, Need::required,
                "surface that carries the contact points, \"body.set\"; a node on the border to another pair "
                "with this primary is a point of the one that bonds, else of the first by name")
          .text("primary", &PairPart::primary, Need::required,
                "surface they meet, \"body.set\", or an obstacle's name")
          .nested("friction", "friction", Need::optional, "friction law; none: frictionless")
          .nested("adhesion", "adhesion", Need::optional, "adhesion law; none: dry")
          .choice(
              "discretisation", &PairPart::discretisation, {"node_to_segment", "mortar"}, Need::optional,
              "node_to_segment: gap and force at every node of the secondary (of quadratic facets about an "
              "axis or in space: of functions that leave no corner without an area); mortar: averages around "
              "its corner nodes, which pass uniform pressure between any two meshes")
          .choice("smoothing", &PairPart::smoothing, {"spline", "polyline"}, Need::optional,
                  "2D, node_to_segment: how the primary surface runs between its nodes")
          .number("reach", &PairPart::reach, "m", core::non_negative, Need::optional,
                  "points farther apart stay out of the contact problem; 0: half a facet, or the range of a "
                  "reversible adhesion if that is more")
          .numbers(
              "direction", &PairPart::direction, "1", Need::optional,
              "3D: the first tangential direction is its part along the primary surface {x, y, z}, on an "
              "obstacle where the run begins, from where it is carried along (mortar on bodies: along the "
              "secondary's)")
          .build();
  return made;
}

void PairPart::read_nested(Reader& reader) {
  if (reader.has("friction"))
    law.friction = nested_choice<interface::FrictionLaw>(reader, "friction", Need::optional);
  if (reader.has("adhesion"))
    law.adhesion = nested_choice<interface::AdhesionLaw>(reader, "adhesion", Need::optional);
  for (char const* key : {"friction", "adhesion"})
    static_cast<void>(reader.at(key, Need::optional));
  if (reach > 0 && reach < law.range())
    reader.complain_at("reach", fmt::format("is {:g} m, but the adhesion is felt up to {:g} m; give at least "
                                            "that, or leave it out",
                                            reach, law.range()));
}

core::Schema const& TractionPart::schema() {
  static auto const made =
      Describe<TractionPart>{"traction", "dead traction per reference area of a surface", ""}
          .text("set", &TractionPart::set, Need::required, "the surface, \"body.set\"")
          .numbers("times", &TractionPart::times, "s", Need::required, "times of the path, ascending")
          .numbers("x", &TractionPart::x, "Pa", Need::optional, "traction in x at those times")
          .numbers("y", &TractionPart::y, "Pa", Need::optional, "traction in y at those times")
          .numbers("z", &TractionPart::z, "Pa", Need::optional, "traction in z at those times (3D)")
          .build();
  return made;
}

core::Schema const& PointForcePart::schema() {
  static auto const made =
      Describe<PointForcePart>{"force",
                               "dead force at one node: N in 3D and, around the whole circle, axisymmetric; "
                               "N per metre of depth in plane strain",
                               ""}
          .text("set", &PointForcePart::set, Need::required, "where to look, \"body.set\"")
          .numbers("near", &PointForcePart::near, "m", Need::required, "its node nearest to {x, y [, z]}")
          .numbers("times", &PointForcePart::times, "s", Need::required, "times of the path, ascending")
          .numbers("x", &PointForcePart::x, "N", Need::optional, "force in x at those times")
          .numbers("y", &PointForcePart::y, "N", Need::optional, "force in y at those times")
          .numbers("z", &PointForcePart::z, "N", Need::optional, "force in z at those times (3D)")
          .build();
  return made;
}

core::Schema const& StagePart::schema() {
  static auto const made =
      Describe<StagePart>{"stage", "a stretch of the run with equal steps", ""}
          .number("to", &StagePart::until, "s", core::positive, Need::required, "time at its end")
          .integer("steps", &StagePart::steps, {1, 1e8, false, false}, Need::required, "number of steps")
          .build();
  return made;
}

core::Schema const& SchedulePart::schema() {
  static auto const made =
      Describe<SchedulePart>{
          "schedule", "the run's stages; a step that fails is halved, and grows again after success", ""}
          .nested("stages", "stage", Need::required, "list of stages")
          .integer("halvings", &SchedulePart::halvings, {0, 20, false, false}, Need::optional,
                   "how often a step may be halved before the run stops")
          .integer("cuts", &SchedulePart::cuts, {1, 1e6, false, false}, Need::optional,
                   "attempts at one step and at parts of it that may fail before the run stops")
          .number(
              "work", &SchedulePart::work, "1", core::positive, Need::optional,
              "1e9 operations (about a second for two) that attempts at one step and at parts of it may "
              "lose before the run stops, and a hundredth of what one attempt may take; where it is more, a "
              "thousand factorizations")
          .number("seconds", &SchedulePart::seconds, "s", core::non_negative, Need::optional,
                  "time of the machine after which the run stops, the one limit that depends on the machine; "
                  "0: none")
          .nested("accuracy", "accuracy", Need::optional,
                  "steps chosen from their error, a stage's own for a start; none: equal steps")
          .build();
  return made;
}

void SchedulePart::read_nested(Reader& reader) {
  for (auto& stage : reader.children("stages"))
    stages.push_back(stage.record<StagePart>());
  if (reader.has("accuracy"))
    accuracy = reader.child("accuracy", Need::optional).record<dynamics::Accuracy>();
  static_cast<void>(reader.at("accuracy", Need::optional));
  if (stages.empty() && reader.has("stages"))
    reader.complain_at("stages", "is empty; give at least one stage{to = ..., steps = ...}");
  for (std::size_t k = 1; k < stages.size(); ++k)
    if (stages[k].until <= stages[k - 1].until)
      reader.complain_at("stages", fmt::format("stage {} ends at {:g} s, not after the one before it", k + 1,
                                               stages[k].until));
}

core::Schema const& OutputPart::schema() {
  static auto const made =
      Describe<OutputPart>{"output", "what is written beside the probes", ""}
          .integer("frames", &OutputPart::frames, {0, 1e6, false, false}, Need::optional,
                   "field frames per stage, its end included")
          .integer("problems_every", &OutputPart::problems_every, {0, 1e6, false, false}, Need::optional,
                   "save the contact problem of every n-th step for `stiction solve`; 0: none")
          .build();
  return made;
}

core::Schema const& ScenePart::schema() {
  static auto const made =
      Describe<ScenePart>{"scene", "everything a run needs", ""}
          .choice("kinematics", &ScenePart::kinematics, {"plane_strain", "axisymmetric", "three_dimensional"},
                  Need::optional, "axisymmetric: x is the radius, y the axis")
          .choice(
              "model", &ScenePart::model, {"bodies", "formula", "half_space", "section", "space"},
              Need::optional,
              "what answers it: its bodies as they are; the closed formula of a half space under a sphere, "
              "cylinder, punch or wave, which gives probes of contact and rigid and no fields; or bodies "
              "that "
              "have to be of that kind, for studies that offer several")
          .numbers("gravity", &ScenePart::gravity, "m/s^2", Need::optional,
                   "acceleration {x, y [, z]} on every body")
          .nested("bodies", "body", Need::required, "table of bodies by name")
          .nested("obstacles", "obstacle", Need::optional, "table of rigid obstacles by name")
          .nested("pairs", "pair", Need::optional, "table of contact pairs by name")
          .nested("motions", "motion", Need::optional, "list of motions")
          .nested("constraints", "constraint", Need::optional,
                  "list of rollers, periodic sides and tied surfaces")
          .nested("loads", "load", Need::optional, "list of prescribed forces")
          .nested("springs", "spring", Need::optional, "table of springs and dashpots by name")
          .nested("probes", "probe", Need::optional, "table of probes by name: the groups of series.h5")
          .nested("scheme", "scheme", Need::optional, "time scheme; default theta_xi{}")
          .nested("solver", "solver", Need::optional, "contact solver; default newton{}")
          .nested("control", "control", Need::optional, "convergence of a step")
          .nested("schedule", "schedule", Need::required, "stages and steps")
          .nested("output", "output", Need::optional, "what is written")
          .build();
  return made;
}

void ScenePart::read_nested(Reader& reader) {
  if (!gravity.empty() && gravity.size() != static_cast<std::size_t>(dim()))
    reader.complain_at("gravity", fmt::format("has {} numbers; {} are wanted", gravity.size(),
                                              dim() == 2 ? "two" : "three"));
  std::tie(bodies, half_spaces) = named_of_two<BodyPart, HalfSpacePart>(reader, "bodies", Need::required);
  std::tie(obstacles, height_maps) =
      named_of_two<ObstaclePart, HeightMapPart>(reader, "obstacles", Need::optional);
  pairs = named<PairPart>(reader, "pairs", Need::optional, [](Reader r) { return r.record<PairPart>(); });
  springs =
      named<SpringPart>(reader, "springs", Need::optional, [](Reader r) { return r.record<SpringPart>(); });
  probes =
      named<ProbePart>(reader, "probes", Need::optional, [](Reader r) { return r.alternative<ProbePart>(); });
  check_names(reader, "bodies", bodies);
  check_names(reader, "bodies", half_spaces);
  check_names(reader, "obstacles", obstacles);
  check_names(reader, "obstacles", height_maps);
  check_names(reader, "pairs", pairs);
  check_names(reader, "springs", springs);
  check_names(reader, "probes", probes);
  for (auto& motion : reader.children("motions", Need::optional))
    motions.push_back(motion.alternative<MotionPart>());
  for (auto& constraint : reader.children("constraints", Need::optional))
    constraints.push_back(constraint.alternative<ConstraintPart>());
  for (auto& load : reader.children("loads", Need::optional)) {
    loads.push_back(load.alternative<LoadPart>());
    std::visit(
        [&](auto const& part) {
          if constexpr (requires { part.x; })
            check_paths(load, part);
        },
        loads.back());
  }
  scheme = nested_choice<dynamics::Scheme>(reader, "scheme", Need::optional);
  solver = nested_choice<contact::SolverChoice>(reader, "solver", Need::optional);
  control = nested_record<dynamics::StepControl>(reader, "control");
  schedule = nested_record<SchedulePart>(reader, "schedule");
  if (!reader.has("schedule"))
    reader.complain_at("schedule", "is missing; it is required");
  output = nested_record<OutputPart>(reader, "output");
}

} // namespace stiction::scene
