// Softening bonds without friction: the Newton solver stays on the branch of its start.
#include <doctest/doctest.h>

#include "contact/solvers.hpp"
#include "contact/solvers/descent.hpp"
#include "contact/solvers/minimum.hpp"
#include "contact/solvers/newton.hpp"
#include "interface/laws.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

constexpr double C = 1e9, w = 1, u0 = 3.1622776601683795e-5; // N/m^3, J/m^2, sqrt(w/C) in m

/// n bonded points of area 1e-6 m^2, each on a spring of its own of the compliance softness/(C area), and
/// tied to each other by a common compliance.
Problem bonded(int dim, int n, double softness, double common) {
  Problem problem;
  problem.dim = dim;
  interface::Rcc law;
  law.w = w;
  law.C_n = law.C_t = law.C_t2 = C;
  problem.adhesions = {law};
  double const unit = 1 / (C * 1e-6);
  problem.W = softness * unit * Dense::Identity(dim * n, dim * n);
  problem.W.entries() += common * unit * Dense::Ones(dim * n, dim * n);
  problem.free.setZero(dim * n);
  for (int i = 0; i < n; ++i) {
    ProblemPoint point{1e-6, 0, 0, {}};
    point.bond.old.beta = 1;
    point.bond.dt = 1;
    problem.points.push_back(point);
  }
  return problem;
}

/// n points 1 mm apart under an arm of 1 m width that is held at their end, glued, and drawn up at the other.
/// skew: what normals that turn leave of W not symmetric, over the compliance of a point alone.
Problem arm(int n, double stiffness, double skew) {
  double const spacing = 1e-3, bending = 70e9 * 1.5e-3 * 1.5e-3 * 1.5e-3 / 12, alone = 4e-8; // N m^2, m/N
  Problem problem;
  problem.dim = 2;
  interface::Bilinear law;
  law.K = stiffness;
  law.sigma_n = 30e6;
  law.sigma_t = 40e6;
  law.G_I = 250;
  law.G_II = 700;
  problem.adhesions = {law};
  problem.W = alone * Dense::Identity(2 * n, 2 * n);
  problem.free.setZero(2 * n);
  for (int i = 0; i < n; ++i) {
    ProblemPoint point{spacing, 0, 0, {}};
    point.bond.old.beta = 1;
    point.bond.dt = 1;
    problem.points.push_back(point);
    double const a = spacing * (i + 1), end = spacing * n + 30e-3;
    for (int j = 0; j < n; ++j) {
      double const b = spacing * (j + 1), shorter = std::min(a, b), longer = std::max(a, b);
      problem.W.entries()(2 * i, 2 * j) += shorter * shorter * (3 * longer - shorter) / (6 * bending);
      problem.W.entries()(2 * i + 1, 2 * j + 1) += shorter / (70e9 * 1.5e-3);
    }
    problem.free[2 * i] = 4000 * a * a * (3 * end - a) / (6 * bending);
    for (int j = 0; j < i; ++j) {
      double const turned = skew * alone * std::cos(3.0 * i + j);
      problem.W.entries()(2 * i, 2 * j + 1) += turned;
      problem.W.entries()(2 * j + 1, 2 * i) -= turned;
    }
  }
  return problem;
}

