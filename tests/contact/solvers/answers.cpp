// Problems of no, one and several answers: which of it is found, and what is shown.
#include <doctest/doctest.h>
#include <numbers>

#include "contact/solvers.hpp"
#include "contact/solvers/answers.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// A wedge in a guide that lets it move along v = (1/2, 1) alone, towards or from the surface: with mu > 1/2
/// it jams. W is singular to the last bit.
Problem wedge(double normal, double along, double mu) {
  Eigen::Vector2d const v(0.5, 1);
  return one_point(1e-6 * v * v.transpose(), Eigen::Vector2d(normal, along), mu);
}

Answers answers_of(Problem const& problem) {
  return seek_answers(problem, solve(BipotentialNewton{}, problem).force);
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("a wedge in a guide that is driven onto the surface has no answer where it jams") {
    auto const problem = wedge(-1e-3, 0, 1);
    auto const solution = solve(BipotentialNewton{}, problem);
    CHECK_FALSE(solution.converged);
    CHECK(solution.method == Method::none);
    auto const answers = answers_of(problem);
    CHECK(answers.found.empty());
    CHECK(answers.all);
    CHECK(words(answers, 2) == "it is shown that this one has none");
    CHECK(without_answer(problem, solution.force).all);
  }

  TEST_CASE("forces that a wedge feels by rounding alone are no answer") {
    for (double const angle : {20.0, 45.0, 60.0, 70.0, 77.0})
      for (double const mu : {2.8, 5.0}) {
        Eigen::Vector2d const v(std::cos(angle * std::numbers::pi / 180),
                                std::sin(angle * std::numbers::pi / 180));
        auto const problem = one_point(1e-6 * v * v.transpose(), Eigen::Vector2d(-1e-3, 0), mu);
        auto const solution = solve(BipotentialNewton{}, problem);
        CAPTURE(angle);
        CAPTURE(mu);
        CAPTURE(solution.force.transpose());
        CHECK_FALSE(solution.converged);
        for (auto const& found : answers_of(problem).found)
          CHECK(found.norm() < 1e9);
      }
  }

  TEST_CASE("the same wedge has one answer where it does not jam, or is driven with the friction") {
    for (auto const& problem : {wedge(-1e-3, 0, 0.3), wedge(-1e-3, -3e-3, 1)}) {
      auto const answers = answers_of(problem);
      REQUIRE(answers.found.size() == 1);
      CHECK(answers.given);
      CHECK(answers.all);
      CHECK(words(answers, 2) == "only this one was found, and there is no other");
      double const mu = problem.points[0].mu, t = problem.free[1] < 0 ? mu : -mu;
      double const r = 1e-3 / (1e-6 * 0.5 * (0.5 + t));
      CHECK((answers.found[0] - Eigen::Vector2d(r, t * r)).norm() < 1e-6 * r);
    }
  }

  TEST_CASE("the same wedge has two answers where it is drawn away: it leaves, or jams") {
    auto const problem = wedge(1e-3, 3e-3, 1);
    auto const answers = answers_of(problem);
    REQUIRE(answers.found.size() == 2);
    CHECK(answers.all);
    double const r = 1e-3 / (1e-6 * 0.5 * 0.5);
    std::vector<double> sizes{answers.found[0].norm(), answers.found[1].norm()};
    std::ranges::sort(sizes);
    CHECK(sizes[0] == 0);
    CHECK(sizes[1] == doctest::Approx(std::sqrt(2.0) * r));
    CHECK(words(answers, 2).starts_with("all 2 answers were found: largest forces "));
    CHECK(words(answers, 2).find("(this one)") != std::string::npos);
  }

  TEST_CASE("a rod on a slope hovers, slides or sticks past its limit, and all three are found") {
    Dense const W = (Dense(2, 2) << 1.6, -1.2, -1.2, 3.4).finished(); // tangent 2
    auto const several = answers_of(one_point(W, Eigen::Vector2d(1e-3, -1), 1.6));
    CHECK(several.found.size() == 3);
    CHECK(several.all);
    CHECK(answers_of(one_point(W, Eigen::Vector2d(1e-3, -1), 1.3)).found.size() == 1);
  }

  TEST_CASE("symmetric points that lean have an answer to either side, in space too") {
    Dense plane(4, 4);
    plane << 1, -0.55, 0.9, -0.45, -0.55, 10, 0.45, 9.95, 0.9, 0.45, 1, 0.55, -0.45, 9.95, 0.55, 10;
    Dense W = Dense::Identity(6, 6);
    std::vector<Index> const rows{0, 1, 3, 4};
    W(rows, rows) = plane;
    Problem problem;
    problem.dim = 3;
    problem.W = W;
    problem.points.assign(2, {1, 0.3, -1, {}});
    problem.free = Vector::Zero(6);
    problem.free[0] = problem.free[3] = -1;
    auto const answers = answers_of(problem);
    CHECK(answers.found.size() >= 2);
    CHECK_FALSE(answers.all); // in space nothing is shown
    CHECK(words(answers, 3).find("answers were found from several starts") != std::string::npos);
  }

  TEST_CASE("where W is positive definite there is an answer, whether or not it was found") {
    auto const answers = without_answer(random_problem(2, 10, 1, 0.5), Vector::Zero(20));
    CHECK(answers.promised);
    CHECK_FALSE(answers.all);
    CHECK_FALSE(without_answer(wedge(-1e-3, 0, 1), Vector::Zero(2)).promised);
  }
}
