// A bulk whose matrix lies on several ranks: multigrid over all of them, no factor, no columns.
#pragma once
#include "linear/multigrid_factor.hpp"
#include "linear/ranks.hpp"

namespace stiction::linear {

/// Where the unknowns of a pattern belong, and whose nodes are whose.
struct UnknownsOfRanks {
  NodesOfUnknowns nodes; ///< numbered so that those of each rank follow each other; modes of own ones alone
  Indices first;         ///< [ranks + 1], first node of each rank
};

/// As make_multigrid_factor, of a pattern whose values are whole only where a row or a column is of an own
/// node. Right-hand sides and motions are those of all unknowns, on every rank; so are the rows of contact,
/// each of which moves the components of one node. What differs between ranks though it must not ends in a
/// Bug.
[[nodiscard]] std::unique_ptr<BulkFactor> make_rank_factor(Pattern pattern, Index surface,
                                                           UnknownsOfRanks nodes, Ranks const& ranks);

} // namespace stiction::linear
