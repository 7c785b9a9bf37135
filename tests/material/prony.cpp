// Networks that relax: weights of a step, stress as derivative of an energy, dissipation.
#include <Eigen/Eigenvalues>
#include <doctest/doctest.h>
#include <random>

#include "core/pack.hpp"
#include "differences.hpp"
#include "material/prony.hpp"

using namespace stiction;
using material::MetricMove;
using material::NetworkStep;

namespace {

template<int N> material::Voigt<N> random_strain(std::mt19937& random, double size) {
  std::uniform_real_distribution<double> uniform(-size, size);
  material::Voigt<N> strain;
  for (int i = 0; i < N; ++i)
    strain[i] = uniform(random);
  return strain;
}

material::NetworkEnergy<double> pass(MetricMove<6, double> const& move, NetworkStep const& step,
                                     material::Voigt<6>& V) {
  material::NetworkEnergy<double> energy;
  move.pass(step, V, energy);
  return energy;
}

/// Of one Maxwell network under a strain that goes straight, by the midpoint rule on many pieces.
struct Integrals {
  double fading = 0, mixed = 0, flowing = 0;
};
Integrals integrals(double x, int pieces) {
  Integrals sum;
  for (int i = 0; i < pieces; ++i) {
    double const y = std::exp(-x * (i + 0.5) / pieces), part = x / pieces;
    sum.fading += part * y * y;
    sum.mixed += part * y * (1 - y) / x;
    sum.flowing += part * (1 - y) * (1 - y) / (x * x);
  }
  return sum;
}

template<int N> void check_tangent(bool small, double size) {
  std::mt19937 random(5);
  material::Voigt<N> P = random_strain<N>(random, 0.2);
  Vector const strain = random_strain<N>(random, size);
  auto const respond = [&](Vector const& at) {
    material::Response<N> response;
    response.stress.setZero();
    response.tangent.setZero();
    material::add_networks<N, material::Wanted::tangent>(small, 1.3, P, material::Voigt<N>(at), response);
    return response;
  };
  auto const stress = [&](Vector const& at) { return Vector(respond(at).stress); };
  Dense const D = respond(strain).tangent;
  auto const found = test::rate(stress, D, strain, 1e-2);
  INFO(found.words());
  CHECK(found.second_order);
  CHECK((D - D.transpose()).norm() < 1e-13 * D.norm());
  if (small)
    return;
  auto const energy = [&](Vector const& at) { // J^-2/3 (m I - 2 P) : C / 2
    auto const C = material::right_cauchy_green<N>(material::Voigt<N>(at));
    material::Tensor<double> const M = 1.3 * Matrix3::Identity() - 2 * material::full<N>(P);
    return Vector::Constant(1, 0.5 * M.cwiseProduct(C).sum() / std::cbrt(C.determinant()));
  };
  CHECK(test::rate(energy, stress(strain).transpose(), strain, 1e-2).second_order);
}

template<int N> void check_volume_tangent(bool small) {
  std::mt19937 random(6);
  Vector const strain = random_strain<N>(random, 0.2);
  auto const respond = [&](Vector const& at) {
    material::Response<N> response;
    response.stress.setZero();
    response.tangent.setZero();
    material::add_volume_networks<N, material::Wanted::tangent>(small, 1.3, 0.4, material::Voigt<N>(at),
                                                                response);
    return response;
  };
  Dense const D = respond(strain).tangent;
  auto const stress = [&](Vector const& at) { return Vector(respond(at).stress); };
  auto const found = test::rate(stress, D, strain, 1e-2);
  INFO(found.words());
  CHECK((small ? found.errors[0] < 1e-12 : found.second_order));
  CHECK((D - D.transpose()).norm() < 1e-14 * D.norm());
  auto const energy = [&](Vector const& at) { // m/2 e^2 - n e
    auto const C = material::right_cauchy_green<N>(material::Voigt<N>(at));
    double const e = small ? at.head<3>().sum() : 0.5 * std::log(C.determinant());
    return Vector::Constant(1, 0.65 * e * e - 0.4 * e);
  };
  auto const derived = test::rate(energy, stress(strain).transpose(), strain, 1e-2);
  CHECK((small ? derived.errors[0] < 1e-12 : derived.second_order));
}

} // namespace

TEST_SUITE_BEGIN("material");

TEST_CASE("relaxation: weights of a step sum to one and are those of the exact course, over 24 decades") {
  for (double x = 1e-12; x < 1e13; x *= 3.7) {
    NetworkStep const step(2, 1 / x, 1);
    CAPTURE(x);
    CHECK(step.keep + step.before + step.after == doctest::Approx(1).epsilon(1e-15));
    CHECK(std::min({step.keep, step.before, step.after}) >= 0);
    CHECK(step.fading * step.flowing >= step.mixed * step.mixed);
    if (x < 1e-3 || x > 30)
      continue;
    auto const exact = integrals(x, 20000);
    CHECK(step.fading == doctest::Approx(exact.fading).epsilon(1e-5));
    CHECK(step.mixed == doctest::Approx(exact.mixed).epsilon(1e-5));
    CHECK(step.flowing == doctest::Approx(exact.flowing).epsilon(1e-5));
  }
  NetworkStep const none(2, 1, 0);
  CHECK(none.left() == 2);
  CHECK(none.fading == 0);
}

TEST_CASE("relaxation: the stress of networks derives from an energy, and its tangent from the stress") {
  for (bool const small : {false, true}) {
    check_tangent<4>(small, 0.2);
    check_tangent<6>(small, 0.2);
  }
}

