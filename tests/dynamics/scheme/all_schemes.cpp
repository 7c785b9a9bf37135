// Every scheme of the list: order on smooth problems, amplification by its formula, energy account.
#include "dynamics/all_schemes.hpp"

#include <Eigen/Eigenvalues>
#include <numbers>

#include "dynamics/bulk/critical_step.hpp"
#include "scene/description/catalog.hpp"

using namespace stiction;
using test::SchemeSample;

namespace {

/// A bar of four cells, E = rho = 1, left end held, in its first mode with this speed at the right end. A
/// wall far away makes the right end a contact surface.
scene::Scene bar(SchemeSample const& sample, test::Input material, double speed) {
  auto table = test::make("scene");
  test::at(table, "bodies.bar") = test::block({{0, 0}, {1, 0.25}, {4, 1}}, std::move(material));
  test::at(table, "obstacles.wall.shape") =
      test::make("rigid.plane", {{"point", test::values({10, 0}, "m")}, {"normal", test::values({-1, 0})}});
  test::at(table, "pairs.end") = test::pair("bar.right", "wall");
  test::at(table, "motions") =
      test::list({test::fix("bar.left", true, false), test::fix("bar.all", false, true)});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "scheme") = sample.table;
  auto made = scene::build(table);
  made.model->control.force_tolerance = 1e-13;
  for (Index i = 0; i < made.model->node_count(); ++i)
    made.model->velocity(i, 0) = speed * std::sin(std::numbers::pi / 2 * made.model->reference(i, 0));
  return made;
}

scene::Scene linear_bar(SchemeSample const& sample) {
  return bar(sample, test::linear_elastic(1, 0), 1);
}
scene::Scene rubber_bar(SchemeSample const& sample) {
  auto rubber =
      test::make("material.neo_hookean", {{"young", test::value(1, "Pa")}, {"poisson", test::value(0.2)}});
  return bar(sample, std::move(rubber), 0.3);
}

/// State after `time` in so many steps; the period is about four seconds.
test::State swung(scene::Scene const& scene, int steps, double time = 2.6) {
  dynamics::Stepper stepper(*scene.model);
  return test::march(stepper, stepper.initial(), time / steps, steps);
}

/// Rates at which displacement and velocity settle when the step is halved three times; the finest.
void check_order(SchemeSample const& sample, scene::Scene const& scene) {
  INFO(sample.label);
  std::vector<test::State> states;
  for (int const steps : {100, 200, 400, 800})
    states.push_back(swung(scene, steps));
  auto const order = [&](Vector test::State::*value) {
    std::array<double, 3> change{};
    for (std::size_t k = 0; k < 3; ++k)
      change[k] = (states[k].*value - states[k + 1].*value).norm();
    CHECK(change[0] > 0);
    CHECK(std::log2(change[0] / change[1]) == doctest::Approx(sample.order).epsilon(0.2));
    return std::log2(change[1] / change[2]);
  };
  CHECK(order(&test::State::u) == doctest::Approx(sample.order).epsilon(0.1));
  if (!sample.massless) // whose velocity is d / dt, half a step late
    CHECK(order(&test::State::v) == doctest::Approx(sample.order).epsilon(0.1));
}

/// (u, dt v, dt^2 a) of the oscillator u'' = -omega^2 u from one step to the next, z = (omega dt)^2; from the
/// schemes' definitions, one unknown after the other. Jean's scheme has no a.
Eigen::Matrix3d amplification(SchemeSample const& s, double z) {
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  for (int column = 0; column < 3; ++column) {
    Eigen::Vector3d const old = Eigen::Vector3d::Unit(column);
    double u = 0, v = 0, a = 0;
    if (s.theta > 0) {
      v = (old[1] - z * (old[0] + s.xi * (1 - s.theta) * old[1])) / (1 + z * s.xi * s.theta);
      u = old[0] + (1 - s.theta) * old[1] + s.theta * v;
    } else {
      double const coast = old[0] + old[1] + (0.5 - s.beta) * old[2];
      a = (-z * ((1 - s.alpha_f) * coast + s.alpha_f * old[0]) - s.alpha_m * old[2]) /
          (1 - s.alpha_m + z * (1 - s.alpha_f) * s.beta);
      u = coast + s.beta * a;
      v = old[1] + (1 - s.gamma) * old[2] + s.gamma * a;
    }
    A.col(column) << u, v, a;
  }
  return A;
}

