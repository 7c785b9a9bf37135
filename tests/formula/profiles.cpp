// Profiles of formulas against their forces and energies, and energies against their derivatives.
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "formula/ball.hpp"
#include "formula/line.hpp"
#include "formula/punch.hpp"
#include "formula/sphere.hpp"
#include "formula/wave.hpp"

namespace {

using namespace stiction::formula;
using std::numbers::pi;

using stiction::test::ball, stiction::test::near, stiction::test::traction;

constexpr double E = stiction::test::ball_modulus, R = stiction::test::ball_radius,
                 w = stiction::test::ball_work;

/// Integral over a stretch whose ends may be those of a root, as a pressure's.
template<class F> double integral(F const& f, double from, double to) {
  constexpr int n = 2000;
  double sum = 0;
  for (int k = 0; k < n; ++k) {
    double const t = pi * (k + 0.5) / n;
    sum += f(0.5 * (from + to) - 0.5 * (to - from) * std::cos(t)) * std::sin(t);
  }
  return sum * 0.5 * (to - from) * pi / n;
}

double net(Local const& at) {
  return at.pressure - at.pull;
}

/// Force and strain energy of the tractions of a round contact up to a, and of what is drawn up to c.
void check_round(Formula const& formula, double s, double a, double c) {
  CAPTURE(formula.name());
  CAPTURE(s);
  auto const state = formula.at(s);
  auto const profile = formula.profile(s);
  auto const over = [&](auto const& f) { return integral(f, 0, a) + (c > a ? integral(f, a, c) : 0); };
  double const force = over([&](double r) { return 2 * pi * r * net(profile(r)); }),
               strain = over([&](double r) { return pi * r * net(profile(r)) * profile(r).sink; });
  CHECK(force == near(state.force, 1e-5));
  CHECK(strain == near(state.strain, 1e-5));
  double const far = 1e3 * std::max(a, c);
  CHECK(profile(far).sink == near(state.force / (pi * E * far), 1e-4));
  CHECK(profile(0.5 * a).touches);
  CHECK_FALSE(profile(1.01 * a).touches);
  if (a == 0)
    return;
  CHECK(profile(a * (1 + 1e-9)).sink == near(profile(a * (1 - 1e-9)).sink, 1e-3));
  if (formula.gives().peak)
    CHECK(profile(0).pressure == near(state.peak, 1e-12));
}

/// Error of central differences of the energy over the depth against the force, at two widths.
void check_rate(Formula const& formula, double s) {
  CAPTURE(formula.name());
  CAPTURE(s);
  auto const error = [&](double h) {
    auto const left = formula.at(s - h), right = formula.at(s + h);
    double const slope = (right.strain + right.bond - left.strain - left.bond) / (right.depth - left.depth);
    return std::abs(slope / formula.at(s).force - 1);
  };
  double const coarse = error(1e-2 * s), fine = error(2.5e-3 * s);
  CHECK(fine < 1e-3);
  CHECK(std::log2(coarse / fine) / 2 == near(2, 0.05));
}

} // namespace

TEST_CASE("pressures of round contacts sum up to their force, and with the sink to their energy") {
  check_round(Hertz(ball), 0.1, 0.1 * R, 0.1 * R);
  check_round(Punch(E, R), 0.01, R, R);
  double const unit = std::cbrt(0.75 * pi * w * R * R / E);
  for (double const s : {0.7, 1.5})
    check_round(Jkr(ball, w), s, s * unit, s * unit);
  for (double const lambda : {0.3, 2.0})
    for (double const s : {1.4, 2.2}) {
      Maugis const maugis(ball, w, traction(lambda));
      double const a = (s - 1) * unit;
      double low = a, high = 100 * a; // where the pull ends
      auto const profile = maugis.profile(s);
      while (high - low > 1e-14 * high)
        (profile(0.5 * (low + high)).pull > 0 ? low : high) = 0.5 * (low + high);
      check_round(maugis, s, a, low);
      double const gap = low * low / (2 * R) - maugis.at(s).depth + profile(low).sink;
      CHECK(gap == near(w / traction(lambda), 1e-6));
    }
}

