// A point on a spring with a bond: shear under pressure and the snap-through of an opening joint.
#include <algorithm>
#include <doctest/doctest.h>

#include "contact/solvers.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

constexpr double u0 = 1e-4, C = 2e9, w = 20; // sigma0 = 0.2 MPa, rate-independent

interface::Rcc joint(interface::BondFriction friction) {
  interface::Rcc law;
  law.w = w;
  law.C_n = law.C_t = law.C_t2 = C;
  law.friction = friction;
  return law;
}

/// A bonded point of 1 m^2 behind springs of k_n, k_t times C.
Problem on_springs(double k_n, double k_t, double mu, interface::BondFriction friction) {
  Problem problem =
      one_point(Eigen::Vector2d(1 / (k_n * C), 1 / (k_t * C)).asDiagonal(), Vector::Zero(2), mu);
  problem.adhesions = {joint(friction)};
  problem.points[0].adhesion = 0;
  problem.points[0].bond = {{1, {0, 0}}, 1e-3, false};
  return problem;
}

struct Pulled {
  std::vector<double> opening; ///< s after each step
  bool all_converged = true, finite = true;
};

/// Pulls the far end of the normal spring up to `end` u0 in steps.
Pulled pull(SolverChoice const& choice, double stiffness, double step, double end) {
  Problem problem = on_springs(stiffness, 1, 0, interface::BondFriction::full);
  Pulled result;
  Vector force = Vector::Zero(2);
  for (double d = step; d <= end; d += step) {
    problem.free[0] = d * u0;
    auto const answer = make_solver(choice)->solve(problem, force);
    result.all_converged = result.all_converged && answer.converged;
    result.finite = result.finite && answer.force.allFinite();
    if (answer.converged)
      force = answer.force;
    Local<2> const x = displacement(problem, force);
    auto& bond = problem.points[0].bond;
    bond.old = interface::advance<2>(problem.adhesions[0], bond, x);
    result.opening.push_back(x[0] / u0);
  }
  return result;
}

/// All solvers, with at most so many iterations.
std::vector<std::pair<std::string, SolverChoice>> patient_solvers(int iterations) {
  auto list = all_solvers();
  for (auto& [name, choice] : list)
    std::visit([&](auto& solver) { solver.iterations = std::min(solver.iterations, iterations); }, choice);
  return list;
}

