// Problems whose points come in another order, with other axes along the surface: the same to anybody but a
// rounding.
#include <Eigen/Geometry>
#include <doctest/doctest.h>
#include <numeric>

#include "contact/saved.hpp"
#include "contact/solvers.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// Of points in space that are dry and slip alike in all directions.
Problem disguised(Problem const& problem, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angles(0, 2 * std::numbers::pi);
  std::vector<Index> order(ix(problem.size()));
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  Dense turn = Dense::Zero(problem.free.size(), problem.free.size());
  Problem result = problem;
  for (Index i = 0; i < problem.size(); ++i) {
    Index const from = order[ix(i)];
    result.points[ix(i)] = problem.points[ix(from)];
    turn(3 * i, 3 * from) = 1;
    turn.block<2, 2>(3 * i + 1, 3 * from + 1) = Eigen::Rotation2Dd(angles(random)).toRotationMatrix();
  }
  Dense const W = turn * problem.W.dense() * turn.transpose();
  result.W = (0.5 * (W + W.transpose())).eval();
  result.free = turn * problem.free;
  return result;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("a wall of rigid bricks stands in whatever order its points come") {
    auto const wall = record::load_problem(friction_problems_folder() / "p10_rigidwall.h5");
    for (unsigned const seed : {7U, 13U, 17U}) {
      auto const answer = solve(BipotentialNewton{1e-8}, disguised(wall, seed));
      CAPTURE(seed);
      CHECK(answer.converged);
      CHECK(answer.verdict.relative() <= 1e-8);
    }
  }
}