/// Frequency of the first mode with the consistent mass, rad/s.
double frequency() {
  double const h = 0.25, k = std::numbers::pi / 2;
  return std::sqrt(6 / (h * h) * (1 - std::cos(k * h)) / (2 + std::cos(k * h)));
}

} // namespace

TEST_CASE("every scheme of the list has samples, and only those") {
  for (auto const& category : scene::catalog())
    if (category.name == "scheme") {
      std::set<std::string> listed, sampled;
      for (auto const& schema : category.kinds)
        listed.insert(schema.name);
      for (auto const& sample : test::scheme_samples())
        sampled.insert(sample.name);
      CHECK(listed == sampled);
    }
}

TEST_CASE("every scheme: its order on a swinging elastic bar") {
  for (auto const& sample : test::scheme_samples())
    if (sample.order > 0)
      check_order(sample, linear_bar(sample));
}

TEST_CASE("every scheme: its order on a swinging rubber bar") {
  for (auto const& sample : test::scheme_samples())
    if (sample.order > 0)
      check_order(sample, rubber_bar(sample));
}

TEST_CASE("every linear scheme follows its recursion and decays as its spectral radius says") {
  for (auto const& sample : test::scheme_samples()) {
    if (!sample.closed_rates)
      continue;
    INFO(sample.label);
    auto const scene = linear_bar(sample);
    dynamics::Stepper stepper(*scene.model);
    auto const start = stepper.initial();
    double const dt = 0.3, z = std::pow(frequency() * dt, 2);
    auto const A = amplification(sample, z);
    Eigen::Vector3d mode(0, dt, 0);
    auto const end = test::march(stepper, start, dt, 60, [&](test::State const&, test::State const& state) {
      mode = A * mode;
      CHECK(test::largest(state.u - mode[0] * start.v) < 1e-10);
      CHECK(test::largest(state.v - mode[1] / dt * start.v) < 1e-10);
    });
    double const radius = A.eigenvalues().cwiseAbs().maxCoeff();
    double const kept = (end.ledger.kinetic + end.ledger.strain) / start.ledger.start;
    CHECK(std::log(kept) / 120 == doctest::Approx(std::log(radius)).epsilon(0.01).scale(0.05));
  }
}

TEST_CASE("central differences turn the phase as their formula says and keep the energy of each mode") {
  auto const samples = test::scheme_samples();
  for (auto const& sample : samples) {
    if (sample.name != "central_difference")
      continue;
    auto const scene = linear_bar(sample);
    dynamics::Stepper stepper(*scene.model);
    auto const start = stepper.initial();
    double const dt = 0.2, h = 0.25;
    double const omega = 2 / h * std::sin(std::numbers::pi / 4 * h); // lumped mass
    double const phase = 2 * std::asin(omega * dt / 2);
    int step = 0;
    test::march(stepper, start, dt, 200, [&](test::State const&, test::State const& state) {
      ++step;
      double const amplitude = dt / std::sin(phase); // u0 = 0, u1 = dt v0
      CHECK(test::largest(state.u - amplitude * std::sin(step * phase) * start.v) < 1e-10);
    });
    CHECK(stepper.cost().stiffness_passes == 0);
    CHECK(stepper.cost().factorizations == 1);
    CHECK(stepper.bulk().factor().pattern().entries() == stepper.bulk().unknowns());
    CHECK(stepper.cost().force_passes == 200);
  }
}

TEST_CASE("every scheme: what its energy account lacks vanishes with its order") {
  for (auto const& sample : test::scheme_samples()) {
    if (sample.order == 0)
      continue;
    INFO(sample.label);
    auto scene = rubber_bar(sample);
    auto& model = *scene.model;
    for (auto& motion : model.motions)
      if (motion.component == 0)
        motion.path = {{0, 10}, {0, 2}};
    for (Index const node : test::nodes_of(scene, "bar.left"))
      model.velocity(node, 0) = 0.2; // as its path goes on
    std::array<double, 3> loss{};
    for (std::size_t k = 0; k < 3; ++k) {
      auto const& ledger = swung(scene, 200 << k, 1.3).ledger;
      loss[k] = ledger.scheme_loss();
      CHECK(std::abs(ledger.motion_work) > 0.1 * ledger.start);
    }
    double const rate = std::log2(std::abs(loss[1] / loss[2]));
    INFO(loss[0] << " " << loss[1] << " " << loss[2]);
    CHECK(rate > sample.order - 0.15);
  }
}

