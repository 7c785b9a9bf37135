// Contact solvers behind one interface: bi-potential Newton, bi-potential Uzawa, nonsmooth Gauss-Seidel.
#pragma once
#include <memory>
#include <string>
#include <variant>

#include "contact/problem/problem.hpp"
#include "contact/solvers/method.hpp"

namespace stiction::contact {

/// What a solver reached; whether that is good is the judge's word, taken before it is returned.
struct Solution {
  Vector force;        ///< total forces p, [dim n], N
  long iterations = 0; ///< Newton iterations or sweeps
  double work = 0;     ///< multiply-adds with W and in factorizations, over those of one product W p
  Verdict verdict;
  bool converged = false;       ///< verdict.relative() <= the tolerance asked for, or rounded
  bool rounded = false;         ///< only as far as rounding allows
  Method method = Method::none; ///< that converged
};

class Solver {
public:
  virtual ~Solver() = default;
  /// guess[dim n]: starting forces, N.
  [[nodiscard]] virtual Solution solve(Problem const& problem, Vector const& guess) = 0;
  /// Forgets what earlier problems left, on which the last digits of answers may depend.
  virtual void forget() {}
};

/// Semismooth Newton on the bi-potential's natural map, with a line search and Gauss-Seidel sweeps to restart
/// where it stagnates; after mixed sweeps where there are many points without bonds.
struct BipotentialNewton {
  double tolerance = 1e-10;
  int iterations = 60;
  [[nodiscard]] static core::Schema const& schema();
  [[nodiscard]] std::unique_ptr<Solver> make() const;
};

/// Predictor-corrector of the bi-potential method, point after point, rho scaled by each point's W.
struct BipotentialUzawa {
  double tolerance = 1e-10;
  int iterations = 20000;
  double relaxation = 1.0;
  [[nodiscard]] static core::Schema const& schema();
  [[nodiscard]] std::unique_ptr<Solver> make() const;
};

/// Nonsmooth Gauss-Seidel: each point solved exactly in turn.
struct GaussSeidel {
  double tolerance = 1e-10;
  int iterations = 5000;
  [[nodiscard]] static core::Schema const& schema();
  [[nodiscard]] std::unique_ptr<Solver> make() const;
};

using SolverChoice = std::variant<BipotentialNewton, BipotentialUzawa, GaussSeidel>;
[[nodiscard]] std::unique_ptr<Solver> make_solver(SolverChoice const& choice);

} // namespace stiction::contact
