// The contract of a step: state in, state out; failure is a verdict; nothing allocated in the long run.
#include "dynamics/step/stepper.hpp"

#include <cstring>
#include <doctest/doctest.h>
#include <set>

#include "dynamics/marching.hpp"
#include "linear/recycling.hpp"

using namespace stiction;
using dynamics::StepVerdict;

namespace {

bool same(Vector const& a, Vector const& b) {
  return a.size() == b.size() &&
         std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

bool same(dynamics::ContactState const& a, dynamics::ContactState const& b) {
  return a.foot.segment == b.foot.segment && a.foot.xi == b.foot.xi && a.gap == b.gap && a.slip == b.slip &&
         a.path == b.path && a.dry == b.dry && a.adhesion == b.adhesion && a.bond.beta == b.bond.beta &&
         a.bond.stretch == b.bond.stretch && a.status == b.status && a.in_reach == b.in_reach;
}

/// Bit by bit, but for the sign of zeros in points and ledger.
bool same(test::State const& a, test::State const& b) {
  bool equal = a.t == b.t && same(a.u, b.u) && same(a.v, b.v) && same(a.internal, b.internal) &&
               same(a.reaction, b.reaction) && same(a.drive, b.drive) &&
               a.contacts.size() == b.contacts.size();
  for (std::size_t p = 0; equal && p < a.contacts.size(); ++p)
    for (std::size_t i = 0; equal && i < a.contacts[p].size(); ++i)
      equal = same(a.contacts[p][i], b.contacts[p][i]);
  return equal && std::memcmp(&a.ledger, &b.ledger, sizeof a.ledger) == 0;
}

/// Two rubber blocks with friction and adhesion, the upper one narrower, pressed and dragged dynamically.
test::Input rubbing() {
  auto table = test::two_blocks();
  test::at(table, "bodies.upper") = test::block({{0.12, 0}, {0.7, 1}, {3, 4}}, test::linear_elastic(1, 0));
  for (std::string const body : {"lower", "upper"})
    test::at(table, "bodies." + body + ".material") =
        test::make("material.blatz_ko", {{"shear_modulus", test::value(400, "Pa")}});
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  test::at(table, "pairs.joint.adhesion") = test::rcc(0.1, 100, 1);
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  return table;
}

/// A rubber block without any support.
test::Input floating() {
  auto table = test::foot_on_floor();
  for (char const* part : {"pairs", "obstacles", "motions"})
    test::remove(table, part);
  return table;
}

} // namespace

TEST_CASE("a step leaves its state alone and gives the same again from a fresh workspace") {
  auto const scene = scene::build(rubbing());
  dynamics::Stepper one(*scene.model), other(*scene.model);
  auto const state = test::march(one, one.initial(), 0.05, 24);
  auto const kept = state;
  static_cast<void>(other.initial());
  auto const first = other.step(state, 0.05);
  CHECK(same(state, kept));
  dynamics::Stepper third(*scene.model);
  auto const second = third.step(state, 0.05);
  REQUIRE(first.converged());
  REQUIRE(second.converged());
  CHECK(first.iterations == second.iterations);
  CHECK(first.out_of_balance == second.out_of_balance);
  CHECK(same(first.state, second.state));
  CHECK_FALSE(same(first.state, state));
}

TEST_CASE("what a workspace did before changes a step by no more than its tolerance") {
  auto const scene = scene::build(rubbing());
  scene.model->control.force_tolerance = 1e-10;
  dynamics::Stepper used(*scene.model), fresh(*scene.model);
  auto const state = test::march(used, used.initial(), 0.05, 24);
  test::march(used, state, 0.02, 5);
  auto const a = used.step(state, 0.05), b = fresh.step(state, 0.05);
  REQUIRE(a.converged());
  REQUIRE(b.converged());
  CHECK(test::largest(a.state.u - b.state.u) < 1e-9);
  CHECK(test::largest(a.state.reaction - b.state.reaction) < 1e-7);
}

TEST_CASE("steps in which points land, bond and part are those of a fresh workspace") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0.001}, {1, 1}, {2, 2}}, test::linear_elastic(1000, 0));
  test::at(table, "pairs.sole.adhesion") = test::rcc(0.1, 1e3, 0.5);
  test::at(table, "motions") = test::list({test::drive("foot.top", {0, 1, 3}, {0, 0, 0}, {0, -0.01, 0.05})});
  auto const scene = scene::build(table);
  dynamics::Stepper used(*scene.model);
  auto state = used.initial();
  int changes = 0;
  for (int k = 0; k < 24; ++k) {
    dynamics::Stepper fresh(*scene.model);
    static_cast<void>(used.step(state, 0.5)); // thrown away
    auto const one = used.step(state, 0.125), other = fresh.step(state, 0.125);
    REQUIRE(one.converged());
    CHECK(one.iterations == other.iterations);
    CHECK(same(one.state, other.state));
    changes += one.state.contacts[0][0].status != state.contacts[0][0].status ? 1 : 0;
    state = one.state;
  }
  CHECK(changes >= 2);
}

