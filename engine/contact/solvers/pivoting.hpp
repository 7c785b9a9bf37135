// Contact with friction as a linear complementarity problem, for where iterations fail.
#pragma once
#include <optional>

#include "contact/problem/problem.hpp"

namespace stiction::contact {

/// Where pivoting starts: from no force; with all points closed; or with all as the given forces have them.
/// Where W is indefinite, it may not be with points closed.
enum class From { nothing, statuses, closed };

struct PivotedForces {
  Vector force;      ///< [dim n], N; empty where none were found
  bool none = false; ///< shown that the linear problem has no answer
  long pivots = 0;
};

/// Forces of the problem whose bonds and coefficients are linear about these forces, by Lemke's
/// method; in space on a cone of facets within Coulomb's. Exact in the plane where bonds are whole
/// and coefficients constant. Nothing where the problem is larger than `pivoting_rows`.
[[nodiscard]] std::optional<PivotedForces> pivot(Problem const& problem, Vector const& force, From from);

struct Enumerated {
  std::vector<Vector> answers; ///< [dim n], N
  bool all = false; ///< there are no others: every status was tried, and each leaves one answer or none
};

/// Answers of that linear problem in the plane, by trying every status of every point: open, sticking,
/// sliding either way. For at most `enumerated` points.
[[nodiscard]] Enumerated enumerate(Problem const& problem, Vector const& force);

inline constexpr Index pivoting_rows = 1200, enumerated = 5;

} // namespace stiction::contact
