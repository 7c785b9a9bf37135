// Tied surfaces: uniform stress, rigid turns, order of convergence, ledger and momentum.
#include <numbers>

#include "dynamics/all_schemes.hpp"
#include "dynamics/tied_blocks.hpp"

using namespace stiction;
using test::Vec3;

namespace {

constexpr double E = 1000, nu = 0.3;

test::Input neo_hookean() {
  return test::make("material.neo_hookean", {{"young", test::value(E, "Pa")}, {"poisson", test::value(nu)}});
}

struct End {
  scene::Scene scene;
  test::State start, state;
};

End run(test::Input const& table, int steps = 1, double duration = 1) {
  End end{scene::build(table), {}, {}};
  end.scene.model->control.force_tolerance = 1e-13;
  dynamics::Stepper stepper(*end.scene.model);
  end.start = stepper.initial();
  end.state = test::march(stepper, end.start, duration / steps, steps);
  return end;
}

/// Held across x = 0, y = -1 (z = -1 and y = 0), so that uniaxial stress is uniform.
core::List symmetry(bool space) {
  core::List all;
  for (std::string const body : {"lower", "upper"}) {
    all.push_back(space ? test::fix_in(body + ".left", "x") : test::fix(body + ".left", true, false));
    if (space)
      all.push_back(test::fix_in(body + ".front", "y"));
  }
  all.push_back(space ? test::fix_in("lower.bottom", "z") : test::fix("lower.bottom", false, true));
  return all;
}

struct Kind {
  char const *kinematics, *cell;
};
constexpr Kind kinds[] = {
    {"plane_strain", "quad4"},     {"plane_strain", "tri3"},       {"plane_strain", "quad8"},
    {"plane_strain", "tri6"},      {"axisymmetric", "quad4"},      {"axisymmetric", "tri3"},
    {"axisymmetric", "quad8"},     {"axisymmetric", "tri6"},       {"three_dimensional", "hex8"},
    {"three_dimensional", "tet4"}, {"three_dimensional", "hex20"}, {"three_dimensional", "tet10"}};

} // namespace

TEST_CASE("uniform stress passes tied meshes of 3 and 5 cells, whichever follows") {
  for (auto const& [kinematics, cell] : kinds)
    for (auto const& cells : {std::pair{3, 5}, std::pair{5, 3}}) {
      bool const space = std::string_view(kinematics) == "three_dimensional";
      auto table = test::tied_blocks(kinematics, cell, test::linear_elastic(E, nu), cells);
      test::at(table, "motions") = test::list(symmetry(space));
      test::at(table, "loads") = test::list({test::traction(
          "upper.top", space ? std::vector<double>{0, 0, -50} : std::vector<double>{0, -50})});
      auto const end = run(table);
      CAPTURE(kinematics);
      CAPTURE(cell);
      CAPTURE(cells.first);
      Matrix const stress = test::stresses(end.scene, end.state);
      CHECK(test::unevenness(stress) < 1e-10 * 50);
      CHECK(stress(0, space ? 2 : 1) == doctest::Approx(-50).epsilon(1e-10));
    }
}

TEST_CASE("uniform shear passes tied meshes, whose ends hang free") {
  for (auto const* cell : {"quad4", "tri3", "quad8", "tri6"}) {
    auto table = test::tied_blocks("plane_strain", cell, test::linear_elastic(E, nu), {3, 5});
    test::at(table, "motions") = test::list({test::fix("lower.bottom")});
    core::List loads{test::traction("upper.top", {30, 0})};
    for (std::string const body : {"lower", "upper"}) {
      loads.push_back(test::traction(body + ".right", {0, 30}));
      loads.push_back(test::traction(body + ".left", {0, -30}));
    }
    test::at(table, "loads") = test::list(std::move(loads));
    auto const end = run(table);
    CAPTURE(cell);
    Matrix const stress = test::stresses(end.scene, end.state);
    CHECK(test::unevenness(stress) < 1e-10 * 30);
    CHECK(stress(0, 3) == doctest::Approx(30).epsilon(1e-10));
  }
}

