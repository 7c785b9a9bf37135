// Doubts of single steps put together.
#include "scene/remarks.hpp"

#include <fmt/format.h>

#include "scene/human.hpp"

namespace stiction::scene {

namespace {

contact::Doubts doubts(dynamics::ContactStage const& contact, contact::Look look) {
  auto const& problem = contact.problem();
  if (problem.points.empty())
    return {};
  return contact::doubts(problem, contact.forces(), contact::displacement(problem, contact.forces()), look);
}

/// "point 17 of pair floor", counted from one as in the pair's line of points.
std::string place_of(Scene const& scene, dynamics::ContactStage const& contact, Index row) {
  auto const place = contact.place(row);
  return fmt::format("point {} of pair {}", place.index + 1,
                     scene.pairs[static_cast<std::size_t>(place.pair)]);
}

} // namespace

void Remarks::look(dynamics::ContactStage const& contact, double t, contact::Look look) {
  ++steps_;
  auto const found = doubts(contact, look);
  auto const note = [&](Remark& remark, auto const& doubt) {
    if (++remark.steps == 1)
      remark.text = fmt::format("at t = {}, {}: {}", human(t, "s"), place_of(*scene_, contact, doubt.worst),
                                words(doubt));
  };
  if (found.friction.points > 0)
    note(friction_, found.friction);
  if (found.softening.any())
    note(softening_, found.softening);
}

std::vector<std::string> Remarks::texts() const {
  std::vector<std::string> all;
  for (auto const* remark : {&friction_, &softening_})
    if (remark->steps > 0)
      all.push_back(fmt::format("{} ({} of {} steps)", remark->text, remark->steps, steps_));
  return all;
}

} // namespace stiction::scene