TEST_CASE("a sphere that is drawn before it touches has a uniform pull's sink and energy") {
  Maugis const maugis(ball, w, traction(0.5));
  auto const state = maugis.at(0.6);
  double const c = std::sqrt(-state.force / (pi * traction(0.5)));
  auto const profile = maugis.profile(0.6);
  CHECK(profile(0).sink == near(-2 * traction(0.5) * c / E, 1e-12));
  CHECK(profile(c).sink == near(-4 * traction(0.5) * c / (pi * E), 1e-12));
  CHECK(profile(1e-9 * c).sink == near(profile(0).sink, 1e-9));
  double const strain = integral([&](double r) { return pi * r * net(profile(r)) * profile(r).sink; }, 0, c);
  CHECK(strain == near(state.strain, 1e-5));
  CHECK(state.strain == near(8 * std::pow(traction(0.5), 2) * std::pow(c, 3) / (3 * E), 1e-12));
}

TEST_CASE("the force is the derivative of what a formula says is stored") {
  check_rate(Hertz(ball), 0.1);
  for (double const s : {0.6, 1.5, 2.5})
    check_rate(Jkr(ball, w), s);
  for (double const lambda : {0.1, 1.0, 4.0})
    for (double const s : {0.5, 0.9, 1.3, 2.5})
      check_rate(Maugis(ball, w, traction(lambda)), s);
  for (double const work : {0.0, 0.002})
    for (double const s : {0.2, 0.4})
      check_rate(Wave({E, 1e-5, 1e-3, 1e-3, 0}, work), s);
  auto const punch = Punch(E, R).at(0.01);
  CHECK(punch.strain == near(0.5 * punch.force * punch.depth, 1e-12));
}

TEST_CASE("what DMT and lines store is not given, with a reason") {
  CHECK_FALSE(Dmt(ball, w).gives().no_energy.empty());
  CHECK_FALSE(Line(E, R, 0).gives().no_energy.empty());
  CHECK(Hertz(ball).gives().no_energy.empty());
  CHECK(Maugis(ball, w, 1e6).gives().no_energy.empty());
}

TEST_CASE("pressures of waves sum up to their force, the surface's mean stays, and energies agree") {
  constexpr double L = 1e-3, D = 1e-5;
  for (double const work : {0.0, 0.002})
    for (double const s : {0.3, 0.8, 1.5}) {
      Wave const wave({E, D, L, L, 0}, work);
      auto const state = wave.at(s);
      auto const profile = wave.profile(s);
      double const edge = 0.5 * std::min(s, 1.0) * L;
      auto const over = [&](auto const& f) {
        return 2 * (integral(f, 0, edge) + (s < 1 ? integral(f, edge, 0.5 * L) : 0));
      };
      CAPTURE(work);
      CAPTURE(s);
      CHECK(over([&](double x) { return profile(x).pressure; }) == near(state.force, 1e-4));
      CHECK(std::abs(over([&](double x) { return profile(x).sink; })) < 1e-5 * D * L);
      CHECK(over([&](double x) { return 0.5 * profile(x).pressure * profile(x).sink; }) ==
            near(state.strain, 1e-4));
      CHECK(profile(0).pressure == near(state.peak, 1e-10));
      CHECK(profile(0.1 * L + 3 * L).sink == near(profile(0.1 * L).sink, 1e-9));
      if (s < 1)
        CHECK(profile(0.4999 * L).touches == false);
    }
}

TEST_CASE("pressures of lines sum up to their force, and far from them the surface has its slope") {
  for (double const work : {0.0, 0.05}) {
    Line const line(E, R, work);
    double const s = work > 0 ? 1.7 : 0.1;
    auto const state = line.at(s);
    auto const profile = line.profile(s);
    double const a = 0.5 * state.area;
    CHECK(2 * integral([&](double x) { return profile(x).pressure; }, 0, a) == near(state.force, 1e-4));
    CHECK(profile(0).pressure == near(state.peak, 1e-12));
    double const far = 500 * a, h = 1e-3 * far;
    CHECK((profile(far + h).sink - profile(far - h).sink) / (2 * h) ==
          near(-2 * state.force / (pi * E * far), 1e-4));
    CHECK(profile(1.0001 * a).sink == near(profile(0.9999 * a).sink, 5e-2));
  }
}
