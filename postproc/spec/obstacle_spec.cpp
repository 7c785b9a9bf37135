// An obstacle is a disc, a half-plane or an outline, as its keys say.
#include "spec/obstacle_spec.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>

namespace stiction::postproc {

namespace {

using core::Need;
using core::Reader;

Point point_at(Reader& reader, std::string_view key, Need need, Point fallback) {
  auto const given = reader.numbers(key, "1", need);
  if (reader.has(key) && given.size() != 2)
    reader.complain_at(key, fmt::format("has {} numbers; [x, y] is wanted", given.size()));
  return given.size() == 2 ? Point{given[0], given[1]} : fallback;
}

Point times(double factor, Point p) {
  return {factor * p.x, factor * p.y};
}

void read_outline(Reader& reader, double metres, ObstacleSpec& obstacle) {
  auto const flat = reader.numbers("points", "1");
  if (reader.has("points") && (flat.size() % 2 != 0 || flat.size() < 4))
    reader.complain_at(
        "points",
        fmt::format("has {} numbers; at least two points [x1, y1, x2, y2, ...] are wanted", flat.size()));
  for (std::size_t i = 0; i + 1 < flat.size(); i += 2)
    obstacle.outline.push_back({metres * flat[i], metres * flat[i + 1]});
  obstacle.closed = reader.flag_or("closed", false);
}

ObstacleSpec read_obstacle(Reader& reader, double metres) {
  ObstacleSpec obstacle;
  if (reader.has("radius")) {
    obstacle.radius = metres * reader.number("radius", "1", core::positive);
    obstacle.at = times(metres, point_at(reader, "centre", Need::required, {}));
  } else if (reader.has("normal")) {
    obstacle.normal = point_at(reader, "normal", Need::required, {0, 1});
    obstacle.at = times(metres, point_at(reader, "point", Need::required, {}));
    if (obstacle.normal->x == 0 && obstacle.normal->y == 0)
      reader.complain_at("normal", "is zero; a direction is wanted");
  } else {
    read_outline(reader, metres, obstacle);
  }
  obstacle.hollow = reader.flag_or("hollow", false);
  obstacle.pivot =
      reader.has("pivot") ? times(metres, point_at(reader, "pivot", Need::required, {})) : obstacle.at;
  if (auto path = reader.child("path", Need::optional); reader.has("path"))
    obstacle.path = read_path(path, metres);
  reader.finish();
  return obstacle;
}

} // namespace

PathSpec read_path(Reader& path, double metres) {
  PathSpec result;
  result.times = path.numbers("times", "1");
  bool const rising = std::is_sorted(result.times.begin(), result.times.end(), std::less_equal<>());
  if (path.has("times") && (result.times.empty() || !rising))
    path.complain_at("times", "wants at least one time, each later than the one before");
  auto const read = [&](std::string const& key, double factor) {
    auto values = path.numbers(key, "1", Need::optional);
    for (auto& value : values)
      value *= factor;
    if (path.has(key) && values.size() != result.times.size())
      path.complain_at(key,
                       fmt::format("has {} numbers but times has {}", values.size(), result.times.size()));
    return values;
  };
  result.moves = {read("x", metres), read("y", metres), read("z", metres)};
  result.angle = read("angle", 1);
  path.finish();
  return result;
}

std::vector<ObstacleSpec> read_obstacles(Reader& reader, double metres, bool solid) {
  std::vector<ObstacleSpec> list;
  for (auto& obstacle : reader.children("obstacles", Need::optional))
    list.push_back(read_obstacle(obstacle, metres));
  if (solid && !list.empty())
    reader.complain_at("obstacles", "are drawn in plane pictures; beside a \"view\" there is \"sphere\"");
  return list;
}

} // namespace stiction::postproc
