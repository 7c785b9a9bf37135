// Every parameter of every kind that scripts can make reaches its own member, and only that.
#include <cmath>
#include <doctest/doctest.h>
#include <set>

#include "scene/description/catalog.hpp"
#include "scene/description/parts.hpp"
#include "scene/tables.hpp"

using namespace stiction;
using core::Parameter;
using core::Schema;
using core::Value;

namespace {

double sample_number(Parameter const& parameter, int variant) {
  auto const [low, high, low_open, high_open] = parameter.range;
  double const step = 0.37 + 0.21 * variant;
  if (parameter.kind == Parameter::Kind::integer)
    return std::isfinite(low) ? low + 3 + variant : 5 + variant;
  if (std::isfinite(low) && std::isfinite(high))
    return low + step * (high - low);
  return std::isfinite(low) ? low + step : -step;
}

/// A valid input for a parameter and what must be read from it; the two variants differ, and from `fallback`.
std::pair<test::Input, Value> sample(Parameter const& parameter, Value const& fallback, int variant) {
  using Kind = Parameter::Kind;
  switch (parameter.kind) {
  case Kind::flag: {
    bool const on = variant == 0 ? std::get<bool>(fallback) : !std::get<bool>(fallback);
    return {test::flag(on), on};
  }
  case Kind::choice: {
    auto const& names = parameter.choices;
    auto const usual = std::find(names.begin(), names.end(), std::get<std::string>(fallback)) - names.begin();
    auto const& name = names[(static_cast<std::size_t>(usual + variant)) % names.size()];
    return {test::text(name), name};
  }
  case Kind::text:
  case Kind::file: {
    std::string const word = variant == 0 ? "some.word" : "another.word";
    return {test::text(word), word};
  }
  case Kind::numbers: {
    std::vector<double> const numbers{1.5 + variant, 2.25 + variant};
    double const unit = core::parse_unit(parameter.unit)->value;
    return {test::values(numbers, parameter.unit), core::Numbers{numbers[0] * unit, numbers[1] * unit}};
  }
  case Kind::nested:
    return {test::make("x"), std::string()};
  default: {
    double const number = sample_number(parameter, variant);
    return {test::value(number, parameter.unit), number * core::parse_unit(parameter.unit)->value};
  }
  }
}

template<class T> T read(core::Table const& table) {
  auto const input = test::make("kind", table);
  core::Complaints complaints;
  core::Reader reader(input, "", complaints);
  T target{};
  reader.fill(&target, T::schema());
  REQUIRE(complaints.empty());
  return target;
}

/// Changes one parameter of T after the other.
template<class T> void check_parameters() {
  Schema const& schema = T::schema();
  core::Table base;
  for (std::size_t i = 0; i < schema.parameters.size(); ++i)
    base[schema.parameters[i].name] = sample(schema.parameters[i], schema.fallback(i), 0).first;
  T const before = read<T>(base);
  for (std::size_t i = 0; i < schema.parameters.size(); ++i) {
    auto const& changed = schema.parameters[i];
    if (changed.kind == Parameter::Kind::nested)
      continue;
    auto table = base;
    auto const [input, wanted] = sample(changed, schema.fallback(i), 1);
    table[changed.name] = input;
    T const after = read<T>(table);
    for (auto const& other : schema.parameters) {
      INFO(schema.name, ".", changed.name, " changed, looking at ", other.name);
      if (other.name == changed.name) {
        CHECK(other.get(&after) == wanted);
        CHECK(other.get(&after) != other.get(&before));
      } else {
        CHECK(other.get(&after) == other.get(&before));
      }
    }
    for (auto const& name : changed.choices) {
      table[changed.name] = test::text(name);
      CHECK(changed.get(&static_cast<T const&>(read<T>(table))) == Value{name});
    }
  }
}

std::set<std::string> checked;

template<class T> void check_kind() {
  checked.insert(T::schema().name);
  check_parameters<T>();
}
template<class... T> void check_kinds(std::type_identity<std::variant<T...>>) {
  (check_kind<T>(), ...);
}
template<class Choice> void check_choice() {
  check_kinds(std::type_identity<Choice>{});
}

} // namespace

TEST_CASE("each parameter of each kind of the catalog is read into its own member") {
  using Others = std::variant<scene::ScenePart, scene::BodyPart, scene::ObstaclePart, scene::PairPart,
                              scene::SchedulePart, scene::StagePart, dynamics::StepControl, scene::OutputPart,
                              mesh::Edge, mesh::Outline, mesh::Refinement, material::KelvinVoigt,
                              material::PronyTerm, scene::RemeshPart, scene::SpringPart, dynamics::Accuracy,
                              scene::HalfSpacePart, scene::HeightMapPart, scene::ReliefPart>;
  check_choice<Others>();
  check_choice<mesh::Generator>();
  check_choice<material::Material>();
  check_choice<contact::Obstacle>();
  check_choice<halfspace::Shape>();
  check_choice<dynamics::Scheme>();
  check_choice<contact::SolverChoice>();
  check_choice<interface::FrictionLaw>();
  check_choice<interface::AdhesionLaw>();
  check_choice<scene::MotionPart>();
  check_choice<scene::ConstraintPart>();
  check_choice<scene::LoadPart>();
  check_choice<scene::ProbePart>();
  for (auto const& category : scene::catalog())
    for (auto const& kind : category.kinds) {
      INFO(category.name, ".", kind.name);
      CHECK(checked.contains(kind.name));
    }
}

TEST_CASE("the catalog says of every kind what it is, in units that exist and defaults that are admissible") {
  std::set<std::string> categories;
  for (auto const& category : scene::catalog()) {
    CHECK(categories.insert(category.name).second);
    CHECK_FALSE(category.meaning.empty());
    CHECK_FALSE(category.kinds.empty());
    std::set<std::string> names;
    for (auto const& kind : category.kinds) {
      CHECK(names.insert(kind.name).second);
      CHECK_FALSE(kind.meaning.empty());
      for (std::size_t i = 0; i < kind.parameters.size(); ++i) {
        auto const& parameter = kind.parameters[i];
        INFO(kind.name, ".", parameter.name);
        CHECK_FALSE(parameter.meaning.empty());
        CHECK(kind.find(parameter.name) != nullptr);
        if (parameter.kind == Parameter::Kind::nested)
          continue;
        CHECK(core::parse_unit(parameter.unit).has_value());
        auto const fallback = kind.fallback(i);
        if (auto const* number = std::get_if<double>(&fallback);
            number != nullptr && parameter.need == core::Need::optional)
          CHECK(parameter.range.contains(*number / core::parse_unit(parameter.unit)->value));
        if (parameter.kind == Parameter::Kind::choice)
          CHECK(std::ranges::count(parameter.choices, std::get<std::string>(fallback)) == 1);
      }
    }
  }
}

TEST_CASE("every table that the catalog mentions is of a category of the catalog") {
  for (auto const& category : scene::catalog())
    for (auto const& kind : category.kinds)
      for (auto const& parameter : kind.parameters) {
        if (parameter.kind != Parameter::Kind::nested || parameter.unit == scene::plain_table)
          continue;
        INFO(kind.name, ".", parameter.name, " is a ", parameter.unit);
        CHECK(std::ranges::any_of(scene::catalog(),
                                  [&](auto const& known) { return known.name == parameter.unit; }));
      }
}
