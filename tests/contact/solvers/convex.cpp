// Random convex problems, and random ones with friction that are known to have an answer: the default solver
// has to find one.
#include <doctest/doctest.h>
#include <numeric>

#include "contact/solvers.hpp"
#include "contact/solvers/complementarity.hpp"
#include "contact/solvers/minimum.hpp"
#include "contact/solvers/pivoting.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

enum class Kind { sound, ill, deficient };

/// W = B diag B^T, of full rank, of condition 1e12, or of half its rank; free so that some x is admitted.
Problem convex(int dim, int n, Kind kind, std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0, 1);
  int const size = dim * n, rank = kind == Kind::deficient ? (size + 1) / 2 : size;
  Dense B(size, rank);
  for (Eigen::Index i = 0; i < B.size(); ++i)
    B.data()[i] = normal(random);
  if (kind == Kind::ill)
    for (int k = 0; k < rank; ++k)
      B.col(k) *= std::pow(10.0, -6.0 * k / rank);
  Problem problem;
  problem.dim = dim;
  problem.W = 1e-6 / size * B * B.transpose();
  Vector way(rank);
  for (int k = 0; k < rank; ++k)
    way[k] = normal(random);
  problem.free = 1e-4 * B * way;
  for (int i = 0; i < n; ++i) {
    problem.free[dim * i] += 1e-4 * uniform(random);
    problem.points.push_back({1e-4 * (0.5 + uniform(random)), 0, -1, {}});
  }
  return problem;
}

/// Whole bonds on two points of three, from much softer than the bodies to much stiffer.
void bond(Problem& problem, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  interface::Rcc law;
  law.C_n = law.C_t = law.C_t2 = std::pow(10.0, 8 + 6 * uniform(random));
  law.w = law.C_n; // whole up to an opening of a metre
  law.bonding = interface::Bonding::never;
  problem.adhesions = {law};
  for (auto& point : problem.points)
    if (uniform(random) < 0.67) {
      point.adhesion = 0;
      point.bond = {{1, {0, 0}}, 1e-3, false};
    }
}

/// One point's gap is given and it is apart.
void hold_first(Problem& problem) {
  problem.W.entries().topRows(problem.dim).setZero();
  problem.W.entries().leftCols(problem.dim).setZero();
  problem.free[0] = 1e-5;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("every random convex problem is solved, whatever the rank and condition of W and the bonds") {
    std::mt19937 random(11);
    int failed = 0, all = 0;
    for (int const dim : {1, 2, 3})
      for (auto const kind : {Kind::sound, Kind::ill, Kind::deficient})
        for (int const n : {1, 2, 5, 12})
          for (int trial = 0; trial < 10; ++trial, ++all) {
            auto problem = convex(dim, n, kind, random);
            if (trial % 2 == 1)
              bond(problem, random);
            if (trial % 5 == 4 && n > 1)
              hold_first(problem);
            auto const answer = solve(BipotentialNewton{}, problem);
            INFO("dim " << dim << ", n " << n << ", kind " << static_cast<int>(kind) << ", trial " << trial
                        << ": " << answer.verdict.relative());
            CHECK(answer.converged);
            failed += answer.converged ? 0 : 1;
          }
    CHECK(all >= 300);
    CHECK(failed == 0);
  }

  TEST_CASE(
      "random plane problems with friction up to 1.5: solved wherever trying every status finds an answer") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(0, 1);
    int answered = 0;
    for (int const n : {1, 2, 3, 4})
      for (int trial = 0; trial < 40; ++trial) {
        auto problem = convex(2, n, trial % 4 == 3 ? Kind::deficient : Kind::sound, random);
        for (auto& point : problem.points)
          point.mu = 1.5 * uniform(random);
        if (trial % 3 == 2)
          problem.W.entries().diagonal().array() -= 2e-7; // may be indefinite
        auto const known = enumerate(problem, Vector::Zero(2 * n)).answers;
        auto const answer = solve(BipotentialNewton{}, problem);
        INFO("n " << n << ", trial " << trial << ", known " << known.size() << ", "
                  << answer.verdict.relative());
        CHECK((known.empty() || answer.converged));
        answered += answer.converged ? 1 : 0;
      }
    CHECK(answered > 100);
  }

  TEST_CASE("pivoting answers friction in the plane at once, from nothing and from closed points") {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      auto problem = random_problem(2, 20, seed, 0.5);
      for (auto const from : {From::nothing, From::statuses, From::closed}) {
        auto const found = pivot(problem, Vector::Zero(40), from);
        REQUIRE(found);
        REQUIRE(found->force.size() == 40);
        CHECK(judge(problem, found->force).relative() <= 1e-9);
      }
    }
  }

  TEST_CASE("a point pressed where nothing gives way has no answer, and pivoting shows it") {
    Problem problem = one_point(Dense::Zero(2, 2), Eigen::Vector2d(-1e-3, 0), 0.3);
    auto const found = pivot(problem, Vector::Zero(2), From::nothing);
    REQUIRE(found);
    CHECK(found->none);
    problem.free[0] = 1e-3;
    CHECK(pivot(problem, Vector::Zero(2), From::nothing)->force.isZero(0));
  }

  TEST_CASE("exchanging active sets and Lemke's method give the same answer") {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int n = 1; n <= 30; ++n) {
      Dense const G = Dense::NullaryExpr(n, n, [&] { return normal(random); });
      Dense const M = G.transpose() * G;
      Vector const q = Vector::NullaryExpr(n, [&] { return normal(random); });
      std::vector<bool> active(static_cast<std::size_t>(n), false);
      auto const exchanged = ConvexComplementarity(M).solve(q, active);
      REQUIRE(exchanged);
      ConvexComplementarity again(M); // after another problem, from its set
      REQUIRE(again.solve(Vector::Constant(n, -1), active));
      auto const repeated = again.solve(q, active);
      REQUIRE(repeated);
      CHECK((*repeated - *exchanged).norm() <= 1e-7 * (1 + exchanged->norm()));
      auto const pivoted = lemke(M, q, 1000);
      REQUIRE(pivoted.end == Pivoted::answered);
      CHECK((*exchanged - pivoted.z).norm() <= 1e-5 * (1 + pivoted.z.norm()));
      CHECK((M * pivoted.z + q).minCoeff() >= -1e-9 * (1 + pivoted.z.norm()));
      for (int const held : {n / 2, n}) { // some rows at rest from the start, and all
        std::vector<Index> set(static_cast<std::size_t>(held));
        std::iota(set.begin(), set.end(), 0);
        auto const other = lemke_from(M, q, set, 1000);
        REQUIRE(other.end == Pivoted::answered);
        CHECK((other.z - pivoted.z).norm() <= 1e-5 * (1 + pivoted.z.norm()));
      }
    }
  }
}
