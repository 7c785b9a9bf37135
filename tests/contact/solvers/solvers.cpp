// The contact solvers on problems solved by hand, on random ones, on degenerate and on softening ones.
#include <Eigen/LU>
#include <doctest/doctest.h>

#include "contact/solvers.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

void check_one(Dense const& W, Vector const& free, double mu, Vector const& exact) {
  for (auto const& [name, choice] : all_solvers()) {
    INFO(name << ", mu " << mu << ", free " << free.transpose());
    auto const answer = solve(choice, one_point(W, free, mu));
    CHECK(answer.converged);
    CHECK((answer.force - exact).norm() <= 1e-7 * (1 + exact.norm()));
  }
}

/// All solvers converge and agree; the displacements always, the forces where they are unique.
void check_agreement(Problem const& problem, bool unique, double tolerance) {
  Vector force, x;
  for (auto const& [name, choice] : all_solvers(tolerance)) {
    CAPTURE(name);
    auto const answer = solve(choice, problem);
    CHECK(answer.converged);
    CHECK(answer.verdict.relative() <= tolerance);
    CHECK(judge(problem, answer.force).residual == answer.verdict.residual);
    Vector const at = displacement(problem, answer.force);
    if (force.size() == 0) {
      force = answer.force;
      x = at;
    }
    CHECK((at - x).norm() <= 1e-6 * (x.norm() + problem.free.norm()));
    if (unique)
      CHECK((answer.force - force).norm() <= 1e-6 * force.norm());
  }
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("one point by hand: open, stick, slip, without friction, with much") {
    Dense W(2, 2);
    W << 2e-6, 0.5e-6, 0.5e-6, 3e-6;
    Dense const apart = Eigen::Vector2d(2e-6, 3e-6).asDiagonal();
    check_one(apart, Eigen::Vector2d(1e-3, 2e-3), 0.4, Eigen::Vector2d(0, 0));
    check_one(apart, Eigen::Vector2d(-1e-3, 3e-4), 0.4, Eigen::Vector2d(500, -100));
    check_one(apart, Eigen::Vector2d(-1e-3, 3e-3), 0.4, Eigen::Vector2d(500, -200));
    check_one(apart, Eigen::Vector2d(-1e-3, -3e-3), 0.4, Eigen::Vector2d(500, 200));
    check_one(W, Eigen::Vector2d(-1e-3, 3e-3), 0, Eigen::Vector2d(500, 0));
    for (double const mu : {0.4, 1.0, 3.0}) { // slides to +t: p_t = -mu p_n
      double const pn = 1e-3 / (2e-6 - mu * 0.5e-6);
      check_one(W, Eigen::Vector2d(-1e-3, 20e-3), mu, Eigen::Vector2d(pn, -mu * pn));
    }
    Vector const stick = -W.inverse() * Eigen::Vector2d(-1e-3, 1e-3);
    check_one(W, Eigen::Vector2d(-1e-3, 1e-3), 3, stick);
  }

  TEST_CASE("one point in space slides against its slip, wherever that points") {
    Dense const W = Eigen::Vector3d(2e-6, 3e-6, 3e-6).asDiagonal();
    for (double angle = 0; angle < 6.2; angle += 0.7) {
      Vector const free = Eigen::Vector3d(-1e-3, 5e-3 * std::cos(angle), 5e-3 * std::sin(angle));
      for (auto const& [name, choice] : all_solvers()) {
        CAPTURE(name);
        auto problem = one_point(W, free, 0.7);
        problem.dim = 3;
        auto const answer = solve(choice, problem);
        CHECK(answer.converged);
        Vector const exact = Eigen::Vector3d(500, -350 * std::cos(angle), -350 * std::sin(angle));
        CHECK((answer.force - exact).norm() < 1e-6);
      }
    }
  }

  TEST_CASE("random problems in two and three dimensions: all solvers agree") {
    for (int const dim : {2, 3})
      for (int const n : {1, 3, 10, 30})
        for (unsigned seed = 1; seed <= 3; ++seed) {
          INFO("dim " << dim << ", n " << n << ", seed " << seed);
          check_agreement(random_problem(dim, n, seed, 0.5), true, 1e-9);
        }
  }

  TEST_CASE("random problems with adhesion: all solvers agree") {
    for (int const dim : {2, 3})
      for (int const n : {1, 4, 30})
        for (unsigned seed = 1; seed <= 3; ++seed) {
          INFO("dim " << dim << ", n " << n << ", seed " << seed);
          auto problem = random_problem(dim, n, seed, 0.5);
          add_adhesion(problem, 0.1, seed);
          check_agreement(problem, true, 1e-9);
        }
  }

  TEST_CASE("more contacts than a rigid body can feel: displacements agree though forces need not") {
    for (int const dim : {2, 3}) {
      int const n = 12;
      auto problem = random_problem(dim, n, 3, 0);
      Dense const H = Dense::Random(dim * n, dim == 2 ? 3 : 6);
      problem.W = 1e-6 * H * H.transpose();
      problem.free = H * Vector::Constant(H.cols(), -1e-4);
      for (auto& point : problem.points)
        point.mu *= 0.3;
      check_agreement(problem, false, 1e-8);
    }
  }

  TEST_CASE("the answer does not depend on the starting guess") {
    auto const problem = random_problem(3, 10, 8, 0.5);
    for (auto const& [name, choice] : all_solvers()) {
      CAPTURE(name);
      auto const solver = make_solver(choice);
      auto const cold = solver->solve(problem, Vector::Zero(30));
      auto const warm = solver->solve(problem, Vector::Random(30) * 1e3);
      auto const again = solver->solve(problem, cold.force);
      CHECK((warm.converged && again.converged));
      CHECK((warm.force - cold.force).norm() < 1e-6 * cold.force.norm());
      CHECK(again.iterations <= 1);
    }
  }

  TEST_CASE("points that just touch and slide are solved as far as rounding lets them be") {
    Problem problem = one_point(Dense(4, 4), Vector::Zero(4), 0.3);
    problem.points.push_back(problem.points[0]);
    // the wall of tests/dynamics/step/audit.cpp at the step that ends where it is met
    problem.W.entries() << 12, -32, -4, -32, -32, 176.7, 32, 175.3, -4, 32, 12, 32, -32, 175.3, 32, 176.7;
    int seed = 0;
    for (double const touch : {1.3e-18, -1.2e-17, 6.9e-17, -6.1e-17, 0.0, -3.3e-18})
      for (double const other : {-1.2e-17, 5.9e-17, 1.1e-18, 0.0}) {
        double const more = 1e-17 * ++seed;
        problem.free = Eigen::Vector4d(touch, -0.0025 + more, other, -0.0025 - more);
        INFO(touch << " " << other);
        auto const answer = solve(BipotentialNewton{}, problem);
        CHECK(answer.converged);
        CHECK(answer.force.norm() < 1e-15);
      }
  }

  TEST_CASE("giving up is a verdict, not a lie") {
    auto const problem = random_problem(3, 20, 2, 0.1);
    BipotentialNewton newton;
    newton.iterations = 1;
    BipotentialUzawa uzawa;
    uzawa.iterations = 2;
    GaussSeidel gauss_seidel;
    gauss_seidel.iterations = 2;
    for (SolverChoice const& choice : {SolverChoice{uzawa}, SolverChoice{gauss_seidel}}) {
      auto const answer = solve(choice, problem);
      CHECK_FALSE(answer.converged);
      CHECK(answer.verdict.relative() > 1e-10);
      CHECK(answer.iterations <= 2);
    }
    auto const answer = solve(newton, problem); // what comes after Newton's iterations has limits of its own
    CHECK(answer.converged == (judge(problem, answer.force).relative() <= newton.tolerance));
  }

  TEST_CASE("no contact at all is solved at once") {
    for (int const n : {0, 5})
      for (auto const& [name, choice] : all_solvers()) {
        auto problem = random_problem(2, 5, 1, 1);
        problem.free.array() = 1e-3;
        if (n == 0)
          problem = Problem{2, Dense(0, 0), Vector(0), {}, {}};
        auto const answer = solve(choice, problem);
        CHECK(answer.converged);
        CHECK(answer.force.isZero(0));
      }
  }
}
