// Reading tables by schema: values, and every complaint at once with place, path and remedy.
#include <algorithm>
#include <doctest/doctest.h>

#include "core/reader.hpp"

using namespace stiction::core;

namespace {

enum class Mode { slow, fast };
struct Part {
  double density = 0, ratio = 0.3, time = 1;
  int count = 0;
  Mode mode = Mode::slow;
  bool on = false;
  Numbers origin;
  static Schema const& schema() {
    static auto const made =
        Describe<Part>{"part", "a part"}
            .number("density", &Part::density, "kg/m^3", positive, Need::required, "mass per volume")
            .number("ratio", &Part::ratio, "1", {-1, 0.5, true, true}, Need::optional, "Poisson's")
            .number("time", &Part::time, "s", {0, 2, false, false}, Need::optional, "how long")
            .integer("count", &Part::count, {1, 10, false, false}, Need::optional, "how many")
            .choice("mode", &Part::mode, {"slow", "fast"}, Need::optional, "how fast")
            .flag("on", &Part::on, "whether")
            .numbers("origin", &Part::origin, "m", Need::optional, "where")
            .build();
    return made;
  }
};
struct Other {
  double length = 0;
  static Schema const& schema() {
    static auto const made =
        Describe<Other>{"other", "another"}
            .number("length", &Other::length, "m", positive, Need::required, "its length")
            .build();
    return made;
  }
};

Input value(std::variant<std::monostate, bool, Quantity, std::string, List, Table> v,
            std::string place = "") {
  return {std::move(v), std::move(place), ""};
}
Input number(double v, std::string_view unit = "", std::string place = "") {
  auto const parsed = parse_unit(unit);
  return value(Quantity{v * parsed->value, parsed->dimension}, std::move(place));
}
Input table(Table entries, std::string tag = "") {
  return {std::move(entries), "study.lua:7", std::move(tag)};
}

struct Outcome {
  Part part;
  Complaints complaints;
  [[nodiscard]] std::string only() const {
    return complaints.size() == 1 ? complaints[0].message()
                                  : std::to_string(complaints.size()) + " complaints";
  }
};
Outcome read(Table entries) {
  Outcome outcome;
  Input const input = table(std::move(entries));
  Reader reader(input, "bodies.plate", outcome.complaints);
  outcome.part = reader.record<Part>();
  return outcome;
}
/// The one complaint about key = input beside a good density.
std::string complaint(std::string const& key, Input const& input) {
  return read({{"density", number(1000, "kg/m^3")}, {key, input}}).only();
}
bool has(std::string const& text, std::string const& words) {
  return text.find(words) != std::string::npos;
}

} // namespace

