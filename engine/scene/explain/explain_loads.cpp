// What acts on surfaces, and how much that is beside the bodies.
#include <algorithm>
#include <fmt/format.h>
#include <numeric>
#include <set>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

std::string path_words(Numbers const& times, Numbers const& values, std::string const& unit) {
  std::vector<std::string> words;
  std::size_t const shown = std::min({times.size(), values.size(), std::size_t{6}});
  words.reserve(shown);
  for (std::size_t k = 0; k < shown; ++k)
    words.push_back(fmt::format("{} at {}", human(values[k], unit), human(times[k], "s")));
  return fmt::format("{}{}", fmt::join(words, ", "), times.size() > 6 ? ", ..." : "");
}

void describe(Facts const&, TractionPart const& part, Section& section) {
  add(section, part.set, "dead traction");
}
void describe(Facts const&, PointForcePart const& part, Section& section) {
  add(section, part.set, "dead force at a node");
}
void describe(Facts const&, PressurePart const& part, Section& section) {
  add(section, part.set,
      fmt::format("{} pressure {}", part.follows ? "following" : "dead",
                  path_words(part.times, part.pressure, "Pa")));
}
void describe(Facts const& all, GasPart const& part, Section& section) {
  double volume = 0;
  for (auto const& gas : all.scene->model->gases)
    if (gas.set == part.set)
      volume = gas.volume;
  char const* unit = all.scene->part.kinematics == solid::Kinematics::plane_strain ? "m^2" : "m^3";
  auto const what = part.volume.empty()
                        ? "gas, pressure at the first volume " + path_words(part.times, part.pressure, "Pa")
                        : "gas of volume " + path_words(part.times, part.volume, "1");
  auto const seal = part.seal.empty() ? "" : fmt::format("; leaks {:g} m off its seal", part.leaks_at);
  section.lines.push_back(
      {part.set, fmt::format("{}; cavity of {:.4g} {}{}", what, volume, unit, seal), volume, unit, ""});
}
void describe(Facts const& all, SurfaceStressPart const& part, Section& section) {
  auto const& body = body_of(all, part.set);
  double const length = part.gamma / body.moduli.young;
  section.lines.push_back(
      {part.set,
       fmt::format("surface stress {}: rounds what is finer than gamma / E = {}, edges of {}",
                   human(part.gamma, "N/m"), human(length, "m"), human(body.smallest_edge, "m")),
       length, "m", "gamma / E"});
}

/// Where a path is above 0 under a seal, which lets that out at once.
void warn_of_vent(GasPart const& part, std::vector<Warning>& warnings) {
  auto const over = std::ranges::find_if(part.pressure, [](double p) { return p > 0; });
  if (part.seal.empty() || over == part.pressure.end())
    return;
  auto const k = static_cast<std::size_t>(over - part.pressure.begin());
  warnings.push_back(
      {fmt::format("load of {}: its pressure is {} at {}, and under a seal gas goes out whenever "
                   "it is over that outside: none of that acts",
                   part.set, human(*over, "Pa"), human(part.times[k], "s")),
       "a pressure below 0 (suction) or the `volume`, or a wall that is closed, without `seal`"});
}

/// Does anything but its bonds act on a body along the normal of one of its pairs: motions, springs, weight?
bool helped(Facts const& all, PairFacts const& pair) {
  auto const& model = *all.scene->model;
  Index const first = model.first_node[pair.secondary], end = model.first_node[pair.secondary + 1];
  constexpr double along = 0.1; // part of a direction
  return !model.springs.empty() || !model.links.empty() || !model.gravity.isZero(0) ||
         std::ranges::any_of(model.motions, [&](dynamics::Motion const& motion) {
           return std::abs(pair.normal[motion.component]) > along &&
                  std::ranges::any_of(motion.nodes, [&](Index node) { return node >= first && node < end; });
         });
}

/// Largest force by which dead loads draw a body off the counterpart of one of its pairs, N.
double pull_of(Facts const& all, PairFacts const& pair) {
  auto const& model = *all.scene->model;
  int const dim = model.dim();
  Index const first = model.first_node[pair.secondary], end = model.first_node[pair.secondary + 1];
  std::vector<double> pulls; // of each load, per unit of its path
  for (auto const& load : model.loads) {
    pulls.push_back(0);
    for (Index node = first; node < end; ++node)
      pulls.back() -= load.force.segment(dim * node, dim).dot(pair.normal.head(dim));
  }
  double most = 0;
  for (auto const& knots : model.loads)
    for (double const t : knots.path.times) {
      double pull = 0;
      for (std::size_t k = 0; k < pulls.size(); ++k)
        pull += model.loads[k].path.value(t) * pulls[k];
      most = std::max(most, pull);
    }
  return most;
}

/// Loads that draw a body off at more than all of its bonds bear at their peak together.
void warn_of_overload(Facts const& all, std::vector<Warning>& warnings) {
  std::set<std::size_t> seen;
  for (auto const& pair : all.pairs) {
    if (all.dynamic() || !pair.adheres() || pair.primary || pair.normal.isZero(0) || helped(all, pair) ||
        !seen.insert(pair.secondary).second)
      continue;
    double borne = 0;
    for (auto const& other : all.pairs)
      if (other.secondary == pair.secondary || other.primary == pair.secondary)
        borne += !other.adheres()
                     ? 0
                     : interface::scales(*other.pair->law.adhesion).strength *
                           std::accumulate(other.pair->areas.begin(), other.pair->areas.end(), 0.0);
    double const pull = pull_of(all, pair);
    char const* unit = all.scene->part.kinematics == solid::Kinematics::plane_strain ? "N/m" : "N";
    if (pull > borne)
      warnings.push_back(
          {fmt::format(
               "body {}: its loads pull with {}, and all of its bonds bear {} at their peak together: it "
               "comes off",
               all.bodies[pair.secondary].body->name, human(pull, unit), human(borne, unit)),
           "smaller loads, stronger bonds, or a motion in place of the load, which shows how they let go"});
  }
}

} // namespace

void describe_loads(Facts const& all, Explanation& explanation) {
  Section section{"Loads", {}};
  for (auto const& load : all.scene->part.loads)
    std::visit([&](auto const& part) { describe(all, part, section); }, load);
  for (auto const& load : all.scene->part.loads)
    if (auto const* gas = std::get_if<GasPart>(&load))
      warn_of_vent(*gas, explanation.warnings);
  warn_of_overload(all, explanation.warnings);
  if (!section.lines.empty())
    explanation.sections.push_back(std::move(section));
}

} // namespace stiction::scene
