// Pressure that follows, gas, surface stress: known answers, Newton's cost, the energy account.
#include <numbers>

#include "dynamics/all_schemes.hpp"
#include "dynamics/bulk/critical_step.hpp"
#include "dynamics/space.hpp"
#include "mesh/gmsh/mesher_process.hpp"

using namespace stiction;

namespace {

constexpr double pi = std::numbers::pi;

test::Input rubber(double young, double poisson) {
  return test::make("material.neo_hookean",
                    {{"young", test::value(young, "Pa")}, {"poisson", test::value(poisson)}});
}

test::Input pressure(std::string set, std::vector<double> const& times, std::vector<double> const& p) {
  return test::make("load.pressure", {{"set", test::text(std::move(set))},
                                      {"times", test::values(times, "s")},
                                      {"pressure", test::values(p, "Pa")}});
}

test::Input stress(std::string set, double gamma) {
  return test::make("load.surface_stress",
                    {{"set", test::text(std::move(set))}, {"gamma", test::value(gamma, "N/m")}});
}

/// A ring of a long tube, radii 1 m and 2 m, held along its axis; its inner side is "left".
test::Input tube(test::Input material, double cells, char const* kind = "quad8") {
  auto table = test::make("scene");
  test::at(table, "kinematics") = test::text("axisymmetric");
  test::at(table, "bodies.tube") = test::block({{1, 0}, {1, 0.2}, {cells, 1}}, std::move(material));
  test::at(table, "bodies.tube.mesh.kind") = test::text(kind);
  auto held = test::make("motion.fix", {{"set", test::text("tube.all")}, {"y", test::flag(true)}});
  test::at(table, "motions") = test::list({held});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

struct Inflated {
  test::State state;
  int iterations = 0; ///< at most in a step
};
void take(Inflated& result, dynamics::Outcome outcome) {
  INFO(outcome.reason);
  REQUIRE(outcome.converged());
  result.iterations = std::max(result.iterations, outcome.iterations);
  result.state = std::move(outcome.state);
}
Inflated inflate(scene::Scene const& scene, int steps) {
  scene.model->control.force_tolerance = 1e-11;
  dynamics::Stepper stepper(*scene.model);
  Inflated result{stepper.initial()};
  for (int k = 0; k < steps; ++k)
    take(result, stepper.step(result.state, 1.0 / steps));
  return result;
}

double radial(scene::Scene const& scene, test::State const& state, char const* set) {
  return state.u[2 * test::nodes_of(scene, set)[0]];
}

/// Lame's tube under p inside, plane strain: u(a) = p a^2 / (b^2 - a^2) ((1 - 2 nu) a + b^2 / a) / (2 G).
double lame(double p, double young, double nu) {
  double const a = 1, b = 2, G = young / (2 * (1 + nu));
  return p * a * a / (b * b - a * a) * ((1 - 2 * nu) * a + b * b / a) / (2 * G);
}

double lame_error(double cells) {
  double const p = 1e-6;
  auto table = tube(test::linear_elastic(1, 0.3), cells, "quad4");
  test::at(table, "loads") = test::list({pressure("tube.left", {0, 1}, {0, p})});
  auto const scene = scene::build(table);
  return std::abs(radial(scene, inflate(scene, 1).state, "tube.left") / lame(p, 1, 0.3) - 1);
}

/// Incompressible neo-Hookean tube blown up to the stretch s of its inner side.
double tube_pressure(double mu, double s) {
  double const outer = std::sqrt((4 + s * s - 1) / 4);
  auto const F = [](double x) { return std::log(x) - 0.5 / (x * x); };
  return mu * (F(s) - F(outer));
}

test::Input arc(std::array<double, 2> to, std::string name, bool round) {
  auto edge =
      test::make("edge", {{"to", test::values({to[0], to[1]}, "m")}, {"name", test::text(std::move(name))}});
  if (round)
    test::at(edge, "centre") = test::values({0, 0}, "m");
  return edge;
}

/// A hollow ball, radii 1 m and `outer`, filled to `volume` times its first cavity.
test::Input balloon(double outer, double volume) {
  auto table = test::make("scene");
  test::at(table, "kinematics") = test::text("axisymmetric");
  test::at(table, "bodies.ball") = test::make(
      "body",
      {{"mesh",
        test::make("mesh.gmsh",
                   {{"start", test::values({1, 0}, "m")},
                    {"size", test::value(0.15, "m")},
                    {"kind", test::text("quad8")},
                    {"edges", test::list({arc({outer, 0}, "flat", false), arc({0, outer}, "outer", true),
                                          arc({0, 1}, "axis", false), arc({1, 0}, "inner", true)})}})},
       {"material", rubber(1, 0.499)},
       {"density", test::value(1, "kg/m^3")}});
  test::at(table, "motions") = test::list({test::fix("ball.flat", false, true)});
  test::at(table, "loads") = test::list({test::make("load.gas", {{"set", test::text("ball.inner")},
                                                                 {"times", test::values({0, 1}, "s")},
                                                                 {"volume", test::values({1, volume})}})});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

/// Incompressible neo-Hookean hollow ball blown up to the stretch s of its inner side.
double ball_pressure(double mu, double outer, double s) {
  double const b = std::cbrt(1 + (s * s * s - 1) / (outer * outer * outer));
  auto const F = [](double x) { return 2 / x + 0.5 / (x * x * x * x); };
  return mu * (F(b) - F(s));
}

/// A quarter of a cylinder (plane strain) or of a ball (about the axis), of radius 1 m.
test::Input drop(char const* kinematics, double size, test::Input material) {
  auto mesh = test::make("mesh.quarter_disc", {{"radius", test::value(1, "m")},
                                               {"fine", test::values({1.6, 1}, "m")},
                                               {"fine_size", test::value(size, "m")},
                                               {"coarse_size", test::value(size, "m")},
                                               {"kind", test::text("quad8")}});
  auto table = test::make("scene");
  test::at(table, "kinematics") = test::text(kinematics);
  test::at(table, "bodies.drop") = test::make(
      "body", {{"mesh", mesh}, {"material", std::move(material)}, {"density", test::value(1, "kg/m^3")}});
  test::at(table, "motions") =
      test::list({test::fix("drop.axis", true, false), test::fix("drop.flat", false, true)});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

double laplace_error(bool ball, double size) {
  double const gamma = 1e-7, nu = 0.3;
  auto table = drop(ball ? "axisymmetric" : "plane_strain", size, test::linear_elastic(1, nu));
  test::at(table, "loads") = test::list({stress("drop.arc", gamma)});
  auto const scene = scene::build(table);
  auto const state = inflate(scene, 1).state;
  double const inward = ball ? 2 * gamma * (1 - 2 * nu) : gamma * (1 + nu) * (1 - 2 * nu);
  double worst = 0;
  for (Index const node : test::nodes_of(scene, "drop.arc"))
    worst = std::max(worst,
                     std::abs(state.u.segment<2>(2 * node).dot(
                                  (scene.model->reference.row(node) - Eigen::RowVector2d(0, 0)).transpose()) /
                                  -inward -
                              1));
  return worst;
}

} // namespace

TEST_CASE("a tube under pressure is Lame's, to the order of its cells") {
  double const coarse = lame_error(8), fine = lame_error(16);
  CHECK(fine < 2e-3);
  CHECK(std::log2(coarse / fine) == doctest::Approx(2).epsilon(0.1));
}

TEST_CASE("a rubber tube is blown up along p(stretch), as by pressure so by volume") {
  double const nu = 0.4999, mu = 1 / (2 * (1 + nu)), s = 1.8;
  auto const error = [&](double cells, bool by_volume) {
    auto table = tube(rubber(1, nu), cells);
    if (by_volume)
      test::at(table, "loads") = test::list({test::make("load.gas", {{"set", test::text("tube.left")},
                                                                     {"times", test::values({0, 1}, "s")},
                                                                     {"volume", test::values({1, s * s})}})});
    else
      test::at(table, "loads") = test::list({pressure("tube.left", {0, 1}, {0, tube_pressure(mu, s)})});
    auto const scene = scene::build(table);
    auto const end = inflate(scene, by_volume ? 12 : 48);
    CHECK(end.iterations <= 13);
    double const got = 1 + radial(scene, end.state, "tube.left");
    if (by_volume)
      CHECK(got == doctest::Approx(s).epsilon(1e-6));
    return by_volume ? std::abs(end.state.gas[0].pressure / tube_pressure(mu, s) - 1) : std::abs(got / s - 1);
  };
  for (bool const by_volume : {false, true}) {
    CAPTURE(by_volume);
    double const fine = error(8, by_volume);
    CHECK(fine < 4e-4);
  }
}

TEST_CASE("what a pressure does is the strain energy that it leaves") {
  auto table = tube(rubber(1, 0.4), 4);
  test::at(table, "loads") = test::list({pressure("tube.left", {0, 1}, {0, 0.15})});
  auto const scene = scene::build(table);
  auto const lost = [&](int steps) {
    auto const ledger = inflate(scene, steps).state.ledger;
    CHECK(ledger.strain > 0.01);
    return std::abs(ledger.load_work / ledger.strain - 1);
  };
  CHECK(lost(40) < 1e-3);
  CHECK(std::log2(lost(20) / lost(40)) == doctest::Approx(2).epsilon(0.01)); // trapezia
}

TEST_CASE("gas of a given amount keeps p V, and its pressure is the path's at the first volume") {
  auto table = tube(rubber(1, 0.4), 4);
  test::at(table, "loads") = test::list({test::make("load.gas", {{"set", test::text("tube.left")},
                                                                 {"times", test::values({0, 1}, "s")},
                                                                 {"pressure", test::values({0, 0.3}, "Pa")},
                                                                 {"outside", test::value(0.5, "Pa")},
                                                                 {"exponent", test::value(1.4)}})});
  auto const scene = scene::build(table);
  CHECK(scene.model->gases[0].volume == doctest::Approx(pi * 0.2));
  auto const end = inflate(scene, 8);
  CHECK(end.iterations <= 13);
  double const stretch = 1 + radial(scene, end.state, "tube.left");
  CHECK(stretch > 1.05);
  CHECK((end.state.gas[0].pressure + 0.5) * std::pow(stretch, 2 * 1.4) == doctest::Approx(0.8).epsilon(1e-9));
}

TEST_CASE("gas goes out under a seal, does not come back, and leaks in where its wall has left the seal") {
  auto table = tube(rubber(1, 0.4), 4);
  auto const lift = [&](double way) {
    test::at(table, "motions") = test::list({test::drive("tube.all", {0, 0.5, 1}, {}, {0, 0, way})});
  };
  auto const gas = test::make("load.gas", {{"set", test::text("tube.left")},
                                           {"times", test::values({0, 0.25, 0.5, 1}, "s")},
                                           {"pressure", test::values({0, 0.3, 0, 0}, "Pa")},
                                           {"outside", test::value(0.5, "Pa")},
                                           {"exponent", test::value(1.4)},
                                           {"seal", test::values({0, 1})},
                                           {"leaks_at", test::value(0.01, "m")}});
  test::at(table, "loads") = test::list({gas});
  lift(0.009);
  auto const scene = scene::build(table);
  auto const end = inflate(scene, 8);
  double const stretch = 1 + radial(scene, end.state, "tube.left"), left = 0.5 * 0.5 / 0.8;
  CHECK(stretch < 0.99);
  CHECK(!end.state.gas[0].leaking);
  double const grown =
      dynamics::SurfaceLoads(*scene.model).volume(scene.model->gases[0], end.state.u) / (pi * 0.2);
  CHECK(grown == doctest::Approx(stretch * stretch * 1.045).epsilon(5e-3)); // the skirt draws the rim in
  CHECK((end.state.gas[0].pressure + 0.5) * std::pow(grown, 1.4) == doctest::Approx(left).epsilon(1e-9));
  lift(0.012);
  auto const off = scene::build(table);
  auto const after = inflate(off, 8);
  CHECK(after.state.gas[0].leaking);
  CHECK(radial(off, after.state, "tube.left") < -0.01); // found out at the end of the last step
  dynamics::Stepper stepper(*off.model);
  auto const next = stepper.step(after.state, 0.125);
  REQUIRE(next.converged());
  CHECK(next.state.gas[0].pressure == 0);
  CHECK(std::abs(radial(off, next.state, "tube.left")) < 1e-9);
}

TEST_CASE("surface stress presses a cylinder by gamma / R, a ball by 2 gamma / R") {
  for (bool const ball : {false, true}) {
    CAPTURE(ball);
    double const coarse = laplace_error(ball, 0.3), fine = laplace_error(ball, 0.15);
    CHECK(fine < 1e-4);
    CHECK(coarse > 4 * fine);
  }
}

TEST_CASE("a pressure pulls at the ends of a strip by pressure times the chord between them, turned") {
  for (bool const free_edge : {false, true}) {
    CAPTURE(free_edge);
    auto table = test::make("scene");
    test::at(table, "bodies.strip") = test::block({{0, 0}, {4, 0.4}, {16, 2}}, rubber(1000, 0.3));
    test::at(table, "bodies.strip.mesh.kind") = test::text("quad8");
    auto motions = core::List{test::fix("strip.left")};
    if (!free_edge)
      motions.push_back(test::fix("strip.right"));
    double const p = free_edge ? 0.3 : 20;
    test::at(table, "motions") = test::list(std::move(motions));
    test::at(table, "loads") = test::list({pressure("strip.bottom", {0, 1}, {0, p})});
    test::at(table, "scheme") = test::quasi_static();
    test::at(table, "schedule") = test::schedule({{1, 1}});
    auto const scene = scene::build(table);
    auto const end = inflate(scene, 20);
    CHECK(end.iterations <= 14);
    CHECK(test::largest(end.state.u) > 0.8);
    Index const tip = scene.nearest(test::nodes_of(scene, "strip.bottom"), {4, 0});
    test::Vec2 const chord = test::Vec2(4, 0) + end.state.u.segment<2>(2 * tip);
    test::Vec2 held = test::force_on(scene, end.state, "strip.left");
    if (!free_edge)
      held += test::force_on(scene, end.state, "strip.right");
    CHECK(held.isApprox(test::Vec2(p * chord.y(), -p * chord.x()), 1e-8));
  }
}

TEST_CASE("every scheme: the ledger with loads that follow surfaces closes to rounding") {
  for (auto const& sample : test::scheme_samples()) {
    if (!sample.closed_rates)
      continue;
    INFO(sample.label);
    auto table = tube(test::linear_elastic(10, 0.3), 2, "quad4");
    test::at(table, "loads") =
        test::list({pressure("tube.right", {0, 0.3, 1}, {0, 0.5, -0.2}), stress("tube.right", 0.2),
                    stress("tube.left", 0.1),
                    test::make("load.gas", {{"set", test::text("tube.left")},
                                            {"times", test::values({0, 1}, "s")},
                                            {"pressure", test::values({0, 1}, "Pa")}})});
    test::at(table, "scheme") = sample.table;
    test::at(table, "probes.energy") = test::make("probe.energy", {{"audit", test::flag(true)}});
    auto const scene = scene::build(table);
    scene.model->control.force_tolerance = 1e-13;
    dynamics::Stepper stepper(*scene.model);
    double open = 0, most = 0;
    auto const start = stepper.initial();
    CHECK(start.ledger.surface == doctest::Approx(2 * pi * 0.2 * (2 * 0.2 + 0.1)));
    auto const end = test::march(stepper, start, 0.02, 25, [&](test::State const&, test::State const& next) {
      open = std::max(open, std::abs(next.ledger.unaccounted()));
      most = std::max({most, next.ledger.kinetic, next.ledger.strain});
    });
    CHECK(end.ledger.surface != doctest::Approx(start.ledger.surface).epsilon(1e-4));
    CHECK(std::abs(end.ledger.load_work) > 1e-4);
    CHECK(open < 1e-9 * most);
  }
}

TEST_CASE("a pressure that does not follow is the traction that it says") {
  auto table = test::foot_on_floor();
  auto dead = pressure("foot.right", {0, 2}, {3, 3});
  test::at(dead, "follows") = test::flag(false);
  test::at(table, "loads") =
      test::list({dead, test::make("load.traction", {{"set", test::text("foot.right")},
                                                     {"times", test::values({0, 2}, "s")},
                                                     {"x", test::values({-3, -3}, "Pa")}})});
  auto const scene = scene::build(table);
  REQUIRE(scene.model->loads.size() == 2);
  CHECK((3 * scene.model->loads[0].force - -3 * scene.model->loads[1].force).norm() < 1e-12);
  CHECK(scene.model->pressures.empty());
}

TEST_CASE("explicit schemes know surface stresses in their stability limit") {
  auto const limit = [](double gamma) {
    auto table = test::make("scene");
    test::at(table, "bodies.block") = test::block({}, test::linear_elastic(10, 0.3));
    test::at(table, "schedule") = test::schedule({{1, 1}});
    test::at(table, "loads") = test::list({stress("block.top", gamma)});
    auto const scene = scene::build(table);
    return dynamics::critical_step(*scene.model, Vector::Zero(scene.model->dofs()));
  };
  CHECK(limit(1e-9) == doctest::Approx(limit(1e-12)).epsilon(1e-6));
  CHECK(limit(100) < 0.3 * limit(1e-9));
}

TEST_CASE("a cavity of given volume passes the largest pressure that a balloon bears") {
  if (mesh::find_mesher().empty()) {
    MESSAGE("the mesher was not built: nothing tested");
    return;
  }
  double const outer = 1.3, mu = 1 / (2 * (1 + 0.499));
  auto const scene = scene::build(balloon(outer, 8));
  CHECK(scene.model->gases[0].volume == doctest::Approx(2 * pi / 3).epsilon(1e-4)); // half a ball
  scene.model->control.force_tolerance = 1e-10;
  dynamics::Stepper stepper(*scene.model);
  double highest = 0, before = 0;
  auto const end = test::march(
      stepper, stepper.initial(), 1.0 / 112, 112, [&](test::State const&, test::State const& next) {
        double const s = std::cbrt(1 + 7 * next.t);
        CHECK(next.gas[0].pressure == doctest::Approx(ball_pressure(mu, outer, s)).epsilon(3e-3));
        CHECK(next.gas[0].pressure != before);
        before = next.gas[0].pressure;
        highest = std::max(highest, before);
      });
  CHECK(end.gas[0].pressure < 0.95 * highest);
}

namespace {

/// An eighth of a ball of radius 1 m, E = 1 Pa, under a load on its cap; how far that comes inwards over
/// `way`, less 1, at worst.
double inward_error(double size, test::Input load, double way) {
  auto mesh = test::make("mesh.half_ball", {{"radius", test::value(1, "m")},
                                            {"fine", test::values({1.6, 1}, "m")},
                                            {"fine_size", test::value(size, "m")},
                                            {"coarse_size", test::value(size, "m")},
                                            {"part", test::text("quarter")},
                                            {"kind", test::text("hex20")}});
  auto table = test::make("scene");
  test::at(table, "kinematics") = test::text("three_dimensional");
  test::at(table, "bodies.ball") = test::make("body", {{"mesh", std::move(mesh)},
                                                       {"material", test::linear_elastic(1, 0.3)},
                                                       {"density", test::value(1, "kg/m^3")}});
  test::at(table, "motions") =
      test::list({test::fix_in("ball.symmetry_x", "x"), test::fix_in("ball.symmetry_y", "y"),
                  test::fix_in("ball.flat", "z")});
  test::at(table, "loads") = test::list({std::move(load)});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  auto const scene = scene::build(table);
  auto const state = inflate(scene, 1).state;
  double worst = 0;
  for (Index const node : test::nodes_of(scene, "ball.cap"))
    worst = std::max(worst,
                     std::abs(state.u.segment<3>(3 * node).dot(scene.model->reference.row(node)) / -way - 1));
  return worst;
}

} // namespace

TEST_CASE(
    "in space a ball gives way to pressure by p (1 - 2 nu) / E, to surface stress by Young and Laplace") {
  double const small = 1e-7, nu = 0.3;
  for (bool const pressed : {true, false}) {
    CAPTURE(pressed);
    auto const error = [&](double size) {
      return inward_error(size,
                          pressed ? pressure("ball.cap", {0, 1}, {0, small}) : stress("ball.cap", small),
                          small * (pressed ? 1 : 2) * (1 - 2 * nu));
    };
    double const coarse = error(0.5), fine = error(0.25);
    CHECK(fine <
          (pressed ? 10 * small : 5e-3)); // of a pressure the strain is uniform: exact but for its square
    CHECK((pressed || coarse > 3 * fine));
  }
}
