// Runs into a folder: what is written, that it repeats, and how a run ends when something goes wrong.
#include "scene/run/run.hpp"

#include <algorithm>
#include <atomic>
#include <doctest/doctest.h>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "folder.hpp"
#include "record/intercept.hpp"
#include "record/series.hpp"
#include "scene/run/solve.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

/// A rubbing foot with one probe of every kind.
test::Input probed() {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "pairs.sole.adhesion") = test::rcc(1, 1e3, 2);
  auto const sole = std::pair<std::string const, test::Input>{"pair", test::text("sole")};
  auto const top = std::pair<std::string const, test::Input>{"set", test::text("foot.top")};
  auto const near = std::pair<std::string const, test::Input>{"near", test::values({1, 0}, "m")};
  test::at(table, "probes.tip") = test::make("probe.contact_point", {sole, near});
  test::at(table, "probes.whole") = test::make("probe.contact", {sole});
  test::at(table, "probes.line") = test::make("probe.contact_line", {sole});
  test::at(table, "probes.push") = test::make("probe.force", {top});
  test::at(table, "probes.corner") = test::make("probe.node", {top, near});
  test::at(table, "probes.energy") = test::make("probe.energy");
  test::at(table, "output") =
      test::make("output", {{"frames", test::value(2)}, {"problems_every", test::value(5)}});
  return table;
}

scene::RunResult run(test::Input const& table, std::filesystem::path const& out) {
  scene::RunOptions options;
  options.out = out;
  options.case_id = "one";
  options.manifest_json = R"({"study": {"given": {"mu": 0.3}}})";
  return scene::run(table, options);
}

std::string text_of(std::filesystem::path const& path) {
  std::ifstream file(path, std::ios::binary);
  REQUIRE(file.good());
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A fast deep press that one step would turn inside out, then a slow one.
test::Input deep_press() {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.material") =
      test::make("material.blatz_ko", {{"shear_modulus", test::value(400, "Pa")}});
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 0.25, 1}, {0, 1.5, 1.5}, {0, -0.3, -0.306}),
                  test::fix("foot.bottom", true, false)});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "probes.push") = test::make("probe.force", {{"set", test::text("foot.top")}});
  return table;
}

} // namespace

TEST_CASE("a run leaves series, fields, problems and manifest") {
  test::Folder const folder;
  auto const result = run(probed(), folder / "case");
  CHECK(result.verdict == "finished");
  CHECK(result.reason.empty());
  CHECK(result.steps == 14);
  CHECK(result.cuts == 0);

  auto const series = record::read_series(folder / "case/series.h5");
  REQUIRE(series.time.size() == 15);
  CHECK(series.time.front() == 0);
  CHECK(series.time[4] == 1);
  CHECK(series.time.back() == 2);
  for (auto const& [column, unit] : std::map<std::string, std::string>{{"step/dt", "s"},
                                                                       {"tip/beta", "1"},
                                                                       {"tip/pressure", "Pa"},
                                                                       {"whole/force_y", "N/m"},
                                                                       {"whole/closed_area", "m"},
                                                                       {"line/gap", "m"},
                                                                       {"push/force_x", "N/m"},
                                                                       {"corner/u_x", "m"},
                                                                       {"corner/v_x", "m/s"},
                                                                       {"energy/strain", "J/m"},
                                                                       {"energy/friction_loss", "J/m"}}) {
    CAPTURE(column);
    REQUIRE(series.columns.contains(column));
    CHECK(series.columns.at(column).unit == unit);
    CHECK_FALSE(series.columns.at(column).meaning.empty());
  }
  CHECK(series.columns.at("line/gap").width == 5);
  CHECK(series.columns.at("tip/beta").values[4] == doctest::Approx(0.5)); // w t / b
  CHECK(series.columns.at("whole/force_y").values[4] == doctest::Approx(10));
  CHECK(series.columns.at("push/force_y").values[4] == doctest::Approx(-10));
  CHECK(series.columns.at("corner/u_x").values.back() == doctest::Approx(0.1));
  CHECK(series.columns.at("whole/open").values[4] == 0);

  auto const list = text_of(folder / "case/fields.pvd");
  CHECK(std::ranges::count(list, '\n') >= 5);
  for (int frame = 0; frame < 5; ++frame) { // the start and two per stage
    std::string const name = "fields/00000" + std::to_string(frame) + ".vtu";
    CHECK(list.find(name) != std::string::npos);
    CHECK(std::filesystem::file_size(folder / ("case/" + name)) > 100);
  }
  CHECK_FALSE(std::filesystem::exists(folder / "case/fields/000005.vtu"));
  CHECK(std::filesystem::exists(folder / "case/problems/000005.h5"));
  CHECK(std::filesystem::exists(folder / "case/problems/000010.h5"));
}

