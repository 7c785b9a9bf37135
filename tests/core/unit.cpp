// The unit grammar: values, dimensions, and what it must refuse.
#include <doctest/doctest.h>
#include <numbers>

#include "core/unit.hpp"

using namespace stiction::core;

TEST_SUITE("core") {
  TEST_CASE("units have the right value and dimension") {
    struct Wanted {
      char const* text;
      double value;
      Dimension dimension;
    };
    for (auto const& wanted : {Wanted{"", 1, {}},
                               {"1", 1, {}},
                               {"%", 0.01, {}},
                               {"deg", std::numbers::pi / 180, {}},
                               {"mm", 1e-3, {1, 0, 0}},
                               {"um", 1e-6, {1, 0, 0}},
                               {"g", 1e-3, {0, 1, 0}},
                               {"ms", 1e-3, {0, 0, 1}},
                               {"Hz", 1, {0, 0, -1}},
                               {"N/m^3", 1, {-2, 1, -2}},
                               {"J/m^2", 1, {0, 1, -2}},
                               {"N s/m", 1, {0, 1, -1}},
                               {"N*s/m", 1, {0, 1, -1}},
                               {"MPa", 1e6, {-1, 1, -2}},
                               {"kg/m/s^2", 1, {-1, 1, -2}},
                               {"mm^-1", 1e3, {-1, 0, 0}},
                               {"1/mm^2", 1e6, {-2, 0, 0}},
                               {"g/cm^3", 1e3, {-3, 1, 0}},
                               {"mJ", 1e-3, {2, 1, -2}},
                               {"W", 1, {2, 1, -3}}}) {
      CAPTURE(wanted.text);
      auto const unit = parse_unit(wanted.text);
      REQUIRE(unit.has_value());
      CHECK(unit->value == doctest::Approx(wanted.value).epsilon(1e-14));
      CHECK(unit->dimension == wanted.dimension);
    }
  }

  TEST_CASE("only the factor behind a slash is divided by") {
    auto const unit = parse_unit("N/m s");
    REQUIRE(unit.has_value());
    CHECK(unit->dimension == Dimension{0, 1, -1});
  }

  TEST_CASE("unknown words and broken powers are refused") {
    for (char const* text : {"mmm", "Mpa", "m^", "m^x", "m^2.5", "furlong", "^2", "N-m"}) {
      CAPTURE(text);
      CHECK_FALSE(parse_unit(text).has_value());
    }
  }

  TEST_CASE("dimensions are worded in base units") {
    CHECK(to_string(Dimension{}) == "1");
    CHECK(to_string(Dimension{1, 0, 0}) == "m");
    CHECK(to_string(parse_unit("MPa")->dimension) == "kg m^-1 s^-2");
  }

  TEST_CASE("every unit word parses to itself") {
    for (auto const& word : unit_words())
      CHECK(parse_unit(word).has_value());
  }
}