TEST_CASE("a neo-Hookean pair of tied blocks stretches as one, to twice its height") {
  for (auto const& [kinematics, cell] : kinds) {
    bool const space = std::string_view(kinematics) == "three_dimensional";
    auto table = test::tied_blocks(kinematics, cell, neo_hookean(), {3, 5});
    auto motions = symmetry(space);
    motions.push_back(space ? test::drive("upper.top", {0, 1}, {{{}, {}, {0, 2}}})
                            : test::drive("upper.top", {0, 1}, {}, {0, 2}));
    test::at(table, "motions") = test::list(std::move(motions));
    auto const end = run(table, 10);
    CAPTURE(kinematics);
    CAPTURE(cell);
    Matrix const stress = test::stresses(end.scene, end.state);
    CHECK(stress(0, space ? 2 : 1) > 0.5 * E);
    CHECK(test::unevenness(stress) < 1e-10 * E);
  }
}

TEST_CASE("uniform stress passes skewed quadrilaterals and triangles in space") {
  if (mesh::test::no_mesher())
    return;
  mesh::test::OwnCache const cache;
  // Inner nodes of every layer go up to a quarter of a cell of 1/4 sideways; those of the outline stay.
  auto const skewed = [](double low, double phase) {
    return [low, phase](Vec3 const& x) {
      double const inside = 16 * x.x() * (1 - x.x()) * x.y() * (1 - x.y()) * 0.06;
      return Vec3(x.x() + inside * std::sin(9 * x.y() + phase), x.y() + inside * std::cos(11 * x.x() - phase),
                  x.z() + low);
    };
  };
  for (bool const tets : {false, true}) {
    auto table = test::space();
    test::at(table, "schedule") = test::schedule({{1, 1}});
    test::at(table, "bodies.lower") = test::file_body(
        cache.write(tets ? "a.msh" : "b.msh", test::grid_file({{4, 3, 2}, tets}, skewed(-1, 0.3))),
        test::linear_elastic(E, nu));
    test::at(table, "bodies.upper") = test::file_body(
        cache.write(tets ? "c.msh" : "d.msh", test::grid_file({{5, 4, 2}, tets}, skewed(0, 2))),
        test::linear_elastic(E, nu));
    test::at(table, "constraints") = test::list({test::tied("upper.bottom", "lower.top")});
    test::at(table, "motions") = test::list(symmetry(true));
    test::at(table, "loads") = test::list({test::traction("upper.top", {0, 0, -50})});
    auto const end = run(table);
    CAPTURE(tets);
    CHECK(test::unevenness(test::stresses(end.scene, end.state)) < 1e-10 * 50);
  }
}

namespace {

/// A half disc of radius 1 m below an arch from there to 2 m, turned as a whole by their flat sides.
test::Input arch_on_disc(double size, std::string const& kind, double angle) {
  auto table = test::make("scene");
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "bodies.disc") = test::half_disc(1, 0.4, neo_hookean());
  test::at(table, "bodies.disc.mesh.centre") = test::values({0, 0}, "m");
  test::at(table, "bodies.disc.mesh.kind") = test::text(kind);
  auto const edge = [](std::vector<double> const& to, bool arc, char const* set) {
    auto made = test::make("edge", {{"to", test::values(to, "m")}, {"name", test::text(set)}});
    if (arc)
      test::at(made, "centre") = test::values({0, 0}, "m");
    return made;
  };
  auto mesh = test::make(
      "mesh.gmsh",
      {{"start", test::values({1, 0}, "m")}, {"size", test::value(size, "m")}, {"kind", test::text(kind)}});
  test::at(mesh, "edges") =
      test::list({edge({2, 0}, false, "right"), edge({0, 2}, true, "outer"), edge({-2, 0}, true, "outer"),
                  edge({-1, 0}, false, "left"), edge({0, 1}, true, "inner"), edge({1, 0}, true, "inner")});
  test::at(table, "bodies.arch") = test::make(
      "body",
      {{"mesh", std::move(mesh)}, {"material", neo_hookean()}, {"density", test::value(1, "kg/m^3")}});
  test::at(table, "constraints") = test::list({test::tied("arch.inner", "disc.arc")});
  test::at(table, "motions") =
      test::list({test::make("motion.turn", {{"set", test::text("disc.flat")},
                                             {"times", test::values({0, 1}, "s")},
                                             {"angle", test::values({0, angle}, "rad")},
                                             {"centre", test::values({0, 0}, "m")}})});
  return table;
}

