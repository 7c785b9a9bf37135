// Pairs whose sides cannot meet, cannot give way or touch over few cells or steps, and obstacles of no pair.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

bool all_held(dynamics::Model const& model, Indices const& nodes, int component, Index first) {
  std::vector<bool> held(ix(model.node_count()), false);
  for (auto const& motion : model.motions)
    if (motion.component == component)
      for (Index const node : motion.nodes)
        held[ix(node)] = true;
  return std::ranges::all_of(nodes, [&](Index node) { return held[ix(first + node)]; });
}

bool nothing_gives_way(Facts const& all, PairFacts const& pair) {
  auto const& model = *all.scene->model;
  bool held = !pair.primary;
  for (int c = 0; c < model.dim(); ++c)
    held = held && all_held(model, pair.pair->nodes(), c);
  return held;
}

namespace {

/// May a side turn its back on where it looks at the start?
bool any_turns(Facts const& all) {
  auto const& model = *all.scene->model;
  return std::ranges::any_of(model.motions, [](auto const& motion) { return !!motion.turn; }) ||
         std::ranges::any_of(model.rigids, [](auto const& rigid) { return rigid.free(); }) ||
         std::ranges::any_of(all.bodies, [](auto const& body) { return body.start_speed > 0; });
}

/// Both sides look the same way, and nothing of bodies is near: a bottom that was to be a top.
void looks_away(Facts const& all, PairFacts const& pair, std::vector<Warning>& warnings) {
  constexpr double same_way = 0.5;
  bool const near = pair.primary && pair.gap >= 0;
  if (pair.pair->self || near || pair.alike < same_way || any_turns(all))
    return;
  warnings.push_back(
      {fmt::format("pair {}: {} and {} look the same way: they are not each other's counterpart",
                   pair.pair->name, pair.part->secondary, pair.part->primary),
       "sets that face each other; of a plane, its normal the other way round"});
}

/// Surfaces that begin within each other, deeper than chords of round ones lie: they jump apart.
void begins_inside(PairFacts const& pair, std::vector<Warning>& warnings) {
  constexpr double shallow = 1e-3, chords = 2; // of a cell; over the sagittas of both
  double const cell = std::max(pair.size, pair.primary_size),
               sagitta = pair.radius > 0 ? cell * cell / (8 * pair.radius) : 0;
  if (pair.overlap <= std::max(shallow * pair.size, chords * sagitta))
    return;
  warnings.push_back(
      {fmt::format(
           "pair {}: {} begins {} within {}: it is pushed out at once in the first step, and no motion "
           "does the work of that",
           pair.pair->name, pair.part->secondary, human(pair.overlap, "m"), pair.part->primary),
       fmt::format("sides that are {} further apart, and a motion that presses them",
                   human(pair.overlap, "m"))});
}

/// Do motions only hold the points, and the counterpart stands? Then nothing presses them.
bool stand_still(Facts const& all, PairFacts const& pair) {
  auto const& model = *all.scene->model;
  auto const& nodes = pair.pair->nodes();
  std::vector<bool> own(ix(model.node_count()), false);
  for (Index const node : nodes)
    own[ix(node)] = true;
  for (auto const& motion : model.motions)
    if (motion.farthest() > 0 && std::ranges::any_of(motion.nodes, [&](Index n) { return own[ix(n)]; }))
      return false;
  auto const& part = all.scene->part.obstacles.at(model.rigids[pair.rigid].name);
  auto const stays = [](core::Numbers const& values) {
    return std::ranges::all_of(values, [](double value) { return value == 0; });
  };
  return !model.rigids[pair.rigid].free() && stays(part.x) && stays(part.y) && stays(part.z) &&
         stays(part.angle);
}

/// Motions have hold of every point, and the counterpart is rigid: what they press has nothing to give way.
void gives_no_way(Facts const& all, PairFacts const& pair, std::vector<Warning>& warnings) {
  if (pair.motion.depth <= 0 || !nothing_gives_way(all, pair) || stand_still(all, pair))
    return;
  warnings.push_back(
      {fmt::format(
           "pair {}: all nodes of {} are held or driven in all directions, and the motions press them "
           "by {} into {}, which is rigid: the run will end there",
           pair.pair->name, pair.part->secondary, human(pair.motion.depth, "m"), pair.part->primary),
       fmt::format("motions of another set of body {}, or that leave {} free across the surface",
                   all.bodies[pair.secondary].body->name, pair.part->secondary)});
}

/// A dry ball, or a cylinder, that touches over few cells: its points come in one by one. Of three depths of
/// a ball forces were off by 6 to 10 % at 1.2 to 1.8 cells over the radius sqrt(R d), 7 to 50 % below, and
/// within 2 % from 2.5 on; a cylinder touches over less than sqrt(2 R d) where its body is no thinner than
/// that.
void few_cells(Facts const& all, PairFacts const& pair, std::vector<Warning>& warnings) {
  constexpr double few = 2, good = 4, rounding = 1e-6;
  if (pair.adheres() || pair.motion.unknown || !(pair.radius > 0) ||
      pair.motion.depth <= rounding * pair.size)
    return;
  bool const plane = all.scene->part.kinematics == solid::Kinematics::plane_strain;
  double const touched = std::sqrt((plane ? 2 : 1) * pair.radius * pair.motion.depth);
  if (touched >= few * pair.size)
    return;
  warnings.push_back(
      {fmt::format("pair {}: it touches over a radius of {}{}, {:.2g} cells of {}: forces and the largest "
                   "pressure will depend on the mesh, areas come in whole cells",
                   pair.pair->name, plane ? "at most " : "", human(touched, "m"), touched / pair.size,
                   human(pair.size, "m")),
       fmt::format("cells of {} or less at {}, which leave a few per cent of the force",
                   human(touched / good, "m"), pair.part->secondary)});
}

/// A side that flies or falls freely: its mass, kg (kg/m in plane strain), and how long a wave takes there
/// and back in what is struck or strikes, s.
struct Flight {
  double mass = 0, wave = 0;
  std::string name;
};

/// A wave along a body that is free to give way sideways is that of a bar, or of a plate in plane strain.
double wave_in(Facts const& all, BodyFacts const& body, int along) {
  bool held = false;
  for (int c = 0; c < all.scene->model->dim(); ++c)
    held = held || (c != along && body.held[ix(c)]);
  bool const plane = all.scene->part.kinematics == solid::Kinematics::plane_strain;
  double const stiffness = plane ? body.plane_modulus() : body.moduli.young;
  return 2 * body.extent() / (held ? body.pressure_speed() : std::sqrt(stiffness / body.body->density));
}

/// No mass: neither side flies.
Flight flight_of(Facts const& all, PairFacts const& pair) {
  auto const& model = *all.scene->model;
  int along = model.dim() - 1;
  if (!pair.normal.isZero(0))
    pair.normal.cwiseAbs().maxCoeff(&along);
  if (!pair.primary && model.rigids[pair.rigid].free())
    return {model.rigids[pair.rigid].mass, wave_in(all, all.bodies[pair.secondary], along),
            pair.part->primary};
  for (auto const number : {pair.secondary, pair.primary.value_or(pair.secondary)})
    if (auto const& body = all.bodies[number]; !body.held[ix(along)])
      return {body.mass, wave_in(all, body, along), body.body->name};
  return {};
}

/// A blow lasts as long as a wave goes there and back, and of a ball as Hertz has it, 2.87 (m^2 / (R E*^2
/// v))^(1/5) (Johnson 1985); steps that see it less often than that take what they like of it.
void blow(Facts const& all, PairFacts const& pair, std::vector<Warning>& warnings) {
  constexpr double few = 8, good = 50; // steps in it
  auto const flight = flight_of(all, pair);
  double const fallen = std::sqrt(2 * all.scene->model->gravity.norm() * std::max(pair.gap, 0.0)),
               speed = std::max(pair.motion.closing, fallen);
  if (!all.dynamic() || all.scene->part.schedule.accuracy || !pair.motion.unknown || pair.adheres() ||
      !(flight.mass > 0 && speed > 0))
    return;
  double lasts = flight.wave;
  if (pair.radius > 0 && all.scene->part.kinematics != solid::Kinematics::plane_strain)
    lasts = std::max(lasts, 2.87 * std::pow(flight.mass * flight.mass /
                                                (pair.radius * pair.modulus * pair.modulus * speed),
                                            0.2));
  if (lasts >= few * all.longest_step)
    return;
  warnings.push_back(
      {fmt::format(
           "pair {}: {} comes at about {} and touches for about {}, {:.2g} steps: what it keeps of its speed "
           "will depend on them",
           pair.pair->name, flight.name, human(speed, "m/s"), human(lasts, "s"), lasts / all.longest_step),
       fmt::format("steps of {} or less where they meet, or schedule accuracy", human(lasts / good, "s"))});
}

void obstacles_alone(Facts const& all, std::vector<Warning>& warnings) {
  for (auto const& [name, part] : all.scene->part.obstacles)
    if (std::ranges::none_of(all.scene->part.pairs,
                             [&name = name](auto const& entry) { return entry.second.primary == name; }))
      warnings.push_back(
          {fmt::format("obstacle {} is in no pair: nothing meets it", name),
           fmt::format("stiction.pair {{ secondary = ..., primary = \"{}\" }}, or leave it out", name)});
}

} // namespace

void warn_of_meeting(Facts const& all, std::vector<Warning>& warnings) {
  obstacles_alone(all, warnings);
  for (auto const& pair : all.pairs) {
    looks_away(all, pair, warnings);
    begins_inside(pair, warnings);
    gives_no_way(all, pair, warnings);
    few_cells(all, pair, warnings);
    blow(all, pair, warnings);
  }
}

} // namespace stiction::scene
