// Where theory promises no single answer, the doubts say so, and only there; two answers are shown to exist.
#include <doctest/doctest.h>
#include <numbers>

#include "contact/problem/held_bonds.hpp"
#include "contact/problem/uniqueness.hpp"
#include "contact/solvers.hpp"
#include "contact/solvers/pivoting.hpp"
#include "interface/laws.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// The end of a rigid uniform rod of mass 1 kg, at this angle to the plane: W times its mass.
Dense rod(double angle) {
  double const c = std::cos(angle), s = std::sin(angle);
  return (Dense(2, 2) << 1 + 3 * c * c, -3 * s * c, -3 * s * c, 1 + 3 * s * s).finished();
}

Doubts doubts_at(Problem const& problem, Vector const& force, Checked which = Checked::bearing) {
  return doubts(problem, force, displacement(problem, force), which);
}

/// Presses, and slides along -t1 so that friction pushes it in.
Doubts pressed_rod(double angle, double mu) {
  auto const problem = one_point(rod(angle), Eigen::Vector2d(-1, -20), mu);
  return doubts_at(problem, Eigen::Vector2d(5, 5 * mu));
}

/// One bonded point that only moves along the normal, W_nn = softness / (A fall) of the bond.
Problem bonded(AdhesionLaw const& law, double softness, double beta) {
  Problem problem;
  problem.dim = 1;
  problem.points = {{0.3, 0, 0, {{beta, {0, 0}}, 0.01, false}}};
  problem.adhesions = {law};
  double const fall = problem.points[0].area * steepest_fall(law, problem.points[0].bond);
  problem.W = Dense::Constant(1, 1, softness / fall);
  problem.free = Vector::Zero(1);
  return problem;
}

/// One point pressed by 3 N, which along a unit direction gives way by softness / (p_n fall), the fall that
/// of a step of 0.1 s; across it by a tenth of that.
Problem dragged(Eigen::Vector2d const& along, double softness, VelocityFriction const& law) {
  auto const fall = 3 * steepest_fall(law, 0.1);
  Problem problem = one_point(Dense::Identity(3, 3), -Eigen::Vector3d(3, 0, 0), law.mu_s);
  Dense W = Dense::Identity(3, 3);
  W.bottomRightCorner(2, 2) =
      softness / fall * (0.9 * along * along.transpose() + 0.1 * Dense::Identity(2, 2));
  problem.W = W;
  problem.dim = 3;
  problem.points[0].bond.dt = 0.1;
  problem.points[0].friction = 0;
  problem.frictions = {law};
  return problem;
}

