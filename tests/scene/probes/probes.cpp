// What probes and fields show of contact points: both tangential components, areas, loads on obstacles.
#include "scene/probes/probes.hpp"

#include <cmath>
#include <doctest/doctest.h>

#include "dynamics/space.hpp"
#include "folder.hpp"
#include "scene/run/frame.hpp"

using namespace stiction;

namespace {

/// Probes of a scene sampled after one step of a second from the start.
struct Sampled {
  scene::Scene scene;
  test::State state;
  record::SeriesData series;
  [[nodiscard]] std::vector<double> const& operator()(std::string const& column) const {
    INFO(column);
    REQUIRE(series.columns.contains(column));
    return series.columns.at(column).values;
  }
  [[nodiscard]] double number(std::string const& column) const { return (*this)(column).front(); }
};

using Change = std::function<void(scene::Scene&)>;

Sampled sample(test::Input const& table, Change const& change = {}) {
  test::Folder const folder;
  Sampled result{scene::build(table), {}, {}};
  if (change)
    change(result.scene);
  result.scene.model->control.force_tolerance = 1e-11;
  dynamics::Stepper stepper(*result.scene.model);
  result.state = test::march(stepper, stepper.initial(), 1, 1);
  {
    record::Series series(folder / "series.h5");
    auto const samplers = scene::add_probes(result.scene, series);
    std::vector<double> row;
    for (auto const& sampler : samplers)
      sampler(result.state, row);
    series.append(1, row);
  }
  result.series = record::read_series(folder / "series.h5");
  return result;
}

test::Input probe(std::string const& kind, std::string const& key, std::string const& of) {
  return test::make("probe." + kind, {{key, test::text(of)}});
}

/// A cube of two cells a side, all driven: 10 Pa on the floor, and (0.06, 0.08) m sideways in the second.
test::Input rubbed_cube() {
  auto table = test::cube_on_floor();
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  auto law = test::rcc(100, 1, 1);
  test::at(law, "C_t") = test::value(50, "N/m^3");
  test::at(law, "beta0") = test::value(1);
  test::at(table, "pairs.sole.adhesion") = law;
  auto near = probe("contact_point", "pair", "sole");
  test::at(near, "near") = test::values({0, 0, 0}, "m");
  test::at(table, "motions") = test::list({test::fix_in("foot.top", "xyz")}); // until drive_all
  test::at(table, "probes.tip") = near;
  test::at(table, "probes.line") = probe("contact_line", "pair", "sole");
  test::at(table, "probes.all") = probe("contact", "pair", "sole");
  test::at(table, "probes.floor") = probe("rigid", "obstacle", "floor");
  return table;
}

void drive_all(scene::Scene& scene) {
  auto& model = *scene.model;
  model.motions.clear();
  for (Index node = 0; node < model.first_node.back(); ++node) {
    double const z = model.reference(node, 2);
    model.motions.push_back({{node}, 0, {{0, 1}, {0, 0.06}}});
    model.motions.push_back({{node}, 1, {{0, 1}, {0, 0.08}}});
    if (z > 0)
      model.motions.push_back({{node}, 2, {{0, 1}, {0, -0.01 * z}}});
  }
}

std::vector<double> const& field(record::FieldFrame const& frame, std::string const& name) {
  auto const found = std::find_if(frame.point_arrays.begin(), frame.point_arrays.end(),
                                  [&](auto const& array) { return array.name == name; });
  REQUIRE(found != frame.point_arrays.end());
  return found->values;
}

double sum(std::vector<double> const& values) {
  double total = 0;
  for (double const value : values)
    total += value;
  return total;
}

double sum_of_products(std::vector<double> const& a, std::vector<double> const& b) {
  double total = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    total += a[i] * b[i];
  return total;
}

} // namespace

