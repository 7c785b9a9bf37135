// The wording and the checks behind reader.hpp.
#include "core/reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace stiction::core {

namespace {
Input const nothing;

/// A value outside the range, in as many digits as show it.
std::string shown_outside(double value, Range range) {
  auto text = fmt::format("{:g}", value);
  return std::isfinite(value) && range.contains(std::stod(text)) ? fmt::format("{}", value) : text;
}

/// The way out where a value outside its range is a wish that has one.
char const* way_out(std::string_view key, double value) {
  if (key == "poisson" && value >= 0.5 && value <= 0.501)
    return "; a body that hardly changes its volume: poisson = 0.499 with interpolation = "
           "\"mean_dilatation\" "
           "in its body";
  return "";
}
} // namespace

char const* kind_of(Input const& input) {
  static constexpr char const* names[] = {"nothing", "true/false", "a number",
                                          "a text",  "a list",     "a table with names"};
  return names[input.value.index()];
}

Reader::Reader(Input const& input, std::string path, Complaints& complaints)
    : input_(&input), path_(std::move(path)), complaints_(&complaints) {
  bool const nothing = std::holds_alternative<std::monostate>(input.value) ||
                       (input.list() != nullptr && input.list()->empty()); // as scripts write it: {}
  if (input.table() == nullptr && !nothing)
    complain(fmt::format("is {}; a table with names is wanted", kind_of(input)));
}

bool Reader::has(std::string_view key) const {
  auto const* table = input_->table();
  return table != nullptr && table->find(key) != table->end();
}

std::vector<std::string> Reader::keys() const {
  std::vector<std::string> names;
  if (auto const* table = input_->table())
    for (auto const& [key, value] : *table)
      names.push_back(key);
  return names;
}

std::string Reader::path_of(std::string_view key) const {
  if (key.empty())
    return path_;
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

void Reader::complain_at(std::string_view key, std::string text) {
  std::string place = input_->place;
  if (has(key) && !input_->table()->find(key)->second.place.empty())
    place = input_->table()->find(key)->second.place;
  complaints_->push_back({place, path_of(key), std::move(text)});
}

void Reader::complain_all(Complaints const& complaints) {
  for (auto const& complaint : complaints)
    complain_at(complaint.path, complaint.text);
}

Input const& Reader::at(std::string_view key, Need need) {
  asked_.emplace(key);
  if (has(key))
    return input_->table()->find(key)->second;
  if (need == Need::required)
    complain_at(key, "is missing; it is required");
  return nothing;
}

Reader Reader::child(std::string_view key, Need need) {
  return {at(key, need), path_of(key), *complaints_};
}

std::vector<Reader> Reader::children(std::string_view key, Need need) {
  std::vector<Reader> result;
  auto const& given = at(key, need);
  if (std::holds_alternative<std::monostate>(given.value))
    return result;
  if (auto const* table = given.table(); table != nullptr && table->empty())
    return result;
  if (given.list() == nullptr) {
    complain_at(key, fmt::format("is {}; a list {{...}} is wanted", kind_of(given)));
    return result;
  }
  for (std::size_t i = 0; i < given.list()->size(); ++i)
    result.emplace_back((*given.list())[i], fmt::format("{}[{}]", path_of(key), i + 1), *complaints_);
  return result;
}

bool Reader::check_number(std::string_view key, Input const& given, std::string_view unit, Range range,
                          double& value) {
  auto const* quantity = given.quantity();
  if (quantity == nullptr) {
    complain_at(key, fmt::format("is {}; a number{} is wanted", kind_of(given),
                                 unit.empty() || unit == "1" ? "" : fmt::format(" in {}", unit)));
    return false;
  }
  auto const wanted = parse_unit(unit);
  expect(wanted.has_value(), "schema units to be known");
  bool const bare_zero = quantity->value == 0 && quantity->dimension == Dimension{};
  if (quantity->dimension != wanted->dimension && !bare_zero) {
    bool const bare = quantity->dimension == Dimension{};
    complain_at(
        key, fmt::format("{:g} {} has the wrong unit; {} is wanted{}", quantity->value,
                         bare ? "(a pure number)" : to_string(quantity->dimension),
                         unit.empty() || unit == "1" ? "a pure number" : unit,
                         bare ? fmt::format(", for example {:g}*units(\"{}\")", quantity->value, unit) : ""));
    return false;
  }
  double const in_unit = quantity->value / wanted->value;
  if (!range.contains(in_unit)) {
    complain_at(key, fmt::format("is {}{}; it must be {}{}", shown_outside(in_unit, range),
                                 unit.empty() || unit == "1" ? "" : fmt::format(" {}", unit),
                                 range.words(unit), way_out(key, in_unit)));
    return false;
  }
  value = quantity->value;
  return true;
}

double Reader::number(std::string_view key, std::string_view unit, Range range) {
  double value = std::numeric_limits<double>::quiet_NaN();
  auto const& given = at(key);
  if (has(key))
    check_number(key, given, unit, range, value);
  return value;
}

double Reader::number_or(std::string_view key, std::string_view unit, Range range, double fallback) {
  auto const& given = at(key, Need::optional);
  if (has(key))
    check_number(key, given, unit, range, fallback);
  return fallback;
}

std::string Reader::text(std::string_view key, Need need) {
  auto const& given = at(key, need);
  if (!has(key))
    return "";
  if (given.text() != nullptr)
    return *given.text();
  complain_at(key, fmt::format("is {}; a text is wanted", kind_of(given)));
  return "";
}

bool Reader::flag_or(std::string_view key, bool fallback) {
  auto const& given = at(key, Need::optional);
  if (!has(key))
    return fallback;
  if (given.flag() != nullptr)
    return *given.flag();
  complain_at(key, fmt::format("is {}; true or false is wanted", kind_of(given)));
  return fallback;
}

Numbers Reader::numbers(std::string_view key, std::string_view unit, Need need) {
  Numbers values;
  auto const& given = at(key, need);
  if (!has(key))
    return values;
  if (given.list() == nullptr) {
    complain_at(key, fmt::format("is {}; a list of numbers{} is wanted", kind_of(given),
                                 unit == "1" ? "" : fmt::format(" in {}", unit)));
    return values;
  }
  for (auto const& element : *given.list()) {
    double value = 0;
    if (!check_number(key, element, unit, any_number, value))
      return {};
    values.push_back(value);
  }
  return values;
}

bool Reader::parse(Parameter const& parameter, Input const& given, Value& value) {
  using Kind = Parameter::Kind;
  switch (parameter.kind) {
  case Kind::number:
  case Kind::integer:
    return parse_number(parameter, given, value);
  case Kind::choice:
    return parse_choice(parameter, given, value);
  case Kind::numbers:
    value = numbers(parameter.name, parameter.unit);
    return true;
  case Kind::flag:
    value = flag_or(parameter.name, false);
    return true;
  case Kind::text:
  case Kind::file:
    value = text(parameter.name);
    return given.text() != nullptr;
  case Kind::nested:
    return false;
  }
  return false;
}

bool Reader::parse_number(Parameter const& parameter, Input const& given, Value& value) {
  double number = 0;
  if (!check_number(parameter.name, given, parameter.unit, parameter.range, number))
    return false;
  value = number;
  if (parameter.kind != Parameter::Kind::integer)
    return true;
  auto const whole = whole_number(number);
  if (whole)
    value = *whole;
  else
    complain_at(parameter.name, fmt::format("is {:g}; a whole number is wanted", number));
  return whole.has_value();
}

bool Reader::parse_choice(Parameter const& parameter, Input const& given, Value& value) {
  std::string const word = text(parameter.name);
  if (std::ranges::find(parameter.choices, word) != parameter.choices.end()) {
    value = word;
    return true;
  }
  if (given.text() == nullptr)
    return false;
  auto const meant = nearest(word, parameter.choices);
  complain_at(parameter.name,
              fmt::format("is \"{}\"; it must be one of {}{}", word, fmt::join(parameter.choices, ", "),
                          meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant)));
  return false;
}