double largest_jump(std::vector<double> const& path) {
  double jump = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    jump = std::max(jump, path[i] - path[i - 1]);
  return jump;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("sheared under pressure: dry friction and bond add up as the closed form says") {
    double const m = 1, mu = 0.5, pressure = m * 2e5 / mu;
    for (auto const friction : {interface::BondFriction::full, interface::BondFriction::damage})
      for (auto const& [name, choice] : all_solvers()) {
        CAPTURE(name);
        Problem problem = on_springs(1, 50, mu, friction);
        problem.points[0].bond.closed = true;
        auto const solver = make_solver(choice);
        Vector force = Vector::Zero(2);
        double s = 0, least = 1e9, most = 0;
        for (int k = 1; k <= 80; ++k) {
          // the far end at 0.05 k u0; slip of the step = its end minus what the spring takes, minus s so far
          problem.free << -problem.W.diagonal(0) * pressure, (0.05 * k - s) * u0;
          auto const answer = solver->solve(problem, force);
          REQUIRE(answer.converged);
          force = answer.force;
          Local<2> const x = displacement(problem, force);
          s += x[1] / u0;
          auto& bond = problem.points[0].bond;
          bond.old = interface::advance<2>(problem.adhesions[0], bond, x);
          CHECK(force[0] == doctest::Approx(pressure).epsilon(1e-8));
          double const tau = -force[1] / 2e5, beta = std::min(1.0, 1 / (s * s));
          double const left = friction == interface::BondFriction::full ? m : m * (1 - beta);
          if (s > 1e-9)
            CHECK(tau == doctest::Approx(left + s * beta * beta).epsilon(1e-6));
          else
            CHECK(tau <= m); // sticks
          if (s > 1.1)
            least = std::min(least, tau);
          most = std::max(most, tau);
        }
        CHECK(s > 3.5);
        if (friction == interface::BondFriction::damage)
          CHECK(least == doctest::Approx(0.8519).epsilon(2e-3)); // the dip at s = 1.5
        else
          CHECK(most == doctest::Approx(2).epsilon(0.02)); // (1 + m) sigma0
      }
  }

  TEST_CASE("a bonded joint behind a spring is stable from k = 3 C on and snaps below") {
    for (auto const& [name, choice] : all_solvers()) {
      CAPTURE(name);
      auto const stiff = pull(choice, 4, 0.01, 3);
      CHECK(stiff.all_converged);
      CHECK(largest_jump(stiff.opening) < 0.05); // ds/dd <= 1 / (1 - 3/4)
      for (std::size_t i = 0; i < stiff.opening.size(); ++i) {
        double const s = stiff.opening[i], pulled = 0.01 * static_cast<double>(i + 1);
        CHECK(s + 0.25 * std::min(s, 1 / (s * s * s)) == doctest::Approx(pulled).epsilon(1e-7));
      }
    }
  }

  TEST_CASE("past the limit of uniqueness answers are true or not given, and never NaN") {
    for (double const stiffness : {2.0, 1.0, 0.5, 0.1}) // W C A = 0.5, 1, 2, 10
      for (double const step : {0.01, 0.1, 1.0})
        for (auto const& [name, choice] : patient_solvers(1000)) {
          INFO(name << ", k/C = " << stiffness << ", step " << step);
          double const end = 3 * (1 + 1 / stiffness);
          auto const pulled = pull(choice, stiffness, step, end);
          CHECK(pulled.finite);
          if (!std::holds_alternative<BipotentialUzawa>(choice)) // whose fixed point repels past the limit
            CHECK(pulled.all_converged);
          if (!pulled.all_converged)
            continue;
          double const s = pulled.opening.back(); // snapped: on the softened branch
          CHECK(s > 1);
          CHECK(s + 1 / (stiffness * s * s * s) == doctest::Approx(end).epsilon(step / end + 1e-6));
        }
    auto const snapped = pull(BipotentialNewton{}, 2, 0.001, 1.51);
    CHECK(snapped.all_converged);
    CHECK(largest_jump(snapped.opening) > 0.15);
    CHECK(snapped.opening.back() == doctest::Approx(1.26).epsilon(0.005)); // s + s^-3/2 = 1.51
  }

  TEST_CASE("many softening points: the verdict holds and nothing is NaN") {
    for (unsigned seed = 1; seed <= 10; ++seed)
      for (double const softness : {0.5, 2.0, 20.0})
        for (auto const& [name, choice] : patient_solvers(1000)) {
          INFO(name << ", seed " << seed << ", softness " << softness);
          auto problem = random_problem(2, 8, seed, 0.1);
          add_adhesion(problem, softness, seed);
          auto const answer = solve(choice, problem);
          CHECK(answer.force.allFinite());
          CHECK(answer.converged == (judge(problem, answer.force).relative() <= 1e-10));
        }
  }

  TEST_CASE("the scale of a point that moves against a force is that of its motion, whatever the unit") {
    for (double const size : {1e-12, 1.0, 1e7})
      for (int const dim : {1, 2, 3}) {
        Problem problem;
        problem.dim = dim;
        Dense W = -size * Dense::Identity(2 * dim, 2 * dim);
        W(0, 0) = -2 * size;
        W.bottomRightCorner(dim, dim) *= -1;
        problem.W = W;
        problem.free = Vector::Zero(2 * dim);
        problem.points.assign(2, {1, 0.3, -1, {}});
        CHECK(natural_scale(problem, 0) == doctest::Approx(0.5 / size).epsilon(1e-12));
        CHECK(natural_scale(problem, 1) == doctest::Approx(1 / size).epsilon(1e-12));
        if (dim > 1) { // rounding beside its own motion
          problem.W.entries()(1, 1) = 1e-16 * size;
          CHECK(natural_scale(problem, 0) == doctest::Approx(0.5 / size).epsilon(1e-12));
        }
        problem.W.entries().topLeftCorner(dim, dim) *= 1e-16; // rounding beside the other
        CHECK(natural_scale(problem, 0) == 1);
      }
  }
}
