// Problems on which a descent ends at a kink: piles that hold each other in more ways than one, rigid or
// badly conditioned; and forces without bounds that are no answers, however loose the tolerance.
#include <doctest/doctest.h>

#include "contact/solvers.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// Rigid square blocks of unit mass one on the other on a plane, each on `points` points, coming down and the
/// topmost pushed along: W of rank 3 a block at most.
Problem pile(Index blocks, Index points, double push, double mu) {
  Dense H = Dense::Zero(2 * blocks * points, 3 * blocks);
  Vector mobility(3 * blocks), velocity = Vector::Zero(3 * blocks);
  for (Index b = 0; b < blocks; ++b) {
    mobility.segment<3>(3 * b) = Eigen::Vector3d(1, 1, 6);
    velocity[3 * b + 1] = -1e-2;
    for (Index k = 0; k < points; ++k) {
      Index const row = 2 * (b * points + k);
      double const x = -0.5 + static_cast<double>(k) / static_cast<double>(points - 1);
      H.block<1, 3>(row, 3 * b) << 0, 1, x;
      H.block<1, 3>(row + 1, 3 * b) << 1, 0, 0.5;
      if (b > 0) {
        H.block<1, 3>(row, 3 * (b - 1)) << 0, -1, -x;
        H.block<1, 3>(row + 1, 3 * (b - 1)) << -1, 0, 0.5;
      }
    }
  }
  velocity[3 * (blocks - 1)] = push;
  Problem problem;
  problem.W = Dense(H * mobility.asDiagonal() * H.transpose());
  problem.free = H * velocity;
  for (Index i = 0; i < blocks * points; ++i)
    problem.points.push_back({1, mu, -1, {}});
  return problem;
}

/// W positive definite, but for its last digits of each size.
Problem badly_conditioned(int points, unsigned seed, double condition) {
  auto problem = random_problem(3, points, seed, 0);
  auto const n = problem.free.size();
  Dense const Q = Eigen::HouseholderQR<Dense>(problem.W.dense()).householderQ();
  Vector sizes(n);
  for (Eigen::Index k = 0; k < n; ++k)
    sizes[k] = 1e-6 * std::pow(condition, -static_cast<double>(k) / static_cast<double>(n - 1));
  problem.W = Dense(Q * sizes.asDiagonal() * Q.transpose());
  return problem;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("piles of rigid blocks are answered, few and many, at rest and pushed") {
    for (Index const blocks : {2, 3, 5, 6, 12, 20})
      for (Index const points : {2, 3, 4})
        for (double const push : {0.0, 3e-3, 3e-2})
          for (double const mu : {0.2, 0.5, 0.8}) {
            CAPTURE(blocks);
            CAPTURE(points);
            CAPTURE(push);
            CAPTURE(mu);
            CHECK(solve(BipotentialNewton{}, pile(blocks, points, push, mu)).converged);
          }
  }

  TEST_CASE("badly conditioned problems are answered, few rows and many") {
    for (double const condition : {1e4, 1e7})
      for (int const points : {5, 15, 30})
        for (unsigned seed = 0; seed < 8; ++seed) {
          CAPTURE(condition);
          CAPTURE(points);
          CAPTURE(seed);
          CHECK(solve(BipotentialNewton{}, badly_conditioned(points, seed, condition)).converged);
        }
  }

  TEST_CASE("without friction, a matrix that is not symmetric is no obstacle") {
    for (unsigned seed = 0; seed < 20; ++seed) {
      auto problem = random_problem(1, 30, seed, 0.01);
      auto const other = random_problem(1, 30, seed + 100, 0);
      Dense const lower = other.W.dense().triangularView<Eigen::StrictlyLower>();
      problem.W = Dense(problem.W.dense() + 20 * (lower - lower.transpose()));
      CAPTURE(seed);
      CHECK(solve(BipotentialNewton{}, problem).converged);
    }
  }

  /// Two points that face each other and have as little room; give: of both together, of one alone.
  Problem jaws(double first, double second, double give) {
    Problem problem;
    problem.dim = 1;
    Dense W(2, 2);
    W << 1, give - 1, give - 1, 1;
    problem.W = W;
    problem.free = Vector(Eigen::Vector2d(first, second));
    problem.points = {{1, 0, -1, {}}, {1, 0, -1, {}}};
    return problem;
  }

  TEST_CASE("what nothing can open is no answer, however loose the tolerance") {
    for (double const tolerance : {1e-2, 1e-4, 1e-6, 1e-10})
      for (auto const& [name, choice] : all_solvers(tolerance)) {
        CAPTURE(name);
        CAPTURE(tolerance);
        CHECK_FALSE(solve(choice, jaws(-2, -2, 0)).converged);
      }
  }

  TEST_CASE("what hardly overlaps where nothing gives has no answer, however large its forces") {
    for (double const second : {1.9, 1.99, 1.9999})
      for (double const tolerance : {1e-8, 1e-10})
        for (auto const& [name, choice] : all_solvers(tolerance)) {
          CAPTURE(name);
          CAPTURE(second);
          CAPTURE(tolerance);
          CHECK_FALSE(solve(choice, jaws(-2, second, 0)).converged);
        }
  }

  TEST_CASE("large forces leave no more than small ones where little gives") {
    for (double const give : {1e-3, 1e-5, 1e-6})
      for (double const tolerance : {1e-6, 1e-8}) {
        CAPTURE(give);
        CAPTURE(tolerance);
        BipotentialNewton newton;
        newton.tolerance = tolerance;
        auto const problem = jaws(-2, 1.9, give);
        auto const solution = solve(newton, problem);
        CHECK(solution.converged);
        CHECK(displacement(problem, solution.force).minCoeff() > -2e-6);
        CHECK(solution.force[1] == doctest::Approx(0.05 / give).epsilon(0.05));
      }
  }
}
