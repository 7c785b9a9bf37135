// Factorization, solution, the trailing block of the factor, and that refactoring takes no memory.
#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <doctest/doctest.h>
#include <numeric>

#include "linear/cholesky.hpp"
#include "linear/recycling.hpp"
#include "linear/systems.hpp"
#include "threads.hpp"

using namespace stiction;
using namespace stiction::linear;
using namespace stiction::test;

namespace {

std::vector<bool> marked(Index n, Indices const& last) {
  std::vector<bool> flags(ix(n), false);
  for (Index const i : last)
    flags[ix(i)] = true;
  return flags;
}

} // namespace

TEST_SUITE("linear") {
  TEST_CASE("a pattern holds each coupling of its cliques once and leaves negative unknowns out") {
    auto const pattern = pattern_of(4, {{0, 2}, {2, 0, -1}, {3, 2}});
    CHECK(pattern.columns == Indices{0, 2, 3, 5, 6});
    CHECK(pattern.rows == Indices{0, 2, 1, 2, 3, 3});
    CHECK(pattern.find(0, 2) == 1);
    CHECK(pattern.find(2, 0) == 1);
    CHECK(pattern.find(3, 3) == 5);
    CHECK(pattern.find(0, 3) == -1);
    CHECK(pattern.find(1, 0) == -1);
  }

  TEST_CASE("the product with a vector is that of the full symmetric matrix") {
    auto const pattern = grid(5);
    auto const values = values_of(pattern, 3);
    Vector const x = Vector::LinSpaced(pattern.size(), -1, 2);
    Vector y;
    multiply(pattern, values, x, y);
    CHECK((y - dense(pattern, values) * x).norm() < 1e-13 * y.norm());
  }

  TEST_CASE("the elimination order is a permutation with the marked unknowns last, as given") {
    auto const pattern = grid(9);
    for (auto const& last : {Indices{}, Indices{3, 4, 5, 40, 80}}) {
      auto const order = elimination_order(pattern, marked(pattern.size(), last));
      Indices sorted = order, all(order.size());
      std::sort(sorted.begin(), sorted.end());
      std::iota(all.begin(), all.end(), 0);
      CHECK(sorted == all);
      CHECK(order.size() == 81);
      CHECK(std::equal(last.begin(), last.end(), order.end() - static_cast<std::ptrdiff_t>(last.size())));
    }
    auto const none_inside = elimination_order(grid(2), {true, true, true, true});
    CHECK(none_inside == Indices{0, 1, 2, 3});
  }

  TEST_CASE("solutions and the trailing factor are those of dense algebra, for value after value") {
    auto const natural = grid(12);
    Indices last;
    for (Index i = 0; i < 12; ++i)
      last.push_back(i);
    auto const order = elimination_order(natural, marked(natural.size(), last));
    Cholesky cholesky(reordered(natural, order), 12);
    for (unsigned seed = 1; seed <= 4; ++seed) {
      auto const values = values_of(cholesky.pattern(), seed);
      Dense const A = dense(cholesky.pattern(), values);
      REQUIRE(cholesky.factorize(values));
      Vector const exact = Vector::LinSpaced(A.rows(), 1, 3);
      Vector b = A * exact;
      cholesky.solve(b);
      CHECK((b - exact).norm() < 1e-12 * exact.norm());
      Dense const L = Dense(A.llt().matrixL()).bottomRightCorner(12, 12);
      CHECK((cholesky.trailing_factor() - L).norm() < 1e-12 * L.norm());
      Dense several = A * Dense::Random(A.rows(), 5), copy = several;
      cholesky.solve(several);
      CHECK((A * several - copy).norm() < 1e-12 * copy.norm());
    }
  }

  TEST_CASE("in an order of its own the same solutions") {
    auto const pattern = grid(9);
    auto const values = values_of(pattern, 5);
    Cholesky given(pattern, 9), free(pattern, 9, Order::free);
    REQUIRE(given.factorize(values));
    REQUIRE(free.factorize(values));
    Vector one = Vector::LinSpaced(81, -1, 3), other = one;
    given.solve(one);
    free.solve(other);
    CHECK((one - other).norm() < 1e-13 * one.norm());
    CHECK(free.effort().entries < given.effort().entries);
  }

  TEST_CASE("a matrix that is not positive definite is refused, and a good one after it accepted") {
    Cholesky cholesky(grid(6), 4);
    auto const good = values_of(cholesky.pattern(), 2);
    for (Index const where : {0, 20, 35}) { // early, amid and in the trailing block
      auto bad = good;
      bad[ix(cholesky.pattern().columns[ix(where)])] = -1;
      CHECK_FALSE(cholesky.factorize(bad));
    }
    CHECK(cholesky.factorize(good));
    Vector b = dense(cholesky.pattern(), good) * Vector::Ones(36);
    cholesky.solve(b);
    CHECK((b - Vector::Ones(36)).norm() < 1e-13);
  }

  TEST_CASE("factors and solutions do not depend on the number of threads, nor do refusals") {
    for (auto const order : {Order::given, Order::free})
      same_by_threads([&] {
        Index const trailing = 200;
        Cholesky cholesky(layers(20, 10, trailing), trailing, order); // some panels need only their own tree
        auto const values = values_of(cholesky.pattern(), 3);
        REQUIRE(cholesky.factorize(values));
        Vector b = Vector::LinSpaced(cholesky.pattern().size(), -1, 2);
        Vector const exact = b;
        multiply(cholesky.pattern(), values, exact, b);
        cholesky.solve(b);
        CHECK((b - exact).norm() < 1e-12 * exact.norm());
        auto bad = values;
        bad[ix(cholesky.pattern().columns[ix(cholesky.pattern().size() - 1)])] = -1;
        CHECK_FALSE(cholesky.factorize(bad));
        return b;
      });
  }

  TEST_CASE("no unknowns: the empty system is solved") {
    Cholesky cholesky(pattern_of(0, {}), 0);
    REQUIRE(cholesky.factorize({}));
    Vector b;
    cholesky.solve(b);
    CHECK(b.size() == 0);
  }

  TEST_CASE("refactoring and solving take no further blocks from the system") {
    Cholesky cholesky(grid(15), 15);
    auto const round = [&](unsigned seed) {
      REQUIRE(cholesky.factorize(values_of(cholesky.pattern(), seed)));
      Vector b = Vector::Ones(cholesky.pattern().size());
      cholesky.solve(b);
      static_cast<void>(cholesky.trailing_factor());
    };
    round(1);
    auto const blocks = blocks_from_system();
    CHECK(blocks > 0);
    for (unsigned seed = 2; seed < 52; ++seed)
      round(seed);
    CHECK(blocks_from_system() == blocks);
  }
}
