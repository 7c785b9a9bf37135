// Columns of a compliance between surface unknowns, kept as long as the factor they come from.
#pragma once
#include <functional>
#include <vector>

#include "linear/bulk_factor.hpp"

namespace stiction::linear {

/// Columns are solved for in groups of neighbours, the same ones whatever is asked for, so that the numbers
/// do not depend on the order of questions. Of a symmetric compliance only the rows from a group's own first
/// on are kept, of its own block the lower triangle.
class SurfaceColumns {
public:
  /// width: columns of a group.
  SurfaceColumns(Index surface, Index width, bool symmetric = true)
      : surface_(surface), width_(width), symmetric_(symmetric), groups_(ix((surface + width - 1) / width)) {}

  /// As many columns from `first` on as X has, [surface, any]; of a symmetric compliance their rows from
  /// `first` on, [surface - first, any]. Returns the operations that took; several threads may call it.
  using Solve = std::function<double(Index first, Dense& X)>;
  /// C(i, j): compliance between used[i] and used[j].
  Spent gather(Indices const& used, Solve const& solve, Dense& C);
  void clear();
  /// The first column of each group that is known.
  [[nodiscard]] Indices known() const;
  [[nodiscard]] double numbers() const { return numbers_; }

private:
  void drop(std::vector<bool> const& wanted);
  [[nodiscard]] double entry(Index row, Index column) const;

  Index surface_, width_;
  bool symmetric_;
  std::vector<Dense> groups_; ///< [groups], empty if not known
  double numbers_ = 0;        ///< in all groups
};

} // namespace stiction::linear
