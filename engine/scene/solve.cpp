// Loads a problem, runs the chosen solvers on it, lets the judge speak.
#include "scene/solve.hpp"

#include <chrono>
#include <fmt/format.h>

#include "contact/solver.hpp"
#include "core/error.hpp"
#include "record/problem_file.hpp"

namespace stiction::scene {

namespace {

/// The named solvers with this tolerance.
template<class... T>
std::vector<std::pair<std::string, contact::SolverChoice>> choices(std::string const& name, double tolerance,
                                                                   std::type_identity<std::variant<T...>>) {
  std::vector<std::pair<std::string, contact::SolverChoice>> chosen;
  std::vector<std::string> const known{T::schema().name...};
  (((name == "all" || name == T::schema().name) ? (chosen.emplace_back(T::schema().name,
                                                                       [&] {
                                                                         T solver;
                                                                         solver.tolerance = tolerance;
                                                                         return solver;
                                                                       }()),
                                                   0)
                                                : 0),
   ...);
  if (chosen.empty()) {
    auto const meant = core::nearest(name, known);
    throw core::InputError(fmt::format("there is no solver \"{}\"; known are all, {}{}", name,
                                       fmt::join(known, ", "),
                                       meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant)));
  }
  return chosen;
}

} // namespace

SolveReport solve_file(std::filesystem::path const& path, std::string const& solver, double tolerance) {
  auto const chosen = choices(solver, tolerance, std::type_identity<contact::SolverChoice>{});
  auto const problem = record::load_problem(path);
  SolveReport report;
  report.converged = true;
  report.text = fmt::format("{}: {} contacts of {} components, tolerance {:g}\n", path.string(),
                            problem.size(), problem.dim, tolerance);
  for (auto const& [name, choice] : chosen) {
    auto const start = std::chrono::steady_clock::now();
    auto const solution = contact::make_solver(choice)->solve(problem, Vector::Zero(problem.free.size()));
    std::chrono::duration<double> const seconds = std::chrono::steady_clock::now() - start;
    report.converged = report.converged && solution.converged;
    report.text += fmt::format(
        "{:<14}{:<16}{:>8} iterations  residual {:.3e} Pa, {:.3e} of the largest traction  {:.4f} s\n", name,
        solution.converged ? "converged" : "NOT CONVERGED", solution.iterations, solution.verdict.residual,
        solution.verdict.relative(), seconds.count());
  }
  return report;
}

} // namespace stiction::scene