TEST_CASE("probes: in space each tangential component is the one that its name says") {
  auto const seen = sample(rubbed_cube(), drive_all);
  for (std::string const probe : {"tip", "line"}) {
    CAPTURE(probe);
    auto const all = [&](std::string const& column, double expected) {
      for (double const value : seen(probe + "/" + column)) {
        INFO(column);
        CHECK(value == doctest::Approx(expected).epsilon(1e-7));
      }
    };
    all("pressure", 10);
    all("friction", -3 * 0.6);
    all("friction_2", -3 * 0.8);
    all("slip", 0.06);
    all("slip_2", 0.08);
    all("stretch", 0.06);
    all("stretch_2", 0.08);
    all("adhesion_t", -3); // C_t x_t
    all("adhesion_t2", -4);
  }
  CHECK(seen.number("all/adhesion_t_max") == doctest::Approx(5).epsilon(1e-7));
}

TEST_CASE("probes: a patch shows what its points alone do, whole pairs what all do") {
  for (std::string const method : {"node_to_segment", "mortar"}) {
    CAPTURE(method);
    auto table = rubbed_cube();
    test::at(table, "pairs.sole.discretisation") = test::text(method);
    for (std::string const side : {"left", "bottom"}) { // the edge below the left side; the whole sole
      auto patch = probe("contact", "pair", "sole");
      test::at(patch, "set") = test::text("foot." + side);
      test::at(table, "probes." + side) = patch;
    }
    auto const seen = sample(table, drive_all);
    CHECK(seen.number("left/stick") + seen.number("left/slip") == 3);
    CHECK(seen.number("bottom/slip") == seen.number("all/slip"));
    double const share = seen.number("left/closed_area"), whole = seen.number("all/closed_area");
    CHECK(share == doctest::Approx(0.25).epsilon(1e-9));
    for (std::string const c : {"x", "y", "z"}) {
      double const all = seen.number("all/force_" + c);
      CHECK(seen.number("bottom/force_" + c) == all);
      CHECK(seen.number("left/force_" + c) == doctest::Approx(share / whole * all).epsilon(1e-7));
    }
  }
}

TEST_CASE("probes: a patch off the pair's points is refused") {
  auto table = rubbed_cube();
  test::at(table, "probes.all.set") = test::text("foot.top");
  try {
    static_cast<void>(scene::build(table));
    FAIL("it was taken");
  } catch (core::InputError const& error) {
    REQUIRE(error.complaints().size() == 1);
    CHECK(error.complaints()[0].path == "probes.all.set");
    CHECK(error.complaints()[0].text.find("none of the points of pair sole") != std::string::npos);
  }
}

TEST_CASE("fields: tangential adhesion in space is the length of both components") {
  auto const seen = sample(rubbed_cube(), drive_all);
  auto const frame = scene::frame_of(seen.scene, seen.state);
  auto const& adhesion = field(frame, "tangential_adhesion");
  for (Index const node : seen.scene.model->pairs[0].secondary)
    CHECK(adhesion[ix(node)] == doctest::Approx(5).epsilon(1e-7));
}

TEST_CASE("probes: a line tells its points' count and areas, whose tractions sum to the force") {
  for (std::string const kind : {"hex8", "tet4", "hex20", "tet10"})
    for (std::string const method : {"node_to_segment", "mortar"}) {
      INFO(kind, " ", method);
      auto table = rubbed_cube();
      test::at(table, "bodies.foot.mesh.kind") = test::text(kind);
      test::at(table, "pairs.sole.discretisation") = test::text(method);
      auto const seen = sample(table, drive_all);
      auto const& areas = seen("line/area");
      CHECK(seen.series.columns.at("line/area").unit == "m^2");
      CHECK(seen.number("line/count") == static_cast<double>(areas.size()));
      CHECK(sum(areas) == doctest::Approx(1).epsilon(1e-12));
      CHECK(sum_of_products(areas, seen("line/pressure")) == doctest::Approx(10).epsilon(1e-8));
      double const along =
          sum_of_products(areas, seen("line/friction")) + sum_of_products(areas, seen("line/adhesion_t"));
      double const across =
          sum_of_products(areas, seen("line/friction_2")) + sum_of_products(areas, seen("line/adhesion_t2"));
      for (auto const& [component, force] :
           std::map<std::string, double>{{"x", along}, {"y", across}, {"z", 10}}) {
        CHECK(seen.number("all/force_" + component) == doctest::Approx(force).epsilon(1e-8));
        CHECK(seen.number("floor/force_" + component) == doctest::Approx(-force).epsilon(1e-8));
      }
      // about the origin: the cube stands on x, y in [0, 1], 0.06 and 0.08 m aside
      CHECK(seen.number("floor/moment_x") == doctest::Approx(-10 * 0.58).epsilon(1e-8));
      CHECK(seen.number("floor/moment_y") == doctest::Approx(10 * 0.56).epsilon(1e-8));
      CHECK(seen.number("floor/moment_z") == doctest::Approx(0.58 * along - 0.56 * across).epsilon(1e-8));
    }
}

