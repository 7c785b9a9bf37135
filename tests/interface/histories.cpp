// The RCC law along histories with a closed form: opening, shear under pressure, and its energy balance.
#include <algorithm>
#include <doctest/doctest.h>
#include <vector>

#include "interface/rcc.hpp"

using namespace stiction;
using namespace stiction::interface;

namespace {

/// The paper's scales: sigma0 = 0.2 MPa, u0 = 0.1 mm.
Rcc bond_law(double b) {
  Rcc law;
  law.w = 20;
  law.C_n = law.C_t = law.C_t2 = 2e9;
  law.b = b;
  return law;
}
constexpr double u0 = 1e-4, sigma0 = 2e5, w = 20;

struct Opening {
  double peak = 0, at = 0, work = 0; ///< in units of sigma0, u0, w
};

/// Opens a full bond at constant speed, V* = V b/(w u0), in steps ds up to s = end; the tail s^-3 is added.
Opening open_bond(double rate_number, double ds, double end) {
  Rcc const law = bond_law(rate_number > 0 ? 0.1 : 0.0);
  double const speed = rate_number > 0 ? rate_number * w * u0 / law.b : 1.0;
  Bond bond{1, {0, 0}};
  Opening result;
  double before = 0;
  for (int k = 1; k * ds <= end + 1e-12; ++k) {
    double const s = k * ds;
    BondStep const step{bond, ds * u0 / speed, false};
    double const stress = -adhere<2>(law, step, {s * u0, 0}).traction[0] / sigma0;
    bond = advance<2>(law, step, {s * u0, 0});
    result.work += 0.5 * (before + stress) * ds;
    if (stress > result.peak) {
      result.peak = stress;
      result.at = s;
    }
    before = stress;
  }
  result.work += 0.5 / (end * end);
  return result;
}

/// beta(s) of the closed form, by Simpson's rule on the integral.
double exact_beta(double s, double rate_number) {
  if (s <= 1)
    return 1;
  auto const weight = [&](double y) { return std::exp((y * y * y - s * s * s) / (3 * rate_number)); };
  int const pieces = 400;
  double const h = (s - 1) / pieces;
  double integral = 0;
  for (int k = 0; k < pieces; ++k)
    integral += h / 6 * (weight(1 + k * h) + 4 * weight(1 + (k + 0.5) * h) + weight(1 + (k + 1) * h));
  return weight(1) + integral / rate_number;
}

double exact_stress(double s, double rate_number) {
  double const beta = exact_beta(s, rate_number);
  return s * beta * beta;
}

/// Shear s = x_t/u0 in steps under pressure p = m sigma0/mu with b = 0: tau/sigma0 after each step.
std::vector<double> shear(BondFriction friction, double m, double ds, double end) {
  Rcc law = bond_law(0);
  law.friction = friction;
  Bond bond{1, {0, 0}};
  std::vector<double> tau;
  for (int k = 1; k * ds <= end + 1e-12; ++k) {
    BondStep const step{bond, 1e-3, true};
    auto const at = adhere<2>(law, step, {0, ds * u0});
    bond = advance<2>(law, step, {0, ds * u0});
    tau.push_back(-at.traction[1] / sigma0 + m * at.friction);
  }
  return tau;
}

/// Work done on the bond minus what it stores and dissipates, over w, along a curved path.
double imbalance(int steps) {
  Rcc law = bond_law(0.1);
  law.C_t = law.C_t2 = 3e9;
  double const duration = 2e-3, dt = duration / steps;
  auto const position = [&](int k) -> Eigen::Vector3d {
    double const t = static_cast<double>(k) / steps;
    return Eigen::Vector3d(2 * t * t, std::sin(2 * t), 0.7 * t) * u0;
  };
  Bond bond{0.9, {0, 0}};
  double const start = bond_energy(law, bond, 0);
  double work = 0, dissipated = 0;
  Local<3> before = Local<3>::Zero();
  for (int k = 1; k <= steps; ++k) {
    Eigen::Vector3d const move = position(k) - position(k - 1);
    BondStep const step{bond, dt, false};
    Local<3> const x(position(k)[0], move[1], move[2]);
    Local<3> const pull = -adhere<3>(law, step, x).traction;
    Bond const next = advance<3>(law, step, x);
    work += 0.5 * (before + pull).dot(move);
    dissipated += law.b * (next.beta - bond.beta) * (next.beta - bond.beta) / dt;
    before = pull;
    bond = next;
  }
  return (work - (bond_energy(law, bond, position(steps)[0]) - start) - dissipated) / w;
}

} // namespace

