// The RCC law at one point: each formula, its settings, its derivatives and the way of each parameter.
#include <doctest/doctest.h>

#include "core/reader.hpp"
#include "differences.hpp"
#include "interface/law.hpp"

using namespace stiction;
using namespace stiction::interface;

namespace {

Rcc sample() {
  Rcc law;
  law.w = 3;
  law.C_n = 5e3;
  law.C_t = law.C_t2 = 7e3;
  law.b = 0.11;
  return law;
}

core::Input quantity(double value, char const* unit) {
  return {core::Quantity{value, core::parse_unit(unit)->dimension}, "", ""};
}
core::Input word(char const* text) {
  return {std::string(text), "", ""};
}
core::Table sample_table() {
  return {{"w", quantity(3, "J/m^2")},
          {"C_n", quantity(5e3, "N/m^3")},
          {"C_t", quantity(7e3, "N/m^3")},
          {"b", quantity(0.11, "N s/m")}};
}
Rcc read(core::Table table) {
  core::Input const input{std::move(table), "", ""};
  core::Complaints complaints;
  Rcc const law = core::Reader(input, "", complaints).record<Rcc>();
  CHECK(complaints.empty());
  return law;
}
Rcc read_with(char const* key, core::Input const& value) {
  auto table = sample_table();
  table[key] = value;
  return read(table);
}

BondStep step_from(double beta, double dt, bool closed) {
  return {{beta, {0.004, -0.007}}, dt, closed};
}

template<int D> void check_derivatives(Rcc const& law, BondStep const& step, Local<D> const& x) {
  auto const at = adhere<D>(law, step, x);
  auto const traction =
      test::rate([&](Vector const& y) { return Vector(adhere<D>(law, step, Local<D>(y)).traction); },
                 Dense(at.traction_by_x), x, 1e-3);
  auto const beta = test::rate(
      [&](Vector const& y) { return Vector::Constant(1, adhere<D>(law, step, Local<D>(y)).beta).eval(); },
      Dense(at.beta_by_x.transpose()), x, 1e-3, 1);
  auto const friction = test::rate(
      [&](Vector const& y) { return Vector::Constant(1, adhere<D>(law, step, Local<D>(y)).friction).eval(); },
      Dense(at.friction_by_x.transpose()), x, 1e-3, 1);
  INFO("D = " << D << ", beta " << at.beta << ", x = " << x.transpose());
  CHECK_MESSAGE(traction.second_order, "traction: " << traction.words());
  CHECK_MESSAGE(beta.second_order, "beta: " << beta.words());
  CHECK_MESSAGE(friction.second_order, "friction: " << friction.words());
  CHECK(traction.errors[3] <= 1e-6 * (1 + traction.scale));
}

} // namespace

