// Contact points on nodes that move as one: nothing decides how these share their reaction.
#include <algorithm>
#include <fmt/format.h>
#include <set>

#include "dynamics/contact/twins.hpp"
#include "scene/explain/facts.hpp"

namespace stiction::scene {

namespace {

constexpr double stiff = 10; // beside the body with periodic sides: an obstacle may stand for it

/// Of different pairs with the same counterpart that are not one point, as many as there are, also at the
/// ends of periodic sides; a corner may well be in two.
std::size_t common_nodes(PairFacts const& a, PairFacts const& b, dynamics::Twins const& twins) {
  bool const one = !a.pair->shared() && !b.pair->shared() && interface::alike(a.pair->law, b.pair->law);
  if (one || a.part->primary != b.part->primary)
    return 0;
  std::set<Index> first;
  for (Index const node : a.pair->nodes())
    first.insert(twins.moves_as(node));
  return static_cast<std::size_t>(std::ranges::count_if(
      b.pair->nodes(), [&](Index node) { return first.contains(twins.moves_as(node)); }));
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
  auto const& model = *all.scene->model;
  dynamics::Twins const twins(model);
  for (std::size_t i = 0; i < all.pairs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (auto const nodes = common_nodes(all.pairs[i], all.pairs[j], twins); nodes > 0)
        warnings.push_back({fmt::format("pairs {} and {} have {} nodes in common on the same counterpart, {}",
                                        all.pairs[j].pair->name, all.pairs[i].pair->name, nodes, undecided),
                            "one pair of both sets"});
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
    else if (pair.primary &&
             all.bodies[*pair.primary].moduli.young > stiff * all.bodies[pair.secondary].moduli.young)
      warnings.push_back(
          {fmt::format("pair {}: the ends of its periodic side may lie over different facets of a body that "
                       "hardly gives way, {}",
                       pair.pair->name, undecided),
           "an obstacle for that body"});
  }
}

} // namespace stiction::scene
