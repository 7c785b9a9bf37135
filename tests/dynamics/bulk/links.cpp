// Constraints: oblique rollers and periodic sides, beside closed forms, stiff springs and wider bodies.
#include <numbers>

#include "dynamics/all_schemes.hpp"
#include "dynamics/space.hpp"

using namespace stiction;
using test::Vec3;

namespace {

constexpr double E = 1000, nu = 0.3;

test::Input neo_hookean() {
  return test::make("material.neo_hookean", {{"young", test::value(E, "Pa")}, {"poisson", test::value(nu)}});
}
test::Input traction(std::string set, double x, double y) {
  return test::make("load.traction", {{"set", test::text(std::move(set))},
                                      {"times", test::values({0, 1}, "s")},
                                      {"x", test::values({0, x}, "Pa")},
                                      {"y", test::values({0, y}, "Pa")}});
}

/// A block "pad" of `width` times 1 m, its bottom held, its sides alike, its top pulled.
test::Input column(double width, double cells, test::Input material) {
  auto table = test::make("scene");
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "bodies.pad") = test::block({{0, 0}, {width, 1}, {cells, 4}}, std::move(material));
  test::at(table, "motions") = test::list({test::fix("pad.bottom")});
  test::at(table, "constraints") = test::list({test::periodic("pad.left", "pad.right")});
  test::at(table, "loads") = test::list({traction("pad.top", 30, -50)});
  return table;
}

struct End {
  scene::Scene scene;
  test::State start, state;
  int iterations = 0; ///< most of a step
};

End run(test::Input const& table, int steps = 1, double duration = 1) {
  End end{scene::build(table), {}, {}};
  end.scene.model->control.force_tolerance = 1e-12;
  dynamics::Stepper stepper(*end.scene.model);
  end.state = end.start = stepper.initial();
  for (int k = 0; k < steps; ++k) {
    auto const outcome = stepper.step(end.state, duration / steps);
    INFO(outcome.reason);
    REQUIRE(outcome.converged());
    end.iterations = std::max(end.iterations, outcome.iterations);
    end.state = outcome.state;
  }
  return end;
}

/// N s
Eigen::Vector2d momentum(scene::Scene const& scene, test::State const& state) {
  dynamics::BulkSystem const bulk(*scene.model, dynamics::weights(scene.model->scheme));
  Vector p;
  bulk.mass().times(state.v, p);
  return p.reshaped(2, p.size() / 2).rowwise().sum();
}

Index node_at(scene::Scene const& scene, double x, double y) {
  auto const& nodes = scene.model->reference;
  for (Index k = 0; k < nodes.rows(); ++k)
    if (std::abs(nodes(k, 0) - x) < 1e-9 && std::abs(nodes(k, 1) - y) < 1e-9)
      return k;
  FAIL("no node there");
  return 0;
}

/// A block whose right side is on an oblique plane, pulled up at its top, its left side held.
test::Input on_rollers(test::Input material) {
  auto table = test::make("scene");
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "bodies.pad") = test::block({{0, 0}, {2, 1}, {4, 2}}, std::move(material));
  test::at(table, "motions") = test::list({test::fix("pad.left")});
  test::at(table, "loads") = test::list({traction("pad.top", 20, 40)});
  return table;
}

} // namespace

TEST_CASE("a linear column with alike sides is sheared and pressed as one of infinite width") {
  auto const end = run(column(0.5, 2, test::linear_elastic(E, nu)));
  double const G = E / (2 * (1 + nu)), M = 2 * G * (1 - nu) / (1 - 2 * nu);
  auto const& nodes = end.scene.model->reference;
  for (Index k = 0; k < nodes.rows(); ++k) {
    CHECK(end.state.u[2 * k] == doctest::Approx(30 / G * nodes(k, 1)).epsilon(1e-10));
    CHECK(end.state.u[2 * k + 1] == doctest::Approx(-50 / M * nodes(k, 1)).epsilon(1e-10));
  }
  CHECK(end.state.ledger.load_work == doctest::Approx(end.state.ledger.strain).epsilon(1e-10)); // one step
}

TEST_CASE("a neo-Hookean column of one cell does what a wider one does, in few iterations") {
  auto const narrow = run(column(0.25, 1, neo_hookean())), wide = run(column(1, 4, neo_hookean()));
  for (double const y : {0.25, 0.5, 1.0})
    for (int c = 0; c < 2; ++c) {
      double const there = wide.state.u[2 * node_at(wide.scene, 0.5, y) + c];
      CHECK(narrow.state.u[2 * node_at(narrow.scene, 0.25, y) + c] == doctest::Approx(there).epsilon(1e-9));
    }
  auto table = column(1, 4, neo_hookean());
  test::remove(table, "constraints");
  CHECK(narrow.iterations <= run(table).iterations + 1);
  Vec3 const bears = test::drive_on(wide.scene, wide.state, "pad.bottom");
  CHECK(bears.x() == doctest::Approx(-30).epsilon(1e-9));
  CHECK(bears.y() == doctest::Approx(50).epsilon(1e-9));
}

