// The manifest says what was asked in words that other programs can read.
#include "record/manifest.hpp"

#include <doctest/doctest.h>
#include <fstream>
#include <limits>

#include "core/error.hpp"
#include "folder.hpp"
#include "record/file.hpp"

using namespace stiction;
using nlohmann::json;

namespace {

struct Spring {
  double stiffness = 2e9;
  bool on = true;
  static core::Schema schema() {
    return core::Describe<Spring>{"spring", "a spring"}
        .number("stiffness", &Spring::stiffness, "N/m", core::positive, core::Need::required, "per length")
        .flag("on", &Spring::on, "acts at all")
        .nested("end", "tie", core::Need::optional, "what it is tied to")
        .build();
  }
};

template<class Value> core::Input input(Value value, std::string tag = "") {
  return {std::move(value), "", std::move(tag)};
}

std::string run_error(std::filesystem::path const& folder) {
  try {
    record::prepare_output(folder);
  } catch (core::RunError const& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_SUITE_BEGIN("record");

TEST_CASE("an object is described by its schema") {
  Spring const spring;
  json const described = record::describe(&spring, Spring::schema());
  CHECK(described.size() == 2);
  CHECK(described["stiffness"] == json{{"value", 2e9}, {"unit", "N/m"}, {"meaning", "per length"}});
  CHECK(described["on"]["value"] == true);
}

TEST_CASE("a script's tree becomes JSON with units and kinds") {
  core::Table table;
  table["height"] = input(core::Quantity{2e-3, {1, 0, 0}});
  table["mu"] = input(core::Quantity{0.4, {}});
  table["sets"] = input(core::List{input(std::string("top")), input(true), input(std::monostate{})});
  json const made = record::to_json(input(table, "material.blatz_ko"));
  CHECK(made["height"] == json{{"value", 2e-3}, {"unit", "m"}});
  CHECK(made["mu"] == 0.4);
  CHECK(made["sets"] == json{"top", true, nullptr});
  CHECK(made["kind"] == "material.blatz_ko");
}

TEST_CASE("values become JSON and infinities become words") {
  CHECK(record::to_json(core::Value{core::Numbers{1, std::numeric_limits<double>::infinity()}}) ==
        json{1.0, "inf"});
  CHECK(record::to_json(core::Value{std::numeric_limits<double>::quiet_NaN()}) == "nan");
  CHECK(record::to_json(core::Value{std::string("contact")}) == "contact");
}

TEST_CASE("the build names itself") {
  json const identity = record::build_identity();
  for (auto const* key : {"version", "commit", "compiler", "flags", "build_type", "processor"})
    CHECK_MESSAGE(!identity.at(key).get<std::string>().empty(), key);
  CHECK(identity.at("libraries").at("hdf5").get<std::string>().starts_with("1."));
}

TEST_CASE("a manifest is written sorted and replaces the last one") {
  test::Folder const folder;
  record::write_manifest(folder / "manifest.json", {{"b", 1}, {"a", "\xff"}});
  record::write_manifest(folder / "manifest.json", {{"b", 2}, {"a", "\xff"}});
  std::ifstream file(folder / "manifest.json");
  std::string const text{std::istreambuf_iterator<char>(file), {}};
  CHECK(json::parse(text)["b"] == 2);
  CHECK(text.find("\"a\"") < text.find("\"b\""));
}

TEST_CASE("an output folder is made with its parents and left empty") {
  test::Folder const folder;
  record::prepare_output(folder / "a" / "b");
  record::prepare_output(folder / "a" / "b");
  CHECK(std::filesystem::is_empty(folder / "a" / "b"));
}

TEST_CASE("an output folder that cannot be used is refused with reason and remedy") {
  test::Folder const folder;
  std::ofstream(folder / "file") << "in the way";
  std::string const in_the_way = run_error(folder / "file");
  CHECK(in_the_way.find("file' is not writable: ") != std::string::npos);
  CHECK(in_the_way.find("Not a directory") != std::string::npos);
  CHECK(in_the_way.find("choose another with --out") != std::string::npos);
  CHECK(run_error(folder / "file" / "below").find("Not a directory") != std::string::npos);
  CHECK_FALSE(run_error("/proc/stiction").empty());
}

TEST_SUITE_END();
