// Borders of curves are ends of their chains, those of surfaces the sides without a neighbour.
#include "scene/run/at_border.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace stiction::scene {

namespace {

/// Part of a facet.
constexpr double near_border = 0.1;

bool at_border(contact::Curve const& curve, contact::Foot const& foot) {
  auto const& segment = curve.segments()[ix(foot.segment)];
  return (segment.previous < 0 && foot.xi < near_border) || (segment.next < 0 && foot.xi > 1 - near_border);
}

/// How far a foot is from each side, over the way across the facet.
std::array<double, 4> from_sides(contact::Facet const& facet, contact::Foot const& foot) {
  if (facet.count == 3)
    return {foot.eta, 1 - foot.xi - foot.eta, foot.xi, 1};
  return {0.5 * (1 + foot.eta), 0.5 * (1 - foot.xi), 0.5 * (1 - foot.eta), 0.5 * (1 + foot.xi)};
}

bool at_border(contact::Surface const& surface, contact::Foot const& foot) {
  auto const& facet = surface.facets()[ix(foot.segment)];
  auto const away = from_sides(facet, foot);
  for (std::size_t side = 0; side < ix(facet.count); ++side)
    if (facet.neighbour[side] < 0 && away[side] < near_border)
      return true;
  return false;
}

bool at_border(dynamics::Pair const& pair, contact::Foot const& foot) {
  if (auto const* curve = std::get_if<contact::Curve>(&pair.primary))
    return at_border(*curve, foot);
  if (auto const* surface = std::get_if<contact::Surface>(&pair.primary))
    return at_border(*surface, foot);
  return false;
}

} // namespace

std::string slid_off(Scene const& scene, dynamics::State const& old, dynamics::ContactSystem const& failed) {
  std::string words;
  failed.each_point([&](dynamics::PointId id, Indices const& nodes, Dense const&) {
    auto const pair = static_cast<std::size_t>(id.pair);
    auto const& before = old.contacts[pair][ix(id.index)];
    if (!words.empty() || !nodes.empty() || !before.foot.found() ||
        before.status == interface::Status::open || !at_border(scene.model->pairs[pair], before.foot))
      return;
    words = fmt::format("point {} of pair {} slides off the border of its counterpart, which has pressed it "
                        "until then: let the primary go on round the corner, or end before that",
                        id.index + 1, scene.pairs[pair]);
  });
  return words;
}

} // namespace stiction::scene
