// The projection onto Coulomb's cone: its three branches, their borders, and its derivatives.
#include <doctest/doctest.h>
#include <random>

#include "differences.hpp"
#include "interface/cone.hpp"

using namespace stiction;
using namespace stiction::interface;

namespace {

template<int D> Local<D> random_point(std::mt19937& random) {
  std::normal_distribution<double> normal;
  Local<D> z = Local<D>::Zero();
  for (int i = 0; i < D; ++i)
    z[i] = normal(random);
  return z;
}

template<int D> double outside(Local<D> const& p, double mu) {
  return p.template tail<D - 1>().norm() - mu * p[0];
}

constexpr double coefficients[] = {0.0, 0.3, 1.0, 5.0};

/// On the cone, idempotent, non-expansive, and the remainder lies in the polar cone, orthogonal to the
/// answer.
template<int D> void check_projection(double mu, std::mt19937& random) {
  std::array<int, 3> seen{};
  for (int k = 0; k < 2000; ++k) {
    Local<D> const z = random_point<D>(random), y = random_point<D>(random);
    auto const p = project<D>(z, mu), q = project<D>(y, mu);
    ++seen[static_cast<std::size_t>(p.status)];
    REQUIRE(p.value[0] >= 0);
    REQUIRE(outside<D>(p.value, mu) <= 1e-14 * (1 + mu));
    if (p.status == Status::slip)
      REQUIRE(std::abs(outside<D>(p.value, mu)) <= 1e-14 * (1 + mu));
    REQUIRE((project<D>(p.value, mu).value - p.value).norm() <= 1e-14);
    REQUIRE((p.value - q.value).norm() <= (z - y).norm() * (1 + 1e-14));
    Local<D> const rest =
        z - p.value; // nearest point: the remainder is orthogonal to it and polar to the cone
    REQUIRE(std::abs(rest.dot(p.value)) <= 1e-13);
    REQUIRE(rest.dot(q.value) <= 1e-13);
  }
  CHECK(seen[0] > 5);
  CHECK((mu == 0 || seen[1] > 5));
  CHECK(seen[2] > 5);
}

template<int D> void check_derivatives(double mu, std::mt19937& random) {
  for (int k = 0; k < 40; ++k) {
    Local<D> const z = random_point<D>(random);
    double const zt = z.template tail<D - 1>().norm();
    bool const near_border = std::abs(mu * zt + z[0]) < 0.05 || std::abs(zt - mu * z[0]) < 0.05 || zt < 0.1;
    if (near_border)
      continue;
    auto const p = project<D>(z, mu);
    auto const by_z = test::rate([&](Vector const& at) { return Vector(project<D>(Local<D>(at), mu).value); },
                                 Dense(p.by_z), z, 1e-3, 1);
    CHECK_MESSAGE(by_z.second_order, by_z.words());
    CHECK(by_z.errors[2] < 1e-7);
    if (mu < 0.01)
      continue;
    auto const by_mu = test::rate([&](Vector const& at) { return Vector(project<D>(z, at[0]).value); },
                                  Dense(p.by_mu), Vector::Constant(1, mu), 1e-3, 1);
    CHECK_MESSAGE(by_mu.second_order, by_mu.words());
    CHECK(by_mu.errors[2] < 1e-7);
  }
}

} // namespace

TEST_SUITE("interface") {
  TEST_CASE("the projection is the nearest point of the cone") {
    std::mt19937 random(1);
    for (double const mu : coefficients) {
      CAPTURE(mu);
      check_projection<2>(mu, random);
      check_projection<3>(mu, random);
    }
  }

  TEST_CASE("by hand: separating, sticking, sliding") {
    CHECK(project<2>({-1.0, 0.5}, 1).value.isZero(0));
    CHECK(project<2>({-1.0, 0.5}, 1).status == Status::open);
    CHECK(project<2>({1.0, -0.5}, 1).value == Local<2>(1, -0.5));
    CHECK(project<2>({1.0, -0.5}, 1).status == Status::stick);
    CHECK((project<2>({1.0, 2.0}, 0.5).value - Local<2>(1.6, 0.8)).norm() < 1e-15); // (1 + 0.5 2)/1.25
    CHECK((project<3>({0.0, 3.0, -4.0}, 1).value - Local<3>(2.5, 1.5, -2.0)).norm() < 1e-15);
    CHECK(project<2>({0.7, -3.0}, 0).value == Local<2>(0.7, 0)); // frictionless
  }

  TEST_CASE("the branches meet at their borders") {
    for (double const mu : coefficients) {
      CAPTURE(mu);
      Local<3> const edge(1, mu * 0.6, mu * 0.8), apex(-mu, 0.6, 0.8);
      for (double const e : {-1e-12, 0.0, 1e-12}) {
        Local<3> const stick = edge + e * Local<3>(0, 0.6, 0.8), apart = apex + e * Local<3>(1, 0, 0);
        CHECK((project<3>(stick, mu).value - edge).norm() < 2e-12 * (1 + mu));
        CHECK(project<3>(apart, mu).value.norm() < 2e-12 * (1 + mu));
      }
    }
    for (double const mu : coefficients) {
      auto const at_origin = project<3>(Local<3>::Zero(), mu);
      CHECK(at_origin.value.isZero(0));
      CHECK(at_origin.by_z.allFinite());
    }
  }

  TEST_CASE("derivatives by z and by mu match differences at second order") {
    std::mt19937 random(2);
    for (double const mu : coefficients) {
      CAPTURE(mu);
      check_derivatives<2>(mu, random);
      check_derivatives<3>(mu, random);
    }
  }
}
