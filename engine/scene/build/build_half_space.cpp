// A scene with a half space: what it is made of, and what does not go with it yet.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "scene/build/builder.hpp"

namespace stiction::scene {

namespace {

constexpr int most_points = 2048; ///< along an axis

} // namespace

bool Builder::given(Where const& where) const {
  core::Input const* at = input_;
  for (auto const& key : where)
    at = at == nullptr ? nullptr : part_of(*at, key);
  return at != nullptr;
}

void Builder::refuse(Where const& where, bool given, std::string const& why) {
  if (given)
    complain(where, why);
}

Scene Builder::with_half_space() {
  check_half_space_alone();
  settle();
  auto const& part = scene_.part;
  scene_.half_space = std::make_unique<halfspace::Model>();
  auto const& [body, half_space] = *part.half_spaces.begin();
  take_half_space(body, half_space);
  settle();
  auto const& [obstacle, heights] = *part.height_maps.begin();
  take_height_map(obstacle, heights);
  auto const& [pair, law] = *part.pairs.begin();
  take_half_space_pair(pair, law);
  check_half_space_scheme();
  for (auto const& [name, probe] : part.probes)
    check_half_space_probe(name, probe);
  if (part.model == ModelKind::formula)
    take_formula();
  if (ranks_ != nullptr)
    complain({}, fmt::format("it cannot be shared by several ranks: {}; run it without --ranks",
                             unfit_for_ranks(scene_)));
  settle();
  scene_.bodies = {body};
  scene_.pairs = {pair};
  return std::move(scene_);
}

/// One half space, one height map, one pair, and nothing else.
void Builder::check_half_space_alone() {
  auto const& part = scene_.part;
  refuse({"kinematics"}, part.kinematics == solid::Kinematics::axisymmetric,
         "is \"axisymmetric\"; a half space wants \"three_dimensional\", or \"plane_strain\" for a line of "
         "points");
  refuse({"bodies"}, part.half_spaces.size() + part.bodies.size() != 1,
         fmt::format("has {} bodies beside a half space, which goes alone; leave the others out",
                     part.half_spaces.size() + part.bodies.size() - 1));
  refuse({"obstacles"}, part.height_maps.size() != 1 || !part.obstacles.empty(),
         fmt::format("has {} height maps and {} other obstacles; a half space wants one "
                     "stiction.obstacle.height_map and nothing else",
                     part.height_maps.size(), part.obstacles.size()));
  refuse({"pairs"}, part.pairs.size() != 1,
         fmt::format("has {} pairs; a half space wants one, with its height map", part.pairs.size()));
  for (auto const& [key, there] : {std::pair{"gravity", !part.gravity.empty()},
                                   {"motions", !part.motions.empty()},
                                   {"constraints", !part.constraints.empty()},
                                   {"loads", !part.loads.empty()},
                                   {"springs", !part.springs.empty()}})
    refuse({key}, there,
           "does not act on a half space, which is driven by its height map's paths or force; leave it out");
}

void Builder::take_half_space(std::string const& name, HalfSpacePart const& part) {
  Where const where{"bodies", name};
  auto& grid = scene_.half_space->grid;
  grid.line = scene_.part.dim() == 2;
  grid.periodic = part.boundary == Boundary::periodic;
  auto const dimensions = grid.line ? std::size_t{1} : std::size_t{2};
  for (auto const& [key, numbers] : {std::pair{"size", &part.size}, {"points", &part.points}})
    if (numbers->size() != dimensions)
      return complain({"bodies", name, key},
                      fmt::format("has {} numbers; {} wanted: {}", numbers->size(),
                                  grid.line ? "one is" : "two are", grid.line ? "{x}" : "{x, y}"));
  for (double const count : part.points)
    if (!(count >= 2 && count <= most_points) || count != std::round(count))
      return complain({"bodies", name, "points"},
                      fmt::format("has {:g}; give whole numbers in [2, {}]", count, most_points));
  for (double const length : part.size)
    if (!(length > 0))
      return complain({"bodies", name, "size"}, fmt::format("has {:g} m; give lengths > 0 m", length));
  refuse(
      {"bodies", name, "depth"}, part.depth > 0 && !grid.periodic,
      "is for a periodic boundary; a free half space gives under the mean traction by itself: leave it out");
  grid.nx = static_cast<Index>(part.points[0]);
  grid.Lx = part.size[0];
  if (!grid.line) {
    grid.ny = static_cast<Index>(part.points[1]);
    grid.Ly = part.size[1];
  }
  scene_.half_space->body = {part.young, part.poisson, part.depth};
}

void Builder::take_height_map(std::string const& name, HeightMapPart const& part) {
  auto& model = *scene_.half_space;
  bool const line = model.grid.line;
  if (part.young > 0)
    model.counterpart = halfspace::Elastic{part.young, part.poisson, model.body.depth};
  model.heights = heights_of({"obstacles", name, "surface"}, part.surface, model.grid);
  if (auto const* wave = std::get_if<halfspace::Wave>(&part.surface); wave != nullptr && model.grid.periodic)
    for (auto const& one : wave->check_period(model.grid))
      complain({"obstacles", name, "surface", one.path}, one.text);
  settle();
  check_no_z({"obstacles", name, "z"}, part.z);
  check_path_end({"obstacles", name, "times"}, part.times);
  char const* const normal = line ? "y" : "z";
  auto const& along_normal = line ? part.y : part.z;
  refuse({"obstacles", name, "force"}, !part.force.empty() && !along_normal.empty(),
         fmt::format("and {} cannot both be given: one follows from the other; leave one out", normal));
  model.shift = {path(part.times, part.x), line ? dynamics::Path{} : path(part.times, part.y),
                 path(part.times, along_normal)};
  if (!part.force.empty())
    model.force = path(part.times, part.force);
  auto const pulls = std::ranges::find_if(part.force, [](double force) { return force < 0; });
  refuse({"obstacles", name, "force"},
         pulls != part.force.end() && !scene_.part.pairs.begin()->second.law.adhesion,
         fmt::format("pulls with {:g} {}, and nothing adheres; give forces >= 0, or the pair an adhesion",
                     pulls == part.force.end() ? 0 : *pulls, line ? "N/m" : "N"));
  check_mean_gives(name, along_normal);
}

/// A periodic surface whose mean stays where it is cannot be pressed lower than flat.
void Builder::check_mean_gives(std::string const& name, Numbers const& along_normal) {
  auto const& model = *scene_.half_space;
  double const lowest = along_normal.empty() ? 0 : std::ranges::min(along_normal);
  auto const* counterpart = model.counterpart ? &*model.counterpart : nullptr;
  if (!model.grid.periodic || model.force || model.heights.size() == 0 ||
      halfspace::Compliance::of(model.body, counterpart).mean_normal > 0)
    return;
  constexpr double rounded = 1e-12;
  if (model.heights.mean() + lowest >= -rounded * std::abs(lowest))
    return;
  complain(
      {"obstacles", name, model.grid.line ? "y" : "z"},
      fmt::format("goes down to {:g} m, {:g} m below where the surface is pressed flat (its mean stays "
                  "where it is{}): no force is enough; stay above {:g} m, give a force, or the half space "
                  "{}",
                  lowest, -(model.heights.mean() + lowest),
                  model.body.depth > 0 ? ", as an incompressible layer cannot be squeezed" : "",
                  -model.heights.mean(), model.body.depth > 0 ? "a Poisson's ratio below 0.5" : "a depth"));
}

void Builder::take_half_space_pair(std::string const& name, PairPart const& part) {
  auto const surface = scene_.part.half_spaces.begin()->first + ".surface";
  auto const& counterpart = scene_.part.height_maps.begin()->first;
  if (part.secondary != surface)
    unknown_name({"pairs", name, "secondary"}, "set", part.secondary, {surface});
  if (part.primary != counterpart)
    unknown_name({"pairs", name, "primary"}, "obstacle", part.primary, {counterpart});
  for (char const* key : {"discretisation", "smoothing", "reach", "direction"})
    refuse(
        {"pairs", name, key}, given({"pairs", name, key}),
        "is not for half spaces, whose points lie over the heights that they meet, t1 along x; leave it out");
  scene_.half_space->law = part.law;
}

void Builder::check_half_space_scheme() {
  auto const& part = scene_.part;
  auto const weights = dynamics::weights(part.scheme);
  refuse({"scheme"}, weights.inertia,
         "has inertia, which a half space has not; give scheme = stiction.scheme.quasi_static {}");
  refuse({"scheme", "stabilisation"}, weights.stabilisation > 0,
         fmt::format("is {:g}; a half space needs none: leave it out", weights.stabilisation));
  auto const* newton = std::get_if<contact::BipotentialNewton>(&part.solver);
  refuse({"solver"}, newton == nullptr,
         "works on a matrix, which a half space has not; give stiction.solver.newton, or leave it out");
  if (newton != nullptr)
    scene_.half_space->tolerance = newton->tolerance;
  refuse({"control"}, given({"control"}),
         "is of bodies with cells; the tolerance of stiction.solver.newton is all that a half space has: "
         "leave it out");
  refuse({"output", "problems_every"}, part.output.problems_every > 0,
         "wants contact problems as matrices, which a half space has not; leave it out");
}

void Builder::check_half_space_probe(std::string const& name, ProbePart const& part) {
  auto const check_pair = [&](std::string const& pair) {
    if (pair != scene_.part.pairs.begin()->first)
      unknown_name({"probes", name, "pair"}, "pair", pair, {scene_.part.pairs.begin()->first});
  };
  auto const& grid = scene_.half_space->grid;
  if (auto const* contact = std::get_if<ContactProbe>(&part)) {
    check_pair(contact->pair);
    refuse({"probes", name, "set"}, !contact->set.empty(), "is not for half spaces; leave it out");
  } else if (auto const* point = std::get_if<PointProbe>(&part)) {
    check_pair(point->pair);
    check_size({"probes", name, "near"}, point->near);
  } else if (auto const* line = std::get_if<LineProbe>(&part)) {
    check_pair(line->pair);
    refuse({"probes", name}, !grid.line,
           "is for lines, in plane strain; in space take the fields of frames, or contact_point");
  } else if (auto const* rigid = std::get_if<RigidProbe>(&part)) {
    if (rigid->obstacle != scene_.part.height_maps.begin()->first)
      unknown_name({"probes", name, "obstacle"}, "obstacle", rigid->obstacle,
                   {scene_.part.height_maps.begin()->first});
  } else if (auto const* energy = std::get_if<EnergyProbe>(&part)) {
    refuse({"probes", name, "audit"}, energy->audit, "is not for half spaces; leave it out");
  } else {
    complain({"probes", name},
             "is not for half spaces; there are contact, contact_point, contact_line, rigid and energy");
  }
}

} // namespace stiction::scene
