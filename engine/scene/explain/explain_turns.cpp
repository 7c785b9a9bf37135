// Bodies that are turned by more than their law knows or whose moments it does not, and those torn from the
// axis of a section.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"
#include "solid/responses.hpp"

namespace stiction::scene {

namespace {

/// A law of small strains leaves its forces where they were: about turned points what is held across the axis
/// makes a moment that is none, by the angle times it.
void moments(Facts const& all, TurnPart const& turn, std::string_view law, std::vector<Warning>& warnings) {
  auto const& facts = body_of(all, turn.set);
  bool const pressed =
      std::ranges::any_of(all.pairs, [&](auto const& pair) { return is_side(all, pair, facts); });
  for (auto const& [name, probe] : all.scene->part.probes)
    if (auto const* force = std::get_if<ForceProbe>(&probe);
        force != nullptr && force->set == turn.set && pressed)
      warnings.push_back(
          {fmt::format(
               "probe {}: the forces of {} do not turn with {}: where it is pressed as well, moments have "
               "the angle times what is held across the axis too much or too little",
               name, law, turn.set),
           law_of_large_strains(facts) + ", or the moment of what it meets: probe.rigid"});
}

} // namespace

void warn_of_turns(Facts const& all, std::vector<Warning>& warnings) {
  constexpr double much = 0.2; // rad: a strain of 2 %
  for (auto const& motion : all.scene->part.motions) {
    auto const* turn = std::get_if<TurnPart>(&motion);
    if (turn == nullptr)
      continue;
    auto const& facts = body_of(all, turn->set);
    auto const [low, high] = std::ranges::minmax(turn->angle);
    double const angle = std::max(std::abs(low), std::abs(high));
    if (!solid::small_strain(facts.body->material) || angle == 0)
      continue;
    auto const law = std::visit([](auto const& own) { return own.schema().name; }, facts.body->material);
    moments(all, *turn, law, warnings);
    if (angle <= much)
      continue;
    warnings.push_back(
        {fmt::format(
             "{}: it is turned by {:.2g} rad, and {} knows small strains and rotations only: of that it "
             "makes a strain of {:.2g} %",
             turn->set, angle, law, 100 * (1 - std::cos(std::min(angle, 3.0)))),
         law_of_large_strains(facts)});
  }
}

void warn_of_holes(Facts const& all, std::vector<Warning>& warnings) {
  auto const& model = *all.scene->model;
  if (model.kinematics != solid::Kinematics::axisymmetric)
    return;
  for (auto const& motion : model.motions) {
    auto const held = [&](Index node) { return model.reference(node, 0) == 0; };
    if (motion.component == 0 && motion.farthest() > 0 && std::ranges::any_of(motion.nodes, held))
      warnings.push_back(
          {fmt::format("{}: nodes on the axis are moved off it in x, by up to {}, which opens a hole",
                       motion.set, human(motion.farthest(), "m")),
           "a set without the nodes at x = 0, or no x"});
  }
}

} // namespace stiction::scene
