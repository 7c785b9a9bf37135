// Points with every friction and adhesion law: the natural map's derivative, and all solvers against closed
// forms.
#include <doctest/doctest.h>

#include "contact/solvers.hpp"
#include "differences.hpp"
#include "interface/laws.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// One point on springs of this compliance, pressed by `pressure` (area 1 m^2) and dragged; the last
/// component is dragged most.
template<int D> Problem dragged(FrictionLaw const& law, double pressure, double drag) {
  Problem problem;
  problem.dim = D;
  problem.W = 1e-4 * Dense::Identity(D, D);
  problem.free = Vector::Zero(D);
  problem.free[0] = -1e-4 * pressure;
  if constexpr (D > 1)
    problem.free[D - 1] = drag;
  if constexpr (D > 2)
    problem.free[1] = 0.75 * drag;
  interface::Law const pair{law, {}};
  problem.points = {{1, pair.mu(), -1, {{}, 0.1, false}, pair.mu_follows() ? 0 : -1}};
  if (pair.mu_follows())
    problem.frictions = {law};
  return problem;
}

/// |r_t| where the point slips, by the law at pressure p and this way in 0.1 s.
double friction_at(FrictionLaw const& law, double p, double way) {
  interface::Sliding<2> at;
  at.dry[0] = p;
  at.x[1] = way;
  at.dt = 0.1;
  return p * coefficient<2>(law, at).mu;
}

template<int D> void check_solvers(NamedFriction const& named, double pressure, double drag) {
  for (auto const& [name, choice] : all_solvers()) {
    INFO(named.name << ", " << name << ", D = " << D << ", pressure " << pressure << ", drag " << drag);
    auto const problem = dragged<D>(named.law, pressure, drag);
    auto const answer = solve(choice, problem);
    REQUIRE(answer.converged);
    Vector const x = displacement(problem, answer.force);
    CHECK(answer.force[0] == doctest::Approx(pressure).epsilon(1e-8));
    double const shear = answer.force.tail(D - 1).norm(), way = x.tail(D - 1).norm();
    if (way > 1e-9)
      CHECK(shear == doctest::Approx(friction_at(named.law, pressure, way)).epsilon(1e-7));
    else
      CHECK(shear <= friction_at(named.law, pressure, 0) * (1 + 1e-8));
    CHECK((way > 1e-9) == (problem.free.tail(D - 1).norm() > 1e-4 * friction_at(named.law, pressure, 0)));
  }
}

/// d(residual)/dp along x = free + W p.
template<int D> void check_map(Problem const& problem, Local<D> const& p) {
  double const rho = natural_scale(problem, 0);
  LocalMatrix<D> const W = problem.W.block<D>(0);
  Local<D> const free = problem.free.head<D>();
  auto const at = [&](Vector const& force) {
    Local<D> const f = force;
    return evaluate<D>(problem, 0, f, Local<D>(free + W * f), rho);
  };
  auto const here = at(p);
  LocalMatrix<D> const J =
      here.residual_by_dry + (here.residual_by_x - here.residual_by_dry * here.adhesion_by_x) * W;
  auto const rate = test::rate([&](Vector const& f) { return Vector(at(f).residual); }, Dense(J), p, 0.02);
  INFO("D = " << D << ", status " << static_cast<int>(here.status) << ", p = " << p.transpose());
  CHECK_MESSAGE(rate.second_order, rate.words());
}

template<int D> Problem bonded(AdhesionLaw const& law, double compliance, double open) {
  Problem problem;
  problem.dim = D;
  problem.W = compliance * Dense::Identity(D, D);
  problem.free = Vector::Constant(D, 0.3 * open);
  problem.free[0] = open;
  problem.adhesions = {law};
  problem.points = {{1, 0.4, 0, {initial_bond(law, 0), 0.01, true}}};
  return problem;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("every friction law with every solver: slip at the law's traction, stick below, in 2D and 3D") {
    for (auto const& named : frictions())
      for (double const pressure : {20.0, 45.0, 120.0})
        for (double const drag : {1e-4, 4e-3, 0.03}) {
          check_solvers<2>(named, pressure, drag);
          check_solvers<3>(named, pressure, drag);
        }
  }

  TEST_CASE("in one component no friction law changes anything") {
    for (auto const& named : frictions())
      for (auto const& [name, choice] : all_solvers()) {
        CAPTURE(named.name);
        auto const answer = solve(choice, dragged<1>(named.law, 70, 0));
        CHECK(answer.converged);
        CHECK(answer.force[0] == doctest::Approx(70).epsilon(1e-9));
      }
  }

  TEST_CASE("the natural map's derivative with a coefficient that follows pressure and speed") {
    for (auto const& named : frictions())
      for (double const area : {1.0, 0.5})
        for (double const drag : {-0.03, 0.02}) {
          CAPTURE(named.name);
          auto plane = dragged<2>(named.law, 50, drag);
          auto space = dragged<3>(named.law, 50, drag);
          plane.points[0].area = space.points[0].area = area;
          for (double const size : {-60.0, 20.0, 55.0, 150.0}) {
            check_map<2>(plane, {size, 17});
            check_map<3>(space, {size, 17, -8});
          }
        }
  }

  TEST_CASE("friction that follows the pressure under a bond that takes it away: the map's derivative") {
    auto law = bilinear_sample();
    law.friction = BondFriction::damage;
    for (double const open : {0.003, 0.01}) {
      Problem problem = bonded<3>(law, 1e-4, open);
      problem.frictions = {PressureFriction{0.9, 0.2, 80}};
      problem.points[0].friction = 0;
      for (double const size : {40.0, 70.0}) {
        check_map<3>(problem, {size, 9, -4});
        check_map<3>(problem, {-size, 9, -4});
      }
    }
  }

  TEST_CASE("every adhesion law with every solver: a pulled point behind a stiff spring holds its traction") {
    for (auto const& named : adhesions()) {
      double const stiffness = 4 * scales(named.law).softening; // beyond the limit of uniqueness
      for (auto const& [name, choice] : all_solvers(1e-9))
        for (double const open : {-0.01, 0.002, 0.012, 0.03, 0.08}) {
          INFO(named.name << ", " << name << ", opened by " << open);
          auto const plane = bonded<2>(named.law, 1 / stiffness, open);
          auto const space = bonded<3>(named.law, 1 / stiffness, open);
          auto const a = solve(choice, plane), b = solve(choice, space);
          if (!std::holds_alternative<BipotentialUzawa>(choice)) { // which may give up, but must say so
            REQUIRE(a.converged);
            REQUIRE(b.converged);
          }
          CHECK(b.converged == (judge(space, b.force).relative() <= 1e-9));
          if (!a.converged)
            continue;
          Local<2> const x = displacement(plane, a.force);
          double const pull = -adhere<2>(named.law, plane.points[0].bond, {0, 0}).traction[0];
          if (open * stiffness > pull) {
            auto const held = adhere<2>(named.law, plane.points[0].bond, x).traction;
            CHECK((a.force - Vector(held)).norm() <= 1e-6 * scales(named.law).strength);
            CHECK(x[0] > 0);
          } else {
            CHECK(std::abs(x[0]) < 1e-8);
          }
        }
    }
  }
}
