// A contact point within a step, and the solution of the problem of all of them.
#pragma once
#include "contact/node_to_segment/kinematics.hpp"
#include "contact/solvers/solver.hpp"
#include "dynamics/bulk/bulk_system.hpp"

namespace stiction::dynamics {

/// Components C of forces in D dimensions: C = D, or 1 where nothing acts along the surface.
template<int D, int C> struct StepPoint {
  int pair = 0;
  Index index = 0;
  contact::PointKinematics<D> kinematics;
  contact::Local<C> force = contact::Local<C>::Zero(); ///< p = A r, N
  double rho = 0;                                      ///< of the last problem, N/m; 0 before
  contact::ProblemPoint data;                          ///< area, mu, bond
  bool active = false;
  bool waits = false; ///< at the velocity level: its gap will not close in this step
  [[nodiscard]] contact::Local<C> x() const {
    contact::Local<C> x;
    x[0] = kinematics.gap;
    x.template tail<C - 1>() = kinematics.slip.template head<C - 1>();
    return x;
  }
};

/// With what does not act along the surface.
template<int D, int C> [[nodiscard]] contact::Local<D> full(Eigen::Matrix<double, C, 1> const& force) {
  contact::Local<D> all = contact::Local<D>::Zero();
  all.template head<C>() = force;
  return all;
}

/// From these forces, and where that fails from none: they may be a bad start.
[[nodiscard]] inline contact::Solution solve_problem(contact::Solver& solver, contact::Problem const& problem,
                                                     Vector const& guess, Cost& cost) {
  contact::Solution found;
  auto const rows = static_cast<double>(problem.W.rows());
  for (bool const from_guess : {true, false}) {
    found = solver.solve(problem, from_guess ? guess : Vector::Zero(guess.size()));
    cost.contact_iterations += found.iterations;
    if (found.rounded)
      cost.contact_rounded = std::max(cost.contact_rounded, found.verdict.relative());
    cost.contact_operations += 2 * rows * rows * found.work;
    if (found.converged)
      break;
  }
  return found;
}

} // namespace stiction::dynamics
