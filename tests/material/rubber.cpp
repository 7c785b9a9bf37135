// Closed forms of rubber laws, and the laws that are each other's special cases.
#include <cmath>
#include <doctest/doctest.h>

#include "material/states.hpp"

using namespace stiction;
using namespace stiction::material;
using stiction::test::cauchy;

namespace {

constexpr double K = 7e7;
MooneyRivlin const mooney{3e5, 0.8e5, K};
Yeoh const yeoh{4e5, -2e4, 1.5e3, K};
ArrudaBoyce const boyce{6e5, 2.4, K};
Ogden const ogden{{6.3e5, -1e4, 1.2e3}, {1.3, -2, 5}, K};

/// W1 = dW/dI1', W2 = dW/dI2' of the incompressible law, from their formulas.
struct Slopes {
  double first, second;
};
Slopes slopes(MooneyRivlin const& law, double /*I1*/) {
  return {law.c10, law.c01};
}
Slopes slopes(Yeoh const& law, double I1) {
  return {law.c10 + 2 * law.c20 * (I1 - 3) + 3 * law.c30 * std::pow(I1 - 3, 2), 0};
}
/// Arruda and Boyce 1993, (26), with mu from their modulus at rest.
Slopes slopes(ArrudaBoyce const& law, double I1) {
  double const m = std::pow(law.lambda_m, 2);
  double const mu = law.shear_modulus / (1 + 3 / (5 * m) + 99 / (175 * m * m) + 513 / (875 * m * m * m) +
                                         42039 / (67375 * m * m * m * m));
  return {mu * (0.5 + I1 / (10 * m) + 11 * I1 * I1 / (350 * m * m) + 19 * std::pow(I1 / m, 3) / 1750 +
                519 * std::pow(I1 / m, 4) / 134750),
          0};
}

/// Difference s1 - s2 of the principal Cauchy stresses at stretches of product 1.
template<class Law> double difference(Law const& law, double l1, double l2) {
  double const l3 = 1 / (l1 * l2);
  auto const [W1, W2] = slopes(law, l1 * l1 + l2 * l2 + l3 * l3);
  return 2 * (l1 * l1 - l2 * l2) * (W1 + W2 * l3 * l3);
}
double difference(Ogden const& law, double l1, double l2) {
  double sum = 0;
  for (std::size_t p = 0; p < law.mu.size(); ++p)
    sum += law.mu[p] * (std::pow(l1, law.alpha[p]) - std::pow(l2, law.alpha[p]));
  return sum;
}

template<class Act> void each_rubber(Act const& act) {
  act(mooney);
  act(yeoh);
  act(boyce);
  act(ogden);
}

Matrix3 stretch(double l1, double l2, double l3) {
  return Eigen::Vector3d(l1, l2, l3).asDiagonal();
}

/// The lateral stretch of a bar that is drawn to l, by bisection of the lateral stress.
template<class Law> double lateral(Law const& law, double l) {
  double low = 0.8 / std::sqrt(l), high = 1.2 / std::sqrt(l);
  for (int k = 0; k < 60; ++k) {
    double const middle = (low + high) / 2;
    (cauchy(law, stretch(l, middle, middle))(1, 1) > 0 ? high : low) = middle;
  }
  return low;
}

/// Energy, stress and tangent of both laws agree in all states.
template<int N, class A, class B> void check_same(A const& a, B const& b, double tolerance) {
  for (auto const& F : test::states<N>()) {
    CAPTURE(F);
    auto const E = test::green<N>(F);
    auto const one = a.template respond<N>(E), two = b.template respond<N>(E);
    double const size = two.tangent.norm();
    CHECK(std::abs(one.energy - two.energy) <= tolerance * size);
    CHECK((one.stress - two.stress).norm() <= tolerance * size);
    CHECK((one.tangent - two.tangent).norm() <= tolerance * size);
    auto const passive = a.template respond<N, Wanted::stress>(E);
    CHECK(std::abs(passive.energy - one.energy) <= 1e-15 * size);
    CHECK((passive.stress - one.stress).norm() <= 1e-15 * size);
  }
}
template<class A, class B> void check_same(A const& a, B const& b, double tolerance = 1e-13) {
  check_same<4>(a, b, tolerance);
  check_same<6>(a, b, tolerance);
}

NeoHookean neo_hookean(double shear) {
  auto const [young, poisson] = Moduli::from(shear, K);
  return {young, poisson};
}

} // namespace