/// The first point downhill of the start where a bonded point on its spring stays, found in small steps; m.
double downhill(Problem const& problem) {
  double const small = 1e-3 * interface::scales(problem.adhesions[0]).opening;
  auto const force = [&](double x) {
    auto const pull =
        interface::adhere<1>(problem.adhesions[0], problem.points[0].bond, Local<1>(x)).traction;
    return (problem.free[0] - x) / problem.W.diagonal(0) + problem.points[0].area * pull[0];
  };
  double x = problem.start[0];
  double const step = force(x) > 0 ? small : -small;
  while (x + step >= 0 && force(x) * step > 0)
    x += step;
  return std::max(x, 0.0);
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("from anywhere between two answers a bonded point goes to the one that is downhill") {
    for (auto const& named : adhesions()) {
      auto const scales = interface::scales(named.law);
      Problem problem;
      problem.dim = 1;
      problem.adhesions = {named.law};
      problem.points = {{1, 0, 0, {interface::initial_bond(named.law, 0), 0.01, false}}};
      for (double const softness : {5.0, 10.0, 14.0, 30.0})
        for (double const start : {0.0, 0.2, 0.63, 0.7, 1.0, 1.5})
          for (double const load : {0.3, 0.7, 0.95, 1.4}) {
            CAPTURE(named.name);
            CAPTURE(softness);
            CAPTURE(start);
            CAPTURE(load);
            problem.W = Dense::Constant(1, 1, softness / scales.softening);
            problem.start = Vector::Constant(1, start * scales.opening);
            problem.free = Vector::Constant(1, load * (1 + softness) * scales.opening);
            auto const found = descend(problem, Vector::Zero(1), 1000);
            REQUIRE(found.has_value());
            bool const corners =
                std::holds_alternative<Bilinear>(named.law) || std::holds_alternative<Dugdale>(named.law);
            CHECK((found->settled || corners)); // which may stop it
            if (!found->settled)
              continue;
            double const x = displacement(problem, found->force)[0];
            CHECK(std::abs(x - downhill(problem)) < 2e-3 * scales.opening);
          }
    }
  }

  TEST_CASE("a bond on a soft spring holds up to the fold of its branch and no further") {
    for (int const dim : {1, 2, 3})
      for (double const softness :
           {0.5, 2.0, 20.0}) { // x = f - W p has its fold at x = u0, f = (1 + softness) u0
        INFO("dim " << dim << ", softness " << softness);
        auto problem = bonded(dim, 1, softness, 0);
        double const fold = (1 + softness) * u0;
        CHECK(may_snap(problem));
        Vector force = Vector::Zero(dim);
        for (int step = 1; step <= 100; ++step) {
          problem.free[0] = 0.011 * step * fold;
          auto const answer = make_solver(BipotentialNewton{})->solve(problem, force);
          REQUIRE(answer.converged);
          force = answer.force;
          problem.start = displacement(problem, force);
          double const opening = problem.start[0];
          if (problem.free[0] < 0.999 * fold)
            CHECK(opening == doctest::Approx(problem.free[0] / (1 + softness)).epsilon(1e-9));
          else if (softness > 1)
            CHECK(opening > 2 * u0);
        }
      }
  }

  TEST_CASE("a row that opens like a wedge breaks from its end, and the answers are those of the judge") {
    int const n = 30;
    for (double const common : {0.0, 0.5}) {
      auto problem = bonded(1, n, 3, common);
      Vector force = Vector::Zero(n);
      int broken = 0;
      for (int step = 1; step <= 60; ++step) {
        for (int i = 0; i < n; ++i)
          problem.free[i] = 0.21 * step * u0 * i / n;
        auto const answer = make_solver(BipotentialNewton{})->solve(problem, force);
        REQUIRE(answer.converged);
        CHECK(judge(problem, answer.force).relative() <= 1e-10);
        force = answer.force;
        Vector const x = problem.start = displacement(problem, force);
        int now = 0;
        for (int i = 0; i < n; ++i) {
          now += x[i] > u0 ? 1 : 0;
          CHECK((common > 0 || i == 0 || x[i] >= x[i - 1] - 1e-9 * u0));
        }
        if (common == 0) { // each on its own: the branch ends at (1 + softness) u0
          for (int i = 0; i < n; ++i)
            CHECK((x[i] > u0) == (problem.free[i] > 4 * u0));
        }
        CHECK(now >= broken);
        broken = now;
      }
      CHECK(broken > 10);
    }
  }

  TEST_CASE("a row that is opened a little further is answered with the factors of the problem before") {
    int const n = 60;
    auto problem = bonded(2, n, 3, 0.5);
    for (int i = 0; i < n; ++i)
      problem.free[2 * i] = 5.99 * u0 * i / n;
    std::unique_ptr<MinimumMemory> memory, none;
    auto const old = minimise(problem, Vector::Zero(2 * n), 1000, none);
    REQUIRE(old);
    problem.start = displacement(problem, old->force);
    double before = 0;
    for (int step = 0; step < 5; ++step) {
      for (int i = 0; i < n; ++i)
        problem.free[2 * i] = (6 + 0.02 * step) * u0 * i / n;
      none.reset();
      auto const with = minimise(problem, Vector::Zero(2 * n), 1000, memory);
      auto const without = minimise(problem, Vector::Zero(2 * n), 1000, none);
      REQUIRE((with && with->settled && without && without->settled));
      INFO("step " << step << ": work " << with->work << ", without " << without->work);
      CHECK((with->force - without->force).norm() <= 1e-8 * without->force.norm());
      CHECK(judge(problem, with->force).relative() <= 1e-9);
      if (step > 0)
        CHECK(with->work < 0.6 * without->work);
      before = with->work;
    }
    memory->forget(); // but for what W says, which no answer and no count may tell
    auto const anew = minimise(problem, Vector::Zero(2 * n), 1000, memory);
    none.reset();
    auto const first = minimise(problem, Vector::Zero(2 * n), 1000, none);
    REQUIRE((anew && first));
    CHECK(anew->force == first->force);
    CHECK(anew->work == first->work);
    CHECK(anew->work > before);
  }

  TEST_CASE("from closed contact, where no bond pulls yet, every law is followed to its minimum") {
    for (auto const& named : adhesions()) {
      auto const scales = interface::scales(named.law);
      Problem problem;
      problem.dim = 1;
      problem.adhesions = {named.law};
      problem.points = {{1, 0, 0, {interface::initial_bond(named.law, 0), 0.01, false}}};
      problem.start = Vector::Zero(1);
      for (double const load : {0.1, 0.3, 0.7}) {
        CAPTURE(named.name);
        CAPTURE(load);
        problem.W = Dense::Constant(1, 1, 0.5 / scales.softening);
        problem.free = Vector::Constant(1, load * scales.opening);
        std::unique_ptr<MinimumMemory> none;
        auto const found = minimise(problem, Vector::Zero(1), 1000, none);
        REQUIRE(found);
        CHECK(found->settled);
        CHECK(judge(problem, found->force).relative() <= 1e-9);
      }
    }
  }

  TEST_CASE("what is left of forces that are all but zero is not followed for long") {
    int const n = 40;
    auto problem = bonded(2, n, 30, 0.5);
    interface::Bilinear law;
    law.K = C;
    law.sigma_n = law.sigma_t = 0.05 * C * u0;
    law.G_I = law.G_II = w;
    problem.adhesions = {law};
    for (int i = 0; i < n; ++i) { // driven back to where nothing pulls, but for rounding
      problem.free[2 * i] = -1e-22;
      problem.free[2 * i + 1] = 1e-10 * std::sin(3.0 * i);
      problem.points[static_cast<std::size_t>(i)].bond.old.stretch[0] =
          -(1 + 1e-11) * problem.free[2 * i + 1];
    }
    problem.start = Vector::Zero(2 * n);
    std::unique_ptr<MinimumMemory> none;
    auto const found = minimise(problem, Vector::Zero(2 * n), 1000, none);
    REQUIRE(found);
    CHECK(found->settled);
    CHECK(found->iterations < 5);
  }

  TEST_CASE("only what may have several answers is searched downhill") {
    CHECK_FALSE(may_snap(bonded(2, 4, 0.3, 0)));
    CHECK(may_snap(bonded(2, 4, 0.4, 0)));
    auto rubbing = bonded(2, 4, 3, 0);
    rubbing.points[2].mu = 0.1;
    CHECK_FALSE(may_snap(rubbing));
    auto dry = bonded(2, 4, 3, 0);
    for (auto& point : dry.points)
      point.adhesion = -1;
    CHECK_FALSE(may_snap(dry));
  }

  TEST_CASE("an answer leaps if it carries a bond further than its opening, and only then") {
    auto problem = bonded(2, 3, 3, 0);
    problem.start.setZero(6);
    problem.free[4] = 0.9 * u0;
    Vector const none = Vector::Zero(6);
    CHECK_FALSE(leaps(problem, none, none));
    problem.free[4] = 1.1 * u0;
    CHECK(leaps(problem, none, none));
    problem.start[4] = 0.2 * u0;
    CHECK_FALSE(leaps(problem, none, none));
    problem.free[5] = -1.1 * u0; // along the surface as well
    CHECK(leaps(problem, none, none));
    problem.points[2].adhesion = -1;
    CHECK_FALSE(leaps(problem, none, none));
  }

  TEST_CASE("without a start an answer leaps from where its guess lies") {
    auto problem = bonded(1, 1, 3, 0);
    problem.free[0] = 2 * u0;
    Vector const guess = Vector::Constant(1, -2 * u0 / problem.W.diagonal(0));
    CHECK(leaps(problem, guess, Vector::Zero(1)));
    CHECK_FALSE(leaps(problem, 0.1 * guess, Vector::Zero(1)));
  }

  TEST_CASE(
      "a closed point of a body that softens, W below zero, stays closed from forces that are an answer") {
    for (int const dim : {1, 2, 3}) {
      auto problem = bonded(dim, 1, 1, 0);
      double const unit = problem.W.diagonal(0), force = 2;
      problem.W.entries()(0, 0) = -unit;
      problem.free[0] = unit * force;
      Vector answer = Vector::Zero(dim);
      answer[0] = force;
      REQUIRE(displacement(problem, answer)[0] == 0);
      for (auto const& choice : {SolverChoice(BipotentialNewton{}), SolverChoice(GaussSeidel{})}) {
        auto const found = make_solver(choice)->solve(problem, answer);
        REQUIRE(found.converged);
        CHECK(found.force == answer);
      }
    }
  }

  TEST_CASE("a bonded point that nothing moves and that just touches pulls as its law says") {
    for (int const dim : {2, 3}) {
      auto problem = bonded(dim, 1, 0, 0);
      problem.free[1] = 0.1 * u0;
      auto const newton = make_solver(BipotentialNewton{})->solve(problem, Vector::Zero(dim));
      REQUIRE(newton.converged);
      CHECK(newton.force[0] == 0);
      CHECK(newton.force[1] == doctest::Approx(-1e-6 * C * 0.1 * u0).epsilon(1e-12));
      auto const sweeps = make_solver(GaussSeidel{})->solve(problem, Vector::Zero(dim));
      REQUIRE(sweeps.converged);
      CHECK((sweeps.force - newton.force).norm() == 0);
    }
  }

  TEST_CASE("what a descent ends with is an answer, of slender arms too and where W is not symmetric") {
    for (double const stiffness : {1e13, 1e14, 1e15})
      for (double const skew : {0.0, 1e-3, 0.1}) {
        CAPTURE(stiffness);
        CAPTURE(skew);
        auto problem = arm(60, stiffness, skew);
        problem.start = Vector::Zero(problem.free.size());
        auto const found = descend(problem, problem.start, 100);
        REQUIRE(found.has_value());
        CHECK(found->settled);
        CHECK(judge(problem, found->force).relative() <= 1e-8); // rounding of x times the stiffness
        CHECK(found->force.maxCoeff() > 0);                     // some drawn, some pressed
        CHECK(found->force.minCoeff() < 0);
        auto const answer = make_solver(BipotentialNewton{})->solve(problem, problem.start);
        CHECK(answer.converged);
        CHECK(answer.method == Method::descent);
        CHECK(answer.iterations <= found->iterations + 6);
      }
  }

  TEST_CASE("bonds go downhill beside points whose friction is held, and from there Newton answers") {
    for (double const mu : {0.1, 0.4}) {
      CAPTURE(mu);
      auto problem = arm(60, 1e14, 1e-3);
      problem.start = Vector::Zero(problem.free.size());
      for (Index i = 0; i < 60; i += 3) { // pressed where the arm goes down
        auto& point = problem.points[static_cast<std::size_t>(i)];
        point.adhesion = -1;
        point.mu = mu;
        problem.free[2 * i + 1] = 2e-8;
      }
      Vector force = problem.start;
      bool found = false;
      for (int k = 0; k < 4 && !found; ++k) {
        auto const end = descend_beside_friction(problem, force, 200);
        REQUIRE(end.has_value());
        auto const answer = newton_from(problem, end->force, 1e-10);
        found = answer.converged;
        force = answer.force;
      }
      CHECK(found);
      CHECK(judge(problem, force).relative() <= 1e-8);
      bool rubs = false;
      for (Index i = 0; i < 60; i += 3)
        rubs = rubs || (force[2 * i] > 0 && force[2 * i + 1] != 0);
      CHECK(rubs);
      problem.points[0].mu = 0;
      CHECK(descend_beside_friction(problem, force, 200).has_value());
      for (auto& point : problem.points)
        point.mu = 0;
      CHECK_FALSE(descend_beside_friction(problem, force, 200).has_value()); // nothing rubs
    }
  }

  TEST_CASE("a singular W has no potential in x") {
    auto problem = bonded(1, 3, 3, 0);
    problem.W.entries().setOnes();
    CHECK_FALSE(descend(problem, Vector::Zero(3), 100).has_value());
  }
}
