// Springs and dashpots: derivatives, periods and decay, momentum, the energy account.
#include <numbers>

#include "differences.hpp"
#include "dynamics/all_schemes.hpp"
#include "dynamics/bulk/critical_step.hpp"
#include "dynamics/space.hpp"

using namespace stiction;
using dynamics::Spring;
using dynamics::SpringAlong;
using test::Vec3;

namespace {

constexpr double k = 3, c = 0.4, v0 = 0.02; // N/m, N s/m, m/s

Spring spring_along(SpringAlong along) {
  Spring spring;
  spring.along = along;
  spring.stiffness = k;
  spring.damping = c;
  spring.axes = {1, 0.5, 0};
  spring.to.at = {0.3, -0.2, 0.4};
  spring.direction = Vec3(2, 1, -1).normalized();
  if (along == SpringAlong::line)
    spring.direction = spring.to.at.normalized();
  spring.stretch = along == SpringAlong::axes ? 0 : 0.1;
  return spring;
}

test::Input spring(std::string from, core::Table entries) {
  entries["from"] = test::text(std::move(from));
  entries.try_emplace("stiffness", test::value(k, "N/m"));
  return test::make("spring", std::move(entries));
}

/// A block of 2 kg in the plane without weight, stiff beside its spring; no motions, no contact.
test::Input block_on(test::Input one) {
  auto table = test::make("scene");
  test::at(table, "bodies.block") = test::block({{0, 0}, {1, 1}, {2, 2}}, test::linear_elastic(1e4, 0.3), 2);
  test::at(table, "bodies.block.velocity") = test::values({v0, 0}, "m/s");
  test::at(table, "springs.tie") = std::move(one);
  test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
  test::at(table, "schedule") = test::schedule({{10, 1}});
  test::at(table, "probes.energy") = test::make("probe.energy", {{"audit", test::flag(true)}});
  test::at(table, "probes.momentum") = test::make("probe.momentum");
  return table;
}

struct Run {
  test::State start, end;
  double open = 0, scale = 0;      ///< largest that the ledger leaves open, largest energy, J
  Vec3 unaccounted = Vec3::Zero(); ///< linear momentum, N s
  double moment = 0;               ///< angular momentum unaccounted, N m s
};

Run run(scene::Scene const& scene, double duration, int steps) {
  scene.model->control.force_tolerance = 1e-13;
  dynamics::Stepper stepper(*scene.model);
  Run result{stepper.initial(), {}};
  result.end = test::march(
      stepper, result.start, duration / steps, steps, [&](test::State const&, test::State const& next) {
        auto const& l = next.ledger;
        result.open = std::max(result.open, std::abs(l.unaccounted()));
        result.scale = std::max({result.scale, l.kinetic, l.spring, std::abs(l.motion_work), l.dashpot_loss});
      });
  if (!scene.model->tallied)
    return result;
  auto const& m = result.end.momenta;
  dynamics::Screw rest = -1 * m.start;
  for (auto const& body : m.bodies)
    rest += body;
  for (auto const& impulse : {m.springs, m.motions, m.loads})
    rest += -1 * impulse;
  result.unaccounted = rest.linear;
  result.moment = rest.angular.z();
  return result;
}

/// Error of the block's place and speed against x'' = -omega^2 x - c x' at the end.
double swing_error(scene::Scene const& scene, int steps, double drag) {
  double const m = 2, T = 5;
  auto const end = run(scene, T, steps).end;
  double const fade = drag / (2 * m), omega = std::sqrt(k / m - fade * fade);
  double const x = v0 / omega * std::exp(-fade * T) * std::sin(omega * T),
               v = v0 * std::exp(-fade * T) * (std::cos(omega * T) - fade / omega * std::sin(omega * T));
  Index const node = test::nodes_of(scene, "block.all")[4];
  return std::hypot(end.v[2 * node] - v, omega * (end.u[2 * node] - x));
}

} // namespace

