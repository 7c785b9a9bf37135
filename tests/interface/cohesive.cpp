// Closed forms of the cohesive laws and potentials: peaks, works of separation, mixed modes.
#include <doctest/doctest.h>

#include "interface/laws.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

/// Work of separation along a ray that turns from the normal by this angle, J/m^2.
double work_along(AdhesionLaw const& law, double angle, double end = 1, int steps = 40000) {
  return straight(law, end * Eigen::Vector3d(std::cos(angle), 0.6 * std::sin(angle), 0.8 * std::sin(angle)),
                  steps)
      .work;
}

/// Traction of a first loading to d, seen along the ray.
Local<3> pull(AdhesionLaw const& law, Local<3> const& d) {
  return -adhere<3>(law, {initial_bond(law, 0), 1, false}, d).traction;
}

} // namespace

TEST_SUITE("interface") {
  TEST_CASE("bilinear: peaks, end and work of both modes, and Benzeggagh-Kenane's formula between them") {
    auto const law = bilinear_sample();
    CHECK(pull(law, {120 / 5e4, 0, 0})[0] == doctest::Approx(120).epsilon(1e-12));
    CHECK(pull(law, {0, 160 / 5e4, 0})[1] == doctest::Approx(160).epsilon(1e-12));
    double const end = 2 * 3 / 120.0, first = 120 / 5e4, middle = 0.5 * (first + end);
    CHECK(pull(law, {middle, 0, 0})[0] == doctest::Approx(60).epsilon(1e-12)); // half way down
    CHECK(pull(law, {end * 1.0001, 0, 0})[0] == 0);
    CHECK(work_along(law, 0, 0.1) == doctest::Approx(3).epsilon(1e-6));
    CHECK(work_along(law, std::numbers::pi / 2, 0.1) == doctest::Approx(7).epsilon(1e-6));
    for (double const angle : {0.3, 0.7, 1.1, 1.4}) {
      double const B = std::pow(std::sin(angle), 2);
      CHECK(work_along(law, angle, 0.12) == doctest::Approx(3 + 4 * std::pow(B, 2.2)).epsilon(1e-6));
      CHECK(work_along(bilinear_sample(ModeMix::linear), angle, 0.12) ==
            doctest::Approx(1 / ((1 - B) / 3 + B / 7)).epsilon(1e-6));
    }
  }

  TEST_CASE("bilinear: damage begins where the quadratic criterion says") {
    auto const law = bilinear_sample();
    for (double const angle : {0.2, 0.8, 1.3}) {
      double const n = std::cos(angle) / 120, t = std::sin(angle) / 160;
      double const onset = 1 / (5e4 * std::hypot(n, t));
      auto const beta = [&](double l) {
        Local<3> const d(l * std::cos(angle), l * std::sin(angle), 0);
        return adhere<3>(law, {{1, {0, 0}}, 1, false}, d).beta;
      };
      CHECK(beta(onset * 0.9999) == 1);
      CHECK(beta(onset * 1.0001) < 1);
    }
  }

  TEST_CASE("bilinear: energies below what is stored at the strength are refused with the mode") {
    CHECK(bilinear_sample().check().empty());
    auto law = bilinear_sample();
    law.G_I = 0.1;
    REQUIRE(law.check().size() == 1);
    CHECK(law.check()[0].path == "G_I");
    CHECK(law.check()[0].text.find("0.144") != std::string::npos);
    law = bilinear_sample();
    law.G_II = 0.2;
    REQUIRE(law.check().size() == 1);
    CHECK(law.check()[0].path == "G_II");
    Bilinear late{100, 23, 75, 3, 30}; // pure modes are sound, but G stays small until nearly pure shear
    CHECK(late.check().empty());
    late.exponent = 10;
    CHECK(late.check().size() == 1);
  }

  TEST_CASE("exponential: sigma_max at delta_n, phi_t / (sqrt(e/2) delta_t) at delta_t / sqrt 2, works phi_n "
            "and phi_t") {
    for (auto const memory : {Memory::irreversible, Memory::reversible})
      for (double const q : {0.6, 1.0, 1.4}) {
        auto const law = exponential_sample(memory, q);
        double const top = q * 3 / (std::sqrt(std::numbers::e / 2) * 0.04), at = 0.04 / std::numbers::sqrt2;
        CHECK(pull(law, {law.delta_n(), 0, 0})[0] == doctest::Approx(45).epsilon(1e-12));
        CHECK(pull(law, {0, 0.6 * at, 0.8 * at}).norm() == doctest::Approx(top).epsilon(1e-12));
        CHECK(pull(law, {0, 1.01 * at, 0}).norm() < top);
        CHECK(pull(law, {0, 0.99 * at, 0}).norm() < top);
        CHECK(work_along(law, 0, 1.2) == doctest::Approx(3).epsilon(1e-5));
        CHECK(work_along(law, std::numbers::pi / 2, 0.3) == doctest::Approx(3 * q).epsilon(1e-5));
      }
  }

  TEST_CASE(
      "exponential, reversible: Xu and Needleman's tractions in mixed mode, r where shear leaves none") {
    double const q = 0.6, r = 0.3;
    auto const law = exponential_sample(Memory::reversible, q, r);
    double const dn = law.delta_n(), dt = 0.04, n = 0.013, t = 0.021;
    double const u = n / dn, ev = std::exp(-t * t / (dt * dt));
    // their equations (2.9), (2.10)
    double const normal = 3 / dn * std::exp(-u) * (u * ev + (1 - q) / (r - 1) * (1 - ev) * (r - u));
    double const shear = 2 * 3 / (dt * dt) * t * (q + (r - q) / (r - 1) * u) * std::exp(-u) * ev;
    auto const at = pull(law, {n, t, 0});
    CHECK(at[0] == doctest::Approx(normal).epsilon(1e-12));
    CHECK(at[1] == doctest::Approx(shear).epsilon(1e-12));
    CHECK(std::abs(pull(law, {r * dn, 50 * dt, 0})[0]) < 1e-12);
    CHECK(work_along(law, 0.9, 1.6) == doctest::Approx(3).epsilon(1e-5)); // all ways out cost phi_n
  }

  TEST_CASE("exponential, irreversible, mixed mode: one damage, work by the integral of its secant") {
    auto const law = exponential_sample(Memory::irreversible, 1.4);
    double const K_n = 3 / (law.delta_n() * law.delta_n()), K_t = 2 * 1.4 * 3 / (0.04 * 0.04);
    auto const at = pull(law, {0.02, 0.015, 0});
    double const beta = std::exp(-0.02 / law.delta_n() - std::pow(0.015 / 0.04, 2));
    CHECK(at[0] == doctest::Approx(K_n * 0.02 * beta).epsilon(1e-12));
    CHECK(at[1] == doctest::Approx(K_t * 0.015 * beta).epsilon(1e-12));
  }

  TEST_CASE("exponential, irreversible: opening and slip at once take less work, as help says") {
    auto const law = exponential_sample(Memory::irreversible, 1);
    double least = 2, at = 0;
    for (double ratio = 0; ratio < 3; ratio += 0.05) { // of opening / delta_n to slip / delta_t
      Eigen::Vector3d const way(ratio * law.delta_n(), law.delta_t, 0);
      double const part = straight(law, way * 12 / std::max(ratio, 1.0), 400).dissipated / law.phi_n;
      if (part < least) {
        least = part;
        at = ratio;
      }
    }
    CHECK(least == doctest::Approx(0.6804).epsilon(1e-3));
    CHECK(at == doctest::Approx(1.1));
  }

  TEST_CASE("dugdale: the traction between the ramps, work sigma0 h0 exactly") {
    for (auto const memory : {Memory::reversible, Memory::irreversible}) {
      auto const law = dugdale_sample(memory);
      for (double const x : {0.01, 0.02, 0.035, 0.05})
        CHECK(pull(law, {x, 0.3, 0})[0] == doctest::Approx(60).epsilon(1e-12));
      CHECK(pull(law, {0.005, 0, 0})[0] == doctest::Approx(30).epsilon(1e-12));
      CHECK(pull(law, {0.055, 0, 0})[0] == doctest::Approx(30).epsilon(1e-12));
      CHECK(pull(law, {0.0601, 0, 0})[0] == 0);
      CHECK(pull(law, {0.02, 0.3, 0}).tail<2>().isZero(0));
      CHECK(work_along(law, 0, 0.1, 100000) == doctest::Approx(3).epsilon(1e-6));
    }
  }

  TEST_CASE("dugdale, irreversible: all that was put in is dissipated once it is open") {
    auto const open = straight(dugdale_sample(Memory::irreversible), {0.1, 0, 0}, 7); // in steps that jump
    CHECK(open.dissipated == doctest::Approx(3).epsilon(1e-12));
    CHECK(open.stored == 0);
    auto const bilinear = straight(bilinear_sample(), {0.1, 0, 0}, 7);
    CHECK(bilinear.dissipated == doctest::Approx(3).epsilon(1e-12));
    auto const sheared = straight(bilinear_sample(), {0, 0.06, 0.08}, 7);
    CHECK(sheared.dissipated == doctest::Approx(7).epsilon(1e-12));
    auto const exponential = straight(exponential_sample(Memory::irreversible, 1.4), {2, 0, 0}, 400);
    CHECK(exponential.dissipated == doctest::Approx(3).epsilon(1e-5));
  }

  TEST_CASE("attraction: w / range where it touches, 1/e of it at the range, psi itself") {
    Attraction const law{3, 0.02};
    CHECK(pull(law, {1e-9, 0.7, 0})[0] == doctest::Approx(150).epsilon(1e-6));
    CHECK(pull(law, {0.02, 0.7, 0})[0] == doctest::Approx(150 / std::numbers::e).epsilon(1e-12));
    CHECK(pull(law, {0.02, 0.7, 0}).tail<2>().isZero(0));
    for (double const x : {0.0, 0.01, 0.07}) {
      Bond const bond = advance<2>(law, {{}, 1, false}, {x, 0});
      CHECK(bond_energy(law, bond, x) == doctest::Approx(-3 * std::exp(-x / 0.02)).epsilon(1e-13));
    }
  }

  TEST_CASE("potential: w / (e delta) at delta, work w, psi itself") {
    Potential const law{3, 0.02};
    CHECK(pull(law, {0.02, 0.7, 0})[0] == doctest::Approx(3 / (std::numbers::e * 0.02)).epsilon(1e-12));
    CHECK(pull(law, {0.02, 0.7, 0}).tail<2>().isZero(0));
    CHECK(work_along(law, 0, 1) == doctest::Approx(3).epsilon(1e-6));
    for (double const x : {0.0, 0.01, 0.07}) {
      Bond const bond = advance<2>(law, {{}, 1, false}, {x, 0});
      CHECK(bond_energy(law, bond, x) ==
            doctest::Approx(-3 * (1 + x / 0.02) * std::exp(-x / 0.02)).epsilon(1e-13));
    }
  }
}