TEST_SUITE("interface") {
  TEST_CASE("beta and traction by hand") {
    Rcc const law = sample();
    double const dt = 0.01, xn = 0.03;
    auto const open = adhere<3>(law, step_from(0.8, dt, false), {xn, 0.002, 0.001});
    double const s1 = 0.006, s2 = -0.006; // stretch of the step's start plus its slip
    double const q = 5e3 * xn * xn + 7e3 * (s1 * s1 + s2 * s2);
    double const beta = (0.11 * 0.8 + dt * 3) / (0.11 + dt * q);
    CHECK(open.beta == doctest::Approx(beta).epsilon(1e-14));
    CHECK(open.traction[0] == doctest::Approx(-5e3 * xn * beta * beta).epsilon(1e-14)); // (21): pulls back
    CHECK(open.traction[1] == doctest::Approx(-7e3 * s1 * beta * beta).epsilon(1e-14));
    CHECK(open.traction[2] == doctest::Approx(-7e3 * s2 * beta * beta).epsilon(1e-14));
    CHECK(open.friction == 1);
    auto const next = advance<3>(law, step_from(0.8, dt, false), {xn, 0.002, 0.001});
    CHECK(next.beta == open.beta);
    CHECK((next.stretch - Eigen::Vector2d(s1, s2)).norm() < 1e-16);
  }

  TEST_CASE("each script parameter changes its own formula") {
    BondStep const step = step_from(0.8, 0.01, false);
    Local<3> const x(0.03, 0.002, 0.001);
    CHECK(read(sample_table()).w == 3);
    auto const traction = [&](Rcc const& law) { return adhere<3>(law, step, x).traction; };
    auto const from_members = [&](auto change) {
      Rcc law = sample();
      change(law);
      return traction(law);
    };
    CHECK(traction(read_with("w", quantity(2, "J/m^2"))) == from_members([](Rcc& l) { l.w = 2; }));
    CHECK(traction(read_with("C_n", quantity(4e3, "N/m^3"))) == from_members([](Rcc& l) { l.C_n = 4e3; }));
    CHECK(traction(read_with("C_t", quantity(4e3, "N/m^3"))) ==
          from_members([](Rcc& l) { l.C_t = l.C_t2 = 4e3; }));
    CHECK(traction(read_with("b", quantity(0.2, "N s/m"))) == from_members([](Rcc& l) { l.b = 0.2; }));
    CHECK(read_with("beta0", quantity(0.6, "1")).beta0 == 0.6);
    CHECK(read(sample_table()).bonding == Bonding::contact);
    CHECK(read_with("bonding", word("contact")).bonding == Bonding::contact);
    CHECK(read_with("bonding", word("proximity")).bonding == Bonding::proximity);
    CHECK(read_with("bonding", word("never")).bonding == Bonding::never);
    CHECK(read(sample_table()).friction == BondFriction::full);
    CHECK(read_with("friction", word("full")).friction == BondFriction::full);
    CHECK(read_with("friction", word("damage")).friction == BondFriction::damage);
    CHECK(read_with("damage_power", quantity(2.5, "1")).damage_power == 2.5);
  }

  TEST_CASE("friction left by the bond: all of mu, or mu (1 - beta)^p, mu 0 without a law") {
    Rcc law = sample();
    BondStep const step = step_from(0.8, 0.01, false);
    Local<2> const x(0.03, 0.002);
    double const beta = adhere<2>(law, step, x).beta;
    law.friction = BondFriction::damage;
    CHECK(adhere<2>(law, step, x).friction == doctest::Approx(1 - beta));
    law.damage_power = 3;
    CHECK(adhere<2>(law, step, x).friction == doctest::Approx(std::pow(1 - beta, 3)));
    CHECK(Law{}.mu() == 0);
    CHECK(Law{Coulomb{0.7}, {}}.mu() == 0.7);
  }

  TEST_CASE("at rest beta grows as w t / b, exactly, and stops at one") {
    for (auto const bonding : {Bonding::contact, Bonding::proximity}) {
      Rcc law = sample();
      law.bonding = bonding;
      Bond bond;
      bond.beta = 0.1;
      double const dt = 3e-3;
      for (int k = 1; k <= 20; ++k) {
        bond = advance<2>(law, {bond, dt, true}, Local<2>::Zero());
        CHECK(bond.beta == doctest::Approx(std::min(1.0, 0.1 + 3 * dt * k / 0.11)).epsilon(1e-13));
      }
    }
  }

  TEST_CASE(
      "a bond that is there across a gap from the start is the one that this gap leaves of it at rest") {
    Rcc law = sample();
    law.beta0 = 0.8;
    law.bonding = Bonding::never;
    law.b = 0;
    double const u0 = std::sqrt(law.w / law.C_n);
    for (double const gap : {-u0, 0.0, 0.5 * u0, 0.99 * u0, 1.5 * u0, 10 * u0, 1e6 * u0}) {
      CAPTURE(gap);
      Bond const there = law.initial(gap), later = advance<1>(law, {there, 1, false}, Local<1>(gap));
      CHECK(later.beta == doctest::Approx(there.beta).epsilon(1e-12));
      CHECK(there.beta == doctest::Approx(gap > u0 ? std::min(0.8, u0 * u0 / (gap * gap)) : 0.8));
    }
    law.w = 0; // which holds at no opening: what was given stays
    CHECK(law.initial(1).beta == 0.8);
    CHECK(law.initial(unreached).beta == 0); // where there is no counterpart
  }

  TEST_CASE("bonding: where closed, everywhere, nowhere") {
    Local<2> const still = Local<2>::Zero();
    auto const after = [&](Bonding bonding, bool closed, Local<2> const& x) {
      Rcc law = sample();
      law.bonding = bonding;
      return advance<2>(law, {{0.4, {0, 0}}, 5e-3, closed}, x).beta;
    };
    double const grown = 0.4 + 3 * 5e-3 / 0.11;
    CHECK(after(Bonding::contact, true, still) == doctest::Approx(grown));
    CHECK(after(Bonding::contact, false, still) == 0.4);
    CHECK(after(Bonding::proximity, false, still) == doctest::Approx(grown));
    CHECK(after(Bonding::never, true, still) == 0.4);
    for (auto const bonding : {Bonding::contact, Bonding::proximity, Bonding::never}) {
      double const q = 5e3 * 0.05 * 0.05; // loss of the bond is the same under all
      CHECK(after(bonding, false, {0.05, 0}) == doctest::Approx((0.11 * 0.4 + 5e-3 * 3) / (0.11 + 5e-3 * q)));
    }
  }

  TEST_CASE("without viscosity beta = clip(w/q) at once") {
    Rcc law = sample();
    law.b = 0;
    auto const beta = [&](double xn, double old, bool closed) {
      return advance<2>(law, {{old, {0, 0}}, 1e-3, closed}, {xn, 0}).beta;
    };
    double const u0 = std::sqrt(3 / 5e3);
    CHECK(beta(2 * u0, 1, false) == doctest::Approx(0.25));
    CHECK(beta(0.5 * u0, 1, false) == 1);
    CHECK(beta(0, 0, true) == 1);
    CHECK(beta(0, 0.3, false) == 0.3);
    law.w = 0;
    CHECK(beta(0, 0.3, true) == 0.3); // nothing drives it
    CHECK(beta(u0, 0.3, true) == 0);
  }

  TEST_CASE("penetration within tolerance neither pushes nor damages") {
    auto const at = adhere<2>(sample(), {{1, {0, 0}}, 1e-3, true}, {-0.02, 0});
    CHECK(at.traction.isZero(0));
    CHECK(at.traction_by_x(0, 0) == 0);
    CHECK(at.beta == 1);
  }

  TEST_CASE("the stretch starts when the bond does and is forgotten with it") {
    Rcc const law = sample();
    Bond bond;
    bond = advance<2>(law, {bond, 1e-3, false}, {0.01, 0.5}); // open: no bond, nothing to remember
    CHECK(bond.beta == 0);
    CHECK(bond.stretch.isZero(0));
    bond = advance<2>(law, {bond, 1e-3, true}, {0, 0.5}); // forms at the end of this step
    CHECK(bond.beta > 0);
    CHECK(bond.stretch.isZero(0));
    bond = advance<2>(law, {bond, 1e-3, true}, {0, 0.002});
    bond = advance<2>(law, {bond, 1e-3, true}, {0, 0.003});
    CHECK(bond.stretch[0] == doctest::Approx(0.005));
    Rcc brittle = law;
    brittle.w = brittle.b = 0;
    bond = advance<2>(brittle, {bond, 1e-3, true}, {0, 0.003});
    CHECK(bond.beta == 0);
    CHECK(bond.stretch.isZero(0));
  }

  TEST_CASE("derivatives of traction, beta and friction match differences at second order") {
    Rcc law = sample();
    for (auto const friction : {BondFriction::full, BondFriction::damage})
      for (double const power : {1.0, 2.5})
        for (double const b : {0.11, 0.0}) {
          law.friction = friction;
          law.damage_power = power;
          law.b = b;
          for (double const beta : {0.8, 0.3}) {
            BondStep const step = step_from(beta, 0.02, true);
            check_derivatives<2>(law, step, {0.06, 0.02});
            check_derivatives<3>(law, step, {0.06, 0.02, -0.03});
            check_derivatives<3>(law, step, {0.004, 0.001, 0.002}); // grows or is full
            check_derivatives<2>(law, step_from(beta, 0.02, false), {0.05, -0.05});
          }
        }
    check_derivatives<2>(law, step_from(0, 0.02, true), {0.05, 0.3}); // no bond at the start: no stretch
  }

  TEST_CASE("bond energy is psi of (9)") {
    Bond const bond{0.6, {0.01, 0.02}};
    double const stretch = 7e3 * (1e-4 + 4e-4);
    CHECK(bond_energy(sample(), bond, 0.03) == doctest::Approx(0.18 * (5e3 * 9e-4 + stretch) - 1.8));
    CHECK(bond_energy(sample(), bond, -0.03) == doctest::Approx(0.18 * stretch - 1.8));
    auto orthotropic = sample();
    orthotropic.C_t2 = 2e3;
    CHECK(bond_energy(orthotropic, bond, 0) == doctest::Approx(0.18 * (7e3 * 1e-4 + 2e3 * 4e-4) - 1.8));
  }
}
