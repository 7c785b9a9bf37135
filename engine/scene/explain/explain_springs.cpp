// What springs couple, how fast they swing, and what they cost.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

constexpr std::size_t many = 400;     ///< nodes in a mean, whose matrix is a full one of that size
constexpr double worth_telling = 0.1; ///< of a swing's energy

/// Mass of the body or free obstacle that the node is of, kg.
double mass_at(Facts const& all, Index node) {
  for (auto const& rigid : all.scene->model->rigids)
    if (rigid.free() && rigid.node == node)
      return rigid.mass;
  std::size_t b = 0;
  while (node >= all.scene->model->first_node[b + 1])
    ++b;
  return all.bodies[b].mass;
}

/// 2 pi sqrt(m / k) with both ends' masses as rigid ones, s.
double period(Facts const& all, dynamics::Spring const& spring) {
  double rate = 1 / mass_at(all, spring.from.nodes.front());
  if (!spring.to.nodes.empty())
    rate += 1 / mass_at(all, spring.to.nodes.front());
  double const part = spring.along == dynamics::SpringAlong::axes ? spring.axes.maxCoeff() : 1;
  return 2 * std::numbers::pi / std::sqrt(part * spring.stiffness * rate);
}

/// What backward Euler, which moves free rigid bodies beside contact, takes of a swing's energy in the run,
/// 1 - (1 + (omega dt)^2)^-steps.
double taken(double period, double end, double steps) {
  double const turn = 2 * std::numbers::pi / period * end / steps;
  return 1 - std::pow(1 + turn * turn, -steps);
}

bool on_free_body(Facts const& all, dynamics::Spring const& spring) {
  return std::ranges::any_of(all.scene->model->rigids, [&](auto const& rigid) {
    auto const is = [&](dynamics::SpringEnd const& end) {
      return !end.nodes.empty() && end.nodes.front() == rigid.node;
    };
    return rigid.free() && (is(spring.from) || is(spring.to));
  });
}

void warn_of_free_body(Facts const& all, dynamics::Spring const& spring, std::vector<Warning>& warnings) {
  double const T = period(all, spring), part = taken(T, all.end, static_cast<double>(all.steps));
  if (part <= worth_telling)
    return;
  double const turns = 2 * std::numbers::pi * all.end / T;
  double const steps = std::ceil(turns * turns / -std::log1p(-worth_telling));
  warnings.push_back(
      {fmt::format("spring {}: the free body on it goes by backward Euler, which takes {} of "
                   "what swings in the run",
                   spring.name, percent(part)),
       fmt::format("contact_inertia = \"full\" where it hardly touches, or {:.0f} steps in all "
                   "instead of {}, which take a tenth",
                   steps, all.steps)});
}

std::string end_words(std::string const& name, dynamics::SpringEnd const& end) {
  if (end.nodes.size() > 1)
    return fmt::format("the mean of {} nodes of {}", end.nodes.size(), name);
  return name;
}

std::string way_words(SpringPart const& part, dynamics::Spring const& spring) {
  if (spring.along == dynamics::SpringAlong::line)
    return "along the line between its ends";
  if (spring.along == dynamics::SpringAlong::direction)
    return fmt::format("along the direction ({:.4g})", fmt::join(part.direction, ", "));
  std::string axes;
  for (int c = 0; c < 3; ++c)
    if (spring.axes[c] > 0)
      axes += fmt::format("{}{}", axes.empty() ? "" : ", ", "xyz"[c]);
  return "along " + axes;
}

} // namespace

void describe_springs(Facts const& all, Explanation& explanation) {
  auto const& model = *all.scene->model;
  bool const plane = model.kinematics == solid::Kinematics::plane_strain;
  for (auto const& spring : model.springs) {
    auto const& part = all.scene->part.springs.at(spring.name);
    Section section{"Spring " + spring.name, {}};
    std::string const place = spring.spread ? "where each of them is" : "a place";
    add(section, "acts",
        fmt::format("between {} and {}, {}",
                    spring.spread ? "each node of " + part.from : end_words(part.from, spring.from),
                    part.to.empty() ? place : end_words(part.to, spring.to), way_words(part, spring)));
    if (spring.stiffness > 0)
      section.lines.push_back({"stiffness", human(spring.stiffness, plane ? "N/m^2" : "N/m"),
                               spring.stiffness, plane ? "N/m^2" : "N/m", ""});
    if (spring.damping > 0)
      section.lines.push_back({"damping", human(spring.damping, plane ? "N s/m^2" : "N s/m"), spring.damping,
                               plane ? "N s/m^2" : "N s/m", ""});
    if (spring.stretch != 0)
      section.lines.push_back(
          {"elongation at the start", human(spring.stretch, "m"), spring.stretch, "m", ""});
    if (spring.stiffness > 0 && all.dynamic()) {
      double const T = period(all, spring);
      section.lines.push_back({"period", human(T, "s") + " with the masses of its ends", T, "s", ""});
    }
    explanation.sections.push_back(std::move(section));
  }
}

void warn_of_springs(Facts const& all, std::vector<Warning>& warnings) {
  for (auto const& spring : all.scene->model->springs) {
    auto const nodes = spring.from.nodes.size() + spring.to.nodes.size();
    if (!spring.spread && nodes > many)
      warnings.push_back(
          {fmt::format(
               "spring {}: its means couple {} nodes with each other, {:.2g} numbers more in the matrix",
               spring.name, nodes, 0.5 * static_cast<double>(nodes * nodes)),
           "name a smaller set, or spread = true"});
    if (spring.stiffness > 0 && all.dynamic() && all.longest_step > 0.1 * period(all, spring))
      warnings.push_back(
          {fmt::format("spring {}: a step of {} is more than a tenth of its period {}", spring.name,
                       human(all.longest_step, "s"), human(period(all, spring), "s")),
           "more steps show its swings; where they do not matter leave it"});
    if (spring.stiffness > 0 && dynamics::weights(all.scene->model->scheme).surface_apart() &&
        on_free_body(all, spring))
      warn_of_free_body(all, spring, warnings);
  }
}

} // namespace stiction::scene