/// Weights and moves below 1e-12 are left out. How far links are from what a turn by 90 degrees about z and a
/// shift does to the reference, m.
double off_in_turn(scene::Scene const& scene) {
  auto const& model = *scene.model;
  int const dim = model.dim();
  Vector u(model.dofs());
  for (Index i = 0; i < model.node_count(); ++i) {
    u.segment(dim * i, dim).setConstant(0.3);
    u[dim * i] += -model.reference(i, 1) - model.reference(i, 0);
    u[dim * i + 1] += model.reference(i, 0) - model.reference(i, 1);
  }
  Vector followed = u;
  dynamics::Links const links(model);
  links.follow(followed);
  return (followed - u).lpNorm<Eigen::Infinity>();
}

} // namespace

TEST_CASE("tied arcs of different meshes turn by 90 degrees without stress") {
  if (mesh::test::no_mesher())
    return;
  mesh::test::OwnCache const cache;
  for (std::string const kind : {"quad4", "tri3", "tri6"}) { // gmsh folds quad8 along the arcs
    auto const end = run(arch_on_disc(0.3, kind, std::numbers::pi / 2), 10);
    CAPTURE(kind);
    CHECK(end.scene.moved[0] > 1e-5);
    CHECK(end.scene.moved[0] < 0.02);
    CHECK(off_in_turn(end.scene) < 2e-12);
    CHECK(test::stresses(end.scene, end.state).cwiseAbs().maxCoeff() < 1e-10 * E);
  }
}

TEST_CASE("tied warped surfaces in space turn by 90 degrees without stress") {
  if (mesh::test::no_mesher())
    return;
  mesh::test::OwnCache const cache;
  auto const bent = [](double low) {
    return [low](Vec3 const& x) {
      double const bulge = 0.15 * std::sin(3 * x.x() + 1) * std::cos(2 * x.y());
      return Vec3(x.x(), x.y(), low + x.z() + bulge);
    };
  };
  for (bool const tets : {false, true}) {
    auto table = test::space();
    test::at(table, "schedule") = test::schedule({{1, 1}});
    test::at(table, "bodies.lower") = test::file_body(
        cache.write(tets ? "a.msh" : "b.msh", test::grid_file({{4, 5, 2}, tets}, bent(-1))), neo_hookean());
    test::at(table, "bodies.upper") = test::file_body(
        cache.write(tets ? "c.msh" : "d.msh", test::grid_file({{5, 4, 2}, tets}, bent(0))), neo_hookean());
    test::at(table, "constraints") = test::list({test::tied("upper.bottom", "lower.top")});
    test::at(table, "motions") =
        test::list({test::make("motion.turn", {{"set", test::text("lower.bottom")},
                                               {"times", test::values({0, 1}, "s")},
                                               {"angle", test::values({0, std::numbers::pi / 2}, "rad")},
                                               {"centre", test::values({0, 0, 0}, "m")},
                                               {"axis", test::values({0, 0, 1})}})});
    CAPTURE(tets);
    auto const end = run(table, 30);
    CHECK(end.scene.moved[0] > 1e-4);
    CHECK(off_in_turn(end.scene) < 2e-12);
    CHECK(test::stresses(end.scene, end.state).cwiseAbs().maxCoeff() < 1e-10 * E);
  }
}