TEST_CASE("relaxation: the stress of volume networks derives from an energy, its tangent from the stress") {
  for (bool const small : {false, true}) {
    check_volume_tangent<4>(small);
    check_volume_tangent<6>(small);
  }
}

TEST_CASE("relaxation: a volume network dissipates what it takes up, in one step as in many") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  for (double const x : {1e-9, 1e-3, 0.3, 2.0, 40.0, 1e9}) {
    double const from = uniform(random), to = uniform(random), start = uniform(random);
    CAPTURE(x);
    double a = start, same = start;
    material::NetworkEnergy<double> once, many;
    material::pass_volume({2, 1, x}, from, to, a, once);
    CHECK(once.dissipated >= 0);
    int const pieces = 64;
    double work = 0; // of K (e - a), by its exact mean over each piece
    for (int i = 0; i < pieces; ++i) {
      double const e = from + (to - from) * i / pieces, next = from + (to - from) * (i + 1) / pieces,
                   y = x / pieces, rate = (next - e) / y;
      work += 2 * rate * (rate * y + (e - same - rate) * -std::expm1(-y));
      many.stored = 0;
      material::pass_volume({2, 1, y}, e, next, same, many);
    }
    CHECK(a == doctest::Approx(same).epsilon(1e-12));
    CHECK(once.stored == doctest::Approx(many.stored).epsilon(1e-11));
    CHECK(once.dissipated == doctest::Approx(many.dissipated).epsilon(1e-9));
    if (x > 1e-4 && x < 1e4)
      CHECK(once.stored + once.dissipated - (from - start) * (from - start) ==
            doctest::Approx(work).epsilon(1e-10));
  }
}

TEST_CASE("relaxation: dissipation is never negative, whatever the step and the move") {
  std::mt19937 random(3);
  for (int i = 0; i < 4000; ++i) {
    bool const small = i % 4 == 0;
    auto const from = material::metric_strain<6>(small, random_strain<6>(random, 0.2)),
               to = material::metric_strain<6>(small, random_strain<6>(random, 0.2));
    auto V = material::metric_strain<6>(small, random_strain<6>(random, 0.2));
    double const x = std::pow(10.0, i % 19 - 9);
    auto const energy = pass(MetricMove<6, double>(small, from, to), {1, 1 / x, 1}, V);
    CAPTURE(x);
    CHECK(energy.dissipated >= 0);
    CHECK(energy.stored >= -1e-14);
    material::Voigt<6> inverse;
    double const det = MetricMove<6, double>::invert(V, inverse);
    CHECK((small || (det > 0 && inverse.head<3>().minCoeff() > 0)));
  }
}

TEST_CASE("relaxation: at constant strain a network dissipates what it held") {
  std::mt19937 random(3);
  for (bool const small : {true, false})
    for (double const size : {0.01, 0.1}) {
      auto const held = material::metric_strain<6>(small, random_strain<6>(random, size));
      MetricMove<6, double> const rest(small, held, held);
      material::Voigt<6> V = material::Voigt<6>::Zero();
      double const stored = pass(rest, {1, 1, 0}, V).stored;
      for (double const x : {0.1, 1.0, 100.0}) {
        V.setZero();
        auto const energy = pass(rest, {1, 1, x}, V);
        CAPTURE(x);
        // of finite strains the rule has one point
        CHECK(energy.dissipated ==
              doctest::Approx(stored - energy.stored).epsilon(small ? 1e-12 : size * size));
      }
    }
}

TEST_CASE("relaxation: small strains dissipate the same in one step as in many") {
  std::mt19937 random(3);
  auto const from = material::metric_strain<6>(true, random_strain<6>(random, 0.1)),
             to = material::metric_strain<6>(true, random_strain<6>(random, 0.1));
  material::Voigt<6> V = random_strain<6>(random, 0.1), same = V;
  auto const once = pass(MetricMove<6, double>(true, from, to), {1, 1, 2}, V);
  double many = 0;
  for (int i = 0; i < 50; ++i) {
    material::Voigt<6> const a = from + i / 50.0 * (to - from), b = from + (i + 1) / 50.0 * (to - from);
    many += pass(MetricMove<6, double>(true, a, b), {1, 1, 2.0 / 50}, same).dissipated;
  }
  CHECK(many == doctest::Approx(once.dissipated).epsilon(1e-12));
  CHECK((same - V).norm() < 1e-14);
}

TEST_CASE("four inverse cube roots at once are those of one") {
  double worst = 0;
  for (double x = 1e-300; x < 1e300; x *= 1.0137)
    worst = std::max(worst, std::abs(inverse_cbrt(Pack(x))[3] * std::cbrt(x) - 1));
  for (double x = 0.1; x < 10; x += 3.1e-4)
    worst = std::max(worst, std::abs(inverse_cbrt(Pack(x))[1] * std::cbrt(x) - 1));
  CHECK(worst < 1e-15);
  CHECK(inverse_cbrt(Pack(1))[0] == doctest::Approx(1).epsilon(1e-15));
}

TEST_CASE("four logarithms at once are those of one") {
  double worst = 0;
  for (double x = 1e-300; x < 1e300; x *= 1.0137)
    worst = std::max(worst, std::abs(log(Pack(x))[2] - std::log(x)) / std::max(std::abs(std::log(x)), 1e-3));
  for (double d = -0.2; d < 0.2; d += 1.7e-4)
    worst = std::max(worst, std::abs(log(Pack(1 + d))[1] / std::log(1 + d) - 1));
  CHECK(worst < 1e-15);
  CHECK(log(Pack(1))[0] == 0);
}

TEST_SUITE_END();
