// Which method answered a problem is said.
#include <doctest/doctest.h>

#include "contact/saved.hpp"
#include "contact/solvers.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

std::string method_of(Problem const& problem) {
  BipotentialNewton solver;
  solver.tolerance = 1e-8;
  return std::string(name_of(solve(solver, problem).method));
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("the default solver says what gave its answer") {
    CHECK(method_of(random_problem(3, 20, 1, 0.5)) == "sweeps");
    CHECK(method_of(random_problem(3, 19, 1, 0.5)) == "newton"); // fewer than 60 rows
    CHECK(method_of(saved("belt_90")) == "proximal");            // sweeps and Newton cycle
    CHECK(method_of(saved("bar_snaps")) == "descent");
    CHECK(method_of(saved("belt_180_indefinite")) == "pivoting");
  }

  TEST_CASE("each of the other solvers names itself, and one that gives up names nothing") {
    auto const problem = random_problem(2, 10, 1, 0.5);
    CHECK(solve(BipotentialUzawa{}, problem).method == Method::uzawa);
    CHECK(solve(GaussSeidel{}, problem).method == Method::gauss_seidel);
    BipotentialUzawa once;
    once.iterations = 1;
    CHECK(solve(once, problem).method == Method::none);
  }

  TEST_CASE("Newton answers a large problem at once whose guess is near") {
    auto const problem = random_problem(3, 20, 1, 0.5);
    BipotentialNewton solver;
    solver.tolerance = 1e-8;
    auto const far = solve(solver, problem);
    REQUIRE(far.method == Method::sweeps);
    auto const near = solver.make()->solve(problem, 1.01 * far.force);
    CHECK(near.method == Method::newton);
    CHECK(near.iterations <= 4);
    CHECK((near.force - far.force).norm() <= 1e-6 * far.force.norm());
  }

  TEST_CASE("a point says whether it has an answer of its own") {
    Dense W(2, 2);
    W << -1e-6, 0, 0, 1e-6; // what presses it makes it sink
    Eigen::Vector2d const free(-1e-3, 0), none(0, 0);
    auto const sinks = one_point(W, free, 0.4), holds = one_point(W.cwiseAbs(), free, 0.4);
    CHECK_FALSE(solve_point<2>(sinks, 0, free, none, natural_scale(sinks, 0)).found);
    auto const answer = solve_point<2>(holds, 0, free, none, natural_scale(holds, 0));
    CHECK(answer.found);
    CHECK((answer.force - Eigen::Vector2d(1000, 0)).norm() <= 1e-6);
  }

  TEST_CASE("counts of methods in words") {
    Methods counts{};
    CHECK(words(counts).empty());
    counts[static_cast<std::size_t>(Method::newton)] = 1;
    counts[static_cast<std::size_t>(Method::sweeps)] = 40;
    CHECK(words(counts) == "sweeps 40 newton 1");
  }
}