TEST_SUITE("material") {
  TEST_CASE("uniaxial and equibiaxial stretch of kept volume: the stress differences of the closed forms") {
    each_rubber([](auto const& law) {
      CAPTURE(law.schema().name);
      for (double const l : {0.5, 0.9, 1.3, 2.0, 3.5}) {
        double const side = 1 / std::sqrt(l), thick = 1 / (l * l), G = law.moduli().shear();
        Matrix3 const uniaxial = cauchy(law, stretch(l, side, side));
        Matrix3 const equibiaxial = cauchy(law, stretch(l, l, thick));
        double const size = K * 1e-14 + G * 1e-13 * (std::pow(l, 8) + std::pow(l, -8));
        CHECK(std::abs(uniaxial(0, 0) - uniaxial(1, 1) - difference(law, l, side)) <= size);
        CHECK(std::abs(equibiaxial(0, 0) - equibiaxial(2, 2) - difference(law, l, thick)) <= size);
        CHECK(std::abs(uniaxial.trace()) + std::abs(equibiaxial.trace()) <= 10 * size);
        CHECK(std::abs(uniaxial(1, 1) - uniaxial(2, 2)) <= size);
      }
    });
  }

  TEST_CASE("a bar with free sides nears the incompressible closed form as 1/K") {
    each_rubber([](auto law) {
      CAPTURE(law.schema().name);
      for (double const l : {0.6, 1.8, 3.0}) {
        double const exact = difference(law, l, 1 / std::sqrt(l));
        auto const error = [&](double bulk) {
          law.bulk_modulus = bulk;
          double const side = lateral(law, l);
          Matrix3 const stress = cauchy(law, stretch(l, side, side));
          CHECK(std::abs(stress(1, 1)) <= 1e-13 * bulk);
          return (stress(0, 0) - exact) / exact;
        };
        double const coarse = error(1e8), fine = error(1e9);
        CHECK(std::abs(coarse) > 1e-5);
        CHECK(coarse / fine == doctest::Approx(10).epsilon(0.1));
      }
    });
  }

  TEST_CASE(
      "simple shear of laws of the invariants: s12 = 2 g (W1 + W2) with both normal stress differences") {
    auto const check = [](auto const& law) {
      CAPTURE(law.schema().name);
      for (double const g : {0.2, 1.0, 2.5}) {
        Matrix3 const s = cauchy(law, test::shear(g));
        auto const [W1, W2] = slopes(law, 3 + g * g);
        double const size = 1e-14 * K + 1e-12 * law.moduli().shear();
        CHECK(std::abs(s(0, 1) - 2 * g * (W1 + W2)) <= size);
        CHECK(std::abs(s(0, 0) - s(2, 2) - 2 * g * g * W1) <= size);
        CHECK(std::abs(s(1, 1) - s(2, 2) + 2 * g * g * W2) <= size);
      }
    };
    check(mooney);
    check(yeoh);
    check(boyce);
  }

  TEST_CASE("Ogden in simple shear: s12 = sum mu (l^a - l^-a) / (l + 1/l) where l - 1/l = g") {
    for (double const g : {0.2, 1.0, 2.5}) {
      double const l = g / 2 + std::sqrt(1 + g * g / 4);
      Matrix3 const s = cauchy(ogden, test::shear(g));
      double const s12 = difference(ogden, l, 1 / l) / (l + 1 / l);
      double const size = 1e-14 * K + 1e-12 * ogden.moduli().shear();
      CHECK(std::abs(s(0, 1) - s12) <= size);
      CHECK(std::abs(s(0, 0) - s(1, 1) - g * s12) <= size); // Rivlin's relation
    }
  }

  TEST_CASE("special cases of rubber laws are the neo-Hookean and the Mooney-Rivlin law") {
    check_same(MooneyRivlin{3e5, 0, K}, neo_hookean(6e5));
    check_same(Yeoh{3e5, 0, 0, K}, neo_hookean(6e5));
    check_same(Ogden{{6e5}, {2}, K}, neo_hookean(6e5));
    check_same(Ogden{{2e5, 3e5, 1e5}, {2, 2, 2}, K}, neo_hookean(6e5));
    check_same(Ogden{{6e5, -1.6e5}, {2, -2}, K}, mooney);
    check_same(ArrudaBoyce{6e5, 1e8, K}, neo_hookean(6e5));
  }

  TEST_CASE("Arruda-Boyce nears the neo-Hookean law as 1/lambda_m^2") {
    Matrix3 const F = test::states<6>()[2];
    auto const error = [&](double lambda_m) -> double {
      return (cauchy(ArrudaBoyce{6e5, lambda_m, K}, F) - cauchy(neo_hookean(6e5), F)).norm();
    };
    CHECK(error(10) > 1e2);
    CHECK(error(10) / error(100) == doctest::Approx(100).epsilon(0.05));
  }

  TEST_CASE("Ogden's even exponents beyond 2 by hand, where stretches coalesce and where not") {
    Ogden const law{{2e5, 1e5}, {4, -4}, K};
    for (auto const& F : test::states<6>()) {
      Matrix3 const C = F.transpose() * F, inverse = C.inverse();
      double const J = F.determinant(), p = std::pow(J, -4.0 / 3), q = 1 / p;
      double const up = p * C.squaredNorm(), down = q * inverse.squaredNorm(); // sums of l^4 and of l^-4
      double const W = 2e5 / 4 * (up - 3) - 1e5 / 4 * (down - 3) + K / 2 * (J - 1) * (J - 1);
      Matrix3 const S = 2e5 * (p * C - up / 3 * inverse) +
                        1e5 * (q * inverse * inverse * inverse - down / 3 * inverse) +
                        K * J * (J - 1) * inverse;
      auto const got = test::respond(law, F);
      double const size = got.tangent.norm();
      CHECK(std::abs(got.energy - W) <= 1e-13 * size);
      CHECK((test::tensor(got.stress) - S).norm() <= 1e-13 * size);
    }
  }
}
