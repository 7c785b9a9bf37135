// Paths whose turns lie within steps, which see their ends alone.
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "scene/description/human.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

constexpr double unseen = 0.1;       // of what a path goes through in all
constexpr double same_time = 1e-9;   // of the run
constexpr double share_of_way = 0.5; // of the way to a turn, for a step that sees it come

struct NamedPath {
  std::string what;
  char const* unit;
  dynamics::Path const* path;
};

std::vector<NamedPath> all_paths(Facts const& all) {
  auto const& model = *all.scene->model;
  std::vector<NamedPath> paths;
  auto const add = [&](std::string what, char const* unit, dynamics::Path const& path) {
    if (!path.constant() && std::ranges::none_of(paths, [&](auto const& one) { return one.what == what; }))
      paths.push_back({std::move(what), unit, &path});
  };
  for (auto const& motion : model.motions) {
    if (!motion.set.empty())
      add(fmt::format("{} in {}", motion.set, "xyz"[motion.component]), "m", motion.path);
    if (motion.turn)
      add(fmt::format("the turn of {}", motion.set), "1", *motion.turn->angle);
  }
  for (auto const& rigid : model.rigids) {
    for (std::size_t c = 0; c < 3; ++c)
      add(fmt::format("obstacle {} in {}", rigid.name, "xyz"[c]), "m", rigid.shift[c]);
    add(fmt::format("the turn of obstacle {}", rigid.name), "1", rigid.angle);
  }
  for (std::size_t k = 0; k < model.pressures.size(); ++k)
    add(fmt::format("pressure {}", k + 1), "Pa", model.pressures[k].path);
  for (std::size_t k = 0; k < model.loads.size(); ++k)
    add(fmt::format("load {}", k + 1), "1", model.loads[k].path);
  return paths;
}

/// The step of the schedule that a time lies in.
std::array<double, 2> step_around(SchedulePart const& schedule, double time) {
  double start = 0;
  for (auto const& stage : schedule.stages) {
    if (time <= stage.until) {
      double const dt = (stage.until - start) / stage.steps,
                   from = start + dt * std::floor((time - start) / dt);
      return {from, std::min(from + dt, stage.until)};
    }
    start = stage.until;
  }
  return {time, time};
}

struct Turn {
  std::size_t knot = 0;
  double missed = 0;
  std::array<double, 2> step{};
};

/// The knot of which the steps around it see least.
Turn least_seen(Facts const& all, dynamics::Path const& path) {
  Turn worst;
  for (std::size_t k = 0; k < path.times.size(); ++k) {
    double const time = path.times[k];
    if (!(time > 0 && time < all.end))
      continue;
    auto const step = step_around(all.scene->part.schedule, time);
    if (std::min(time - step[0], step[1] - time) <= same_time * all.end)
      continue;
    double const part = (time - step[0]) / (step[1] - step[0]);
    double const seen = (1 - part) * path.value(step[0]) + part * path.value(step[1]);
    if (double const missed = std::abs(path.values[k] - seen); missed > worst.missed)
      worst = {k, missed, step};
  }
  return worst;
}

} // namespace

void warn_of_paths(Facts const& all, std::vector<Warning>& warnings) {
  if (all.scene->part.schedule.accuracy)
    return;
  for (auto const& [what, unit, path] : all_paths(all)) {
    auto const [low, high] = std::ranges::minmax(path->values);
    auto const turn = least_seen(all, *path);
    if (!(turn.missed > unseen * (high - low)))
      continue;
    double const at = path->times[turn.knot], before = turn.knot > 0 ? path->times[turn.knot - 1] : 0;
    warnings.push_back(
        {fmt::format("{}: its path turns at {} at {}, within the step from {} to {}, which sees no more than "
                     "its ends: {} of the way are passed over",
                     what, human(path->values[turn.knot], unit), human(at, "s"), human(turn.step[0], "s"),
                     human(turn.step[1], "s"), percent(turn.missed / (high - low))),
         fmt::format("a stage that ends at {}, or steps of {} or less", human(at, "s"),
                     human(share_of_way * (at - before), "s"))});
  }
}

} // namespace stiction::scene
