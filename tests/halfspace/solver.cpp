// Contact of half spaces: Hertz, counts of products, and answers against the solvers of dense problems.
#include "halfspace/solver.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace {

using namespace stiction;
using halfspace::Compliance;
using halfspace::Grid;
using halfspace::Surface;
using std::numbers::pi;

contact::Problem problem_of(Surface const& surface, double radius, double depth) {
  auto const& grid = surface.grid();
  contact::Problem problem;
  problem.dim = surface.components();
  problem.W = surface.delassus();
  problem.free = Vector::Zero(surface.rows());
  problem.points.resize(ix(grid.size()));
  for (Index i = 0; i < grid.size(); ++i) {
    problem.points[ix(i)].area = grid.area();
    problem.free[problem.dim * i] =
        (grid.x(i) * grid.x(i) + grid.y(i) * grid.y(i)) / (2 * radius) - depth;
  }
  return problem;
}

TEST_CASE("hertz") {
  for (Index n : {64, 128, 256, 512, 1024}) {
    Grid const grid{n, n, 4, 4, false, false};
    Surface const surface(grid, Compliance::of({0.75, 0.5, 0}, nullptr), 1);
    auto const problem = problem_of(surface, 1, 1);
    halfspace::Solver const solver(surface);
    auto const answer = solver.solve(problem, Vector::Zero(surface.rows()), {});
    MESSAGE(n, " force ", answer.force.sum() / (4.0 / 3) - 1, " p0 ", answer.force.maxCoeff() / grid.area() / (2 / pi)-1,
            " rel ", answer.verdict.relative(), " newton ", answer.iterations, " krylov ", answer.krylov, " products ",
            surface.products(), " solves ", surface.solutions(), answer.reason);
    CHECK(answer.converged);
  }
}

} // namespace
