// Friction laws: the coefficient by hand, its limits, and its derivatives.
#include <doctest/doctest.h>

#include "differences.hpp"
#include "interface/laws.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

template<int D> double mu_at(FrictionLaw const& law, double p, double slip, double dt = 0.1) {
  Sliding<D> at;
  at.dry[0] = p;
  at.x[0] = -0.3; // neither the gap nor the dry shear matters
  if constexpr (D > 1)
    at.x[D - 1] = at.dry[1] = slip;
  at.dt = dt;
  return coefficient<D>(law, at).mu;
}

template<int D> void check_derivatives(NamedFriction const& named, Sliding<D> const& at) {
  auto const here = coefficient<D>(named.law, at);
  auto const by_dry = test::rate(
      [&](Vector const& dry) {
        return Vector::Constant(1, coefficient<D>(named.law, {Local<D>(dry), at.x, at.dt}).mu).eval();
      },
      Dense(here.by_dry.transpose()), at.dry, 1, 1);
  auto const by_x = test::rate(
      [&](Vector const& x) {
        return Vector::Constant(1, coefficient<D>(named.law, {at.dry, Local<D>(x), at.dt}).mu).eval();
      },
      Dense(here.by_x.transpose()), at.x, 1e-3, 1);
  INFO(named.name << ", D = " << D << ", rbar " << at.dry.transpose() << ", x " << at.x.transpose());
  CHECK_MESSAGE(by_dry.second_order, by_dry.words());
  CHECK_MESSAGE(by_x.second_order, by_x.words());
}

template<int D> void check_states(NamedFriction const& named) {
  for (double const p : {-20.0, 15.0, 45.0, 150.0})
    for (double const slip : {-0.02, 0.01, 0.05}) {
      Sliding<D> at;
      at.dry.setConstant(0.3 * p);
      at.dry[0] = p;
      at.x.setConstant(slip);
      at.dt = 0.1;
      check_derivatives<D>(named, at);
    }
}

} // namespace

TEST_SUITE("interface") {
  TEST_CASE("friction laws: derivatives by traction and slip match differences at second order") {
    for (auto const& named : frictions()) {
      check_states<1>(named);
      check_states<2>(named);
      check_states<3>(named);
    }
  }

  TEST_CASE("friction laws by hand, the same in the plane and in space") {
    for (double const p : {-5.0, 10.0, 60.0, 200.0}) {
      double const pressed = std::max(p, 0.0);
      for (double const slip : {0.0, 0.01, -0.04}) {
        double const speed = std::abs(slip) / 0.1;
        auto const check = [&](FrictionLaw const& law, double mu) {
          CHECK(mu_at<2>(law, p, slip) == doctest::Approx(mu).epsilon(1e-14));
          CHECK(mu_at<3>(law, p, slip) == doctest::Approx(mu).epsilon(1e-14));
        };
        check(Coulomb{0.4}, 0.4);
        check(Tresca{0.5, 30}, p > 60 ? 30 / p : 0.5);
        check(PressureFriction{0.9, 0.2, 80}, 0.2 + 0.7 * std::exp(-pressed / 80));
        PressureFriction thirion{0.9, 0, 80};
        thirion.decay = PressureDecay::thirion;
        check(thirion, 1 / (1 / 0.9 + pressed / (0.9 * 80))); // 1/mu is linear in the pressure
        check(VelocityFriction{0.7, 0.5, 0.2}, 0.5 + 0.2 * std::exp(-speed / 0.2));
      }
    }
  }

  TEST_CASE("friction laws: their limits are Coulomb's") {
    for (double const p : {1.0, 100.0, 1e6})
      for (double const slip : {0.0, 0.02}) {
        CHECK(mu_at<2>(Tresca{0.5, 1e12}, p, slip) == 0.5);
        CHECK(mu_at<2>(PressureFriction{0.9, 0.2, 1e18}, p, slip) == doctest::Approx(0.9).epsilon(1e-11));
        CHECK(mu_at<2>(PressureFriction{0.9, 0.2, 1e-6}, p, slip) == doctest::Approx(0.2).epsilon(1e-11));
        CHECK(mu_at<2>(VelocityFriction{0.7, 0.5, 1e18}, p, slip) == doctest::Approx(0.7).epsilon(1e-11));
        CHECK(mu_at<2>(VelocityFriction{0.7, 0.5, 1e-6}, p, slip) ==
              doctest::Approx(slip == 0 ? 0.7 : 0.5).epsilon(1e-11));
      }
  }

  TEST_CASE("a step starts with the static coefficient unless the point slid in the last one") {
    StaticKinetic const law{0.6, 0.4};
    CHECK(Law{law, {}}.mu(Status::open) == 0.6);
    CHECK(Law{law, {}}.mu(Status::stick) == 0.6);
    CHECK(Law{law, {}}.mu(Status::slip) == 0.4);
    for (auto const& named : frictions()) {
      bool const follows = Law{named.law, {}}.mu_follows();
      CHECK(follows == (named.name.starts_with("tresca") || named.name.starts_with("pressure") ||
                        named.name.starts_with("velocity")));
      CHECK(Law{named.law, {}}.tangential());
    }
    CHECK_FALSE(Law{Coulomb{0}, {}}.tangential());
    CHECK(Law{StaticKinetic{0, 0.1}, {}}.tangential());
  }
}