namespace {
bool is_number(Parameter const& parameter) {
  using Kind = Parameter::Kind;
  return parameter.kind == Kind::number || parameter.kind == Kind::integer || parameter.kind == Kind::numbers;
}
} // namespace

void Reader::fill(void* target, Schema const& schema) {
  for (auto const& parameter : schema.parameters) {
    auto const& given = at(parameter.name, Need::optional);
    if (parameter.kind == Parameter::Kind::nested)
      continue;
    if (!has(parameter.name)) {
      if (parameter.need == Need::required)
        complain_at(parameter.name,
                    fmt::format("is missing; {}: {}{}", schema.name, parameter.meaning,
                                is_number(parameter) ? ", " + parameter.range.words(parameter.unit) : ""));
      continue;
    }
    if (Value value; parse(parameter, given, value))
      parameter.set(target, value);
  }
}

void Reader::complain_unknown_kind(std::string const& name, std::vector<std::string> const& known) {
  if (input_->table() == nullptr) { // the reader has complained already, knowing less
    if (!complaints_->empty() && complaints_->back().path == path_ && input_->value.index() != 0)
      complaints_->back().text =
          fmt::format("is {}; it must be made by one of {}", kind_of(*input_), fmt::join(known, ", "));
    return;
  }
  auto const meant = nearest(name, known);
  complain(
      fmt::format("{}; it must be made by one of {}{}",
                  name.empty() ? std::string("has no kind") : fmt::format("\"{}\" is not known here", name),
                  fmt::join(known, ", "), meant.empty() ? "" : fmt::format("; did you mean \"{}\"?", meant)));
}

void Reader::finish() {
  std::vector<std::string> const known(asked_.begin(), asked_.end());
  for (auto const& key : keys()) {
    if (asked_.contains(key))
      continue;
    auto const meant = nearest(key, known);
    complain_at(key, meant.empty()
                         ? fmt::format("is not a parameter here; known are {}", fmt::join(known, ", "))
                         : fmt::format("is not a parameter here; did you mean \"{}\"?", meant));
  }
}

} // namespace stiction::core
