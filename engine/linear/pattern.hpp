// The fixed sparsity of a symmetric matrix and the order in which its unknowns are eliminated.
#pragma once
#include <span>
#include <vector>

#include "core/types.hpp"

namespace stiction::linear {

/// Lower triangle in compressed columns, diagonal included, rows ascending.
struct Pattern {
  Indices columns; ///< [n + 1], first entry of each column
  Indices rows;    ///< [entries]
  [[nodiscard]] Index size() const { return static_cast<Index>(columns.size()) - 1; }
  [[nodiscard]] Index entries() const { return static_cast<Index>(rows.size()); }
  /// Position of entry (i, j) among `rows`; -1 if it is not in the pattern. Either triangle may be asked for.
  [[nodiscard]] Index find(Index i, Index j) const;
};

/// Pattern of a matrix assembled from cliques: each group couples all its unknowns; negative ones are left
/// out.
[[nodiscard]] Pattern pattern_of(Index unknowns, std::vector<Indices> const& cliques);

/// Fill-reducing order of the unknowns with those marked `last` at the end in their given order:
/// order[k] is the old number of new unknown k. With the contact unknowns last, the trailing block of the
/// Cholesky factor is the factor of the Schur complement onto them.
[[nodiscard]] Indices elimination_order(Pattern const& pattern, std::vector<bool> const& last);

/// y = A x for the symmetric matrix with these values of its lower triangle.
void multiply(Pattern const& pattern, std::span<double const> values, Vector const& x, Vector& y);

} // namespace stiction::linear
