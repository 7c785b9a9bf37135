// Which of the ranks that share a case owns which node, and what of a cell is whose.
#pragma once
#include "linear/ranks.hpp"
#include "solid/cells.hpp"

namespace stiction::dynamics {

/// A node is owned by one rank, which has all cells about it: its forces and its rows of a matrix are summed
/// there.
struct Share {
  linear::Ranks const* ranks;
  Indices owner; ///< [nodes], rank
  Indices order; ///< [nodes], those of the first rank, then of the next, each in ascending order
  Indices first; ///< [ranks + 1], where those of a rank begin in `order`

  [[nodiscard]] bool own(Index node) const { return owner[ix(node)] == ranks->rank(); }
  /// Of the cell with these nodes: all if its first node is own, forces if another one is.
  [[nodiscard]] solid::CellPart part(std::span<Index const> nodes, Index first_node) const;
  /// What each rank has found for its own nodes, put together: values [dim nodes].
  void gather(Vector& values, int dim) const;
};

/// Nodes [nodes, dim] in parts of equal size: halved across their longest extent, and again.
[[nodiscard]] Share share_out(Matrix const& nodes, linear::Ranks const& ranks);

} // namespace stiction::dynamics