namespace {

/// A cantilever of 4 m by 1 m with n cells over its height, in two parts of n and 3/2 n cells where tied; its
/// strain energy under 1 Pa across at its end, J.
double bent(std::string const& kind, int n, bool in_two) {
  auto table = test::make("scene");
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  auto const part = [&](double from, double to, int cells) {
    auto made = test::block({{from, 0}, {to - from, 1}, {cells * (to - from), 1.0 * cells}},
                            test::linear_elastic(E, 0));
    test::at(made, "mesh.kind") = test::text(kind);
    return made;
  };
  test::at(table, "bodies.near") = part(0, in_two ? 2 : 4, n);
  if (in_two) {
    test::at(table, "bodies.far") = part(2, 4, 3 * n / 2);
    test::at(table, "constraints") = test::list({test::tied("far.left", "near.right")});
  }
  test::at(table, "motions") = test::list({test::fix("near.left")});
  test::at(table, "loads") = test::list({test::traction(in_two ? "far.right" : "near.right", {0, 1})});
  return run(table).state.ledger.strain;
}

} // namespace

TEST_CASE("a cantilever in two tied parts converges as in one") {
  double const exact = bent("quad8", 32, false);
  for (auto const* kind : {"quad4", "tri3", "quad8", "tri6"}) {
    std::array<double, 2> before{};
    for (int const n : {2, 4, 8}) {
      std::array const off{exact - bent(kind, n, false), exact - bent(kind, n, true)};
      CAPTURE(kind);
      CAPTURE(n);
      CHECK(off[1] > 0);
      CHECK(off[1] < off[0]);
      if (before[0] > 0)
        CHECK(std::log2(before[1] / off[1]) > std::log2(before[0] / off[0]) - 0.05);
      before = off;
    }
  }
}

TEST_CASE("three tied blocks meet at a point, and one cell of many is tied across") {
  auto table = test::make("scene");
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  auto const part = [](std::vector<double> const& origin, std::vector<double> const& size,
                       std::vector<double> const& cells) {
    return test::block({origin, size, cells}, test::linear_elastic(E, nu));
  };
  test::at(table, "bodies.lower") = part({0, -1}, {2, 1}, {5, 2});
  test::at(table, "bodies.a") = part({0, 0}, {1, 1}, {3, 4});
  test::at(table, "bodies.b") = part({1, 0}, {1, 1}, {4, 3});
  core::List const ties{test::tied("a.bottom", "lower.top"), test::tied("b.bottom", "lower.top"),
                        test::tied("a.right", "b.left")};
  for (auto const& order : {std::array{0, 1, 2}, std::array{2, 0, 1}, std::array{1, 2, 0}}) {
    test::at(table, "constraints") = test::list({ties[ix(order[0])], ties[ix(order[1])], ties[ix(order[2])]});
    test::at(table, "motions") = test::list({test::fix("lower.bottom")});
    core::List loads;
    for (std::string const set : {"lower.right", "b.right"})
      loads.push_back(test::traction(set, {0, 30}));
    for (std::string const set : {"lower.left", "a.left"})
      loads.push_back(test::traction(set, {0, -30}));
    for (std::string const set : {"a.top", "b.top"})
      loads.push_back(test::traction(set, {30, 0}));
    test::at(table, "loads") = test::list(std::move(loads));
    auto const end = run(table);
    CHECK(test::unevenness(test::stresses(end.scene, end.state)) < 1e-10 * 30);
  }
  auto cell = test::tied_blocks("plane_strain", "quad4", test::linear_elastic(E, nu), {3, 5});
  auto& constraints = std::get<core::List>(test::at(cell, "constraints").value);
  constraints.push_back(test::periodic("lower.left", "lower.right"));
  constraints.push_back(test::periodic("upper.left", "upper.right"));
  test::at(cell, "motions") = test::list({test::fix("lower.bottom")});
  test::at(cell, "loads") = test::list({test::traction("upper.top", {30, -50})});
  auto const end = run(cell);
  CHECK(test::unevenness(test::stresses(end.scene, end.state)) < 1e-10 * 50);
}