TEST_SUITE("core") {
  TEST_CASE("a good table fills every member in SI and leaves defaults alone") {
    auto const outcome = read({{"density", number(1.2, "g/cm^3")},
                               {"count", number(0.3 / 0.1)},
                               {"mode", value(std::string("fast"))},
                               {"on", value(true)},
                               {"origin", value(List{number(5, "mm"), number(0)})},
                               {"time", number(5, "ms")}});
    CHECK(outcome.complaints.empty());
    CHECK(outcome.part.density == doctest::Approx(1200));
    CHECK(outcome.part.count == 3);
    CHECK(outcome.part.mode == Mode::fast);
    CHECK(outcome.part.on);
    CHECK(outcome.part.origin == Numbers{5e-3, 0});
    CHECK(outcome.part.time == doctest::Approx(5e-3));
    CHECK(outcome.part.ratio == 0.3);
  }

  TEST_CASE("everything wrong is said at once") {
    auto const outcome = read({{"densty", number(1000, "kg/m^3")},
                               {"ratio", number(0.5)},
                               {"time", number(1, "m")},
                               {"count", number(2.5)},
                               {"mode", value(std::string("fats"))},
                               {"on", number(1)},
                               {"origin", number(1, "m")}});
    REQUIRE(outcome.complaints.size() == 8);
    std::vector<std::string> paths;
    for (auto const& c : outcome.complaints) {
      paths.push_back(c.path);
      CHECK(c.place == "study.lua:7");
    }
    std::sort(paths.begin(), paths.end());
    CHECK(paths == std::vector<std::string>{"bodies.plate.count", "bodies.plate.density",
                                            "bodies.plate.densty", "bodies.plate.mode", "bodies.plate.on",
                                            "bodies.plate.origin", "bodies.plate.ratio",
                                            "bodies.plate.time"});
    InputError const error(outcome.complaints);
    CHECK(has(error.what(),
              "study.lua:7: bodies.plate.densty: is not a parameter here; did you mean \"density\"?"));
  }

  TEST_CASE("a missing parameter is named with its meaning and range") {
    auto const text = read({}).only();
    CHECK(has(text, "bodies.plate.density: is missing"));
    CHECK(has(text, "mass per volume, > 0 kg/m^3"));
  }

  TEST_CASE("unknown keys: the nearest known one, or all of them") {
    CHECK(has(complaint("mod", value(std::string("fast"))), "did you mean \"mode\"?"));
    CHECK(
        has(complaint("temperature", number(1)), "known are count, density, mode, on, origin, ratio, time"));
  }

  TEST_CASE("a wrong unit is refused with the one wanted, a bare zero has every unit") {
    CHECK(has(complaint("time", number(3, "m")), "3 m has the wrong unit; s is wanted"));
    auto const bare = complaint("time", number(1.5));
    CHECK(has(bare, "1.5 (a pure number)"));
    CHECK(has(bare, "for example 1.5*units(\"s\")"));
    CHECK(has(complaint("ratio", number(0.2, "m")), "a pure number is wanted"));
    CHECK(read({{"density", number(1, "kg/m^3")}, {"time", number(0)}}).complaints.empty());
  }

  TEST_CASE("range ends: open ones are refused, closed ones taken") {
    for (double const end : {-1.0, 0.5})
      CHECK(has(complaint("ratio", number(end)), "it must be in (-1, 0.5)"));
    for (double const end : {0.0, 2.0})
      CHECK(read({{"density", number(1, "kg/m^3")}, {"time", number(end, "s")}}).complaints.empty());
    CHECK(has(complaint("time", number(2.001, "s")), "is 2.001 s; it must be in [0, 2] s"));
    CHECK(has(complaint("time", number(2.000000001, "s")), "is 2.000000001 s; it must be in [0, 2] s"));
    CHECK(has(read({{"density", number(-1, "kg/m^3")}}).only(), "is -1 kg/m^3; it must be > 0 kg/m^3"));
    CHECK(has(complaint("count", number(11)), "in [1, 10]"));
  }

  TEST_CASE("whole numbers and words are held to") {
    CHECK(has(complaint("count", number(2.5)), "is 2.5; a whole number is wanted"));
    CHECK(has(complaint("mode", value(std::string("fats"))),
              "is \"fats\"; it must be one of slow, fast; did you mean \"fast\"?"));
    CHECK(has(complaint("mode", number(1)), "is a number; a text is wanted"));
    CHECK(has(complaint("origin", value(List{number(1, "m"), value(true)})), "is true/false; a number in m"));
    CHECK(has(complaint("on", value(std::string("yes"))), "true or false is wanted"));
  }

  TEST_CASE("a value's own place is preferred over its table's") {
    auto const outcome = read({{"density", number(-1, "kg/m^3", "study.lua:31")}});
    CHECK(outcome.complaints.at(0).place == "study.lua:31");
  }

  TEST_CASE("the tag picks the alternative, an unknown one is refused with what was meant") {
    Complaints complaints;
    Input const good = table({{"length", number(2, "mm")}}, "shape.other");
    auto const picked = Reader(good, "x", complaints).alternative<std::variant<Part, Other>>();
    REQUIRE(std::holds_alternative<Other>(picked));
    CHECK(std::get<Other>(picked).length == doctest::Approx(2e-3));
    CHECK(complaints.empty());

    Input const bad = table({}, "shape.othr"), untagged = table({});
    static_cast<void>(Reader(bad, "x", complaints).alternative<std::variant<Part, Other>>());
    static_cast<void>(Reader(untagged, "y", complaints).alternative<std::variant<Part, Other>>());
    REQUIRE(complaints.size() == 2);
    CHECK(has(complaints[0].message(), "\"othr\" is not known here; it must be made by one of part, other"));
    CHECK(has(complaints[0].message(), "did you mean \"other\"?"));
    CHECK(has(complaints[1].message(), "has no kind"));
  }

  TEST_CASE("children of a list carry their number, and a table is not a list") {
    Complaints complaints;
    Input const input = table({{"stages", value(List{table({}), table({})})}, {"pairs", number(1)}});
    Reader reader(input, "scene", complaints);
    auto const stages = reader.children("stages");
    REQUIRE(stages.size() == 2);
    CHECK(stages[1].path() == "scene.stages[2]");
    CHECK(reader.children("pairs").empty());
    CHECK(has(complaints.at(0).message(), "is a number; a list {...} is wanted"));
    CHECK(reader.children("absent", Need::optional).empty());
    CHECK(complaints.size() == 1);
  }
}