TEST_CASE("probes: the force on an obstacle is that of its own pairs, also where they share nodes") {
  auto table = test::foot_on_floor();
  test::at(table, "obstacles.wall") =
      test::make("obstacle", {{"shape", test::make("rigid.plane", {{"point", test::values({0, 0}, "m")},
                                                                   {"normal", test::values({1, 0})}})},
                              {"pivot", test::values({0, 0.5}, "m")}});
  test::at(table, "pairs.side") = test::pair("foot.left", "wall");
  test::at(table, "obstacles.floor.times") = test::values({0, 1}, "s"); // along itself, with its pivot
  test::at(table, "obstacles.floor.x") = test::values({0, 0.2}, "m");
  test::at(table, "probes.line") = probe("contact_line", "pair", "sole");
  test::at(table, "motions") = test::list(
      {test::drive("foot.top", {0, 1}, {}, {0, -0.01}), test::drive("foot.right", {0, 1}, {0, -0.02}, {})});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "probes.floor") = probe("rigid", "obstacle", "floor");
  test::at(table, "probes.wall") = probe("rigid", "obstacle", "wall");
  auto const seen = sample(table);
  CHECK(seen.number("floor/force_x") == doctest::Approx(0).scale(1));
  CHECK(seen.number("floor/force_y") == doctest::Approx(-10).epsilon(1e-8));
  CHECK(seen.number("wall/force_x") == doctest::Approx(-20).epsilon(1e-8));
  CHECK(seen.number("wall/force_y") == doctest::Approx(0).scale(1));
  CHECK(seen.series.columns.at("floor/moment").unit == "N");
  CHECK(seen.number("floor/moment") == doctest::Approx(-10 * (0.49 - 0.2)).epsilon(1e-8)); // 0.02 m narrower
  CHECK(seen.number("floor/u_x") == doctest::Approx(0.2));
  CHECK(seen.series.columns.at("line/area").unit == "m");
  CHECK(seen.number("wall/moment") == doctest::Approx(20 * -0.005).epsilon(1e-6)); // 0.01 m lower
}

TEST_CASE("probes: force of a set that is an obstacle points to the probe that has it") {
  auto table = test::foot_on_floor();
  test::at(table, "probes.push") = probe("force", "set", "floor");
  std::string words;
  try {
    static_cast<void>(scene::build(table));
  } catch (core::InputError const& error) {
    words = error.what();
  }
  CHECK(words.find("stiction.probe.rigid { obstacle = \"floor\" }") != std::string::npos);
}

TEST_CASE("the energy probe shows what networks that relax dissipate, where there are any") {
  auto table = test::foot_on_floor();
  test::at(table, "probes.energy") = test::make("probe.energy");
  CHECK_FALSE(sample(table).series.columns.contains("energy/relaxation_loss"));
  test::at(table, "bodies.foot.relaxing") =
      test::list({test::make("prony", {{"share", test::value(0.5)}, {"time", test::value(0.5, "s")}})});
  auto const relaxing = sample(table);
  double const loss = relaxing.number("energy/relaxation_loss");
  CHECK(loss > 0);
  CHECK(loss == relaxing.state.ledger.relaxation_loss);
  CHECK(relaxing.number("energy/scheme_loss") == relaxing.state.ledger.scheme_loss());
  CHECK(relaxing.number("energy/strain") == relaxing.state.ledger.strain);
}
