// Bodies that are turned by more than their law knows.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "scene/explain/facts.hpp"
#include "solid/responses.hpp"

namespace stiction::scene {

void warn_of_turns(Facts const& all, std::vector<Warning>& warnings) {
  constexpr double much = 0.2; // rad: a strain of 2 %
  for (auto const& motion : all.scene->part.motions) {
    auto const* turn = std::get_if<TurnPart>(&motion);
    if (turn == nullptr)
      continue;
    auto const& facts = body_of(all, turn->set);
    auto const [low, high] = std::ranges::minmax(turn->angle);
    double const angle = std::max(std::abs(low), std::abs(high));
    if (!solid::small_strain(facts.body->material) || angle <= much)
      continue;
    auto const law = std::visit([](auto const& own) { return own.schema().name; }, facts.body->material);
    warnings.push_back(
        {fmt::format(
             "{}: it is turned by {:.2g} rad, and {} knows small strains and rotations only: of that it "
             "makes a strain of {:.2g} %",
             turn->set, angle, law, 100 * (1 - std::cos(std::min(angle, 3.0)))),
         law_of_large_strains(facts)});
  }
}

} // namespace stiction::scene
