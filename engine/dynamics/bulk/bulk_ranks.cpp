// What the ranks that share a case know of its unknowns and of each other's forces.
#include <limits>

#include "dynamics/bulk/bulk_system.hpp"
#include "linear/rank_factor.hpp"

namespace stiction::dynamics {

/// Nodes that have an unknown, rank by rank.
linear::UnknownsOfRanks BulkSystem::unknowns_of_ranks(Model const& model) const {
  auto const& share = *model.share;
  linear::UnknownsOfRanks all{{}, {0}};
  Indices nodes, mine;
  for (int rank = 0; rank < share.ranks->count(); ++rank) {
    for (Index k = share.first[ix(rank)]; k < share.first[ix(rank + 1)]; ++k)
      if (Index const node = share.order[ix(k)]; moves(node)) {
        nodes.push_back(node);
        if (share.own(node))
          mine.push_back(node);
      }
    all.first.push_back(static_cast<Index>(nodes.size()));
  }
  all.nodes = {places(nodes), motions(model, mine)};
  return all;
}

/// The pass of all ranks from this one's: the forces on all nodes, and the first cell inside out that any
/// found.
solid::Pass BulkSystem::together(solid::Pass mine, Vector& force) const {
  auto const& share = *model_->share;
  constexpr double no_cell = std::numeric_limits<Index>::max();
  double const first = -share.ranks->largest(mine.sound() ? -no_cell : -mine.inverted_cell);
  solid::Pass all;
  if (first < no_cell) {
    all.inverted_cell = static_cast<Index>(first);
    return all;
  }
  all.energy = share.ranks->sum(mine.energy);
  share.gather(force, dim_);
  return all;
}

} // namespace stiction::dynamics