TEST_CASE("sides alike in both directions leave one node of four corners") {
  auto table = column(1, 3, test::linear_elastic(E, nu));
  test::at(table, "motions") = test::list({});
  test::at(table, "loads") = test::list({});
  test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
  test::at(table, "constraints") =
      test::list({test::periodic("pad.left", "pad.right"), test::periodic("pad.top", "pad.bottom")});
  auto const scene = scene::build(table);
  dynamics::BulkSystem const bulk(*scene.model, dynamics::weights(scene.model->scheme));
  CHECK(bulk.unknowns() == 2 * 3 * 4);
  std::set<Index> followers;
  for (auto const& link : scene.model->links)
    followers.insert(link.dof);
  CHECK(followers.size() == scene.model->links.size());
  for (auto const& link : scene.model->links)
    for (auto const& [master, weight] : link.masters) {
      CHECK(!followers.contains(master));
      CHECK(weight == 1);
    }
}

TEST_CASE("an oblique roller is what ever stiffer springs across it become") {
  for (auto const& material : {test::linear_elastic(E, nu), neo_hookean()}) {
    auto table = on_rollers(material);
    test::at(table, "constraints") = test::list({test::roller("pad.right", {1, 2})});
    auto const exact = run(table);
    table = on_rollers(material);
    double before = 0;
    for (double const stiffness : {1e7, 1e8}) {
      test::at(table, "springs.across") = test::make("spring", {{"from", test::text("pad.right")},
                                                                {"stiffness", test::value(stiffness, "N/m")},
                                                                {"direction", test::values({1, 2})},
                                                                {"spread", test::flag(true)}});
      auto const near = run(table);
      CHECK(exact.iterations <= near.iterations + 1);
      double const off = (near.state.u - exact.state.u).norm() / exact.state.u.norm();
      if (before > 0)
        CHECK(before / off == doctest::Approx(10).epsilon(0.02));
      before = off;
    }
    CHECK(before < 1e-4);
  }
}

TEST_CASE("what rollers bear is across them, balances the load, and does no work") {
  auto table = on_rollers(neo_hookean());
  test::at(table, "constraints") = test::list({test::roller("pad.right", {1, 2})});
  auto const end = run(table, 4);
  double force = 0;
  for (Index const node : test::nodes_of(end.scene, "pad.right")) {
    auto const at = end.state.drive.segment<2>(2 * node), u = end.state.u.segment<2>(2 * node);
    CHECK(std::abs(at.dot(Eigen::Vector2d(2, -1))) < 1e-9);
    CHECK(std::abs(u.dot(Eigen::Vector2d(1, 2))) < 1e-14);
    force += at.norm();
  }
  CHECK(force > 1);
  Vec3 const both =
      test::drive_on(end.scene, end.state, "pad.right") + test::drive_on(end.scene, end.state, "pad.left");
  CHECK(both.x() == doctest::Approx(-2 * 20).epsilon(1e-8));
  CHECK(both.y() == doctest::Approx(-2 * 40).epsilon(1e-8));
  CHECK(std::abs(end.state.ledger.motion_work) < 1e-10);
}

TEST_CASE("a roller in space leaves two directions, and a side that is driven takes the other along") {
  auto table = test::space();
  test::at(table, "bodies.cube") = test::box({}, neo_hookean());
  test::at(table, "motions") = test::list({test::fix_in("cube.bottom", "xyz")});
  test::at(table, "constraints") = test::list({test::roller("cube.right", {2, 1, -1})});
  test::at(table, "motions") = test::list(
      {test::fix_in("cube.left", "xyz"), test::drive("cube.right", {0, 2}, {{{0, 0.1}, {}, {0, -0.1}}})});
  double before = 0;
  for (int const steps : {8, 16}) { // trapezia of forces do a step's work
    auto const end = run(table, steps, 2);
    for (Index const node : test::nodes_of(end.scene, "cube.right"))
      CHECK(end.state.u[3 * node + 1] == doctest::Approx(-0.3).epsilon(1e-12));
    double const off = end.state.ledger.motion_work - end.state.ledger.strain;
    if (before > 0)
      CHECK(before / off == doctest::Approx(4).epsilon(0.02));
    before = off;
  }
  table = column(1, 2, neo_hookean());
  test::at(table, "motions") = test::list({test::drive("pad.left", {0, 1}, {0, 0.1}, {0, 0.2})});
  test::at(table, "loads") = test::list({});
  auto const carried = run(table);
  for (Index dof = 0; dof < carried.state.u.size(); ++dof)
    CHECK(carried.state.u[dof] == doctest::Approx(dof % 2 == 0 ? 0.1 : 0.2).epsilon(1e-9));
}

