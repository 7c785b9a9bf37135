// What holds for every adhesion law: derivatives, energy balance, damage that stays, potentials that do not
// care for the way.
#include <doctest/doctest.h>

#include "differences.hpp"
#include "interface/laws.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

constexpr double h = 2e-4; // m, largest step of the differences

/// No kink of the law within reach of the differences.
template<int D> bool smooth(AdhesionLaw const& law, BondStep const& step, Local<D> const& x) {
  auto const here = adhere<D>(law, step, x);
  double const scale = 1 + here.traction_by_x.norm();
  for (int k = 0; k < D; ++k)
    for (double const side : {-1.0, 1.0}) {
      auto const there = adhere<D>(law, step, x + side * h * Local<D>::Unit(k));
      if ((there.traction_by_x - here.traction_by_x).norm() > 0.4 * scale)
        return false;
      if (here.beta_by_x.isZero(0) != there.beta_by_x.isZero(0))
        return false;
    }
  return true;
}

template<int D> void check_derivatives(NamedAdhesion const& named, BondStep const& step, Local<D> const& x) {
  auto const& law = named.law;
  auto const at = adhere<D>(law, step, x);
  auto const traction =
      test::rate([&](Vector const& y) { return Vector(adhere<D>(law, step, Local<D>(y)).traction); },
                 Dense(at.traction_by_x), x, h, 100);
  auto const beta = test::rate(
      [&](Vector const& y) { return Vector::Constant(1, adhere<D>(law, step, Local<D>(y)).beta).eval(); },
      Dense(at.beta_by_x.transpose()), x, h, 1);
  auto const friction = test::rate(
      [&](Vector const& y) { return Vector::Constant(1, adhere<D>(law, step, Local<D>(y)).friction).eval(); },
      Dense(at.friction_by_x.transpose()), x, h, 1);
  INFO(named.name << ", D = " << D << ", beta " << at.beta << ", x = " << x.transpose());
  CHECK_MESSAGE(traction.second_order, "traction: " << traction.words());
  CHECK_MESSAGE(beta.second_order, "beta: " << beta.words());
  CHECK_MESSAGE(friction.second_order, "friction: " << friction.words());
  CHECK(traction.errors[3] <= 1e-4 * (1 + traction.scale));
}

/// How many random states were smooth enough for differences.
template<int D> int check_random_states(NamedAdhesion const& named, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  int checked = 0;
  for (int k = 0; k < 40; ++k) {
    BondStep step{{0.05 + 0.95 * uniform(random), {0, 0}}, 0.02, uniform(random) < 0.5};
    Local<D> x = Local<D>::Zero();
    x[0] = 0.06 * uniform(random) - 0.005;
    for (int t = 1; t < D; ++t) {
      step.old.stretch[t - 1] = 0.03 * (uniform(random) - 0.5);
      x[t] = 0.03 * (uniform(random) - 0.5);
    }
    if (!smooth<D>(named.law, step, x))
      continue;
    ++checked;
    check_derivatives<D>(named, step, x);
  }
  return checked;
}

/// A smooth way out and back, to the side and about.
struct Wander {
  double a, b, c;
  Eigen::Vector3d operator()(double t) const {
    return 0.03 * Eigen::Vector3d(1 + std::sin(a * t - 1.5708), std::sin(b * t), 0.7 * (1 - std::cos(c * t)));
  }
};

Wander wander(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(2, 8);
  double const a = uniform(random), b = uniform(random);
  return {a, b, uniform(random)};
}

/// Does it pull most where surfaces touch?
bool strongest_at_none(AdhesionLaw const& law) {
  return std::holds_alternative<Attraction>(law);
}

} // namespace