TEST_CASE("linear bodies: the same stepper repeats a step bit by bit") {
  auto table = test::two_blocks();
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.1, 12);
  auto const first = stepper.step(state, 0.1), second = stepper.step(state, 0.1);
  REQUIRE(first.converged());
  CHECK(same(first.state, second.state));
}

TEST_CASE("a leap too far for the cells turns them inside out, smaller steps then get through") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.material") =
      test::make("material.blatz_ko", {{"shear_modulus", test::value(400, "Pa")}});
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 2}, {0, 3}, {0, -0.6}), test::fix("foot.bottom", true, false)});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const start = stepper.initial();
  auto const failed = stepper.step(start, 1);
  REQUIRE_FALSE(failed.converged());
  CHECK(failed.verdict == StepVerdict::inverted_cell);
  CHECK(failed.reason.find("inside out") != std::string::npos);
  auto const end = test::march(stepper, start, 1.0 / 16, 16);
  CHECK(test::contact_force(scene, end).y() > 100);
}

TEST_CASE("a contact solver that gives up is a verdict") {
  auto table = rubbing();
  test::at(table, "solver") =
      test::make("solver.uzawa", {{"iterations", test::value(1)}, {"tolerance", test::value(1e-14)}});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const outcome = stepper.step(stepper.initial(), 0.5);
  CHECK(outcome.verdict == StepVerdict::contact_failed);
  CHECK(outcome.reason.find("contact") != std::string::npos);
}

TEST_CASE("a body that nothing holds ends in a verdict with a reason") {
  auto table = floating();
  test::at(table, "gravity") = test::values({0, -10}, "m/s^2");
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  auto const scene = scene::build(table);
  scene.model->scheme = dynamics::QuasiStatic{}; // a script's scene would be refused
  dynamics::Stepper stepper(*scene.model);
  auto const outcome = stepper.step(stepper.initial(), 1);
  CHECK_FALSE(outcome.converged());
  CHECK_FALSE(outcome.reason.empty());
}

TEST_CASE("a converged step is out of balance by less than the tolerance that was asked for") {
  auto const scene = scene::build(rubbing());
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.05, 24);
  std::set<int> counts;
  for (double tolerance = 1e-2; tolerance > 1e-9; tolerance /= 1.5) {
    CAPTURE(tolerance);
    scene.model->control.force_tolerance = tolerance;
    auto const outcome = stepper.step(state, 0.05);
    REQUIRE(outcome.converged());
    CHECK(outcome.out_of_balance <= tolerance);
    CHECK(outcome.out_of_balance >= 0);
    counts.insert(outcome.iterations);
  }
  CHECK(counts.size() > 2);
}

