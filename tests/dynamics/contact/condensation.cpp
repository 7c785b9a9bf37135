// The Delassus operator condensed from bulk, rows of H and stiffness of contact, against dense algebra; and
// that it is made anew only when one of them has changed.
#include "dynamics/contact/condensation.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <doctest/doctest.h>
#include <numeric>
#include <random>

#include "linear/systems.hpp"

using namespace stiction;
using namespace stiction::dynamics;

namespace {

constexpr Index surface = 12;

struct Bulk {
  linear::Pattern pattern = test::grid(6);
  std::unique_ptr<linear::BulkFactor> factor = linear::make_bulk_factor(pattern, surface);
  std::vector<double> values;
  Dense V; ///< compliance of the surface
  void take(unsigned seed) {
    values = test::values_of(pattern, seed);
    V = test::dense(pattern, values).inverse().bottomRightCorner(surface, surface);
    REQUIRE(factor->factorize(values));
  }
};

/// Rows of H over the surface: two unknowns each, or one and with a sign.
Dense rows_of(bool one_each) {
  Dense H = Dense::Zero(4, surface);
  for (Index i = 0; i < 4; ++i) {
    H(i, 2 * i + 1) = i % 2 == 0 ? 1 : -1;
    if (!one_each)
      H(i, 2 * i + 2) = 0.3 * (i + 1);
  }
  return H;
}

void pose(Condensation& condensation, Dense const& H, Dense const& K) {
  Indices all(surface);
  std::iota(all.begin(), all.end(), 0);
  condensation.clear();
  condensation.add_point(all, H.topRows(2));
  condensation.add_point(all, H.bottomRows(2));
  condensation.add_stiffness(all, K);
}

/// A problem with the operator of H and K whose present forces `now` act by rows `turned`, answered by
/// `next`.
struct Kept {
  Dense const &V, &H, &turned, &K;
  Vector const &y, &now;
  void check(Condensation const& condensation, Vector const& free, Vector const& next, double weight) const {
    Dense const A = (Dense::Identity(surface, surface) - weight * V * K).inverse();
    Vector const extra = weight * (turned - H).transpose() * now, moved = y + V * extra;
    CHECK((free - H * A * moved).norm() <= 1e-12 * free.norm());
    Vector c = Vector::Zero(surface);
    condensation.add_forces(next, weight, c);
    Vector const du = A * (moved + weight * V * H.transpose() * next);
    CHECK((c - weight * (K * du + H.transpose() * next) - extra).norm() <= 1e-12 * c.norm());
  }
};

} // namespace

