// Contact points on nodes that move as one: nothing decides how these share their reaction.
#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "dynamics/contact/twins.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

/// Of different pairs with the same counterpart, as many as there are; a corner may well be in two.
std::size_t common_nodes(PairFacts const& a, PairFacts const& b) {
  if (a.part->primary != b.part->primary)
    return 0;
  std::set<Index> const first(a.pair->nodes().begin(), a.pair->nodes().end());
  return static_cast<std::size_t>(
      std::ranges::count_if(b.pair->nodes(), [&](Index node) { return first.contains(node); }));
}

bool any_move_as_one(dynamics::Twins const& twins, Indices const& nodes) {
  std::set<Index> seen;
  return std::ranges::any_of(nodes, [&](Index node) { return !seen.insert(twins.moves_as(node)).second; });
}

bool is_periodic(dynamics::Twins const& twins, dynamics::Model const& model, std::size_t body) {
  for (Index node = model.first_node[body]; node < model.first_node[body + 1]; ++node)
    if (twins.moves_as(node) != node)
      return true;
  return false;
}

} // namespace

void warn_of_shared_nodes(Facts const& all, std::vector<Warning>& warnings) {
  static constexpr char const* undecided = "which share their reaction in any way: sums hold, pressures and "
                                           "friction there do not";
  for (std::size_t i = 0; i < all.pairs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (auto const nodes = common_nodes(all.pairs[i], all.pairs[j]); nodes > 0)
        warnings.push_back({fmt::format("pairs {} and {} have {} nodes in common on the same counterpart, {}",
                                        all.pairs[j].pair->name, all.pairs[i].pair->name, nodes, undecided),
                            "one pair of both sets"});
  auto const& model = *all.scene->model;
  dynamics::Twins const twins(model);
  for (auto const& pair : all.pairs) {
    if (!any_move_as_one(twins, pair.pair->nodes()))
      continue;
    if (pair.pair->mortar)
      warnings.push_back({fmt::format("pair {}: mortar and sides that are periodic have nodes that move as "
                                      "one, {}",
                                      pair.pair->name, undecided),
                          "discretisation = \"node_to_segment\""});
    else if (pair.primary && is_periodic(twins, model, *pair.primary))
      warnings.push_back(
          {fmt::format("pair {}: both sides are periodic, with nodes that move as one at their "
                       "ends, {}; and the primary has no images of itself",
                       pair.pair->name, undecided),
           "an obstacle for one of them, or a half space"});
  }
}

} // namespace stiction::scene