/// Free gap that leads an open point to x, and whether it ever falls as x grows: then several x have one gap.
bool folds(Problem const& problem) {
  double const far = 100 * scales(problem.adhesions[0]).opening;
  double last = -1;
  for (int k = 0; k <= 200000; ++k) {
    Local<1> const x(far * std::pow(k / 200000.0, 3));
    auto const pull = adhere<1>(problem.adhesions[0], problem.points[0].bond, x).traction[0];
    double const gap = x[0] - problem.W.diagonal(0) * problem.points[0].area * pull;
    if (gap < last - 1e-13)
      return true;
    last = gap;
  }
  return false;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("a rigid rod jams from mu = 4/3 on, and that at an angle of tangent 2") {
    double least = 10, at = 0;
    for (double angle = 0.02; angle < 1.57; angle += 1e-4) {
      Dense const W = rod(angle);
      double const limit = W(0, 0) / std::abs(W(0, 1));
      if (limit < least) {
        least = limit;
        at = angle;
      }
    }
    CHECK(least == doctest::Approx(4.0 / 3).epsilon(1e-7));
    CHECK(std::tan(at) == doctest::Approx(2).epsilon(1e-3));
    CHECK(pressed_rod(std::atan(2), 4.0 / 3 - 1e-9).friction.points == 0);
    auto const jams = pressed_rod(std::atan(2), 4.0 / 3 + 1e-9).friction;
    CHECK(jams.points == 1);
    CHECK(jams.worst == 0);
    CHECK(words(jams).find("more than one answer, or none") != std::string::npos);
    CHECK(words(jams).find("mu below 1.33 makes it single") != std::string::npos);
  }

  TEST_CASE("past the limit a rod may hover or jam, and both are answers") {
    double const mu = 1.6;
    Dense const W = rod(std::atan(2)); // friction p_t = mu p_n against a slide along -t1 pushes the tip in
    for (bool const past : {false, true}) {
      double const coefficient = past ? mu : 1.0;
      auto const problem = one_point(W, Eigen::Vector2d(1e-3, -1), coefficient);
      double const stiffness = W(0, 0) - coefficient * std::abs(W(0, 1));
      double const p = past ? -1e-3 / stiffness : 1e-3 / std::abs(stiffness);
      CHECK(judge(problem, Vector::Zero(2)).residual == 0);
      CHECK((judge(problem, Eigen::Vector2d(p, coefficient * p)).relative() < 1e-12) == past);
      CHECK(doubts_at(problem, Vector::Zero(2)).friction.points == 0); // it does not press
      CHECK((doubts_at(problem, Vector::Zero(2), Checked::all).friction.points == 1) == past);
    }
  }

  TEST_CASE("two points that each have one answer lean together: a symmetric load has three answers") {
    // the foot of a slender column: shifts of both along the surface are much the softest way
    for (double const mu : {0.05, 0.3}) {
      Problem problem;
      problem.points.assign(2, ProblemPoint{});
      problem.points[0].mu = problem.points[1].mu = mu;
      problem.W = (Dense(4, 4) << 1, -0.55, 0.9, -0.45, //
                   -0.55, 10, 0.45, 9.95,               //
                   0.9, 0.45, 1, 0.55,                  //
                   -0.45, 9.95, 0.55, 10)
                      .finished();
      problem.free = Eigen::Vector4d(-1, 0, -1, 0);
      auto const answers = enumerate(problem, Vector::Zero(4)).answers;
      bool several = false, told = false;
      for (auto const& force : answers) {
        CHECK(judge(problem, force).relative() < 1e-8);
        several = several || (force - answers[0]).norm() > 1e-6 * force.norm();
        auto const found = doubts_at(problem, force).friction;
        CHECK(found.points == 0);
        told = told || found.together == 2;
        if (found.any())
          CHECK(words(found).find("may lean to either side") != std::string::npos);
      }
      CAPTURE(mu);
      REQUIRE(!answers.empty());
      CHECK(several == (mu > 0.1));
      CHECK(told == several);
    }
  }

  TEST_CASE("in space the coupling is the length of both tangential entries") {
    auto problem = random_problem(3, 2, 1, 1);
    problem.W.entries().setIdentity();
    problem.W.entries()(3, 4) = 0.6;
    problem.W.entries()(3, 5) = -0.8;
    problem.points[0].mu = problem.points[1].mu = 0.99;
    CHECK_FALSE(doubts_at(problem, Vector::Zero(6), Checked::all).any());
    problem.points[0].mu = problem.points[1].mu = 1.01;
    auto const found = doubts_at(problem, Vector::Zero(6), Checked::all).friction;
    CHECK(found.points == 1);
    CHECK(found.worst == 1);
    CHECK(found.W_nt == doctest::Approx(1));
  }

  TEST_CASE(
      "a bond snaps exactly where its force falls faster than what holds it: every law and any damage") {
    for (auto const& [name, law] : adhesions())
      for (double const beta : {1.0, 0.4, 0.02})
        for (double const softness : {0.97, 1.03}) {
          CAPTURE(name);
          CAPTURE(beta);
          auto const problem = bonded(law, softness, beta);
          if (!problem.W.dense().allFinite()) // viscosity lets nothing fall
            continue;
          CHECK(folds(problem) == (softness > 1));
          CHECK(doubts_at(problem, Vector::Zero(1), Checked::all).softening.any() == (softness > 1));
          CHECK(doubts_at(problem, Vector::Zero(1), Checked::all).softening.points == (softness > 1 ? 1 : 0));
        }
  }

  TEST_CASE("without viscosity the fall of RCC is 3 C beta^2, a broken bond has none") {
    auto const law = rcc_sample(0);
    for (double const beta : {0.1, 0.5, 1.0})
      CHECK(steepest_fall(law, {{beta, {0, 0}}, 0.1, false}) == doctest::Approx(3 * law.C_n * beta * beta));
    CHECK(steepest_fall(law, {{0.1, {0, 0}}, 0.1, true}) == doctest::Approx(3 * law.C_n)); // it may grow
    for (auto const& [name, any] : adhesions())
      if (irreversible(any))
        CHECK(steepest_fall(any, {{0, {0, 0}}, 0.1, false}) == 0);
  }

  TEST_CASE(
      "bonds of unlike areas weaken together as fast as the largest eigenvalue of W times their falls") {
    auto problem = bonded(rcc_sample(0), 1, 1);
    problem.points.push_back(problem.points[0]);
    problem.points[1].area *= 10;
    double const fall = 1 / problem.W.diagonal(0);
    problem.W = (Dense(2, 2) << 1, 0.1, 0.1, 0.05).finished() / fall;
    problem.free.setZero(2);
    // of (1, 1; 0.1, 0.5): trace 1.5, determinant 0.4
    CHECK(doubts_at(problem, Vector::Zero(2), Checked::all).softening.together ==
          doctest::Approx(0.75 + std::sqrt(0.75 * 0.75 - 0.4)).epsilon(1e-9));
  }

  TEST_CASE("friction that falls with speed has one answer exactly where what it holds follows") {
    VelocityFriction const law{0.6, 0.2, 0.05};
    Eigen::Vector2d const along(0.6, -0.8);
    for (double const softness : {0.97, 1.03}) {
      auto const problem = dragged(along, softness, law);
      Vector force = Vector::Zero(3);
      force << 3, 0.5 * 3 * along;
      auto const found = doubts_at(problem, force).weakening;
      CHECK(found.together == doctest::Approx(softness));
      CHECK(found.any() == (softness > 1));
      CHECK(found.points == (softness > 1 ? 1 : 0));
      CHECK_FALSE(doubts_at(problem, Vector::Zero(3)).weakening.any()); // it does not press
      // several slips have one push where the push that a slip takes falls as it grows
      auto const push = [&](double slip) {
        Local<3> const way(0, slip * along[0], slip * along[1]);
        return 3 * steepest_fall(law, 0.1) / softness * slip +
               3 * coefficient<3>(law, {{3, 0, 0}, way, 0.1}).mu;
      };
      bool folds = false;
      for (int k = 0; k < 1000; ++k)
        folds = folds || push(1e-6 * (k + 1)) < push(1e-6 * k);
      CHECK(folds == (softness > 1));
    }
    CHECK(words(doubts_at(dragged(along, 2, law), Eigen::Vector3d(3, 1, -1)).weakening).find("leaps") !=
          std::string::npos);
    for (auto const& [name, any] : frictions())
      if (name != "velocity, falling")
        CHECK(steepest_fall(any, 0.1) == 0);
  }

  TEST_CASE("points on one spring leap together where none would alone") {
    VelocityFriction const law{0.6, 0.2, 0.05};
    auto problem = dragged({1, 0}, 1, law);
    double const fall = 3 * steepest_fall(law, 0.1);
    problem.points.push_back(problem.points[0]);
    problem.dim = 2;
    problem.W = (Dense(4, 4) << 1, 0, 0, 0, 0, 0.6, 0, 0.6, 0, 0, 1, 0, 0, 0.6, 0, 0.6).finished() *
                Eigen::Vector4d(1, 1 / fall, 1, 1 / fall).asDiagonal();
    problem.free = Eigen::Vector4d(-3, 0, -3, 0);
    auto const found = doubts_at(problem, Eigen::Vector4d(3, 1, 3, 1)).weakening;
    CHECK(found.points == 0);
    CHECK(found.together == doctest::Approx(1.2));
    CHECK(words(found).find("1.2 times as fast") != std::string::npos);
    // pushed apart they hold each other
    CHECK(doubts_at(problem, Eigen::Vector4d(3, 1, 3, -1)).weakening.together == doctest::Approx(1.2));
  }

  TEST_CASE("only a bond that pulls is told of") {
    auto const problem = bonded(rcc_sample(0), 2, 1);
    auto const opening = scales(problem.adhesions[0]).opening;
    auto const at = [&](double x) {
      Vector const x_n = Vector::Constant(1, x * opening);
      auto const pull = adhere<1>(problem.adhesions[0], problem.points[0].bond, Local<1>(x_n[0])).traction;
      return doubts(problem, Vector(problem.points[0].area * pull), x_n, Checked::bearing).softening.any();
    };
    CHECK_FALSE(at(0));
    CHECK(at(0.5));
    CHECK(at(2));
    CHECK_FALSE(at(20)); // what is left is no longer felt
  }

  TEST_CASE("bonds that are held together snap together where none would alone") {
    for (double const each : {0.2, 0.3}) { // four bonds on one spring
      auto problem = bonded(rcc_sample(0), 1, 1);
      double const fall = 1 / problem.W.diagonal(0);
      problem.points.assign(4, problem.points[0]);
      problem.W = Dense::Constant(4, 4, each / fall);
      problem.free = Vector::Zero(4);
      auto const found = doubts_at(problem, Vector::Zero(4), Checked::all).softening;
      CHECK(found.together == doctest::Approx(4 * each));
      CHECK(found.points == 0);
      CHECK(found.any() == (each > 0.25));
      if (found.any())
        CHECK(words(found).find("1.2 times as fast") != std::string::npos);
    }
  }

  TEST_CASE(
      "a bond that falls beside an elastic one snaps exactly where both bodies and bond do not hold it") {
    Bilinear law;
    law.K = 10;
    law.sigma_n = law.sigma_t = 1;
    law.G_I = law.G_II = 0.5; // falls from 0.1 to 1
    double const fall = 1 / 0.9;
    auto const force_at = [&](double x) {
      return adhere<1>(AdhesionLaw(law), {{1, {0, 0}}, 0.1, false}, Local<1>(x)).traction[0];
    };
    for (double const softness : {4.5, 5.0}) {
      Problem problem;
      problem.dim = 1;
      problem.points.assign(2, {1, 0, 0, {{1, {0, 0}}, 0.1, false}});
      problem.adhesions = {law};
      Dense const W = (Dense(2, 2) << 1, 0.9, 0.9, 1).finished() * softness / fall;
      problem.W = W;
      double const second = W(1, 0) + 0.05; // leaves the other below 0.1 whatever the first pulls
      auto const beside = [&](double x) { return (second + W(1, 0) * force_at(x)) / (1 + law.K * W(1, 1)); };
      double last = -1e9;
      bool folds = false;
      for (int k = 0; k <= 1000; ++k) {
        double const x = 0.1 + 0.9 * k / 1000;
        REQUIRE(beside(x) < 0.1);
        double const gap = x - W(0, 0) * force_at(x) + W(0, 1) * law.K * beside(x);
        folds = folds || gap < last - 1e-12;
        last = gap;
      }
      problem.free = Vector::Zero(2);
      problem.start = Eigen::Vector2d(0.11, beside(0.11));
      Eigen::Vector2d const x(0.2, beside(0.2)), force(force_at(x[0]), force_at(x[1]));
      auto const found = doubts(problem, force, x, Checked::bearing).softening;
      CHECK(folds == (softness > 4.9));
      CHECK(found.held);
      CHECK(found.any() == folds);
      CHECK(found.points == (folds ? 1 : 0));
      double const held = softness * (1 - 0.81 * law.K * W(1, 1) / (1 + law.K * W(1, 1)));
      CHECK(found.together == doctest::Approx(held));
      CHECK(found.stiffness == doctest::Approx(fall / held));
      if (folds)
        CHECK(words(found).find("the other bonds hold it") != std::string::npos);
      // before damage nothing has fallen
      problem.start = Eigen::Vector2d(0.01, 0.01);
      CHECK_FALSE(doubts(problem, Eigen::Vector2d(-0.9, -0.2), Eigen::Vector2d(0.09, 0.02), Checked::bearing)
                      .softening.any());
    }
  }

  TEST_CASE("bonds that fall in one step do so together, and one that was passed over counts") {
    Bilinear law;
    law.K = 10;
    law.sigma_n = law.sigma_t = 1;
    law.G_I = law.G_II = 0.5;
    Problem problem;
    problem.dim = 1;
    problem.points.assign(2, {1, 0, 0, {{1, {0, 0}}, 0.1, false}});
    problem.adhesions = {law};
    problem.W = Dense((Dense(2, 2) << 0.6, 0.54, 0.54, 0.6).finished() * 0.9);
    problem.free = Vector::Zero(2);
    problem.start = Eigen::Vector2d(0.05, 0.05);
    for (double const end : {0.3, 2.0, 200.0}) { // 2, 200: both broken
      Eigen::Vector2d const x(end, end);
      double const pull = adhere<1>(AdhesionLaw(law), problem.points[0].bond, Local<1>(end)).traction[0];
      auto const found = doubts(problem, Eigen::Vector2d(pull, pull), x, Checked::all).softening;
      CAPTURE(end);
      CHECK(found.together == doctest::Approx(1.14));
      CHECK(found.points == 0);
      auto const held = held_bonds(problem, Eigen::Vector2d(pull, pull), x, Snapped::unknown);
      REQUIRE(held.has_value());
      CHECK(held->together == doctest::Approx(1.14));
      CHECK(words(*held).find("1.14 times as fast") != std::string::npos);
    }
    problem.points[0].bond.old.beta = problem.points[1].bond.old.beta = 0; // had none before
    CHECK_FALSE(held_bonds(problem, Eigen::Vector2d::Zero(), Eigen::Vector2d(2, 2), Snapped::unknown)->any());
  }
}
