// Linear complementarity: 0 <= z, 0 <= w = q + M z, z_i w_i = 0, by exchanging active sets and by pivoting.
#pragma once
#include <optional>
#include <vector>

#include "linear/decompositions.hpp"

namespace stiction::contact {

/// M = G^T G, as of a convex problem with its multipliers z: exchanges whole active sets, pivots where that
/// cycles. Dependent rows are told apart by a compliance that vanishes.
class ConvexComplementarity {
public:
  explicit ConvexComplementarity(Dense const& M);
  /// active[n]: first guess, then the set found. Nothing where the problem has no answer.
  [[nodiscard]] std::optional<Vector> solve(Vector const& q, std::vector<bool>& active);

private:
  [[nodiscard]] bool exchange(Vector const& q, std::vector<bool>& active);
  [[nodiscard]] bool solve_with(Vector const& q, std::vector<bool> const& active);
  [[nodiscard]] Indices wrong_ones(Vector const& q, std::vector<bool> const& active) const;

  Index of_;                   ///< rows of M
  Indices rows_, set_;         ///< those kept; of these the active ones
  Vector scale_;               ///< z = scale * scaled z
  Dense M_;                    ///< of unit diagonal
  std::vector<bool> factored_; ///< behind factor_
  Eigen::LLT<Dense> factor_;   ///< of M in the set
  Vector z_, w_;
};

enum class Pivoted { answered, ray, limit };

struct LemkeResult {
  Pivoted end = Pivoted::limit;
  Vector z; ///< the answer, or the direction in which the method went off to infinity
  long pivots = 0;
};

/// Lemke's method with a lexicographic choice between rows that leave together. Where M is copositive, as for
/// bodies with friction, it ends in an answer or on a ray. Scales M and q by itself.
[[nodiscard]] LemkeResult lemke(Dense const& M, Vector const& q, long most);

/// From where the rows of a set, in rising order, have w = 0: what M is not there, it may be with them held.
[[nodiscard]] LemkeResult lemke_from(Dense const& M, Vector const& q, std::vector<Index> const& set,
                                     long most);

/// Does a direction y >= 0 show that no answer exists: M^T y <= 0 and q^T y < 0?
[[nodiscard]] bool proves_none(Dense const& M, Vector const& q, Vector const& y);

} // namespace stiction::contact