TEST_SUITE("interface") {
  TEST_CASE("the samples hold every adhesion and friction law") {
    std::vector<int> adhesion(std::variant_size_v<AdhesionLaw>), friction(std::variant_size_v<FrictionLaw>);
    for (auto const& named : adhesions())
      ++adhesion[named.law.index()];
    for (auto const& named : frictions())
      ++friction[named.law.index()];
    CHECK(std::ranges::count(adhesion, 0) == 0);
    CHECK(std::ranges::count(friction, 0) == 0);
  }

  TEST_CASE("adhesion laws: derivatives by x match differences at second order in one to three components") {
    std::mt19937 random(3);
    for (auto const& named : adhesions()) {
      CAPTURE(named.name);
      CHECK(check_random_states<1>(named, random) >= 8);
      CHECK(check_random_states<2>(named, random) >= 8);
      CHECK(check_random_states<3>(named, random) >= 8);
    }
  }

  TEST_CASE("adhesion laws: work = stored + dissipated on wandering paths, closing with the step") {
    for (auto const& named : adhesions()) {
      CAPTURE(named.name);
      double scale = 0;
      auto const misfit = [&](int steps) {
        double sum = 0;
        for (unsigned seed = 1; seed <= 6; ++seed) {
          auto const a = account(named.law, wander(seed), steps);
          CHECK(a.least >= -1e-14);
          sum += std::abs(a.work - a.stored - a.dissipated);
          scale = std::max(scale, a.largest * 0.06);
        }
        return sum;
      };
      double const coarse = misfit(500), fine = misfit(2000), finest = misfit(8000);
      CHECK(coarse < 0.05 * scale);
      CHECK(fine < 0.35 * coarse); // first order: a quarter; most laws are of second
      CHECK(finest < 0.35 * fine);
    }
  }

  TEST_CASE("bonds that follow their opening: straight ways close in any step, also where the mode changes") {
    for (auto const& named : adhesions()) {
      if (evolves(named.law))
        continue;
      CAPTURE(named.name);
      double misfit = 0, by_end = 0;
      for (unsigned seed = 1; seed <= 6; ++seed) {
        auto const a = account(named.law, wander(seed), 60);
        misfit = std::max(misfit, std::abs(a.exact_work - a.stored - a.exact_loss));
        by_end = std::max(by_end, std::abs(a.exact_work - a.stored - a.dissipated));
      }
      double const taken = scales(named.law).work;
      CHECK(misfit < 1e-8 * taken); // 60 steps, each to 1e-10
      if (irreversible(named.law) && std::visit([](auto const& l) { return l.tangential(); }, named.law))
        CHECK(by_end > 1e-4 * taken); // of the mode of each step's end
    }
  }

  TEST_CASE("bonds that evolve: what a step loses beside trapezia is what the law says") {
    for (auto const& named : adhesions()) {
      CAPTURE(named.name);
      CHECK(bond_time(named.law) >= 0);
      if (!evolves(named.law)) {
        CHECK(bond_time(named.law) == 0);
        CHECK(integration_loss(named.law, {}) == 0);
        CHECK(dissipation(named.law, BondMove{}) == 0);
        continue;
      }
      for (unsigned seed = 1; seed <= 6; ++seed) {
        auto const a = account(named.law, wander(seed), 300);
        CHECK(std::abs(a.predicted) > 1e-4);
        CHECK(a.by_moves == doctest::Approx(a.dissipated).epsilon(1e-12));
        CHECK(a.work - a.stored - a.dissipated == doctest::Approx(a.predicted).epsilon(1e-10));
      }
    }
  }

  TEST_CASE("damage stays: beta never grows, unloading is straight to the origin, at rest nothing is left") {
    for (auto const& named : adhesions()) {
      if (!irreversible(named.law))
        continue;
      CAPTURE(named.name);
      Bond bond = initial_bond(named.law, 0);
      CHECK(bond.beta == 1);
      Local<3> const out(0.02, 0.008, -0.004);
      auto const there = adhere<3>(named.law, {bond, 1, true}, out);
      bond = advance<3>(named.law, {bond, 1, true}, out);
      CHECK(bond.beta < 1);
      CHECK(bond.beta > 0);
      for (double const part :
           {0.75, 0.5, 0.0}) { // the slip of the step leads from the stretch to part of it
        BondStep const step{bond, 1, true};
        Local<3> const x(part * out[0], part * out[1] - bond.stretch[0], part * out[2] - bond.stretch[1]);
        auto const at = adhere<3>(named.law, step, x);
        CHECK((at.traction - part * there.traction).norm() <= 1e-12 * there.traction.norm());
        CHECK(at.beta == bond.beta);
        CHECK(dissipation<3>(named.law, step, x) == 0);
        bond = advance<3>(named.law, step, x);
      }
      CHECK(bond_energy(named.law, bond, 0) == doctest::Approx(0).epsilon(1e-15));
      std::vector<double> betas{1};
      bond = initial_bond(named.law, 0);
      for (int k = 1; k <= 300; ++k) {
        Eigen::Vector3d const x = wander(4)(k / 300.0), move = x - wander(4)((k - 1) / 300.0);
        bond = advance<3>(named.law, {bond, 1, true}, {x[0], move[1], move[2]});
        betas.push_back(bond.beta);
      }
      CHECK(std::ranges::is_sorted(betas, std::greater{}));
      CHECK(betas.back() < 0.9);
    }
  }

  TEST_CASE("what a bond loses is a number from zero up, however small the opening") {
    for (auto const& named : adhesions())
      for (double size = 1e-30; size < 0.1; size *= 1.3)
        for (Local<3> const& way : {Local<3>(1, 0, 0), Local<3>(0, 1, 0), Local<3>(0.3, -0.5, 0.8)}) {
          CAPTURE(named.name);
          CAPTURE(size);
          double const loss = dissipation<3>(named.law, {initial_bond(named.law, 0), 1, true}, size * way);
          CHECK(loss >= 0);
          CHECK(std::isfinite(loss));
        }
  }

  TEST_CASE("a bond that is gone pulls no more and does not come back") {
    for (auto const& named : adhesions()) {
      if (!irreversible(named.law))
        continue;
      CAPTURE(named.name);
      BondStep step{initial_bond(named.law, 0), 1, true};
      step.old = advance<3>(named.law, step, {10, 0, 0});
      CHECK(step.old.beta == 0);
      CHECK(step.old.stretch.isZero(0));
      auto const back = adhere<3>(named.law, step, {0.001, 0.01, 0});
      CHECK(back.traction.isZero(0));
      CHECK(back.beta == 0);
    }
  }

  TEST_CASE("reversible laws: the traction depends on the opening alone, nothing is dissipated") {
    for (auto const& named : adhesions()) {
      if (!reversible(named.law))
        continue;
      CAPTURE(named.name);
      for (unsigned seed = 1; seed <= 4; ++seed) {
        auto const way = wander(seed);
        auto const few = account(named.law, way, 300);
        Eigen::Vector3d const end = way(1);
        auto const one = account(
            named.law, [&](double t) -> Eigen::Vector3d { return t * end; }, 300);
        CHECK((few.traction - one.traction).norm() <= 1e-9 * one.largest);
        CHECK(few.dissipated == 0);
        CHECK(few.bond.beta == doctest::Approx(one.bond.beta).epsilon(1e-9));
      }
    }
  }

  TEST_CASE("work along a straight way: that of many little ones, however long it is, across and along") {
    for (auto const& named : adhesions()) {
      if (evolves(named.law))
        continue;
      CAPTURE(named.name);
      BondStep const step{initial_bond(named.law, 0), 1, false};
      double const u = scales(named.law).opening, work = scales(named.law).work;
      Local<3> const from(0.3 * u, 0, 0), to(4 * u, 3 * u, -u);
      int const parts = 20000;
      double sum = 0;
      for (int k = 0; k < parts; ++k)
        sum += adhere<3>(named.law, step, from + (k + 0.5) / parts * (to - from)).traction.dot(to - from) /
               parts;
      CHECK(std::abs(sum) > 0.05 * work);
      CHECK(work_along(named.law, step, from, to) == doctest::Approx(sum).epsilon(1e-6));
      Local<3> const far = from + 1e12 * (to - from);
      CHECK(work_along(named.law, step, from, to) + work_along(named.law, step, to, far) ==
            doctest::Approx(work_along(named.law, step, from, far)).epsilon(1e-8));
      BondStep const gone{Bond{}, 1, false};
      double const gap = 2 * std::visit([](auto const& law) { return law.range(); }, named.law) + u;
      Local<3> const away(gap, 0, 0), aside(gap, 1e12 * u, 0);
      CHECK(std::abs(work_along(named.law, gone, away, aside)) < 1e-8 * work);
    }
  }

  TEST_CASE("reversible laws reach as far as they say, and damage begins with what the gap leaves") {
    for (auto const& named : adhesions()) {
      CAPTURE(named.name);
      double const range = std::visit([](auto const& law) { return law.range(); }, named.law);
      double const strength = scales(named.law).strength;
      if (reversible(named.law)) {
        BondStep const step{initial_bond(named.law, range), 1, false};
        CHECK(range > 0);
        CHECK(adhere<3>(named.law, step, {range, 0, 0}).traction.norm() < 1e-10 * strength);
        CHECK(std::abs(bond_energy(named.law, step.old, range)) < 1e-10);
        CHECK(initial_bond(named.law, 0).beta == 1);
      } else {
        CHECK(range == 0);
      }
      if (irreversible(named.law)) {
        CHECK(initial_bond(named.law, 1e100).beta == 0);
        double const gap = 0.01;
        Bond const late = initial_bond(named.law, gap);
        Bond const pulled = advance<2>(named.law, {initial_bond(named.law, 0), 1, false}, {gap, 0});
        CHECK(late.beta == doctest::Approx(pulled.beta).epsilon(1e-14));
      }
    }
  }

  TEST_CASE("penetration neither pushes nor damages whatever the law") {
    for (auto const& named : adhesions()) {
      CAPTURE(named.name);
      auto const at = adhere<2>(named.law, {initial_bond(named.law, 0), 1e-3, true}, {-0.02, 0});
      auto const touching = adhere<2>(named.law, {initial_bond(named.law, 0), 1e-3, true}, {0, 0});
      CHECK((at.traction - touching.traction).isZero(1e-12)); // rounding of a fused product
      CHECK((touching.traction.isZero(1e-12) || strongest_at_none(named.law)));
      CHECK(at.traction_by_x(0, 0) == 0);
      CHECK(at.beta == 1);
    }
  }

  TEST_CASE(
      "scales: the strength is reached at the opening said, and no slope is steeper than the softening") {
    for (auto const& named : adhesions()) {
      if (bond_time(named.law) > 0) // its peak follows the speed
        continue;
      CAPTURE(named.name);
      auto const s = scales(named.law);
      Bond bond = initial_bond(named.law, 0);
      double last = -adhere<1>(named.law, {bond, 1, false}, Local<1>(0)).traction[0];
      double peak = last, steepest = 0, work = 0;
      double const end = 3, dx = 5e-5;
      for (double x = dx; x < end; x += dx) {
        double const pull = -adhere<1>(named.law, {bond, 1, false}, Local<1>(x)).traction[0];
        bond = advance<1>(named.law, {bond, 1, false}, Local<1>(x));
        peak = std::max(peak, pull);
        steepest = std::max(steepest, (last - pull) / dx);
        work += 0.5 * (last + pull) * dx;
        last = pull;
      }
      CHECK(peak == doctest::Approx(s.strength).epsilon(2e-3));
      CHECK(steepest == doctest::Approx(s.softening).epsilon(1e-2));
      CHECK(work == doctest::Approx(s.work).epsilon(2e-4));
      double const there =
          -adhere<1>(named.law, {initial_bond(named.law, 0), 1, false}, Local<1>(s.opening)).traction[0];
      double const part = strongest_at_none(named.law) ? std::exp(-1.0) : 1;
      CHECK(there == doctest::Approx(part * s.strength).epsilon(1e-9));
    }
  }
}
