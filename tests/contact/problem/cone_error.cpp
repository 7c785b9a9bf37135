// The error over all points together, as collections of friction problems state it.
#include <doctest/doctest.h>

#include "contact/problem/cone_error.hpp"
#include "contact/solvers.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

TEST_SUITE("contact") {
  TEST_CASE("the error over all points of one that is pressed too much, too little, or slides wrongly") {
    auto const error = [](double free_n, double free_t, double pn, double pt) {
      auto const problem = one_point(Dense::Identity(2, 2), Eigen::Vector2d(free_n, free_t), 0.5);
      Vector const force = Eigen::Vector2d(pn, pt);
      return cone_error(problem, force, displacement(problem, force)).value();
    };
    CHECK(error(-1, 0, 1, 0) == doctest::Approx(0));
    CHECK(error(-1, 0, 1.1, 0) == doctest::Approx(0.1)); // gap 0.1: r - u = 1
    CHECK(error(-1, 0, 0.9, 0) == doctest::Approx(0.1));
    CHECK(error(-1, 1, 1, -0.5) == doctest::Approx(0)); // slides by 0.5
    // u = (0, 1), r - (u + mu |u_t| n) = (0.5, -1), which lands on (0.8, -0.4); |q| = sqrt 2
    CHECK(error(-1, 1, 1, 0) == doctest::Approx(std::hypot(0.2, 0.4) / std::sqrt(2)));
  }

  TEST_CASE("the error over all points does not know the units of force and length") {
    auto problem = random_problem(3, 4, 3, 1);
    Vector const force = solve(BipotentialNewton{}, problem).force * 1.01;
    double const error = cone_error(problem, force, displacement(problem, force)).value();
    CHECK(error > 1e-4);
    auto other = problem;
    other.W = Dense(problem.W.dense() * 1e-3); // 1e3 / 7 times the force
    other.free = problem.free / 7;
    Vector const same = force * (1e3 / 7);
    CHECK(cone_error(other, same, displacement(other, same)).value() ==
          doctest::Approx(error).epsilon(1e-10));
  }

  TEST_CASE("problems with bonds, with nothing that drives them, or without points have no such error") {
    auto problem = random_problem(2, 3, 5, 1);
    Vector const none = Vector::Zero(6);
    CHECK(cone_error(problem, none, problem.free).has_value());
    auto bonded = problem;
    add_adhesion(bonded, 0.2, 5);
    CHECK_FALSE(cone_error(bonded, none, bonded.free).has_value());
    problem.free.setZero();
    CHECK_FALSE(cone_error(problem, none, problem.free).has_value());
    CHECK_FALSE(cone_error(Problem{}, Vector{}, Vector{}).has_value());
  }
}