TEST_CASE("a step that may not iterate says how far it came") {
  auto const scene = scene::build(rubbing());
  auto const attempt = [&](int iterations) {
    scene.model->control.iterations = iterations;
    dynamics::Stepper stepper(*scene.model);
    return stepper.step(stepper.initial(), 1);
  };
  auto const first = attempt(1), second = attempt(2);
  for (auto const& outcome : {first, second}) {
    CHECK(outcome.verdict == StepVerdict::not_converged);
    CHECK(outcome.out_of_balance > scene.model->control.force_tolerance);
  }
  CHECK(first.reason == "with points still coming into contact or changing their bonding after 1 iterations");
  CHECK(second.reason.starts_with("out of balance by"));
}

TEST_CASE("after the first step SuiteSparse takes nothing from the system") {
  auto const scene = scene::build(rubbing());
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.05, 1);
  auto const before = linear::blocks_from_system();
  auto const factorizations = stepper.cost().factorizations;
  auto later = state;
  for (double const dt : {0.05, 0.04, 0.03, 0.02, 0.03, 0.04}) // a new size asks for a new factor
    later = test::march(stepper, later, dt, 3);
  CHECK(stepper.cost().factorizations > factorizations + 4);
  CHECK(linear::blocks_from_system() == before);
}

TEST_CASE("rubber that nothing strains is carried along, however short the way") {
  for (double const way : {1e-2, 1e-5, 1e-9, 1e-14}) {
    INFO("way " << way);
    auto table = floating();
    test::at(table, "bodies.foot.material") = test::make(
        "material.neo_hookean", {{"young", test::value(1e6, "Pa")}, {"poisson", test::value(0.4)}});
    test::at(table, "motions") = test::list({test::drive("foot.top", {0, 1}, {0, way}, {0, 0})});
    test::at(table, "scheme") = test::quasi_static();
    test::at(table, "schedule") = test::schedule({{1, 4}});
    auto const scene = scene::build(table);
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), 0.25, 4);
    for (Index i = 0; i < scene.model->node_count(); ++i) {
      CHECK(std::abs(state.u[2 * i] - way) < 1e-8 * way + 1e-14);
      CHECK(std::abs(state.u[2 * i + 1]) < 1e-8 * way + 1e-14);
    }
  }
}

TEST_CASE("what is left of the forces of a body let go may fade to numbers without digits") {
  auto table = floating();
  test::at(table, "bodies.foot") = test::block({{0, 0}, {1, 1}, {40, 40}}, test::linear_elastic(1e5, 0.49));
  test::at(table, "bodies.foot.interpolation") = test::text("mean_dilatation");
  test::at(table, "motions") = test::list({test::fix("foot.bottom")});
  test::at(table, "loads") =
      test::list({test::make("load.traction", {{"set", test::text("foot.top")},
                                               {"times", test::values({0, 1, 2}, "s")},
                                               {"y", test::values({0, 100, 0}, "Pa")}})});
  test::at(table, "scheme") = test::quasi_static();
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const pulled = test::march(stepper, stepper.initial(), 1, 1);
  for (double const part : {1e-300, 1e-305, 1e-308, 1e-310, 1e-312}) {
    CAPTURE(part);
    auto faded = pulled;
    for (auto* all : {&faded.u, &faded.internal, &faded.drive})
      *all *= part;
    auto const rest = test::march(stepper, faded, 1, 4);
    CHECK(rest.u.lpNorm<Eigen::Infinity>() < 1e-200);
  }
}

TEST_CASE("a step whose energies are rounding is not refused for making energy") {
  for (char const* scheme : {"scheme.theta_xi", "scheme.newmark"})
    for (double const drift : {0.0, 1e-12}) {
      INFO(scheme << " " << drift);
      auto table = floating();
      test::at(table, "bodies.foot.material") = test::make(
          "material.neo_hookean", {{"young", test::value(1e6, "Pa")}, {"poisson", test::value(0.4)}});
      test::at(table, "bodies.foot.velocity") = test::values({drift, 0}, "m/s");
      test::at(table, "scheme") = test::make(scheme);
      auto const scene = scene::build(table);
      dynamics::Stepper stepper(*scene.model);
      auto const state = test::march(stepper, stepper.initial(), 0.1, 50);
      CHECK(std::abs(state.u[0] - 5 * drift) < 1e-14);
    }
}
