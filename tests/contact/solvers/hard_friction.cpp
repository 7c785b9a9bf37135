// Friction of more than one, and matrices whose stiffest and softest forces are far apart: there is an
// answer.
#include <doctest/doctest.h>

#include "contact/saved.hpp"
#include "contact/solvers.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// n dry points with W = Q diag(10^u) Q^T, u between -8 and 0, Q a rotation.
Problem spread(int dim, int n, unsigned seed, double mu) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> power(-8, 0);
  Eigen::Index const size = dim * n;
  Dense entries(size, size);
  for (Eigen::Index i = 0; i < entries.size(); ++i)
    entries.data()[i] = normal(random);
  Dense const Q = Eigen::HouseholderQR<Dense>(entries).householderQ();
  Vector values(size);
  for (Eigen::Index i = 0; i < size; ++i)
    values[i] = std::pow(10.0, power(random));
  Problem problem;
  problem.dim = dim;
  Dense const W = Q * values.asDiagonal() * Q.transpose();
  problem.W = Dense(0.5 * (W + W.transpose()));
  problem.free.resize(size);
  for (Eigen::Index i = 0; i < size; ++i)
    problem.free[i] = 0.1 * normal(random);
  problem.points.assign(static_cast<std::size_t>(n), {1, mu, -1, {}});
  return problem;
}

/// n dry points of a rigid body in the plane, W of rank three, that has an answer with points of all kinds.
Problem rigid(int n, unsigned seed, double most) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  Dense B(2 * n, 3);
  for (Eigen::Index i = 0; i < B.size(); ++i)
    B.data()[i] = normal(random);
  Problem problem;
  problem.W = Dense(B * B.transpose() / 3);
  Vector force = Vector::Zero(2 * n), y = Vector::Zero(2 * n);
  for (int i = 0; i < n; ++i) {
    double const mu = most * uniform(random), way = random() % 2 == 0 ? 1 : -1;
    problem.points.push_back({1, mu, -1, {}});
    auto const kind = random() % 3;
    if (kind == 0) {
      y.segment<2>(2 * i) << 0.1 + uniform(random), normal(random);
      continue;
    }
    force[2 * i] = 0.1 + uniform(random);
    force[2 * i + 1] = -way * mu * force[2 * i] * (kind == 1 ? 0.9 * uniform(random) : 1);
    y[2 * i + 1] = kind == 1 ? 0 : way * (0.1 + uniform(random));
  }
  problem.free = y - problem.W.dense() * force;
  return problem;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("friction above one over ill-conditioned bodies is answered, in the plane and in space") {
    for (auto const& [dim, n, mu] : {std::tuple{2, 24, 2.0}, {2, 36, 4.0}, {3, 20, 2.0}, {3, 26, 3.0}})
      for (unsigned seed = 1; seed <= 8; ++seed) {
        auto const answer = solve(BipotentialNewton{1e-9}, spread(dim, n, seed, mu));
        CAPTURE(dim);
        CAPTURE(mu);
        CAPTURE(seed);
        CAPTURE(answer.verdict.relative());
        CHECK(answer.converged);
        CHECK(answer.verdict.relative() <= 1e-9);
      }
  }

  TEST_CASE("a rigid body on many rough points is answered") {
    int projected = 0;
    struct Known {
      int points;
      double mu;
      unsigned seed;
    };
    for (auto const& [points, mu, seed] : {Known{12, 1.5, 9},
                                           {30, 1.5, 71},
                                           {12, 3, 69},
                                           {20, 3, 29},
                                           {60, 3, 8},
                                           {40, 1.5, 1},
                                           {60, 1.5, 2},
                                           {40, 3, 3},
                                           {60, 3, 4}}) {
      auto const answer = solve(BipotentialNewton{1e-9}, rigid(points, seed, mu));
      CAPTURE(points);
      CAPTURE(seed);
      CHECK(answer.converged);
      projected += answer.method == Method::uzawa ? 1 : 0;
    }
    CHECK(projected > 0); // what nothing else answers is among them
  }

  TEST_CASE("bonds that soften much faster than bodies give way are answered beside friction") {
    int damped = 0;
    for (auto const& [dim, n, softness] : {std::tuple{2, 30, 300.0}, {3, 8, 3000.0}, {3, 30, 30.0}})
      for (unsigned seed = 0; seed < 30; ++seed) {
        auto problem = random_problem(dim, n, seed, 0.05);
        add_adhesion(problem, softness, seed);
        auto const answer = solve(BipotentialNewton{}, problem);
        CAPTURE(dim);
        CAPTURE(softness);
        CAPTURE(seed);
        CHECK(answer.converged);
        CHECK(judge(problem, answer.force).relative() <= 1e-10);
        damped += answer.method == Method::damping ? 1 : 0;
      }
    CHECK(damped > 0); // what nothing else answers is among them
  }

  TEST_CASE("bodies that give way next to nothing along the surface are answered") {
    auto const answer = solve(BipotentialNewton{1e-10}, saved("slab_held_along"));
    CHECK(answer.converged);
    CHECK(answer.verdict.relative() <= 1e-10);
  }
}
