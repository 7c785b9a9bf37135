// What the scene models, in plain words: bodies, obstacles, pairs, motions, and how the run goes.
#include <cmath>
#include <fmt/format.h>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

void add(Section& section, std::string name, std::string words, double value) {
  section.lines.push_back({std::move(name), std::move(words), value, "1", ""});
}

std::string words_of(core::Value const& value, std::string const& unit) {
  if (auto const* number = std::get_if<double>(&value)) // nu = 0.4999 is not 0.5
    return unit.empty() || unit == "1" ? fmt::format("{:.6g}", *number) : human(*number, unit);
  if (auto const* numbers = std::get_if<Numbers>(&value)) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < numbers->size() && i < 6; ++i)
      words.push_back(human((*numbers)[i], unit));
    return fmt::format("{{{}{}}}", fmt::join(words, ", "), numbers->size() > 6 ? ", ..." : "");
  }
  return core::to_string(value);
}

/// "category.kind{young = 5 MPa, poisson = 0.48}"; empty lists and texts are left out.
std::string settings(std::string const& category, void const* part, core::Schema const& schema) {
  std::vector<std::string> words;
  for (auto const& parameter : schema.parameters) {
    if (parameter.kind == core::Parameter::Kind::nested)
      continue;
    auto const value = parameter.get(part);
    auto const* numbers = std::get_if<Numbers>(&value);
    if (numbers != nullptr && numbers->empty())
      continue;
    words.push_back(fmt::format("{} = {}", parameter.name, words_of(value, parameter.unit)));
  }
  return fmt::format("{}{}{}{{{}}}", category, category.empty() ? "" : ".", schema.name,
                     fmt::join(words, ", "));
}
template<class Choice> std::string chosen(std::string const& category, Choice const& choice) {
  return std::visit([&](auto const& part) { return settings(category, &part, part.schema()); }, choice);
}

/// "0 at 0 s, -1.5 mm at 2 s"
std::string path_words(Numbers const& times, Numbers const& values, char const* unit) {
  std::vector<std::string> words;
  for (std::size_t k = 0; k < times.size() && k < 6; ++k)
    words.push_back(fmt::format("{} at {}", human(values[k], unit), human(times[k], "s")));
  return fmt::format("{}{}", fmt::join(words, ", "), times.size() > 6 ? ", ..." : "");
}

template<class Part> void add_paths(Section& section, std::string const& what, Part const& part) {
  for (auto const& [axis, values] : {std::pair{"x", &part.x}, {"y", &part.y}, {"z", &part.z}})
    if (!values->empty())
      add(section, fmt::format("{} in {}", what, axis), path_words(part.times, *values, "m"));
}

/// A boundary with heights.
void add_relief(Facts const& all, std::string const& name, Section& section) {
  auto const found = all.scene->reliefs.find(name);
  if (found == all.scene->reliefs.end())
    return;
  auto const& part = *all.scene->part.bodies.at(name).relief;
  auto const& made = found->second;
  add(section, "relief", settings("", &part, ReliefPart::schema()));
  if (!std::holds_alternative<halfspace::Map>(part.surface)) // of which all heights would stand here
    add(section, "surface", chosen("surface", part.surface));
  add(section, "heights",
      fmt::format("from {} to {} at its nodes, up to {} apart", human(made.least, "m"), human(made.most, "m"),
                  human(made.spacing, "m")));
}