TEST_CASE("the manifest tells every setting, also those nobody gave") {
  test::Folder const folder;
  static_cast<void>(run(probed(), folder / "case"));
  auto const manifest = nlohmann::json::parse(text_of(folder / "case/manifest.json"));
  CHECK(manifest["case"] == "one");
  CHECK(manifest["study"]["given"]["mu"] == 0.3);
  CHECK(manifest["scene"]["bodies"]["foot"]["material"]["kind"] == "material.linear_elastic");
  CHECK_FALSE(manifest["build"].empty());
  auto const& settings = manifest["settings"];
  auto has_all = [](nlohmann::json const& described, core::Schema const& schema) {
    for (auto const& parameter : schema.parameters)
      if (parameter.kind != core::Parameter::Kind::nested) {
        INFO(schema.name, ".", parameter.name, " in ", described.dump());
        CHECK(described.contains(parameter.name));
      }
  };
  has_all(settings["pairs"]["sole"]["rcc"], interface::Rcc::schema());
  has_all(settings["pairs"]["sole"]["coulomb"], interface::Coulomb::schema());
  has_all(settings["pairs"]["sole"]["pair"], scene::PairPart::schema());
  has_all(settings["bodies"]["foot"]["linear_elastic"], material::LinearElastic::schema());
  has_all(settings["control"], dynamics::StepControl::schema());
  has_all(settings["solver"]["newton"], contact::BipotentialNewton::schema());
  CHECK(settings["scheme"].contains("quasi_static"));
  CHECK(settings["pairs"]["sole"]["rcc"]["bonding"]["value"] == "contact");
  CHECK(settings["pairs"]["sole"]["rcc"]["C_n"]["value"] == 1e3);
  CHECK(settings["pairs"]["sole"]["rcc"]["C_n"]["unit"] == "N/m^3");
}

TEST_CASE("two runs of one scene agree bit by bit") {
  test::Folder const folder;
  auto table = probed();
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  auto const first = run(table, folder / "a"), second = run(table, folder / "b");
  CHECK(first.iterations == second.iterations);
  auto const a = record::read_series(folder / "a/series.h5"), b = record::read_series(folder / "b/series.h5");
  CHECK(a.time == b.time);
  REQUIRE(a.columns.size() == b.columns.size());
  for (auto const& [name, column] : a.columns) {
    CAPTURE(name);
    CHECK(column.values == b.columns.at(name).values);
  }
  for (std::string const file : {"fields/000004.vtu", "fields.pvd"})
    CHECK(text_of(folder / ("a/" + file)) == text_of(folder / ("b/" + file)));
  auto one = nlohmann::json::parse(text_of(folder / "a/manifest.json"));
  auto other = nlohmann::json::parse(text_of(folder / "b/manifest.json"));
  for (auto* manifest : {&one, &other})
    for (auto const* moment : {"started", "ended"})
      CHECK(manifest->erase(moment) == 1);
  CHECK(one == other);
}

TEST_CASE("a run into a folder that was used before replaces what was there") {
  test::Folder const folder;
  static_cast<void>(run(probed(), folder / "case"));
  auto table = probed();
  test::at(table, "schedule") = test::schedule({{2, 3}});
  static_cast<void>(run(table, folder / "case"));
  CHECK(record::read_series(folder / "case/series.h5").time.size() == 4);
  CHECK_FALSE(std::filesystem::exists(folder / "case/fields/000004.vtu"));
}

TEST_CASE("a run that is asked to stop says so and leaves readable files") {
  test::Folder const folder;
  std::atomic<bool> stop = false;
  scene::RunOptions options;
  options.out = folder / "case";
  options.stop = &stop;
  options.progress = [&](scene::Progress const& progress) {
    CHECK(progress.end_time == 2);
    CHECK(progress.open + progress.stick + progress.slip == 5);
    stop = true;
  };
  auto const result = scene::run(probed(), options);
  CHECK(result.verdict == "stopped");
  CHECK_FALSE(result.reason.empty());
  CHECK(result.steps == 1);
  CHECK(record::read_series(folder / "case/series.h5").time.size() == 2);
  CHECK(std::filesystem::exists(folder / "case/fields.pvd"));
}

TEST_CASE("a step that fails is halved and grows back, the end is that of small steps") {
  test::Folder const folder;
  auto table = deep_press();
  auto const cut = run(table, folder / "cut");
  CHECK(cut.verdict == "finished");
  CHECK(cut.cuts > 0);
  auto const series = record::read_series(folder / "cut/series.h5");
  CHECK(series.time.back() == 1);
  CHECK(std::ranges::is_sorted(series.time));
  auto const& dt = series.columns.at("step/dt").values;
  double covered = 0;
  for (double const step : dt)
    covered += step;
  CHECK(covered == doctest::Approx(1).epsilon(1e-14));
  CHECK(std::adjacent_find(dt.begin() + 1, dt.end(), std::less<>{}) != dt.end()); // it grew back
  test::at(table, "schedule") = test::schedule({{1, 32}});
  auto const fine = run(table, folder / "fine");
  CHECK(fine.cuts == 0);
  auto const small = record::read_series(folder / "fine/series.h5");
  CHECK(series.columns.at("push/force_y").values.back() ==
        doctest::Approx(small.columns.at("push/force_y").values.back()).epsilon(1e-5));
}

