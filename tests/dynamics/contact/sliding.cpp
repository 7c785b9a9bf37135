// A block sliding on a rigid plane under gravity against Coulomb's closed form.
#include <doctest/doctest.h>

#include "dynamics/marching.hpp"

using namespace stiction;

namespace {

constexpr double gravity = 10, speed = 1, young = 1e7;

struct Slide {
  double stop_time = 0, distance = 0;
  double speed = 0; ///< of the centre of mass at the end, m/s
};

/// Mean over a body, weighted by mass: of x components.
double mean_x(dynamics::Stepper const& stepper, Vector const& values) {
  Vector weighted, ones = Vector::Zero(values.size());
  for (Eigen::Index i = 0; i < ones.size(); i += 2)
    ones[i] = 1;
  stepper.bulk().mass().times(ones, weighted);
  return values.dot(weighted) / ones.dot(weighted);
}

/// A block that rests on the floor in equilibrium and is set sliding at 1 m/s. The stopping time is that of
/// the step after which its centre stands still.
Slide slide(double mu, double dt, double duration, contact::SolverChoice const& solver = {}) {
  auto table = test::foot_on_floor();
  test::remove(table, "motions");
  test::at(table, "bodies.foot.material") = test::linear_elastic(young, 0);
  test::at(table, "bodies.foot.velocity") = test::values({speed, 0}, "m/s");
  test::at(table, "gravity") = test::values({0, -gravity}, "m/s^2");
  if (mu > 0)
    test::at(table, "pairs.sole.friction") = test::coulomb(mu);
  test::at(table, "scheme") =
      test::make("scheme.theta_xi", {{"theta", test::value(1)}, {"xi", test::value(1)}});
  auto const scene = scene::build(table);
  scene.model->solver = solver;
  dynamics::Stepper stepper(*scene.model);
  auto start = stepper.initial();
  for (Index i = 0; i < scene.model->node_count(); ++i) { // a column under its own weight
    double const y = scene.model->reference(i, 1);
    start.u[2 * i + 1] = -gravity / young * (y - y * y / 2);
  }
  Slide result;
  auto const end = test::march(stepper, start, dt, static_cast<int>(std::lround(duration / dt)),
                               [&](test::State const&, test::State const& state) {
                                 if (std::abs(mean_x(stepper, state.v)) > 1e-2 * speed)
                                   result.stop_time = state.t;
                               });
  result.distance = mean_x(stepper, end.u) - mean_x(stepper, start.u);
  result.speed = mean_x(stepper, end.v);
  return result;
}

} // namespace

TEST_CASE("a sliding block stops after v / mu g and v^2 / 2 mu g, and stays") {
  double const mu = 0.5, time = speed / (mu * gravity), distance = speed * speed / (2 * mu * gravity);
  double const coarse_dt = 2e-3, fine_dt = 1e-3;
  auto const coarse = slide(mu, coarse_dt, 0.3), fine = slide(mu, fine_dt, 0.3);
  CHECK(std::abs(coarse.stop_time - time) < 4 * coarse_dt);
  CHECK(std::abs(fine.stop_time - time) < 6 * fine_dt);
  CHECK(std::abs(coarse.distance - distance) < speed * coarse_dt);
  CHECK(std::abs(fine.distance - distance) < 0.65 * std::abs(coarse.distance - distance));
  CHECK(std::abs(fine.speed) < 1e-4 * speed);
}

TEST_CASE("deceleration is mu g while the block slides") {
  for (double const mu : {0.1, 0.3}) {
    auto const part = slide(mu, 2e-3, 0.2);
    CHECK(part.speed == doctest::Approx(speed - mu * gravity * 0.2).epsilon(0.01));
  }
}

TEST_CASE("without friction a block keeps its speed") {
  auto const free = slide(0, 5e-3, 0.2);
  CHECK(free.speed == doctest::Approx(speed).epsilon(1e-10));
  CHECK(free.distance == doctest::Approx(0.2 * speed).epsilon(1e-10));
}

TEST_CASE("all contact solvers give the same slide") {
  auto const newton = slide(0.5, 5e-3, 0.1, contact::BipotentialNewton{});
  auto const uzawa = slide(0.5, 5e-3, 0.1, contact::BipotentialUzawa{});
  auto const seidel = slide(0.5, 5e-3, 0.1, contact::GaussSeidel{});
  CHECK(uzawa.distance == doctest::Approx(newton.distance).epsilon(1e-6));
  CHECK(seidel.distance == doctest::Approx(newton.distance).epsilon(1e-6));
  CHECK(uzawa.speed == doctest::Approx(newton.speed).epsilon(1e-6));
  CHECK(seidel.speed == doctest::Approx(newton.speed).epsilon(1e-6));
}
