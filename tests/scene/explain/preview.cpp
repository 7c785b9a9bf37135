// What is said of a run before its first step is what it then records.
#include "scene/explain/preview.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "folder.hpp"
#include "record/series.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

/// A rubbing foot with one probe of every kind that a plane scene has.
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
  test::at(table, "probes.energy") = test::make("probe.energy", {{"audit", test::flag(true)}});
  return table;
}

void check_columns(test::Input const& table) {
  test::Folder const folder;
  scene::RunOptions options;
  options.out = folder / "case";
  static_cast<void>(scene::run(table, options));
  auto const recorded = record::read_series(folder / "case/series.h5");
  auto const preview = scene::preview(table);
  CHECK(preview.columns.size() == recorded.columns.size());
  for (auto const& [name, width] : preview.columns) {
    INFO(name);
    REQUIRE(recorded.columns.contains(name));
    CHECK(recorded.columns.at(name).width == static_cast<std::size_t>(width));
  }
  CHECK(preview.end == recorded.time.back());
}

} // namespace

TEST_SUITE_BEGIN("scene");

TEST_CASE("the columns of a run are known before it") {
  auto table = probed();
  check_columns(table);
  test::at(table, "schedule.accuracy") = test::make("accuracy");
  check_columns(table);
}

TEST_CASE("a run leaves the warnings that explain gives") {
  auto table = probed();
  test::at(table, "pairs.sole.adhesion") = test::rcc(1, 1e9, 0);
  auto const explained = scene::explain(table).warnings;
  REQUIRE_FALSE(explained.empty());
  test::Folder const folder;
  scene::RunOptions options;
  options.out = folder / "case";
  auto const result = scene::run(table, options);
  auto const foreseen = scene::preview(table).warnings;
  auto const manifest = nlohmann::json::parse(std::ifstream(folder / "case/manifest.json"));
  REQUIRE(result.warnings.size() == explained.size());
  REQUIRE(foreseen.size() == explained.size());
  for (std::size_t i = 0; i < explained.size(); ++i) {
    CHECK(result.warnings[i].text == explained[i].text);
    CHECK(foreseen[i].text == explained[i].text);
    CHECK(manifest["warnings"][i]["text"] == explained[i].text);
    CHECK(manifest["warnings"][i]["change"] == explained[i].change);
  }
}

TEST_SUITE_END();
