// Ordering of a set's facets into chains.
#include <fmt/format.h>
#include <map>

#include "contact/surface/curve.hpp"
#include "core/error.hpp"

namespace stiction::contact {

namespace {

/// Successor of each node; a quadratic facet (a, b, middle) gives a -> middle -> b.
std::map<Index, Index> successors(mesh::Set const& set, std::string const& name) {
  std::map<Index, Index> next;
  auto link = [&](Index from, Index to) {
    if (!next.emplace(from, to).second)
      throw core::InputError(fmt::format(
          "contact surface \"{}\": two facets leave node {}; the surface branches or its facets are oriented "
          "against each other; use a boundary of one body with consistently oriented facets",
          name, from));
  };
  for (auto const& facet : set.facets) {
    if (facet.nodes.size() == 3) {
      link(facet.nodes[0], facet.nodes[2]);
      link(facet.nodes[2], facet.nodes[1]);
    } else {
      link(facet.nodes[0], facet.nodes[1]);
    }
  }
  return next;
}

/// The nodes from `start` on; takes their links out of `next`.
Chain follow(Index start, std::map<Index, Index>& next) {
  Chain chain{{start}, false};
  for (auto link = next.find(start); link != next.end(); link = next.find(chain.nodes.back())) {
    Index const to = link->second;
    next.erase(link);
    if (to == start) {
      chain.closed = true;
      break;
    }
    chain.nodes.push_back(to);
  }
  return chain;
}

} // namespace

std::vector<Chain> chains_of(mesh::Set const& set, std::string const& name) {
  if (set.facets.empty())
    throw core::InputError(fmt::format("contact surface \"{}\" has no facets; name a boundary set of the "
                                       "mesh (its sides), not a set of nodes",
                                       name));
  auto next = successors(set, name);
  std::map<Index, bool> has_predecessor;
  for (auto const& [from, to] : next)
    has_predecessor[to] = true;

  std::vector<Index> starts;
  for (auto const& [from, to] : next)
    if (!has_predecessor.contains(from))
      starts.push_back(from);
  std::vector<Chain> chains;
  chains.reserve(starts.size());
  for (Index const start : starts)
    chains.push_back(follow(start, next));
  while (!next.empty())
    chains.push_back(follow(next.begin()->first, next)); // closed loops remain
  return chains;
}

} // namespace stiction::contact