/// "2500 quad4"
std::string cell_words(solid::Body const& body) {
  std::vector<std::string> words;
  for (auto const& block : body.mesh.blocks)
    if (!block.nodes.empty())
      words.push_back(fmt::format("{} {}",
                                  static_cast<int>(block.nodes.size()) / mesh::info(block.kind).nodes,
                                  mesh::info(block.kind).name));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// "G_k = 1 kPa, K_k = 2 kPa"
std::string moduli_words(material::PronyTerm const& term, material::Moduli const& at_rest) {
  std::vector<std::string> words;
  if (term.in_shear())
    words.push_back("G_k = " + human(term.stiffness(at_rest.shear()), "Pa"));
  if (term.in_volume())
    words.push_back("K_k = " + human(term.bulk_stiffness(at_rest.bulk()), "Pa"));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// Each time against the steps and the run.
void add_relaxation(Facts const& all, BodyFacts const& facts, Section& section) {
  double at_once = 1, in_volume = 1;
  double const shear = facts.moduli.shear(), bulk = facts.moduli.bulk();
  for (auto const& term : facts.body->relaxing) {
    at_once += term.stiffness(shear) / shear;
    in_volume += term.bulk_stiffness(bulk) / bulk;
    std::string words =
        fmt::format("{}, {:.2g} of the longest step, {:.2g} of the run", moduli_words(term, facts.moduli),
                    term.time / all.unseen_step, term.time / all.end);
    if (term.time < 0.1 * all.unseen_step)
      words += ": gone within a step";
    else if (term.time > 10 * all.end)
      words += ": a spring, as long as the run lasts";
    add(section, "relaxes in " + human(term.time, "s"), words, term.time);
  }
  if (at_once > 1)
    add(section, "at once", fmt::format("{:.4g} times as stiff in shear as at rest", at_once), at_once);
  if (in_volume > 1)
    add(section, "at once in volume", fmt::format("{:.4g} times as stiff as at rest", in_volume), in_volume);
}

void add_body(Facts const& all, BodyFacts const& facts, Explanation& explanation) {
  auto const& body = *facts.body;
  int const dim = all.scene->part.dim();
  Section section{"Body " + body.name, {}};
  std::string sides;
  for (int c = 0; c < dim; ++c)
    sides += (c > 0 ? " x " : "") + human(facts.sides[c], "m");
  add(section, "size", fmt::format("{}, shortest edge {}", sides, human(facts.smallest_edge, "m")));
  add(section, "cells",
      fmt::format("{} with {} interpolation{}", cell_words(body),
                  body.interpolation == solid::Interpolation::plain ? "plain" : "mean_dilatation",
                  body.plane_stress ? ", in plane stress" : ""),
      body.mesh.cell_count());
  add(section, "nodes", counted(body.mesh.node_count()), body.mesh.node_count());
  add(section, "unknowns", fmt::format("{} free, {} driven or held", facts.free, facts.driven), facts.free);
  auto const& laws = all.scene->part.bodies.at(body.name).laws_by_set;
  if (laws.empty())
    add(section, "material", chosen("material", body.material));
  for (auto const& [set, law] : laws)
    add(section, "material of " + set, chosen("material", law));
  if (!laws.empty())
    add(section, "numbers", "by the most compliant of these laws");
  add(section, "at rest",
      fmt::format("E = {}, nu = {:.6g}, G = {}, K = {}", human(facts.moduli.young, "Pa"),
                  facts.moduli.poisson, human(facts.moduli.shear(), "Pa"), human(facts.moduli.bulk(), "Pa")));
  if (body.damping)
    add(section, "damping", settings("damping", &*body.damping, material::KelvinVoigt::schema()));
  add_relaxation(all, facts, section);
  add_relief(all, body.name, section);
  bool const per_metre = all.scene->part.kinematics == solid::Kinematics::plane_strain;
  section.lines.push_back(
      {"mass", human(facts.mass, per_metre ? "kg/m" : "kg"), facts.mass, per_metre ? "kg/m" : "kg", ""});
  if (facts.start_speed > 0)
    section.lines.push_back({"initial speed", human(facts.start_speed, "m/s"), facts.start_speed, "m/s", ""});
  explanation.sections.push_back(std::move(section));
}

/// Of a height map: the smallest radius of its peaks.
void add_peaks(Facts const& all, std::string const& name, Section& section) {
  for (auto const& rigid : all.scene->model->rigids) {
    if (rigid.name != name)
      continue;
    double const radius = contact::sharpest_peak(std::get<contact::RigidHeights>(rigid.shape));
    if (std::isfinite(radius))
      section.lines.push_back({"peaks", "radii down to " + human(radius, "m"), radius, "m", ""});
  }
}

void add_obstacle(Facts const& all, std::string const& name, ObstaclePart const& part,
                  Explanation& explanation) {
  Section section{"Obstacle " + name, {}};
  add(section, "shape", chosen("rigid", part.shape));
  if (part.surface &&
      !std::holds_alternative<halfspace::Map>(*part.surface)) // of which all heights would stand here
    add(section, "surface", chosen("surface", *part.surface));
  if (part.surface)
    add_peaks(all, name, section);
  add_paths(section, "moves", part);
  if (!part.angle.empty())
    add(section, "turns", path_words(part.times, part.angle, "rad"));
  if (part.mass > 0)
    add(section, "free",
        fmt::format(
            "where it has no path: mass {:.3g} kg, inertia {:.3g} kg m^2", part.mass,
            fmt::join(part.inertia_tensor.empty() ? std::vector{part.inertia} : part.inertia_tensor, ", ")));
  else if (part.times.empty())
    add(section, "moves", "not at all");
  explanation.sections.push_back(std::move(section));
}

/// What acts along the surface, and so how many unknowns a contact point has.
std::string component_words(Facts const& all) {
  if (all.components == 1)
    return "1 per point, along the normal: no law acts along the surface";
  return fmt::format("{} per point: along the normal and the surface", all.components);
}

void add_pair(Facts const& all, PairFacts const& facts, Explanation& explanation) {
  auto const& pair = *facts.pair;
  Section section{"Pair " + pair.name, {}};
  add(section, "contact points",
      fmt::format("{} on {}, cells of {}", pair.size(), facts.part->secondary, human(facts.size, "m")),
      pair.size());
  add(section, "against",
      facts.primary ? fmt::format("{} facets of {}, {} on average", facts.facets, facts.part->primary,
                                  human(facts.primary_size, "m"))
                    : "obstacle " + facts.part->primary);
  add(section, "discretisation",
      pair.mortar ? "mortar: averages around the corner nodes" : "node_to_segment");
  add(section, "components", component_words(all), all.components);
  section.lines.push_back({"state", human(sizeof(dynamics::ContactState), "B") + " per point",
                           sizeof(dynamics::ContactState), "B", ""});
  add(section, "friction", pair.law.friction ? chosen("friction", *pair.law.friction) : "none");
  add(section, "adhesion", pair.law.adhesion ? chosen("adhesion", *pair.law.adhesion) : "none");
  if (facts.gap >= 0)
    section.lines.push_back({"gap at the start",
                             (facts.overlap > 0 ? "-" : "") + human(std::max(facts.gap, facts.overlap), "m"),
                             facts.gap - facts.overlap, "m", ""});
  section.lines.push_back({"reach", human(pair.reach, "m"), pair.reach, "m", ""});
  explanation.sections.push_back(std::move(section));
}

void add_motion(MotionPart const& motion, int dim, Section& section) {
  if (auto const* drive = std::get_if<DrivePart>(&motion))
    return add_paths(section, drive->set, *drive);
  if (auto const* turn = std::get_if<TurnPart>(&motion)) {
    add(section, turn->set,
        fmt::format("turns about {}{}: {}", words_of(turn->centre, "m"),
                    turn->axis.empty() ? "" : ", axis " + words_of(turn->axis, "1"),
                    path_words(turn->times, turn->angle, "rad")));
    return add_paths(section, "axis of " + turn->set, *turn);
  }
  auto const& fix = std::get<FixPart>(motion);
  add(section, fix.set,
      fmt::format("held in{}{}{}", fix.x ? " x" : "", fix.y ? " y" : "", fix.z && dim == 3 ? " z" : ""));
}

void add_run(Facts const& facts, Explanation& explanation) {
  auto const& part = facts.scene->part;
  Section section{"Run", {}};
  static constexpr std::array<char const*, 3> kinematics{
      "plane strain, forces per metre of depth",
      "axisymmetric: x is the radius, y the axis; forces of the full turn", "three-dimensional"};
  add(section, "kinematics", kinematics[static_cast<std::size_t>(part.kinematics)]);
  if (!facts.scene->model->gravity.isZero(0))
    add(section, "gravity", words_of(part.gravity, "m/s^2"));
  add(section, "scheme", chosen("scheme", part.scheme));
  if (facts.scene->model->held_by_bonds)
    add(section, "held by", "the motions together with the bonds that are whole at the start");
  add(section, "solver", chosen("solver", part.solver));
  add(section, "control", settings("", &part.control, dynamics::StepControl::schema()));
  double start = 0;
  for (std::size_t s = 0; s < part.schedule.stages.size(); ++s) {
    auto const& stage = part.schedule.stages[s];
    add(section, fmt::format("stage {}", s + 1),
        fmt::format("to {} in {} steps of {}", human(stage.until, "s"), stage.steps,
                    human((stage.until - start) / stage.steps, "s")),
        stage.steps);
    start = stage.until;
  }
  explanation.sections.push_back(std::move(section));
}

/// The set that follows, and what.
std::pair<std::string, std::string> words_of(ConstraintPart const& constraint, double moved) {
  if (auto const* roller = std::get_if<RollerPart>(&constraint))
    return {roller->set, fmt::format("on rollers across ({:g})", fmt::join(roller->normal, ", "))};
  if (auto const* periodic = std::get_if<PeriodicPart>(&constraint))
    return {periodic->set, "moves as " + periodic->to};
  auto const& tied = std::get<TiedPart>(constraint);
  return {tied.set,
          "tied to " + tied.to +
              (moved > 0 ? fmt::format(", its nodes moved onto it by up to {}", human(moved, "m")) : "")};
}

Section constraints_of(Scene const& scene) {
  Section section{"Constraints", {}};
  for (std::size_t k = 0; k < scene.part.constraints.size(); ++k) {
    auto const [set, words] = words_of(scene.part.constraints[k], scene.moved[k]);
    add(section, set, words);
  }
  add(section, "followers", fmt::format("{} components", scene.model->links.size()),
      static_cast<double>(scene.model->links.size()));
  return section;
}

} // namespace

void describe_scene(Facts const& facts, Explanation& explanation) {
  auto const& part = facts.scene->part;
  for (auto const& body : facts.bodies)
    add_body(facts, body, explanation);
  for (auto const& [name, obstacle] : part.obstacles)
    add_obstacle(facts, name, obstacle, explanation);
  for (auto const& pair : facts.pairs)
    add_pair(facts, pair, explanation);
  Section motions{"Motions", {}};
  for (auto const& motion : part.motions)
    add_motion(motion, part.dim(), motions);
  if (!motions.lines.empty())
    explanation.sections.push_back(std::move(motions));
  describe_loads(facts, explanation);
  if (!part.constraints.empty())
    explanation.sections.push_back(constraints_of(*facts.scene));
  describe_springs(facts, explanation);
  add_run(facts, explanation);
}

} // namespace stiction::scene