TEST_CASE("tied bodies in flight keep momentum and energy, and their ledger closes") {
  for (auto const* kind : {"quad4", "tri6"}) {
    auto table = test::tied_blocks("plane_strain", kind, test::linear_elastic(E, nu), {3, 5});
    for (std::string const body : {"lower", "upper"}) {
      test::at(table, "bodies." + body + ".velocity_gradient") = test::values({0, 2, 0, 0.5}, "1/s");
      test::at(table, "bodies." + body + ".velocity") =
          body == "lower" ? test::values({0.3, -0.2}, "m/s") : test::values({2.3, 0.3}, "m/s");
    }
    test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
    test::at(table, "probes.momentum") = test::make("probe.momentum");
    auto const end = run(table, 100, 0.2);
    auto const &before = end.start.ledger, &after = end.state.ledger;
    CAPTURE(kind);
    CHECK(before.kinetic > 0);
    CHECK(after.strain > 0.01 * before.kinetic);
    CHECK(after.kinetic + after.strain == doctest::Approx(before.kinetic).epsilon(1e-9));
    dynamics::Screw rest = -1 * end.state.momenta.start;
    for (auto const& body : end.state.momenta.bodies)
      rest += body;
    CHECK(rest.linear.norm() < 1e-10 * end.state.momenta.start.linear.norm());
  }
}

TEST_CASE("a tied pair that is driven does the work that it stores, and nothing at its joint") {
  auto table = test::tied_blocks("plane_strain", "quad4", neo_hookean(), {3, 5});
  test::at(table, "motions") =
      test::list({test::fix("lower.bottom"), test::drive("upper.top", {0, 1}, {0, 0.3}, {0, 0.2})});
  double before = 0;
  for (int const steps : {8, 16}) { // trapezia of forces do a step's work
    auto const end = run(table, steps);
    Vec3 const both = test::drive_on(end.scene, end.state, "lower.bottom") +
                      test::drive_on(end.scene, end.state, "upper.top");
    CHECK(both.norm() < 1e-9 * E);
    Vec3 const joint = test::drive_on(end.scene, end.state, "upper.bottom") +
                       test::drive_on(end.scene, end.state, "lower.top");
    CHECK(joint.norm() < 1e-9 * E);
    double const off = end.state.ledger.motion_work - end.state.ledger.strain;
    if (before > 0)
      CHECK(before / off == doctest::Approx(4).epsilon(0.01));
    before = off;
  }
}

TEST_CASE("the ledger of a tied pad that is dragged with friction closes, and so does its momentum") {
  for (auto const* inertia : {"full", "implicit"}) {
    auto table = test::tied_blocks("plane_strain", "quad4", test::linear_elastic(E, nu), {4, 6});
    test::at(table, "obstacles.floor") = test::floor();
    test::at(table, "obstacles.floor.shape.point") = test::values({0, -1}, "m");
    test::at(table, "pairs.sole") = test::pair("lower.bottom", "floor");
    test::at(table, "pairs.sole.friction") = test::coulomb(0.4);
    test::at(table, "motions") =
        test::list({test::drive("upper.top", {0, 0.2, 0.4}, {0, 0, 0.2}, {0, -0.05, -0.05})});
    test::at(table, "scheme") = test::theta_xi(0.6, 0.6);
    test::at(table, "scheme.contact_inertia") = test::text(inertia);
    test::at(table, "probes.energy") = test::make("probe.energy", {{"audit", test::flag(true)}});
    test::at(table, "probes.momentum") = test::make("probe.momentum");
    test::at(table, "schedule") = test::schedule({{0.4, 40}});
    auto const end = run(table, 40, 0.4);
    auto const& ledger = end.state.ledger;
    CAPTURE(inertia);
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