TEST_CASE("the schemes that conserve do so to rounding where all is linear") {
  for (auto const& sample : test::scheme_samples()) {
    bool const trapezoid = sample.closed_rates && ((sample.theta == 0.5 && sample.xi == 0.5) ||
                                                   (sample.beta == 0.25 && sample.alpha_f == 0));
    if (!trapezoid)
      continue;
    INFO(sample.label);
    auto const end = swung(linear_bar(sample), 40);
    CHECK(end.ledger.start > 0.05);
    CHECK(std::abs(end.ledger.scheme_loss()) < 1e-10 * end.ledger.start);
  }
}

TEST_CASE("theta = xi loses (theta - 1/2) (dv M dv + du K du) in each step") {
  for (auto const& sample : test::scheme_samples()) {
    if (!(sample.closed_rates && sample.theta > 0.5 && sample.theta == sample.xi))
      continue;
    INFO(sample.label);
    auto const scene = linear_bar(sample);
    dynamics::Stepper stepper(*scene.model);
    auto const start = stepper.initial();
    Vector inertia, force;
    double lost = 0;
    auto const end =
        test::march(stepper, start, 0.1, 40, [&](test::State const& old, test::State const& next) {
          Vector const dv = next.v - old.v, du = next.u - old.u;
          stepper.bulk().mass().times(dv, inertia);
          static_cast<void>(stepper.bulk().internal_force(du, force));
          lost += (sample.theta - 0.5) * (dv.dot(inertia) + du.dot(force));
        });
    CHECK(lost > 0.01 * start.ledger.start);
    CHECK(end.ledger.scheme_loss() == doctest::Approx(lost).epsilon(1e-9));
  }
}

TEST_CASE("every scheme: moving a body rigidly costs force times way and becomes kinetic energy") {
  for (auto const& sample : test::scheme_samples()) {
    if (sample.order == 0)
      continue;
    INFO(sample.label);
    auto table = test::foot_on_floor();
    test::remove(table, "pairs");
    test::at(table, "motions") = test::list({test::drive("foot.all", {0, 1, 2, 4}, {0, 0.5, 2, 3}, {})});
    test::at(table, "scheme") = sample.table;
    test::at(table, "bodies.foot.material") = test::linear_elastic(1, 0);
    test::at(table, "bodies.foot.density") = test::value(3, "kg/m^3");
    auto const scene = scene::build(table);
    dynamics::Stepper stepper(*scene.model);
    auto const end = test::march(stepper, stepper.initial(), 0.1, 40);
    // speeds 0, 1/2, 3/2, 1/2 m/s of 3 kg; each jump takes one step, in which the force goes all the way
    double const work = 3 * (0.5 * 0.5 + 1 * 1.5 - 1 * 0.5);
    CHECK(end.ledger.motion_work == doctest::Approx(work).epsilon(1e-9));
    CHECK(end.ledger.kinetic == doctest::Approx(0.5 * 3 * 0.25).epsilon(1e-9));
    CHECK(end.ledger.scheme_loss() == doctest::Approx(work - 0.375).epsilon(1e-9));
  }
}

TEST_CASE("the stability limit of rubber follows its deformation") {
  SchemeSample sample;
  for (auto const& one : test::scheme_samples())
    if (one.name == "central_difference")
      sample = one;
  auto const scene = rubber_bar(sample);
  scene.model->motions[0].path = {{0, 1, 10}, {0, 0.5, 0.5}}; // pressed to half its length
  dynamics::Stepper stepper(*scene.model);
  auto const start = stepper.initial();
  double const dt = 0.2 * dynamics::critical_step(*scene.model, start.u);
  auto const end = test::march(stepper, start, dt, static_cast<int>(1 / dt) + 101);
  CHECK(end.critical_step < 0.9 * dynamics::critical_step(*scene.model, start.u));
}
