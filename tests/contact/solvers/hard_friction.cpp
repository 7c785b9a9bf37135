// Friction of more than one, and matrices whose stiffest and softest forces are far apart: there is an
// answer.
#include <doctest/doctest.h>

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
}