TEST_CASE("a run that may not halve ends with its reason and keeps what it has") {
  test::Folder const folder;
  auto table = deep_press();
  test::at(table, "schedule.halvings") = test::value(0);
  auto const result = run(table, folder / "case");
  CHECK(result.verdict == "not converged");
  CHECK(result.reason.find("t = 0 s") != std::string::npos);
  CHECK(result.reason.find("inside out") != std::string::npos);
  CHECK(result.cuts == 1);
  CHECK(record::read_series(folder / "case/series.h5").time.size() == 1);
}

TEST_CASE("a contact problem that no solver step can solve is kept for `solve`") {
  test::Folder const folder;
  auto table = probed();
  test::at(table, "solver") =
      test::make("solver.uzawa", {{"iterations", test::value(1)}, {"tolerance", test::value(1e-14)}});
  test::at(table, "schedule.halvings") = test::value(1);
  auto const result = run(table, folder / "case");
  CHECK(result.verdict == "not converged");
  CHECK(result.reason.find("failed.h5") != std::string::npos);
  std::stringstream log;
  log << std::ifstream(folder / "case/steps.csv").rdbuf();
  CHECK(log.str().find(",cut,not_converged,") != std::string::npos);
  CHECK(log.str().find(",none ") != std::string::npos); // uzawa answered nothing
  auto const report = scene::solve_file(folder / "case/problems/failed.h5", "newton", 1e-10);
  CHECK(report.converged);
}

TEST_CASE("a contact node that is held in all directions and pressed is named with what holds it") {
  test::Folder const folder;
  auto table = test::foot_on_floor();
  test::at(table, "motions") = test::list({test::drive("foot.left", {0, 2}, {0, 0}, {0, -0.01}),
                                           test::drive("foot.top", {0, 2}, {}, {0, -0.01})});
  test::at(table, "schedule.halvings") = test::value(1);
  auto const result = run(table, folder / "case");
  CAPTURE(result.reason);
  CHECK(result.verdict == "not converged");
  CHECK(result.reason.find(
            "the node at (0, 0) m is held or driven in all its directions, by foot.left, and pressed") !=
        std::string::npos);
  CHECK(result.reason.find("into floor of pair sole") != std::string::npos);
  CHECK(result.reason.find("set = \"foot.left\", x = true") != std::string::npos);
}

TEST_CASE("a saved contact problem is solved by every solver, unknown names are refused") {
  test::Folder const folder;
  static_cast<void>(run(probed(), folder / "case"));
  auto const problem = folder / "case/problems/000010.h5";
  auto const all = scene::solve_file(problem, "all", 1e-8);
  INFO(all.text);
  CHECK(all.converged);
  for (char const* name : {"newton", "uzawa", "gauss_seidel"})
    CHECK(all.text.find(name) != std::string::npos);
  CHECK(all.text.find("5 contacts") != std::string::npos);
  CHECK_THROWS_WITH_AS(static_cast<void>(scene::solve_file(problem, "newtom", 1e-8)),
                       doctest::Contains("did you mean \"newton\""), core::InputError);
}

TEST_CASE("an output folder that vanishes ends the run") {
  test::Folder const folder;
  scene::RunOptions options;
  options.out = folder / "case";
  options.progress = [&](scene::Progress const&) { std::filesystem::remove_all(folder / "case"); };
  auto const result = scene::run(probed(), options);
  CHECK(result.verdict == "output failed");
  CHECK(result.reason.find("cannot write") != std::string::npos);
}

TEST_CASE("a full disk ends the run and leaves what was written") {
  test::Folder const folder;
  auto table = probed();
  test::at(table, "output.frames") = test::value(0);
  test::at(table, "output.problems_every") = test::value(0);
  test::at(table, "schedule") = test::schedule({{1, 200}, {2, 400}});
  scene::RunOptions options;
  options.out = folder / "whole";
  test::interception() = {};
  CHECK(scene::run(table, options).verdict == "finished");
  auto const calls = test::interception().calls;
  options.out = folder / "full";
  test::interception() = {0, -1, calls / 2};
  auto const result = scene::run(table, options);
  test::interception() = {};
  CHECK(result.verdict == "output failed");
  CHECK(result.reason.find("No space left") != std::string::npos);
  auto const rows = record::read_series(folder / "full/series.h5").time.size();
  CHECK(rows >= 32);
  CHECK(rows < 601);
}