TEST_SUITE("dynamics") {
  TEST_CASE("bulk and stiffness of contact are condensed onto points as dense algebra has it") {
    Bulk bulk;
    bulk.take(3);
    Vector const y = Vector::LinSpaced(surface, -1, 3), p = Vector::LinSpaced(4, 2, -1);
    double const weight = 0.7;
    for (bool const one_each : {true, false})
      for (double const stiffness : {0.0, 0.2}) {
        INFO("one unknown each " << one_each << ", stiffness " << stiffness);
        Dense const H = rows_of(one_each);
        Dense K = Dense::Zero(surface, surface);
        K(2, 3) = K(3, 2) = K(5, 5) = stiffness;
        K(4, 2) = 0.5 * stiffness;
        Condensation condensation;
        pose(condensation, H, K);
        Dense W;
        Vector free, c = Vector::Zero(surface);
        condensation.eliminate(*bulk.factor, y, weight, W, free);
        Dense const A = (Dense::Identity(surface, surface) - weight * bulk.V * K).inverse();
        Dense const expected = weight * H * A * bulk.V * H.transpose();
        CHECK((W - expected).norm() <= 1e-12 * expected.norm());
        CHECK((free - H * A * y).norm() <= 1e-12 * free.norm());
        condensation.add_forces(p, weight, c);
        Vector const du = A * (y + weight * bulk.V * H.transpose() * p);
        CHECK((c - weight * (K * du + H.transpose() * p)).norm() <= 1e-12 * c.norm());
      }
  }

  TEST_CASE("a problem beside another one is that one's, with its own present forces by its own rows") {
    Bulk bulk;
    bulk.take(3);
    std::mt19937 random(8);
    std::normal_distribution<double> normal;
    auto const any = [&](Index size) {
      return Vector(Vector::NullaryExpr(size, [&] { return normal(random); }));
    };
    double const weight = 0.7;
    Dense const H = rows_of(false);
    Dense W;
    Vector free;
    for (double const stiffness : {0.0, 0.2})
      for (int trial = 0; trial < 20; ++trial) {
        INFO("stiffness " << stiffness << ", trial " << trial);
        Dense K = Dense::Zero(surface, surface);
        K(2, 3) = K(3, 2) = K(5, 5) = stiffness;
        Condensation lead, beside;
        pose(lead, H, K);
        lead.eliminate(*bulk.factor, any(surface), weight, W, free);
        Dense const turned =
            H + 0.1 * H.cwiseProduct(Dense::NullaryExpr(4, surface, [&] { return normal(random); }));
        Vector const y = any(surface), now = any(4), next = any(4), reaction = turned.transpose() * now;
        REQUIRE(beside.eliminate_as(lead, *bulk.factor, {y, now, reaction}, weight, free));
        Kept{bulk.V, H, turned, K, y, now}.check(beside, free, next, weight);
      }
  }

  TEST_CASE(
      "a problem whose rows have hardly changed keeps its operator, with present forces by present rows") {
    Bulk bulk;
    bulk.take(3);
    double const weight = 0.7, little = 1e-3;
    Dense const H = rows_of(false), turned = H * (1 + little);
    Dense K = Dense::Zero(surface, surface);
    K(2, 3) = K(3, 2) = K(5, 5) = 0.2;
    Dense W;
    Vector free;
    Vector const y = Vector::LinSpaced(surface, -1, 3), now = Vector::LinSpaced(4, 2, -1);
    Condensation condensation;
    pose(condensation, H, K);
    condensation.eliminate(*bulk.factor, y, weight, W, free);
    Dense const before = W;
    pose(condensation, turned, K * (1 - little));
    CHECK_FALSE(condensation.like_last(*bulk.factor, weight, 0.5 * little));
    CHECK_FALSE(condensation.like_last(*bulk.factor, 2 * weight, 2 * little));
    REQUIRE(condensation.like_last(*bulk.factor, weight, 2 * little));
    REQUIRE(condensation.eliminate_as(condensation, *bulk.factor, {y, now, turned.transpose() * now}, weight,
                                      free));
    CHECK(W == before);
    Kept{bulk.V, H, turned, K, y, now}.check(condensation, free, 0.5 * now, weight);
    Dense another = turned;
    another(0, 9) = little; // a further node
    pose(condensation, another, K);
    CHECK_FALSE(condensation.like_last(*bulk.factor, weight, 2 * little));
    pose(condensation, turned, K);
    condensation.forget();
    CHECK_FALSE(condensation.like_last(*bulk.factor, weight, 2 * little));
  }

  TEST_CASE("a problem beside another one is not that one's where matrix, weight or nodes are others") {
    Bulk bulk;
    bulk.take(3);
    Dense const none = Dense::Zero(surface, surface), H = rows_of(false);
    Vector const y = Vector::LinSpaced(surface, -1, 3), p = Vector::LinSpaced(4, 2, -1);
    Vector const reaction = H.transpose() * p, elsewhere = reaction + Vector::Unit(surface, 0);
    Condensation lead, beside;
    Dense W, own;
    Vector free;
    pose(lead, 1.1 * H, none);
    pose(beside, H, none);
    beside.eliminate(*bulk.factor, y, 1, own, free);
    CHECK_FALSE(beside.eliminate_as(lead, *bulk.factor, {y, p, reaction}, 1, free)); // it has posed none
    lead.eliminate(*bulk.factor, y, 1, W, free);
    CHECK_FALSE(beside.eliminate_as(lead, *bulk.factor, {y, p, reaction}, 0.5, free));
    CHECK_FALSE(beside.eliminate_as(lead, *bulk.factor, {y, p, elsewhere}, 1, free));
    REQUIRE(beside.eliminate_as(lead, *bulk.factor, {y, p, reaction}, 1, free));
    Dense const expected = own;
    own = W; // as who poses does: what W was made of before tells nothing of it now
    beside.eliminate(*bulk.factor, y, 1, own, free);
    CHECK((own - expected).norm() <= 1e-14 * expected.norm());
    bulk.take(5);
    CHECK_FALSE(beside.eliminate_as(lead, *bulk.factor, {y, p, reaction}, 1, free));
  }

  TEST_CASE("the bulk with the stiffness of contact is stable where dense algebra says so") {
    Bulk bulk;
    bulk.take(3);
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    double const weight = 0.7;
    int stable = 0, all = 0;
    for (double const size : {0.1, 0.4, 0.7, 1.0, 1.5, 3.0})
      for (int trial = 0; trial < 20; ++trial, ++all) {
        Dense const any = Dense::NullaryExpr(surface, surface, [&] { return normal(random); });
        Dense const symmetric = any + any.transpose();
        Dense const K = size * symmetric / (weight * bulk.V * symmetric).eigenvalues().cwiseAbs().maxCoeff() +
                        0.01 * size * (any - any.transpose());
        Condensation condensation;
        pose(condensation, rows_of(false), K);
        Dense W;
        Vector free;
        condensation.eliminate(*bulk.factor, Vector::Zero(surface), weight, W, free);
        Dense const left = bulk.V.inverse() - 0.5 * weight * (K + K.transpose());
        INFO("size " << size << ", trial " << trial);
        CHECK(condensation.stable() == (Eigen::LLT<Dense>(left).info() == Eigen::Success));
        stable += condensation.stable() ? 1 : 0;
      }
    CHECK(stable > all / 4);
    CHECK(stable < 3 * all / 4);
  }

  TEST_CASE("the Delassus operator stays while bulk, points and weight do") {
    Bulk bulk;
    bulk.take(3);
    Vector y = Vector::LinSpaced(surface, -1, 3);
    Dense const none = Dense::Zero(surface, surface);
    Condensation condensation;
    Dense W, mark;
    Vector free;
    auto const eliminate = [&](double weight) {
      mark = W = Dense::Constant(4, 4, 7);
      condensation.eliminate(*bulk.factor, y, weight, W, free);
      return W != mark; // was it made?
    };
    for (bool const one_each : {true, false}) {
      Dense const H = rows_of(one_each);
      pose(condensation, H, none);
      CHECK(eliminate(1));
      y *= -2;
      CHECK_FALSE(eliminate(1));
      CHECK((free - H * y).norm() <= 1e-12 * free.norm());
      CHECK(eliminate(0.5)); // another weight
      pose(condensation, 1.1 * H, none);
      CHECK(eliminate(0.5)); // other rows
      pose(condensation, 1.1 * H, 0.1 * Dense::Identity(surface, surface));
      CHECK(eliminate(0.5)); // with stiffness, twice
      CHECK(eliminate(0.5));
      pose(condensation, H, none);
      CHECK(eliminate(0.5)); // and without it again
      bulk.take(5);
      CHECK(eliminate(0.5)); // another matrix
      CHECK_FALSE(eliminate(0.5));
    }
  }
}
