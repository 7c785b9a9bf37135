// Cavities that are open at a seal or at moving motions: their volumes in every kinematics.
#include <cmath>
#include <fstream>
#include <map>

#include "dynamics/bulk/surface_loads.hpp"
#include "dynamics/space.hpp"
#include "folder.hpp"

using namespace stiction;

namespace {

/// Two cells along each side of a square or cube of 2 m, but the one at the origin, which is the pocket: its
/// wall is "wall", sets x0, y0, bottom, top.
std::string pocket(int dim) {
  int const layers = dim == 3 ? 3 : 1;
  auto const number = [](int i, int j, int k) { return 1 + i + 3 * j + 9 * k; };
  std::string nodes = "*NODE\n", cells, wall = "*SURFACE, NAME=wall, TYPE=ELEMENT\n";
  std::map<std::string, std::string> sets;
  for (int k = 0; k < layers; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i) {
        if (i == 0 && j == 0 && k == 0)
          continue;
        auto const own = std::to_string(number(i, j, k));
        nodes += own + ", " + std::to_string(i) + ", " + std::to_string(j) +
                 (dim == 3 ? ", " + std::to_string(k) : "") + "\n";
        int const height = dim == 3 ? k : j;
        for (auto const& [name, in] : std::map<std::string, bool>{
                 {"x0", i == 0}, {"y0", dim == 3 && j == 0}, {"bottom", height == 0}, {"top", height == 2}})
          if (in)
            sets[name] += own + "\n";
      }
  int cell = 0;
  for (int k = 0; k < std::max(1, layers - 1); ++k)
    for (int j = 0; j < 2; ++j)
      for (int i = 0; i < 2; ++i) {
        if (i + j + k == 0)
          continue;
        cells += std::to_string(++cell);
        for (int up = 0; up < (dim == 3 ? 2 : 1); ++up)
          for (auto const& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
            cells += ", " + std::to_string(number(i + a, j + b, k + up));
        cells += "\n";
        if (i + j + k == 1)
          wall += std::to_string(cell) + (k == 1   ? ", S1\n"
                                          : j == 1 ? (dim == 3 ? ", S3\n" : ", S1\n")
                                                   : (dim == 3 ? ", S6\n" : ", S4\n"));
      }
  std::string file =
      nodes + "*ELEMENT, TYPE=" + (dim == 3 ? "C3D8" : "CPE4") + ", ELSET=all\n" + cells + wall;
  for (auto const& [name, own] : sets)
    file.append("*NSET, NSET=").append(name).append("\n").append(own);
  return file;
}

/// A stiff pocket without motions or loads.
test::Input scene_of(test::Folder const& folder, char const* kinematics) {
  int const dim = std::string(kinematics) == "three_dimensional" ? 3 : 2;
  auto const path = (folder / "pocket.inp").string();
  std::ofstream(path) << pocket(dim);
  auto table = test::make("scene");
  test::at(table, "kinematics") = test::text(kinematics);
  test::at(table, "bodies.cup") =
      test::make("body", {{"mesh", test::make("mesh.msh_file", {{"path", test::text(path)}})},
                          {"material", test::make("material.neo_hookean", {{"young", test::value(1e9, "Pa")},
                                                                           {"poisson", test::value(0.3)}})},
                          {"density", test::value(1, "kg/m^3")}});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

test::Input air(core::Table more) {
  more["set"] = test::text("cup.wall");
  more["times"] = test::values({0, 1}, "s");
  if (!more.contains("volume")) {
    more["pressure"] = test::values({0, 0}, "Pa");
    more["outside"] = test::value(1e5, "Pa");
  }
  return test::make("load.gas", std::move(more));
}

std::vector<double> up(int dim) {
  return dim == 3 ? std::vector<double>{0, 0, 1} : std::vector<double>{0, 1};
}

/// Sideways where nothing else holds it, up by `way`.
test::Input lift(std::string set, int dim, double way) {
  std::vector<double> const none{0, 0}, all{0, way};
  return test::drive(std::move(set), {0, 1},
                     std::array<std::vector<double>, 3>{none, dim == 3 ? none : all,
                                                        dim == 3 ? all : std::vector<double>{}});
}

test::Input turn(std::string set, int dim) {
  return test::make(
      "motion.turn",
      {{"set", test::text(std::move(set))},
       {"times", test::values({0, 1}, "s")},
       {"angle", test::values({0, 0.7})},
       {"centre", test::values(dim == 3 ? std::vector<double>{5, 0, 5} : std::vector<double>{5, 4}, "m")},
       {"axis", test::values(dim == 3 ? std::vector<double>{0, 1, 0} : std::vector<double>{0, 0, 1})}});
}

struct Reached {
  scene::Scene scene;
  test::State state;
  [[nodiscard]] double volume() const {
    auto const& gas = scene.model->gases[0];
    return dynamics::SurfaceLoads(*scene.model).volume(gas, state.u) / gas.volume;
  }
};
Reached reach(test::Input const& table, int steps) {
  Reached result{scene::build(table), {}};
  dynamics::Stepper stepper(*result.scene.model);
  result.state = test::march(stepper, stepper.initial(), 1.0 / steps, steps);
  return result;
}

constexpr char const* kinds[] = {"plane_strain", "axisymmetric", "three_dimensional"};

} // namespace

TEST_CASE("under a lifted rim the cavity grows by its area times the way, and its gas does that work") {
  for (auto const* const kind : kinds) {
    CAPTURE(kind);
    int const dim = std::string(kind) == "three_dimensional" ? 3 : 2;
    test::Folder const folder;
    auto const ended = [&](int steps) {
      auto table = scene_of(folder, kind);
      test::at(table, "motions") = test::list({lift("cup.all", dim, 0.28)});
      test::at(table, "loads") =
          test::list({air({{"seal", test::values(up(dim))}, {"leaks_at", test::value(0.3, "m")}})});
      return reach(table, steps);
    };
    auto const end = ended(40);
    CHECK(end.volume() == doctest::Approx(1.28).epsilon(1e-9));
    double const p = end.state.gas[0].pressure;
    CHECK(p == doctest::Approx(1e5 * (1 / 1.28 - 1)).epsilon(1e-9));
    double const work = 1e5 * end.scene.model->gases[0].volume * (std::log(1.28) - 0.28);
    auto const missed = [&](Reached const& one) { return std::abs(one.state.ledger.load_work / work - 1); };
    CHECK(missed(end) < 1e-3);
    CHECK(missed(ended(20)) / missed(end) == doctest::Approx(4).epsilon(0.01)); // trapezia
  }
}

TEST_CASE("a cavity whose ends are carried or turned as a rigid body stays as it is") {
  for (auto const* const kind : kinds)
    for (bool const turned : {false, true})
      for (bool const by_volume : {false, true}) {
        bool const revolved = std::string(kind) == "axisymmetric";
        if (turned && revolved)
          continue;
        CAPTURE(kind);
        CAPTURE(turned);
        CAPTURE(by_volume);
        int const dim = std::string(kind) == "three_dimensional" ? 3 : 2;
        test::Folder const folder;
        auto table = scene_of(folder, kind);
        auto motions = turned ? core::List{turn("cup.bottom", dim), turn("cup.x0", dim)}
                              : core::List{lift("cup.bottom", dim, 0.5), test::fix_in("cup.x0", "x")};
        if (dim == 3)
          motions.push_back(turned ? turn("cup.y0", dim) : test::fix_in("cup.y0", "y"));
        test::at(table, "motions") = test::list(std::move(motions));
        test::at(table, "loads") =
            test::list({air(by_volume ? core::Table{{"volume", test::values({1, 1})}} : core::Table{})});
        auto const end = reach(table, 8);
        CHECK(end.volume() == doctest::Approx(1).epsilon(1e-6));
        CHECK(std::abs(end.state.gas[0].pressure) < 1e-8 * 1e9); // Young's modulus
      }
}

TEST_CASE("a thin strip over liquid gives way by bending: pushed on one side it rises on the other") {
  auto table = test::make("scene");
  test::at(table, "bodies.strip") = test::block({{0, 0}, {1, 0.02}, {40, 2}}, test::linear_elastic(1, 0));
  test::at(table, "bodies.strip.mesh.kind") = test::text("quad8");
  test::at(table, "motions") = test::list({test::fix("strip.left"), test::fix("strip.right")});
  double const force = 1e-9, bending = std::pow(0.02, 3) / 12;
  test::at(table, "loads") = test::list({test::make("load.gas", {{"set", test::text("strip.bottom")},
                                                                 {"times", test::values({0, 1}, "s")},
                                                                 {"centre", test::values({0.5, -0.5}, "m")},
                                                                 {"volume", test::values({1, 1})}}),
                                         test::make("load.force", {{"set", test::text("strip.top")},
                                                                   {"near", test::values({0.5, 0.02}, "m")},
                                                                   {"times", test::values({0, 1}, "s")},
                                                                   {"y", test::values({0, -force}, "N")}})});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const outcome = stepper.step(stepper.initial(), 1);
  INFO(outcome.reason);
  REQUIRE(outcome.converged());
  CHECK(outcome.iterations <= 10);
  // clamped: a force gives the volume F L^4 / (384 E I), a pressure p L^5 / (720 E I)
  CHECK(outcome.state.gas[0].pressure == doctest::Approx(720.0 / 384 * force).epsilon(2e-3));
  double const sag = force / bending * (1.0 / 192 - 720.0 / 384 / 384);
  Index const middle = scene.nearest(test::nodes_of(scene, "strip.bottom"), {0.5, 0});
  CHECK(-outcome.state.u[2 * middle + 1] == doctest::Approx(sag).epsilon(2e-2));
  auto const& gas = scene.model->gases[0];
  CHECK(dynamics::SurfaceLoads(*scene.model).volume(gas, outcome.state.u) / gas.volume ==
        doctest::Approx(1).epsilon(1e-12));
}
