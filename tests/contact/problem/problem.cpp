// The natural map at one point, its derivatives, and the judge.
#include <doctest/doctest.h>

#include "contact/solvers.hpp"
#include "differences.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

Dense matrix2(double nn, double nt, double tt) {
  return (Dense(2, 2) << nn, nt, nt, tt).finished();
}

/// d(residual)/dp along x = free + W p: as the solvers combine the parts of evaluate().
template<int D> void check_map(Problem const& problem, Local<D> const& p) {
  double const rho = natural_scale(problem, 0);
  LocalMatrix<D> const W = problem.W.block<D>(0);
  Local<D> const free = problem.free.head<D>();
  auto const at = [&](Vector const& force) {
    Local<D> const f = force;
    return evaluate<D>(problem, 0, f, Local<D>(free + W * f), rho);
  };
  auto const here = at(p);
  LocalMatrix<D> const J =
      here.residual_by_dry + (here.residual_by_x - here.residual_by_dry * here.adhesion_by_x) * W;
  auto const rate = test::rate([&](Vector const& f) { return Vector(at(f).residual); }, Dense(J), p, 0.1);
  INFO("D = " << D << ", status " << static_cast<int>(here.status) << ", p = " << p.transpose());
  CHECK_MESSAGE(rate.second_order, rate.words());
  CHECK(rate.errors[3] < 1e-5);
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("the natural map's derivative along x = free + W p, with and without adhesion") {
    for (int const dim : {2, 3})
      for (bool const bonded : {false, true})
        for (unsigned seed = 1; seed <= 5; ++seed) {
          auto problem = random_problem(dim, 1, seed, 1);
          if (bonded)
            add_adhesion(problem, 0.2, seed);
          if (bonded && seed % 2 == 0)
            problem.points[0].adhesion = 1; // damaged friction
          for (double const size : {-60.0, 20.0, 150.0}) {
            if (dim == 2)
              check_map<2>(problem, {size, 37});
            else
              check_map<3>(problem, {size, 37, -21});
          }
        }
  }

  TEST_CASE("the scale of the natural map is one over the largest eigenvalue") {
    auto const plane = one_point(matrix2(3e-6, 1e-6, 3e-6), Vector::Zero(2), 0);
    CHECK(natural_scale(plane, 0) == doctest::Approx(1 / 4e-6));
    auto space = random_problem(3, 2, 4, 1);
    space.W.entries().block<3, 3>(3, 3) = Eigen::Vector3d(1e-6, 5e-6, 2e-6).asDiagonal();
    CHECK(natural_scale(space, 1) == doctest::Approx(1 / 5e-6));
  }

  TEST_CASE("a point far apart does not set the yardstick of the judge") {
    auto problem = random_problem(2, 2, 1, 0);
    problem.W = Dense::Identity(4, 4) * 1e-6;
    problem.free << -1e-3, 0, 10, 0; // pressed by 1 mm, 10 m apart
    for (auto& point : problem.points)
      point.area = 0.1;
    CHECK(judge(problem, Vector::Zero(4)).scale == doctest::Approx(1e-3 / 1e-6 / 0.1));
    problem.free[0] = 1e-3;
    CHECK(judge(problem, Vector::Zero(4)).scale == 0);
  }

  TEST_CASE("the judge passes right forces and says no to wrong ones, in Pa") {
    Dense const W = matrix2(2e-6, 0, 4e-6);
    auto const judged = [&](double free_n, double free_t, double pn, double pt) {
      auto problem = one_point(W, Eigen::Vector2d(free_n, free_t), 0.5);
      problem.points[0].area = 0.1;
      return judge(problem, Eigen::Vector2d(pn, pt));
    };
    CHECK(judged(-1e-3, 4e-4, 500, -100).residual < 1e-9); // sticks: x = 0
    CHECK(judged(-1e-3, 2e-3, 500, -250).residual < 1e-9); // slides
    CHECK(judged(1e-3, 2e-3, 0, 0).residual < 1e-9);       // open
    CHECK(judged(-1e-3, 4e-4, 500, -100).scale == doctest::Approx(std::hypot(500, 100) / 0.1));
    CHECK(judged(-1e-3, 4e-4, 499, -100).relative() > 1e-4); // penetrates
    CHECK(judged(-1e-3, 4e-4, 501, -100).relative() > 1e-4); // pushes across a gap
    CHECK(judged(-1e-3, 2e-3, 500, 250).relative() > 0.1);   // friction the wrong way
    CHECK(judged(-1e-3, 2e-3, 500, -260).relative() > 0.01); // outside the cone
    CHECK(judged(-1e-3, 2e-3, 500, -240).relative() > 0.01); // slides inside the cone
    CHECK(judged(1e-3, 0, 1, 0).relative() > 0.1);           // force at a distance
    CHECK(judged(-1e-3, 0, -1, 0).relative() > 0.1);         // dry contact cannot pull
    CHECK(judged(-1e-3, 0, 0, 0).relative() > 0.1);          // no answer is no answer
  }

  TEST_CASE("each point is judged with its own area, coefficient and law") {
    auto problem = random_problem(2, 4, 9, 2);
    auto const right = solve(BipotentialNewton{}, problem);
    REQUIRE(right.converged);
    for (int i = 0; i < 4; ++i) {
      auto changed = problem;
      changed.points[static_cast<std::size_t>(i)].mu += 0.5;
      auto const p = right.force.segment<2>(2 * i);
      bool const slides =
          std::abs(p[1]) > 1e-6 &&
          std::abs(std::abs(p[1]) - problem.points[static_cast<std::size_t>(i)].mu * p[0]) < 1e-6;
      CHECK((judge(changed, right.force).relative() > 1e-6) == slides);
    }
  }
}
