// Ranges and their words, whole numbers, and the search for a misspelt word.
#include <doctest/doctest.h>
#include <limits>

#include "core/schema.hpp"

using namespace stiction::core;

namespace {

enum class Colour { red, green };
struct Sample {
  double length = 2.5;
  int count = 3;
  bool on = true;
  Colour colour = Colour::green;
  std::string name = "some";
  Numbers list{1, 2};
  static Schema make() {
    return Describe<Sample>{"sample", "a sample"}
        .number("length", &Sample::length, "m", positive, Need::required, "its length")
        .integer("count", &Sample::count, {0, 9, false, false}, Need::optional, "how many")
        .flag("on", &Sample::on, "whether")
        .choice("colour", &Sample::colour, {"red", "green"}, Need::optional, "which")
        .text("name", &Sample::name, Need::optional, "called")
        .numbers("list", &Sample::list, "m", Need::optional, "places")
        .build();
  }
};

} // namespace

TEST_SUITE("core") {
  TEST_CASE("ranges include their ends unless open, and never what is not finite") {
    double const infinity = std::numeric_limits<double>::infinity();
    Range const closed{0, 1, false, false}, open{0, 1, true, true};
    CHECK((closed.contains(0) && closed.contains(1) && closed.contains(0.5)));
    CHECK_FALSE((open.contains(0) || open.contains(1)));
    CHECK(open.contains(0.5));
    CHECK_FALSE((closed.contains(-1e-300) || closed.contains(1.0000001)));
    CHECK_FALSE((positive.contains(0) || positive.contains(infinity) || any_number.contains(infinity)));
    CHECK(non_negative.contains(0));
    CHECK_FALSE(any_number.contains(std::numeric_limits<double>::quiet_NaN()));
  }

  TEST_CASE("ranges are worded with their unit") {
    CHECK(positive.words("Pa") == "> 0 Pa");
    CHECK(non_negative.words("1") == ">= 0");
    CHECK(Range{0, 0.5, false, true}.words("") == "in [0, 0.5)");
    CHECK(Range{-1, 0.5, true, false}.words("m") == "in (-1, 0.5] m");
    CHECK(Range{-std::numeric_limits<double>::infinity(), 3, false, true}.words("s") == "< 3 s");
    CHECK(any_number.words("m/s") == "any finite number in m/s");
  }

  TEST_CASE("whole numbers survive the rounding of quotients, fractions do not") {
    CHECK(whole_number(18e-3 / 0.25e-3) == 72);
    CHECK(whole_number(0.3 / 0.1) == 3);
    CHECK(whole_number(-4) == -4);
    CHECK_FALSE(whole_number(2.5).has_value());
    CHECK_FALSE(whole_number(3 + 1e-6).has_value());
    CHECK_FALSE(whole_number(std::numeric_limits<double>::quiet_NaN()).has_value());
  }

  TEST_CASE("the nearest word is found, and none for a far one") {
    std::vector<std::string> const known{"density", "material", "mesh"};
    CHECK(nearest("densty", known) == "density");
    CHECK(nearest("mehs", known) == "mesh");
    CHECK(nearest("materials", known) == "material");
    CHECK(nearest("temperature", known).empty());
    CHECK(nearest("x", {}).empty());
  }

  TEST_CASE("values are worded") {
    CHECK(to_string(Value{true}) == "true");
    CHECK(to_string(Value{0.25}) == "0.25");
    CHECK(to_string(Value{std::string("full")}) == "\"full\"");
    CHECK(to_string(Value{Numbers{1, 2.5}}) == "{1, 2.5}");
  }

  TEST_CASE("a schema sets and gets each member and knows its default") {
    auto const schema = Sample::make();
    std::vector<Value> const defaults{2.5,          3.0, true, std::string("green"), std::string("some"),
                                      Numbers{1, 2}};
    std::vector<Value> const others{4.5, 7.0, false, std::string("red"), std::string("else"), Numbers{3}};
    REQUIRE(schema.parameters.size() == defaults.size());
    Sample sample;
    for (std::size_t i = 0; i < defaults.size(); ++i) {
      auto const& parameter = schema.parameters[i];
      CAPTURE(parameter.name);
      CHECK(schema.fallback(i) == defaults[i]);
      CHECK(parameter.get(&sample) == defaults[i]);
      parameter.set(&sample, others[i]);
      CHECK(parameter.get(&sample) == others[i]);
      CHECK(schema.find(parameter.name) == &parameter);
    }
    CHECK(schema.find("lenght") == nullptr);
    CHECK(sample.length == 4.5);
    CHECK(sample.count == 7);
    CHECK_FALSE(sample.on);
    CHECK(sample.colour == Colour::red);
    CHECK(sample.name == "else");
    CHECK(sample.list == Numbers{3});
  }
}
