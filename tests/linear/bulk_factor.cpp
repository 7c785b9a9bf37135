// Loads condensed onto a surface, its compliance and what is expanded, against dense algebra; and that
// columns are solved for where they are asked for.
#include <Eigen/LU>
#include <doctest/doctest.h>
#include <numeric>

#include "linear/bulk_factor.hpp"
#include "linear/sparse_factor.hpp"
#include "linear/systems.hpp"

using namespace stiction;
using namespace stiction::linear;
using namespace stiction::test;

namespace {

Indices all_of(Index count) {
  Indices all(ix(count));
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// condense and expand with a load on the surface, and the compliance, of the matrix A.
void check_against(BulkFactor& factor, Dense const& A) {
  Index const n = factor.pattern().size(), m = factor.surface();
  Dense const inverse = A.inverse();
  Vector b = Vector::LinSpaced(n, -1, 2), surface_load = Vector::LinSpaced(m, 3, 1);
  Vector loads = b;
  Vector const alone = inverse * loads;
  Vector const y = factor.condense(b);
  CHECK((y - alone.tail(m)).norm() <= 1e-12 * alone.norm());
  factor.expand(surface_load, b);
  loads.tail(m) += surface_load;
  Vector const both = inverse * loads;
  CHECK((b - both).norm() <= 1e-12 * both.norm());
  Dense C;
  factor.compliance(all_of(m), C);
  CHECK((C - inverse.bottomRightCorner(m, m)).norm() <= 1e-12 * inverse.norm());
  Vector solution = loads;
  factor.solve(solution);
  CHECK((solution - both).norm() <= 1e-12 * both.norm());
}

/// Several right sides at once: each as alone, and to the last bit the same whichever come with it.
void check_several(BulkFactor& factor) {
  constexpr std::size_t count = 6;
  Index const n = factor.pattern().size(), m = factor.surface();
  auto const all = [&](std::size_t first, std::size_t last, std::vector<Vector>& sides) {
    std::vector<Vector*> b;
    std::vector<Vector const*> loads;
    std::vector<Vector> on_surface;
    for (std::size_t k = first; k < last; ++k) {
      sides.emplace_back(Vector::LinSpaced(n, -1, static_cast<double>(k)));
      on_surface.emplace_back(Vector::LinSpaced(m, 3, static_cast<double>(k)));
    }
    for (std::size_t k = 0; k < sides.size(); ++k) {
      b.push_back(&sides[k]);
      loads.push_back(&on_surface[k]);
    }
    auto const motions = factor.condense_all(b);
    factor.expand_all(loads, b);
    return motions;
  };
  std::vector<Vector> together, fewer;
  auto const motions = all(0, count, together), some = all(3, count, fewer);
  for (std::size_t k = 0; k < count; ++k) {
    Vector b = Vector::LinSpaced(n, -1, static_cast<double>(k));
    Vector const y = factor.condense(b);
    factor.expand(Vector::LinSpaced(m, 3, static_cast<double>(k)), b);
    CHECK((motions[k] - y).norm() <= 1e-13 * b.norm());
    CHECK((together[k] - b).norm() <= 1e-13 * b.norm());
    if (k >= 3) {
      CHECK(some[k - 3] == motions[k]);
      CHECK(fewer[k - 3] == together[k]);
    }
  }
}

/// The same by products with the matrix, for the unknowns `used` of its surface.
void check_by_products(BulkFactor& factor, std::vector<double> const& values, Indices const& used) {
  Index const n = factor.pattern().size(), m = factor.surface();
  Vector b = Vector::LinSpaced(n, -1, 2), surface_load = Vector::LinSpaced(m, 3, 1), product;
  Vector loads = b, alone = b;
  factor.solve(alone);
  multiply(factor.pattern(), values, alone, product);
  CHECK((product - loads).norm() <= 1e-12 * loads.norm());
  CHECK((factor.condense(b) - alone.tail(m)).norm() <= 1e-12 * alone.norm());
  factor.expand(surface_load, b);
  loads.tail(m) += surface_load;
  multiply(factor.pattern(), values, b, product);
  CHECK((product - loads).norm() <= 1e-12 * loads.norm());
  Dense C;
  factor.compliance(used, C);
  for (std::size_t j = 0; j < used.size(); ++j) {
    Vector column = Vector::Unit(n, n - m + used[j]);
    factor.solve(column);
    CHECK((C.col(static_cast<Eigen::Index>(j)) - column.tail(m)(used)).norm() <= 1e-12 * column.norm());
  }
}

/// Some of the surface, out of order.
Indices some(Index surface) {
  Indices used;
  for (Index const u : {7, 3, 40, 12, 41, 90, 0, 63})
    if (u < surface)
      used.push_back(u);
  return used;
}

} // namespace

TEST_SUITE("linear") {
  TEST_CASE("a surface of any size, eliminated last: as dense algebra has it") {
    for (Index const surface : {0, 1, 12, 50, 144}) {
      auto const pattern = grid(12);
      auto const factor = make_bulk_factor(pattern, surface);
      for (unsigned seed = 1; seed <= 2; ++seed) {
        auto values = values_of(pattern, seed);
        REQUIRE(factor->factorize(values));
        CHECK(factor->hold() == 0);
        CHECK(factor->symmetric());
        check_against(*factor, dense(pattern, values));
        check_several(*factor);
      }
    }
  }

  TEST_CASE("a large surface is eliminated where it fills least, and a plate thin enough is large") {
    auto const plate = layers(36, 2, 1296);
    auto const factor = make_bulk_factor(plate, 1296);
    auto values = values_of(plate, 3);
    REQUIRE(factor->factorize(values));
    CHECK(factor->effort().entries < 1296.0 * 1296 / 2); // no dense block
    CHECK(factor->surface_numbers() == 0);
    check_by_products(*factor, values, some(1296));
    check_several(*factor);
  }

  TEST_CASE("a surface eliminated last, some of its columns solved for") {
    auto const pattern = grid(30);
    auto const factor = make_bulk_factor(pattern, 600);
    auto values = values_of(pattern, 4);
    REQUIRE(factor->factorize(values));
    check_by_products(*factor, values, some(600));
    CHECK(factor->spent().columns == 4 * 24);
    CHECK(factor->surface_numbers() < 600 * 600 + 4 * 24 * 600);
  }

  TEST_CASE("the compliance of some does not depend on what was asked for before, and is symmetric") {
    for (Index const surface : {100, 600, 1296}) {
      auto const pattern = surface == 1296 ? layers(36, 2, 1296) : grid(30);
      auto values = values_of(pattern, 4);
      auto const fresh = make_bulk_factor(pattern, surface), asked = fresh->another();
      REQUIRE(fresh->factorize(values));
      REQUIRE(asked->factorize(values));
      Dense one, other;
      asked->compliance({90, 5, 66}, other);
      asked->compliance(all_of(30), other);
      asked->compliance(some(surface), other);
      fresh->compliance(some(surface), one);
      CHECK(one == other);
      CHECK(one == Dense(one.transpose()));
      auto const spent = asked->spent();
      CHECK(spent.columns <= surface);
      asked->compliance(some(surface), other); // known by now
      CHECK(asked->spent().columns == 0);
      CHECK(asked->spent().operations == 0);
    }
  }

  TEST_CASE("a new matrix forgets the columns of the last") {
    auto const pattern = grid(12);
    auto const factor = make_bulk_factor(pattern, 30);
    for (unsigned seed = 1; seed <= 3; ++seed) {
      auto values = values_of(pattern, seed);
      REQUIRE(factor->factorize(values));
      check_against(*factor, dense(pattern, values));
      CHECK(factor->spent().columns == 30);
    }
  }

  TEST_CASE("columns of a contact that has gone elsewhere are dropped") {
    auto const pattern = layers(36, 2, 1296);
    auto const factor = make_bulk_factor(pattern, 1296);
    auto values = values_of(pattern, 5);
    REQUIRE(factor->factorize(values));
    double most = 0;
    Dense C;
    for (Index first = 0; first + 24 < 1296; first += 24) {
      Indices used = all_of(24);
      for (auto& u : used)
        u += first;
      factor->compliance(used, C);
      most = std::max(most, factor->surface_numbers());
    }
    CHECK(factor->spent().columns <= 1296 + 24);
    CHECK(most <= 2 * 24 * 1296);
  }

  TEST_CASE("a matrix that its surface alone makes indefinite is held there, and says by how much") {
    auto const pattern = grid(6);
    auto const factor = make_bulk_factor(pattern, 6);
    auto values = values_of(pattern, 2);
    auto& last = values[ix(pattern.columns[35])];
    last = -1;
    double const largest = 10 * values_of(pattern, 2)[ix(pattern.columns[0])];
    REQUIRE(factor->factorize(values));
    CHECK(factor->hold() > 0.8 * largest);
    check_against(*factor, dense(pattern, values)); // values hold it as well
    values = values_of(pattern, 2);
    REQUIRE(factor->factorize(values));
    CHECK(factor->hold() == 0);
    REQUIRE(factor->factorize(values, {}, Hold::always));
    CHECK(factor->hold() > 0);
    values = values_of(pattern, 2);
    values[ix(pattern.columns[3])] = -1; // in the interior
    CHECK_FALSE(factor->factorize(values));
    auto const bare = make_bulk_factor(pattern, 0);
    CHECK_FALSE(bare->factorize(values, {}, Hold::always));
  }

  TEST_CASE("columns beside the matrix make it unsymmetric") {
    auto const pattern = grid(7);
    auto const factor = make_bulk_factor(pattern, 14, true);
    auto values = values_of(pattern, 6);
    Dense A = dense(pattern, values);
    std::vector<ColumnEntry> columns;
    for (Index column = 0; column < 14; column += 3)
      for (Index const row : {35 + column, 35 + column - 7, 36 + column}) {
        columns.push_back({row, column, 0.1 * row});
        A(row, 35 + column) += 0.1 * row;
      }
    REQUIRE(factor->factorize(values, columns));
    CHECK_FALSE(factor->symmetric());
    check_against(*factor, A);
    REQUIRE(factor->factorize(values));
    CHECK(factor->symmetric());
    check_against(*factor, dense(pattern, values));
  }

  TEST_CASE("columns beside the matrix: its compliance, too, is solved for where it is asked for") {
    auto const pattern = grid(12);
    auto const factor = make_bulk_factor(pattern, 144, true);
    auto values = values_of(pattern, 8);
    Dense A = dense(pattern, values);
    std::vector<ColumnEntry> columns;
    for (Index column = 1; column < 144; column += 2) {
      columns.push_back({143 - column, column, 0.2});
      A(143 - column, column) += 0.2;
    }
    REQUIRE(factor->factorize(values, columns));
    Dense const inverse = A.inverse();
    (void)factor->spent();
    Dense C;
    for (Indices const& used : {Indices{130, 125, 141}, Indices{141, 3, 125}}) {
      factor->compliance(used, C);
      CHECK((C - inverse(used, used)).norm() <= 1e-12 * inverse.norm());
      CHECK(factor->spent().columns == 24);
    }
    check_against(*factor, A);
  }

  TEST_CASE("a diagonal matrix is divided by: no factor, no columns") {
    auto const pattern = pattern_of(30, {});
    auto const factor = make_bulk_factor(pattern, 12);
    auto values = values_of(pattern, 7);
    REQUIRE(factor->factorize(values));
    check_against(*factor, dense(pattern, values));
    CHECK(factor->effort().entries == 30);
    CHECK(factor->surface_numbers() == 0);
    CHECK(factor->spent().columns == 0);
    values[4] = 0;
    CHECK_FALSE(factor->factorize(values));
  }

  TEST_CASE("20 000 surface unknowns, 200 of them near: bytes and columns follow those near") {
    Index const side = 142, surface = side * side, patch = 14;
    auto const pattern = layers(side, 2, surface);
    auto const factor = make_bulk_factor(pattern, surface);
    auto values = values_of(pattern, 8);
    REQUIRE(factor->factorize(values));
    Indices near;
    for (Index i = 0; i < patch; ++i)
      for (Index j = 0; j < patch; ++j)
        near.push_back((60 + i) * side + 60 + j);
    Dense C;
    factor->compliance(near, C);
    auto const spent = factor->spent();
    double const square = static_cast<double>(surface) * static_cast<double>(surface);
    MESSAGE("numbers of the factor ", factor->effort().entries, ", beside it ", factor->surface_numbers(),
            " of ", 2 * square, " when all were inverted; columns ", spent.columns, " of ", surface);
    CHECK(spent.columns <= 3 * patch * patch);
    CHECK(factor->effort().entries + factor->surface_numbers() < square / 20);
    CHECK(factor->effort().operations + spent.operations < square * static_cast<double>(surface) / 200);
    Vector b = Vector::Zero(pattern.size());
    b[factor->first_of_surface() + near[70]] = 1;
    Vector const y = factor->condense(b);
    for (Index k = 0; k < patch; ++k)
      CHECK(y[near[ix(k)]] == doctest::Approx(C(k, 70)));
  }
}