TEST_SUITE("interface") {
  TEST_CASE("opening without viscosity: sigma0 at s = 1, then s^-3, work w") {
    Rcc const law = bond_law(0);
    Bond bond{1, {0, 0}};
    for (double const s : {0.2, 0.7, 1.0, 1.3, 2.0, 5.0}) {
      BondStep const step{bond, 1e-3, false};
      double const stress = -adhere<2>(law, step, {s * u0, 0}).traction[0] / sigma0;
      CHECK(stress == doctest::Approx(s <= 1 ? s : 1 / (s * s * s)).epsilon(1e-12));
      bond = advance<2>(law, step, {s * u0, 0});
    }
    auto const fine = open_bond(0, 1e-3, 40);
    CHECK(fine.peak == doctest::Approx(1).epsilon(1e-12));
    CHECK(fine.at == doctest::Approx(1).epsilon(1e-12));
    CHECK(fine.work == doctest::Approx(1).epsilon(1e-5));
  }

  TEST_CASE("opening with viscosity tends to the closed form at first order") {
    struct Wanted {
      double rate_number, peak, at, work;
    };
    for (auto const& wanted : {Wanted{0.1, 1.01326, 1.0274, 1.07261}, Wanted{1, 1.10795, 1.2075, 1.51453}}) {
      CAPTURE(wanted.rate_number);
      CHECK(exact_stress(wanted.at, wanted.rate_number) == doctest::Approx(wanted.peak).epsilon(1e-5));
      auto const fine = open_bond(wanted.rate_number, 2.5e-4, 40);
      CHECK(fine.peak == doctest::Approx(wanted.peak).epsilon(5e-4));
      CHECK(fine.at == doctest::Approx(wanted.at).epsilon(3e-3));
      CHECK(fine.work == doctest::Approx(wanted.work).epsilon(2e-3));
      auto const error = [&](double ds) { return wanted.peak - open_bond(wanted.rate_number, ds, 3).peak; };
      double const order = std::log2(error(2e-3) / error(1e-3));
      CHECK(order == doctest::Approx(1).epsilon(0.1));
    }
    CHECK(open_bond(1, 0.1, 3).peak / 1.10795 - 1 == doctest::Approx(-0.033).epsilon(0.02));
  }

  TEST_CASE("shear under pressure, full friction: (1 + m) sigma0 at s = 1, then towards m") {
    for (double const m : {0.5, 1.0}) {
      auto const tau = shear(BondFriction::full, m, 0.1, 20);
      for (std::size_t k = 0; k < tau.size(); ++k) {
        double const s = 0.1 * static_cast<double>(k + 1);
        CHECK(tau[k] == doctest::Approx(m + std::min(s, 1 / (s * s * s))).epsilon(1e-9));
      }
    }
  }

  TEST_CASE("shear under pressure, damaged friction: s to 1, then s^-3 + m (1 - s^-2), dip at s = 1.5") {
    auto const tau = shear(BondFriction::damage, 1, 0.05, 6);
    for (std::size_t k = 0; k < tau.size(); ++k) {
      double const s = 0.05 * static_cast<double>(k + 1);
      double const exact = s <= 1 ? s : 1 / (s * s * s) + 1 - 1 / (s * s);
      CHECK(tau[k] == doctest::Approx(exact).epsilon(1e-9));
    }
    auto const dip = std::min_element(tau.begin() + 20, tau.end()) - tau.begin();
    CHECK(dip == 29); // s = 1.5
    CHECK(tau[29] == doctest::Approx(0.8519).epsilon(1e-4));
  }

  TEST_CASE("work = stored + dissipated b beta'^2 dt, closing at first order") {
    double const coarse = imbalance(400), fine = imbalance(800), finest = imbalance(1600);
    CHECK(std::abs(coarse) < 0.02);
    CHECK(coarse / fine == doctest::Approx(2).epsilon(0.05));
    CHECK(fine / finest == doctest::Approx(2).epsilon(0.05));
  }
}
