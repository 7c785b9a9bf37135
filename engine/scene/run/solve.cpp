// Loads a problem, runs the chosen solvers on it, lets the judge speak.
#include "scene/run/solve.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fmt/format.h>

#include "contact/problem/cone_error.hpp"
#include "contact/problem/uniqueness.hpp"
#include "contact/solvers/answers.hpp"
#include "core/error.hpp"
#include "record/problem_file.hpp"
#include "scene/description/human.hpp"

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

SolverAnswer answer_of(std::string const& name, contact::SolverChoice const& choice,
                       contact::Problem const& problem) {
  auto const start = std::clock();
  auto solution = contact::make_solver(choice)->solve(problem, Vector::Zero(problem.free.size()));
  double const seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  SolverAnswer answer{name,
                      solution.converged,
                      std::string(contact::name_of(solution.method)),
                      solution.iterations,
                      solution.work,
                      solution.verdict.residual,
                      solution.verdict.relative(),
                      {},
                      seconds,
                      {},
                      contact::displacement(problem, solution.force)};
  answer.cone_error = contact::cone_error(problem, solution.force, answer.displacement);
  answer.force = std::move(solution.force);
  return answer;
}

std::string line_of(SolverAnswer const& answer) {
  return fmt::format(
      "{:<14}{:<16}{:<14}{:>8} iterations  residual {:.3e} Pa, {:.3e} of the largest traction{}  "
      "{:.4f} s\n",
      answer.solver, answer.converged ? "converged by" : "NOT CONVERGED",
      answer.converged ? answer.method : "", answer.iterations, answer.residual, answer.relative,
      answer.cone_error ? fmt::format(", {:.3e} in Siconos' measure", *answer.cone_error) : "",
      answer.seconds);
}

/// At the first answer; where there is none, at all points.
std::vector<std::string> doubts_of(contact::Problem const& problem,
                                   std::vector<SolverAnswer> const& answers) {
  auto at = std::find_if(answers.begin(), answers.end(), [](auto const& answer) { return answer.converged; });
  auto const which = at == answers.end() ? contact::Checked::all : contact::Checked::bearing;
  at = at == answers.end() ? answers.begin() : at;
  auto const found = contact::doubts(problem, at->force, at->displacement, which);
  std::vector<std::string> lines;
  if (found.friction.any())
    lines.push_back(fmt::format("contact {} ({} such): {}", found.friction.worst + 1,
                                std::max(found.friction.points, found.friction.together),
                                words(found.friction)));
  if (found.softening.any())
    lines.push_back(fmt::format("contact {} ({} such alone): {}", found.softening.worst + 1,
                                found.softening.points, words(found.softening)));
  if (found.weakening.any())
    lines.push_back(fmt::format("contact {} ({} such alone): {}", found.weakening.worst + 1,
                                found.weakening.points, words(found.weakening)));
  if (lines.empty())
    return lines;
  if (auto const text = words(contact::seek_answers(problem, at->force), problem.dim); !text.empty())
    lines.back() += "; here " + text;
  return lines;
}

/// Solvers that converged to other displacements than the first that did: more than tolerances tell apart.
std::vector<std::string> differences(contact::Problem const& problem,
                                     std::vector<SolverAnswer> const& answers, double tolerance) {
  double const apart = std::max(1e-4, std::sqrt(tolerance)); // of the largest motion that forces make
  std::vector<std::string> lines;
  SolverAnswer const* first = nullptr;
  for (auto const& answer : answers) {
    if (!answer.converged)
      continue;
    if (first == nullptr) {
      first = &answer;
      continue;
    }
    auto const moved_by = [&](SolverAnswer const& one) {
      return (one.displacement - problem.free).lpNorm<Eigen::Infinity>();
    };
    double const moved = std::max(moved_by(*first), moved_by(answer));
    double const between = (answer.displacement - first->displacement).lpNorm<Eigen::Infinity>();
    if (between > apart * moved)
      lines.push_back(fmt::format("{} and {} answer differently, by {} of the largest displacement: there is "
                                  "more than one answer, or hardly one",
                                  first->solver, answer.solver, percent(between / moved)));
  }
  return lines;
}

} // namespace

SolveReport solve_file(std::filesystem::path const& path, std::string const& solver, double tolerance) {
  if (auto const& range = contact::BipotentialNewton::schema().find("tolerance")->range;
      !range.contains(tolerance))
    throw core::InputError(fmt::format("solve: tolerance = {:g} must be {}", tolerance, range.words("1")));
  auto const chosen = choices(solver, tolerance, std::type_identity<contact::SolverChoice>{});
  auto const problem = record::load_problem(path);
  SolveReport report;
  report.converged = true;
  report.contacts = problem.size();
  report.components = problem.dim;
  report.free = problem.free;
  report.text = fmt::format("{}: {} contacts of {} components, tolerance {:g}\n", path.string(),
                            problem.size(), problem.dim, tolerance);
  for (auto const& [name, choice] : chosen) {
    auto const& answer = report.answers.emplace_back(answer_of(name, choice, problem));
    report.converged = report.converged && answer.converged;
    report.text += line_of(answer);
  }
  report.doubts = doubts_of(problem, report.answers);
  for (auto& line : differences(problem, report.answers, tolerance))
    report.doubts.push_back(std::move(line));
  for (auto const& doubt : report.doubts)
    report.text += doubt + "\n";
  return report;
}

} // namespace stiction::scene
