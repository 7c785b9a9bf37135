// The manifest walks the schemas: no setting of any part can be missing from it.
#include "scene/run/manifest.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <fstream>
#include <set>

#include "folder.hpp"
#include "record/manifest.hpp"
#include "scene/scenes.hpp"

using namespace stiction;
using nlohmann::json;

namespace {

using Kind = core::Parameter::Kind;

/// A value that no default is.
core::Input sample(core::Parameter const& parameter) {
  switch (parameter.kind) {
  case Kind::flag:
    return test::flag(true);
  case Kind::number:
  case Kind::integer:
    return test::value(17);
  case Kind::numbers:
    return test::values({17, 18});
  default:
    return test::text("sample");
  }
}

json in_json(core::Input const& input) {
  return input.list() != nullptr ? json{17, 18} : record::to_json(input);
}

json manifest_of(core::Input const& table) {
  test::Folder const folder;
  scene::RunOptions options;
  options.out = folder / "case";
  static_cast<void>(scene::run(table, options));
  return json::parse(std::ifstream(folder / "case/manifest.json"));
}

void collect_tags(core::Input const& input, std::multiset<std::string>& kinds) {
  if (!input.tag.empty())
    kinds.insert(input.tag.substr(input.tag.rfind('.') + 1));
  if (auto const* table = input.table())
    for (auto const& [name, entry] : *table)
      collect_tags(entry, kinds);
  if (auto const* list = input.list())
    for (auto const& entry : *list)
      collect_tags(entry, kinds);
}

void collect_kinds(json const& parts, std::multiset<std::string>& kinds) {
  if (parts.is_object() && parts.contains("is"))
    kinds.insert(parts["is"].get<std::string>());
  if (parts.is_structured())
    for (auto const& entry : parts)
      collect_kinds(entry, kinds);
}

bool has_all(json const& described, core::Schema const& schema) {
  return std::ranges::all_of(schema.parameters,
                             [&](auto const& parameter) { return described.contains(parameter.name); });
}

} // namespace

TEST_SUITE_BEGIN("scene");

TEST_CASE("every parameter of every part is described, as given and by its default") {
  int count = 0;
  for (auto const& category : scene::catalog())
    for (auto const& kind : category.kinds) {
      auto const tag = category.name + "." + kind.name;
      auto given = test::make(tag);
      for (auto const& parameter : kind.parameters)
        if (parameter.kind != Kind::nested)
          test::at(given, parameter.name) = sample(parameter);
      auto const as_given = scene::describe_part(given, category),
                 by_default = scene::describe_part(test::make(tag), category);
      for (std::size_t i = 0; i < kind.parameters.size(); ++i) {
        auto const& parameter = kind.parameters[i];
        INFO(tag, ".", parameter.name);
        REQUIRE(parameter.name != "is");
        REQUIRE(as_given.contains(parameter.name));
        REQUIRE(by_default.contains(parameter.name));
        ++count;
        if (parameter.kind == Kind::nested) {
          CHECK(by_default[parameter.name].is_null());
          continue;
        }
        CHECK(as_given[parameter.name]["value"] == in_json(sample(parameter)));
        CHECK(as_given[parameter.name]["given"] == true);
        CHECK(as_given[parameter.name]["unit"] == parameter.unit);
        CHECK(by_default[parameter.name]["value"] == record::to_json(kind.fallback(i)));
        CHECK(by_default[parameter.name]["given"] == false);
      }
    }
  CHECK(count > 200);
}

TEST_CASE("the manifest holds every part of a scene, and what the program takes where there is none") {
  auto table = test::foot_on_floor();
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "pairs.sole.adhesion") = test::rcc(1, 1e3, 2);
  test::at(table, "schedule.accuracy") = test::make("accuracy", {{"factors", test::value(3)}});
  test::at(table, "probes.energy") = test::make("probe.energy");
  auto const manifest = manifest_of(table);
  auto const& parts = manifest["parts"];
  std::multiset<std::string> asked, told;
  collect_tags(table, asked);
  collect_kinds(parts, told);
  for (auto const& kind : asked) {
    INFO(kind, " in ", parts.dump(1));
    CHECK(told.count(kind) >= asked.count(kind));
  }
  CHECK(parts["schedule"]["accuracy"]["factors"]["value"] == 3);
  CHECK(has_all(parts["schedule"]["accuracy"], dynamics::Accuracy::schema()));
  CHECK(has_all(manifest["settings"]["accuracy"], dynamics::Accuracy::schema()));
  CHECK(manifest["settings"]["accuracy"]["factors"]["value"] == 3);
  CHECK(has_all(parts["control"], dynamics::StepControl::schema()));
  CHECK(has_all(parts["output"], scene::OutputPart::schema()));
  CHECK(parts["solver"]["is"] == "newton");
  CHECK(parts["pairs"]["sole"]["adhesion"]["C_t2"]["value"] ==
        parts["pairs"]["sole"]["adhesion"]["C_t"]["value"]); // which depends on another
  CHECK(parts["pairs"]["sole"]["adhesion"]["C_t2"]["given"] == false);
  CHECK(parts["schedule"]["halvings"]["given"] == false);
  CHECK(parts["bodies"]["foot"]["density"]["given"] == true);
  CHECK(manifest["warnings"].is_array());
}

TEST_CASE("the manifest holds a relief, and the heights that nodes have") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.relief") = test::make(
      "relief", {{"set", test::text("bottom")},
                 {"surface", test::make("surface.wave", {{"amplitude", test::value(0.01, "m")},
                                                         {"wavelengths", test::values({1}, "m")}})},
                 {"size", test::values({1}, "m")},
                 {"points", test::values({64})}});
  auto const manifest = manifest_of(table);
  CHECK(manifest["parts"]["bodies"]["foot"]["relief"]["surface"]["amplitude"]["value"] == 0.01);
  auto const& relief = manifest["settings"]["bodies"]["foot"]["relief"];
  CHECK(has_all(relief, scene::ReliefPart::schema()));
  CHECK(relief["surface"]["wave"]["amplitude"]["value"] == 0.01);
  CHECK(std::abs(relief["least"]["value"].get<double>()) < 1e-7); // between points of the map
  CHECK(relief["most"]["value"].get<double>() == doctest::Approx(0.02).epsilon(1e-4));
  CHECK(relief["spacing"]["value"] == 0.25);
  CHECK_FALSE(manifest_of(test::foot_on_floor())["settings"]["bodies"]["foot"].contains("relief"));
}

TEST_CASE("a scene without accuracy has none in its manifest") {
  auto const manifest = manifest_of(test::foot_on_floor());
  CHECK(manifest["parts"]["schedule"]["accuracy"].is_null());
  CHECK_FALSE(manifest["settings"].contains("accuracy"));
}

TEST_SUITE_END();
