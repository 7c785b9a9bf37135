// Contact of a half space: Newton on the natural map of all points, its systems solved by products alone.
#pragma once
#include <functional>
#include <optional>

#include "contact/solvers/solver.hpp"
#include "halfspace/problem.hpp"

namespace stiction::halfspace {

struct Answer {
  Vector force, x; ///< [components points], N and m
  double lift = 0; ///< of the counterpart off where the problem has it, m; 0 unless a force is asked for
  contact::Verdict verdict;
  bool converged = false;
  bool interrupted = false;
  long iterations = 0; ///< of Newton
  long krylov = 0;     ///< of the systems within
  std::string reason;  ///< empty when converged
};

/// What is asked of an answer beside the problem.
struct Wanted {
  double tolerance = 1e-10; ///< of the judge's residual over the largest traction
  int iterations = 60;      ///< of Newton
  std::optional<double>
      force; ///< of all points along the normal, N: the counterpart is lifted until it is so
  std::function<bool()> enough = nullptr; ///< is it to be left off?
};

/// From these forces, N, and x = free + W forces if known. Nothing is changed but workspace.
class Solver {
public:
  explicit Solver(Surface const& surface) : surface_(&surface) {}
  [[nodiscard]] Answer solve(Problem const& problem, Vector const& guess, Wanted const& wanted) const;

private:
  Surface const* surface_;
};

} // namespace stiction::halfspace