TEST_CASE("a spring's force is the derivative of its energy, its tangent that of its force") {
  for (auto const along : {SpringAlong::axes, SpringAlong::direction, SpringAlong::line}) {
    CAPTURE(static_cast<int>(along));
    auto const spring = spring_along(along);
    Vector const x = Vec3(0.5, 0.1, 0.2);
    auto const pull = dynamics::pull_of(spring, Vec3(x));
    auto const energy = test::rate(
        [&](Vector const& at) {
          return Vector::Constant(1, dynamics::pull_of(spring, Vec3(at)).energy).eval();
        },
        Dense(pull.force.transpose()), x, 1e-2);
    INFO(energy.words());
    CHECK(energy.second_order);
    auto const tangent =
        test::rate([&](Vector const& at) { return Vector(dynamics::pull_of(spring, Vec3(at)).force); },
                   Dense(pull.tangent), x, 1e-2);
    INFO(tangent.words());
    CHECK(tangent.second_order);
    CHECK(pull.energy > 0);
  }
  auto line = spring_along(SpringAlong::line);
  CHECK(dynamics::pull_of(line, Vec3::Zero()).force.allFinite()); // ends that meet push as they began
  CHECK(dynamics::pull_of(line, line.start()).elongation == doctest::Approx(0.1));
}

TEST_CASE("a block on a spring swings with sqrt(k/m), and a dashpot damps it, to second order") {
  for (double const drag : {0.0, c})
    for (bool const directed : {false, true}) {
      CAPTURE(drag);
      CAPTURE(directed);
      core::Table entries{{"damping", test::value(drag, "N s/m")}};
      if (directed)
        entries["direction"] = test::values({-1, 0});
      auto const scene = scene::build(block_on(spring("block.all", entries)));
      double const coarse = swing_error(scene, 50, drag), fine = swing_error(scene, 100, drag);
      CHECK(fine < 2e-3 * v0);
      CHECK(std::log2(coarse / fine) == doctest::Approx(2).epsilon(0.05));
    }
}

TEST_CASE("swings fall by the logarithmic decrement, and the dashpot's loss is what is gone") {
  auto const scene = scene::build(block_on(spring("block.all", {{"damping", test::value(c, "N s/m")}})));
  double const fade = c / 4, omega = std::sqrt(k / 2 - fade * fade), T = 2 * std::numbers::pi / omega;
  auto const swung = run(scene, 3 * T, 1200);
  Index const node = test::nodes_of(scene, "block.all")[0];
  CHECK(std::log(v0 / swung.end.v[2 * node]) == doctest::Approx(3 * T * fade).epsilon(1e-4));
  auto const& l = swung.end.ledger;
  CHECK(l.dashpot_loss == doctest::Approx(l.start - l.kinetic - l.strain - l.spring).epsilon(1e-4));
  CHECK(swung.open < 1e-11 * swung.scale);
  CHECK(swung.unaccounted.norm() < 1e-10 * 2 * v0);
}

TEST_CASE("two blocks on a spring: momentum is kept, their centre flies on, the account closes") {
  for (bool const line : {false, true}) {
    CAPTURE(line);
    auto table = block_on({});
    auto const rubber = test::make("material.neo_hookean",
                                   {{"young", test::value(1e3, "Pa")}, {"poisson", test::value(0.3)}});
    test::at(table, "bodies.block.material") = rubber;
    test::at(table, "bodies.other") = test::block({{2, 0.5}, {1, 1}, {2, 2}}, rubber, 1);
    core::Table entries{{"to", test::text("other.left")}, {"damping", test::value(c, "N s/m")}};
    if (line) {
      entries["along"] = test::text("line");
      entries["rest"] = test::value(1.01, "m");
    }
    test::at(table, "springs.tie") = spring("block.right", entries);
    auto const scene = scene::build(table);
    auto const swung = run(scene, 6, 400);
    CHECK(swung.end.ledger.spring > 0);
    CHECK(swung.end.momenta.springs.linear.norm() < 1e-12 * v0);
    CHECK(swung.unaccounted.norm() < 1e-10 * v0);
    CHECK(swung.open < 1e-9 * swung.scale);
    CHECK(std::abs(swung.moment) < (line ? 1e-3 : 1e-9) * v0);
    if (line) // along the line between the points it acts on: no moment, but for the step's ends
      CHECK(std::abs(swung.end.momenta.springs.angular.z()) < 2e-4 * 2 * v0);
  }
}

