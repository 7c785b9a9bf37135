// Every saved problem against every solver: an answer that satisfies the laws, or the admission that there is
// none.
#include <Eigen/Eigenvalues>
#include <doctest/doctest.h>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

#include "contact/problem/uniqueness.hpp"
#include "contact/solvers.hpp"
#include "record/problem_file.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

constexpr double tolerance = 1e-8;

std::map<std::string, std::filesystem::path> saved_problems() {
  std::map<std::string, std::filesystem::path> files;
  for (auto const& entry : std::filesystem::directory_iterator(
           std::filesystem::path(__FILE__).parent_path().parent_path() / "problems"))
    if (entry.path().extension() == ".h5")
      files[entry.path().stem()] = entry.path();
  return files;
}

/// (29) written out once more: the point of the cone |t| <= mu n that is next to z.
Vector onto_cone(Vector const& z, double mu) {
  double const n = z[0], t = z.tail(z.size() - 1).norm();
  Vector result = Vector::Zero(z.size());
  if (mu * t < -n)
    return result;
  if (t <= mu * n)
    return z;
  result[0] = (n + mu * t) / (1 + mu * mu);
  if (t > 0)
    result.tail(z.size() - 1) = mu * result[0] / t * z.tail(z.size() - 1);
  return result;
}

/// What one point says of the forces, over its area, Pa.
struct Judged {
  double residual = 0, traction = 0;
};

/// pbar - Proj(pbar - rho (y + mu |y_t| n)); none of the engine's own but the laws. The traction is the
/// yardstick of the residual: the present one, or that which would push a free penetration out.
template<int D> Judged judged_at(Problem const& problem, Index i, Vector const& force, Vector const& x) {
  auto const& point = problem.points[ix(i)];
  Local<D> dry = force.segment<D>(D * i), at = x.segment<D>(D * i);
  double mu = point.mu, factor = 1;
  if (point.adhesion >= 0) {
    auto const bond = interface::adhere<D>(problem.adhesions[ix(point.adhesion)], point.bond, at);
    dry -= point.area * bond.traction;
    factor = bond.friction;
  }
  Local<D> y = at - point.shift.head<D>();
  if (point.friction >= 0)
    mu =
        interface::coefficient<D>(problem.frictions[ix(point.friction)], {dry / point.area, y, point.bond.dt})
            .mu;
  mu *= factor;
  y[0] += mu * y.template tail<D - 1>().norm();
  Dense const block = problem.W.block<D>(i);
  double const largest =
      Eigen::SelfAdjointEigenSolver<Dense>(0.5 * (block + block.transpose())).eigenvalues()[D - 1];
  double const rho = largest > 0 ? 1 / largest : 1,
               sunk = std::max(0.0, point.shift[0] - problem.free[D * i]);
  double const rounding = 4 * std::numeric_limits<double>::epsilon() * rho * y.norm(); // of z
  double const off = (Vector(dry) - onto_cone(dry - rho * y, mu)).norm();
  return {std::max(0.0, off - rounding) / point.area,
          std::max(force.segment<D>(D * i).norm(), rho * sunk) / point.area};
}

/// The largest residual of all points over the largest traction.
double residual(Problem const& problem, Vector const& force) {
  Vector const x = problem.free + problem.W * force;
  Judged all;
  for (Index i = 0; i < problem.size(); ++i) {
    auto const one = by_dimension(problem.dim, [&]<int D>() { return judged_at<D>(problem, i, force, x); });
    all = {std::max(all.residual, one.residual), std::max(all.traction, one.traction)};
  }
  return all.traction > 0 ? all.residual / all.traction : all.residual;
}

/// With friction, forces that the bodies cannot feel leave even the displacements open.
bool deficient(Problem const& problem) {
  Dense const& W = problem.W.dense();
  auto const values = Eigen::SelfAdjointEigenSolver<Dense>(0.5 * (W + W.transpose())).eigenvalues();
  return values[0] < 1e-9 * values[values.size() - 1];
}

/// Difference of two answers' displacements over what the forces have moved.
double difference(Problem const& problem, Vector const& one, Vector const& other) {
  Vector const moved = problem.W * one;
  return (problem.W * other - moved).norm() / std::max(moved.norm(), 1e-300);
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("every saved problem: each solver satisfies the laws or says that it did not") {
    auto const files = saved_problems();
    CHECK(files.size() >= 12);
    std::set<std::string> solved;
    for (auto const& [name, file] : files) {
      auto const problem = record::load_problem(file);
      std::vector<std::pair<std::string, Vector>> answers;
      bool single = !deficient(problem);
      for (auto const& [solver, choice] : all_solvers(tolerance)) {
        INFO(name << ", " << solver);
        auto const answer = solve(choice, problem);
        CHECK(answer.force.allFinite());
        CHECK(answer.work > 0);
        if (!answer.converged) {
          CHECK(answer.verdict.relative() > tolerance);
          continue;
        }
        solved.insert(name);
        CHECK(residual(problem, answer.force) <= tolerance);
        single =
            single && !doubts(problem, answer.force, displacement(problem, answer.force), Checked::all).any();
        answers.emplace_back(solver, answer.force);
      }
      for (auto const& [solver, force] : answers) {
        INFO(name << ", " << solver << " and " << answers[0].first);
        if (single)
          CHECK(difference(problem, answers[0].second, force) <= 1e-5);
      }
    }
    MESSAGE(solved.size() << " of " << files.size() << " problems solved by at least one");
  }
}
