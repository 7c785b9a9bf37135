// What is made for many points: sweeps that are mixed, more compliance that vanishes, a Hessian that is kept.
#include <doctest/doctest.h>

#include "contact/solvers.hpp"
#include "contact/solvers/kept_hessian.hpp"
#include "contact/solvers/mixed_sweeps.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// W of rank `rank`; free that some forces lift.
Problem of_rank(int n, int rank, std::mt19937& random) {
  std::normal_distribution<double> normal;
  Problem problem;
  problem.dim = 3;
  Dense const B = Dense::NullaryExpr(3L * n, rank, [&] { return normal(random); });
  problem.W = 1e-6 / rank * B * B.transpose();
  problem.free = 1e-4 * B * Vector::NullaryExpr(rank, [&] { return normal(random); });
  problem.points.assign(static_cast<std::size_t>(n), {1e-4, 0.4, -1, {}});
  for (int i = 0; i < n; ++i)
    problem.free[3L * i] += 1e-4 * std::abs(normal(random));
  return problem;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("mixed sweeps give the answer of plain ones, and need fewer of them") {
    for (int const dim : {2, 3})
      for (unsigned seed = 1; seed <= 5; ++seed) {
        auto const problem = random_problem(dim, 60, seed, 0.4);
        REQUIRE(plain(problem));
        auto const mixed = mix_sweeps(problem, Vector::Zero(problem.free.size()), 1e-11, 2000);
        GaussSeidel sweeps;
        sweeps.tolerance = 1e-11;
        auto const swept = solve(sweeps, problem);
        INFO("dim " << dim << ", seed " << seed << ": " << mixed.iterations << " of " << swept.iterations);
        REQUIRE(swept.converged);
        CHECK(mixed.converged);
        CHECK(judge(problem, mixed.force).relative() <= 1e-11);
        CHECK((mixed.force - swept.force).norm() <= 1e-7 * swept.force.norm());
        CHECK(mixed.iterations < swept.iterations);
      }
  }

  TEST_CASE("mixed sweeps that do not get there say so") {
    std::mt19937 random(4);
    auto const problem = of_rank(40, 12, random);
    auto const few = mix_sweeps(problem, Vector::Zero(problem.free.size()), 1e-12, 3);
    CHECK(few.iterations == 3);
    CHECK_FALSE(few.converged);
    CHECK(few.verdict.relative() > 1e-12);
  }

  TEST_CASE("many points on few degrees of freedom with friction have an answer, and the default finds it") {
    std::mt19937 random(9);
    for (int const rank : {6, 12, 40})
      for (int trial = 0; trial < 5; ++trial) {
        auto const answer = solve(BipotentialNewton{}, of_rank(40, rank, random));
        INFO("rank " << rank << ", trial " << trial << ": " << answer.verdict.relative());
        CHECK(answer.converged);
      }
  }

  TEST_CASE(
      "a Hessian whose blocks change is that of the new blocks, and is refused where it is indefinite") {
    std::mt19937 random(2);
    std::normal_distribution<double> normal;
    Index const n = 70, moved = 30, rank = 50; // nothing moves the others
    Dense F = Dense::Zero(2 * n, rank);
    F.topRows(2 * moved) = Dense::NullaryExpr(2 * moved, rank, [&] { return normal(random); });
    KeptHessian<2> hessian(F);
    KeptHessian<2>::Blocks K(static_cast<std::size_t>(n), LocalMatrix<2>::Identity());
    auto const direct = [&] {
      Dense H = Dense::Identity(rank, rank);
      for (Index i = 0; i < n; ++i)
        H += F.middleRows<2>(2 * i).transpose() * K[ix(i)] * F.middleRows<2>(2 * i);
      return H;
    };
    Vector const g = Vector::NullaryExpr(rank, [&] { return normal(random); });
    auto const same = [&] {
      Dense const H = direct(), N = F(Eigen::seqN(0, n, 2), Eigen::all);
      Dense const M = N * H.ldlt().solve(N.transpose());
      CHECK((hessian.solve(g) - H.ldlt().solve(g)).norm() <= 1e-10 * g.norm());
      CHECK((hessian.normal_compliance() - M).norm() <= 1e-10 * M.norm());
    };
    REQUIRE(hessian.set(K));
    same();
    for (int round = 0; round < 4; ++round) {
      K[ix(3 * round)] = 0.1 * LocalMatrix<2>::Random();
      K[ix(3 * round)] = (K[ix(3 * round)] + K[ix(3 * round)].transpose()).eval();
      REQUIRE(hessian.set(K));
      same();
    }
    Vector const as_it_was = hessian.solve(g);
    K[20] *= 1 + 1e-9;
    REQUIRE(hessian.set(K, 1e-6)); // too slight to matter
    CHECK(hessian.solve(g) == as_it_was);
    REQUIRE(hessian.set(K));
    CHECK(hessian.solve(g) != as_it_was);
    auto const sound = K;
    K[7] = -50 * LocalMatrix<2>::Identity();
    CHECK(Eigen::LLT<Dense>(direct()).info() != Eigen::Success);
    CHECK_FALSE(hessian.set(K));
    K = sound;
    for (auto& block : K) // too many to be changed one by one
      block *= 1.5;
    REQUIRE(hessian.set(K));
    same();
  }
}
