// GMRES with preconditioners that are linear, and with one that is not.
#include "linear/krylov.hpp"

#include <Eigen/LU>
#include <doctest/doctest.h>

using namespace stiction;
using namespace stiction::linear;

namespace {

/// Unsymmetric, and indefinite where few rows have the other sign.
Dense system(Index n) {
  Dense A(n, n);
  for (Index i = 0; i < n; ++i)
    for (Index j = 0; j < n; ++j)
      A(i, j) =
          i == j ? (i % 7 == 0 ? -2.0 : 3.0 + double(i) / double(n)) : 1 / double(2 + (3 * i + j) % 11) / 6;
  return A;
}

TEST_CASE("a linear preconditioner is applied once more instead of being kept, to the same answer") {
  Index const n = 50;
  Dense const A = system(n);
  Vector const b = Vector::LinSpaced(n, -1, 2), exact = A.partialPivLu().solve(b);
  auto const apply = [&](Vector const& x, Vector& y) { y = A * x; };
  int calls = 0;
  auto const precondition = [&](Vector const& r, Vector& z) {
    ++calls;
    z = r.cwiseQuotient(A.diagonal());
  };
  Vector kept, again;
  auto const one = gmres(apply, precondition, b, kept, KrylovLimits<>{1e-12, 50});
  CHECK(calls == one.iterations);
  calls = 0;
  auto const other = gmres(apply, precondition, b, again, KrylovLimits<>{1e-12, 50, {}, true});
  CHECK(calls == other.iterations + 1);
  CHECK(one.converged);
  CHECK(other.iterations == one.iterations);
  CHECK((kept - exact).norm() < 1e-11 * exact.norm());
  CHECK((again - kept).norm() < 1e-13 * exact.norm());
}

TEST_CASE("what a preconditioner made is kept where it is not linear") {
  Index const n = 50;
  Dense const A = system(n);
  Vector const b = Vector::LinSpaced(n, -1, 2);
  auto const apply = [&](Vector const& x, Vector& y) { y = A * x; };
  auto const precondition = [&](Vector const& r, Vector& z) {
    z = r.cwiseQuotient(A.diagonal()).array() * (1 + 0.2 * r.cwiseAbs().array() / r.norm());
  };
  Vector x;
  CHECK(gmres(apply, precondition, b, x, KrylovLimits<>{1e-10, 50}).converged);
  CHECK((A * x - b).norm() < 1e-9 * b.norm());
  gmres(apply, precondition, b, x, KrylovLimits<>{1e-10, 50, {}, true});
  CHECK((A * x - b).norm() > 1e-4 * b.norm());
}

TEST_CASE("vectors kept in single precision bring five digits at a time, in as many iterations") {
  Index const n = 50;
  Dense const A = system(n);
  Vector const b = Vector::LinSpaced(n, -1, 2);
  auto const apply = [&](Vector const& x, Vector& y) { y = A * x; };
  auto const precondition = [&](Vector const& r, Vector& z) { z = r.cwiseQuotient(A.diagonal()); };
  Vector x, answer = Vector::Zero(n), residual = b;
  int const usual = gmres(apply, precondition, b, x, KrylovLimits<>{1e-5, 50, {}, true}).iterations;
  for (double left = 1; left > 1e-12;) {
    auto const end = gmres(apply, precondition, residual, x, KrylovLimits<ShortVectors>{1e-5, 50, {}, true});
    CHECK(end.converged);
    CHECK(end.iterations <= usual + 1);
    answer += x;
    residual = b - A * answer;
    double const now = residual.norm() / b.norm();
    REQUIRE(now < 2e-5 * left);
    left = now;
  }
}

} // namespace
