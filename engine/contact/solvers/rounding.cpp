// Forces, and displacements times rho, to the last digits of double precision.
#include "contact/solvers/rounding.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stiction::contact {

namespace {
constexpr double no_answer =
    1e-8; ///< relative: so much is not rounding's, whatever it may do to a point that hardly gives way
} // namespace

bool within_rounding(Problem const& problem, Solution const& solution) {
  if (!(solution.verdict.relative() <= no_answer))
    return false;
  Vector const x = displacement(problem, solution.force);
  double largest = 0; // Pa
  for (Index i = 0; i < problem.size(); ++i) {
    auto const of = [&](Vector const& v) { return v.segment(problem.dim * i, problem.dim).norm(); };
    double const size = of(solution.force) + natural_scale(problem, i) * (of(x) + of(problem.free));
    largest = std::max(largest, size / problem.points[ix(i)].area);
  }
  double const terms = std::sqrt(static_cast<double>(problem.free.size()));
  return solution.verdict.residual <= 2 * std::numeric_limits<double>::epsilon() * terms * largest;
}

} // namespace stiction::contact