TEST_CASE("an end on a path does the work that the spring stores and the dashpot takes") {
  for (auto const& sample : test::scheme_samples()) {
    if (!sample.closed_rates)
      continue;
    INFO(sample.label);
    bool const explicit_one = sample.name == "central_difference";
    auto table = block_on(spring("block.left", {{"times", test::values({0, 0.3, 1}, "s")},
                                                {"x", test::values({0, -0.01, -0.1}, "m")},
                                                {"y", test::values({0, 0.02, 0.02}, "m")}}));
    if (!explicit_one)
      test::at(table, "springs.tie.damping") = test::value(c, "N s/m");
    test::at(table, "scheme") = sample.table;
    test::at(table, "schedule") = test::schedule({{1, 1}});
    test::at(table, "bodies.block.material") = test::linear_elastic(10, 0.3);
    auto const pulled = run(scene::build(table), 1, 50);
    CHECK(pulled.end.ledger.motion_work > 1e-4);
    CHECK(pulled.end.ledger.spring > 1e-5);
    CHECK((pulled.end.ledger.dashpot_loss > 1e-6) == !explicit_one);
    CHECK(pulled.open < 1e-10 * pulled.scale);
    if (sample.theta > 0) // others owe a part of M a until the end
      CHECK(pulled.unaccounted.norm() < 1e-9 * v0);
  }
}

TEST_CASE("springs hold a body at rest: a bedding gives way by p / k, a mean by F / k") {
  for (bool const spread : {false, true}) {
    CAPTURE(spread);
    auto table = block_on(spring("block.bottom", {{"spread", test::flag(spread)}}));
    test::at(table, "scheme") = test::quasi_static();
    test::remove(table, "probes.momentum");
    test::at(table, "bodies.block.material") = test::linear_elastic(1e3, 0);
    if (!spread)
      test::at(table, "motions") = test::list({test::fix("block.left", true, false)});
    test::at(table, "loads") =
        test::list({test::make("load.traction", {{"set", test::text("block.top")},
                                                 {"times", test::values({0, 10}, "s")},
                                                 {"y", test::values({-0.3, -0.3}, "Pa")}})});
    auto const scene = scene::build(table);
    auto const end = run(scene, 10, 1).end;
    for (Index const node : test::nodes_of(scene, "block.bottom"))
      CHECK(end.u[2 * node + 1] == doctest::Approx(-0.3 / k).epsilon(1e-9));
    CHECK(end.ledger.spring == doctest::Approx(0.3 * 0.3 / (2 * k)).epsilon(1e-9));
  }
}

TEST_CASE("a free obstacle hangs on a line of given length as a pendulum of that length") {
  auto table = block_on({});
  test::at(table, "motions") = test::list({test::fix("block.all")});
  test::at(table, "bodies.block.velocity") = test::values({0, 0}, "m/s");
  test::at(table, "gravity") = test::values({0, -10}, "m/s^2");
  test::at(table, "obstacles.bob") =
      test::make("obstacle", {{"shape", test::make("rigid.circle", {{"centre", test::values({5, -2}, "m")},
                                                                    {"radius", test::value(0.1, "m")}})},
                              {"mass", test::value(2, "kg")},
                              {"velocity", test::values({0.01, 0}, "m/s")}});
  test::at(table, "springs.tie") = spring("bob", {{"anchor", test::values({5, 0}, "m")},
                                                  {"along", test::text("line")},
                                                  {"stiffness", test::value(1e5, "N/m")},
                                                  {"rest", test::value(2 - 20 / 1e5, "m")}});
  auto const scene = scene::build(table);
  double const omega = std::sqrt(10.0 / 2), quarter = std::numbers::pi / (2 * omega);
  auto const end = run(scene, quarter, 200).end;
  Index const bob = scene.model->rigids[0].node;
  CHECK(end.u[2 * bob] == doctest::Approx(0.01 / omega).epsilon(1e-3));
  CHECK(std::abs(end.v[2 * bob]) < 1e-3 * 0.01);
}

TEST_CASE("explicit schemes know springs in their stability limit, and multigrid and ranks do without") {
  auto table = block_on(spring("block.all", {}));
  auto const soft = scene::build(table);
  Vector const rest = Vector::Zero(soft.model->dofs());
  double const free = dynamics::critical_step(*soft.model, rest);
  test::at(table, "springs.tie") = spring("block.left", {{"stiffness", test::value(1e7, "N/m")}});
  auto const stiff = scene::build(table);
  double const bound = dynamics::critical_step(*stiff.model, rest);
  CHECK(bound < 0.2 * free);
  test::at(table, "scheme") = test::make("scheme.central_difference");
  auto const scene = scene::build(table);
  auto const end = run(scene, 500 * bound, 500);
  CHECK(end.end.ledger.kinetic + end.end.ledger.spring < 2 * end.end.ledger.start);
  CHECK(end.end.ledger.spring > 0);
}
