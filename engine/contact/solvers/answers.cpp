// Other starts for Newton, and what pivoting and enumeration show.
#include "contact/solvers/answers.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "contact/solvers/mixed_sweeps.hpp"
#include "contact/solvers/newton.hpp"
#include "contact/solvers/pivoting.hpp"
#include "contact/solvers/rounding.hpp"
#include "linear/decompositions.hpp"

namespace stiction::contact {

namespace {

constexpr Index sought_rows = 600, pivoted_rows = 120; // a factorization a start; Lemke's method takes more
constexpr double apart = 1e-5;                         // of the larger force: less is the same answer
constexpr std::size_t told = 4;

/// Forces from which to start: the normal ones by which each point alone would close, or the given ones if
/// larger, with friction at its cone's rim along a direction of the surface, or none.
Vector leaning(Problem const& problem, Vector const& force, int along, double sign) {
  Vector start = Vector::Zero(force.size());
  for (Index i = 0; i < problem.size(); ++i) {
    Index const row = problem.dim * i;
    auto const& point = problem.points[ix(i)];
    double const pressed = std::max(0.0, point.shift[0] - problem.free[row]);
    start[row] = std::max(force[row], natural_scale(problem, i) * pressed);
    if (along > 0)
      start[row + along] = sign * point.mu * start[row];
  }
  return start;
}

std::vector<Vector> starts_of(Problem const& problem, Vector const& force) {
  std::vector<Vector> starts{Vector::Zero(force.size()), leaning(problem, force, 0, 0)};
  for (int along = 1; along < problem.dim; ++along)
    for (double const sign : {-1.0, 1.0})
      starts.push_back(leaning(problem, force, along, sign));
  if (force.size() <= pivoted_rows)
    for (auto const from : {From::nothing, From::closed})
      if (auto const found = pivot(problem, force, from); found && found->force.size() == force.size())
        starts.push_back(found->force);
  return starts;
}

Solution solve_from(Problem const& problem, Vector const& start, double tolerance) {
  if (start.size() > sought_rows && plain(problem))
    return mix_sweeps(problem, start, tolerance, 100);
  return newton_from(problem, start, tolerance);
}

/// As far as Newton gets from there: of a badly conditioned problem what is within a tolerance lies apart.
Vector sharp(Problem const& problem, Vector const& force) {
  if (force.size() > sought_rows)
    return force;
  auto const solution = newton_from(problem, force, 1e-14);
  return solution.verdict.residual < judge(problem, force).residual ? solution.force : force;
}

void add(std::vector<Vector>& found, Vector const& force) {
  for (auto const& other : found)
    if ((other - force).norm() <= apart * std::max(other.norm(), force.norm()))
      return;
  found.push_back(force);
}

bool positive_definite(Dense const& W) {
  double const least = 1e-10 * W.diagonal().mean();
  Dense const symmetric = 0.5 * (W + W.transpose()) - least * Dense::Identity(W.rows(), W.cols());
  return least > 0 && Eigen::LLT<Dense>(symmetric).info() == Eigen::Success;
}

} // namespace

Answers without_answer(Problem const& problem, Vector const& force) {
  Answers answers;
  answers.sought = true;
  if (!plain(problem))
    return answers;
  auto const tried = enumerate(problem, force);
  auto const pivoted = problem.dim <= 2 ? pivot(problem, force, From::nothing) : std::nullopt;
  answers.all = (tried.all && tried.answers.empty()) || (pivoted && pivoted->none);
  answers.promised = !answers.all && positive_definite(problem.W.dense());
  return answers;
}

Answers seek_answers(Problem const& problem, Vector const& force, double tolerance) {
  Answers answers;
  answers.sought = force.allFinite() && (force.size() <= sought_rows || plain(problem));
  if (!answers.sought)
    return answers;
  double const there = forces_there(problem, Vector::Zero(force.size()));
  auto const is_answer = [&](Vector const& p) {
    Solution given;
    given.force = p;
    given.verdict = judge(problem, p);
    return p.allFinite() && given.verdict.relative() <= tolerance && felt(problem, given, there);
  };
  if ((answers.given = is_answer(force)))
    answers.found.push_back(sharp(problem, force));
  for (auto const& start : starts_of(problem, force))
    if (auto const solution = solve_from(problem, start, tolerance);
        solution.converged && felt(problem, solution, there))
      add(answers.found, sharp(problem, solution.force));
  auto const tried = enumerate(problem, force);
  for (auto const& other : tried.answers)
    if (is_answer(other))
      add(answers.found, sharp(problem, other));
  answers.all = tried.all && plain(problem);
  return answers.found.empty() ? without_answer(problem, force) : answers;
}

std::string words(Answers const& answers, int dim) {
  if (!answers.sought)
    return "";
  if (answers.found.empty())
    return answers.all        ? "it is shown that this one has none"
           : answers.promised ? "none was found, though W is positive definite, so that there is one"
                              : "none was found, from any start";
  auto const only = answers.all ? "" : " from several starts";
  if (answers.found.size() == 1)
    return fmt::format("only {} was found{}", answers.given ? "this one" : "one",
                       answers.all ? ", and there is no other" : only);
  std::vector<std::string> sizes;
  for (auto const& force : answers.found) {
    double largest = 0;
    for (Index row = 0; row < force.size(); row += dim)
      largest = std::max(largest, force.segment(row, dim).norm());
    if (sizes.size() < told)
      sizes.push_back(
          fmt::format("{:.3g} N{}", largest, answers.given && sizes.empty() ? " (this one)" : ""));
  }
  return fmt::format("{}{} answers were found{}: largest forces {}{}", answers.all ? "all " : "",
                     answers.found.size(), only, fmt::join(sizes, ", "),
                     answers.found.size() > told ? ", ..." : "");
}

} // namespace stiction::contact