TEST_CASE("a pad with alike sides is pressed and dragged as an infinite one") {
  auto table = column(0.5, 2, test::linear_elastic(E, nu));
  test::at(table, "obstacles.floor") = test::floor();
  test::at(table, "pairs.sole") = test::pair("pad.bottom", "floor");
  test::at(table, "pairs.sole.friction") = test::coulomb(0.4);
  test::at(table, "loads") = test::list({});
  test::at(table, "motions") = test::list({test::drive("pad.top", {0, 1, 2}, {0, 0, 0.5}, {0, -0.1, -0.1})});
  test::at(table, "schedule") = test::schedule({{2, 4}});
  double const G = E / (2 * (1 + nu)), M = 2 * G * (1 - nu) / (1 - 2 * nu), pressed = 0.5 * 0.1 * M;
  double before = 0;
  for (int const steps : {8, 16}) {
    auto const end = run(table, steps, 2);
    Vec3 const force = test::contact_on(end.scene, end.state);
    CHECK(force.y() == doctest::Approx(pressed).epsilon(1e-8));
    CHECK(force.x() == doctest::Approx(-0.4 * pressed).epsilon(1e-8));
    CHECK(end.state.ledger.friction_loss > 0);
    double area = 0;
    for (auto const& point : end.state.contacts[0]) { // the two ends, which are one node, share alike
      CHECK(point.dry[0] == doctest::Approx(0.1 * M).epsilon(1e-8));
      CHECK(point.dry[1] == doctest::Approx(-0.4 * 0.1 * M).epsilon(1e-8));
      area += point.area;
    }
    CHECK(area == doctest::Approx(0.5).epsilon(1e-12));
    double const off = end.state.ledger.scheme_loss(), taken = end.state.ledger.friction_loss;
    CHECK(std::abs(off) < 1.0 / steps * taken); // of the one step in which it begins to slip
    if (before != 0)
      CHECK(std::abs(off) < 0.6 * std::abs(before));
    before = off;
  }
}

TEST_CASE("with inertia constrained bodies keep momentum and energy") {
  for (auto const inertia : {"full", "implicit"}) {
    auto table = column(0.5, 2, test::linear_elastic(E, nu));
    test::at(table, "bodies.pad.velocity_gradient") = test::values({0, 2, 0, 0.5}, "1/s");
    test::at(table, "bodies.pad.velocity") = test::values({0.3, -0.2}, "m/s");
    test::at(table, "motions") = test::list({});
    test::at(table, "loads") = test::list({});
    test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
    test::at(table, "scheme.contact_inertia") = test::text(inertia);
    auto const end = run(table, 200, 0.4);
    auto const &before = end.start.ledger, &after = end.state.ledger;
    CHECK(before.kinetic > 0);
    CHECK(after.strain > 0.01 * before.kinetic);
    CHECK(after.kinetic + after.strain == doctest::Approx(before.kinetic).epsilon(1e-9));
    Eigen::Vector2d const first = momentum(end.scene, end.start), last = momentum(end.scene, end.state);
    CHECK((last - first).norm() < 1e-9 * first.norm());
  }
}

TEST_CASE("the ledger of a constrained pad with friction closes, and so does its momentum") {
  for (auto const* inertia : {"full", "implicit"})
    for (bool const driven : {false, true}) {
      auto table = column(0.5, 2, test::linear_elastic(E, nu));
      test::at(table, "obstacles.floor") = test::floor();
      test::at(table, "pairs.sole") = test::pair("pad.bottom", "floor");
      test::at(table, "pairs.sole.friction") = test::coulomb(0.4);
      test::at(table, "loads") = test::list({});
      core::List motions{test::drive("pad.top", {0, 0.2, 0.4}, {0, 0, 0.2}, {0, -0.05, -0.05})};
      if (driven) // a side along, and with it what follows
        motions = {test::drive("pad.top", {0, 0.2, 0.4}, {}, {0, -0.05, -0.05}),
                   test::drive("pad.right", {0, 0.2, 0.4}, {0, 0, 0.2}, {})};
      test::at(table, "motions") = test::list(std::move(motions));
      test::at(table, "scheme") = test::theta_xi(0.6, 0.6);
      test::at(table, "scheme.contact_inertia") = test::text(inertia);
      test::at(table, "probes.energy") = test::make("probe.energy", {{"audit", test::flag(true)}});
      test::at(table, "probes.momentum") = test::make("probe.momentum");
      test::at(table, "schedule") = test::schedule({{0.4, 40}});
      auto const end = run(table, 40, 0.4);
      auto const& ledger = end.state.ledger;
      CAPTURE(inertia);
      CAPTURE(driven);
      CHECK(ledger.friction_loss > 0);
      CHECK(std::abs(ledger.unaccounted()) < 1e-9 * ledger.motion_work);
      if (std::string_view(inertia) != "full") // else contact nodes balance by themselves
        continue;
      auto const& m = end.state.momenta;
      dynamics::Screw rest = -1 * m.start;
      for (auto const& body : m.bodies)
        rest += body;
      for (auto const& pair : m.pairs)
        rest += -1 * pair.secondary;
      rest += -1 * m.motions;
      CHECK(rest.linear.norm() < 1e-9 * m.motions.linear.norm());
    }
}
