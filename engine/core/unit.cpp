// The table of units and the small grammar "N s/m^2" (factors, powers, one '/' per divisor).
#include "core/unit.hpp"

#include <charconv>
#include <map>
#include <numbers>

namespace stiction::core {

namespace {

std::map<std::string, Quantity, std::less<>> const& table() {
  static std::map<std::string, Quantity, std::less<>> const units = {
      {"1", {1, {}}},
      {"%", {1e-2, {}}},
      {"rad", {1, {}}},
      {"deg", {std::numbers::pi / 180, {}}},
      {"m", {1, {1, 0, 0}}},
      {"km", {1e3, {1, 0, 0}}},
      {"cm", {1e-2, {1, 0, 0}}},
      {"mm", {1e-3, {1, 0, 0}}},
      {"um", {1e-6, {1, 0, 0}}},
      {"nm", {1e-9, {1, 0, 0}}},
      {"kg", {1, {0, 1, 0}}},
      {"g", {1e-3, {0, 1, 0}}},
      {"s", {1, {0, 0, 1}}},
      {"ms", {1e-3, {0, 0, 1}}},
      {"us", {1e-6, {0, 0, 1}}},
      {"ns", {1e-9, {0, 0, 1}}},
      {"Hz", {1, {0, 0, -1}}},
      {"N", {1, {1, 1, -2}}},
      {"kN", {1e3, {1, 1, -2}}},
      {"mN", {1e-3, {1, 1, -2}}},
      {"uN", {1e-6, {1, 1, -2}}},
      {"J", {1, {2, 1, -2}}},
      {"mJ", {1e-3, {2, 1, -2}}},
      {"W", {1, {2, 1, -3}}},
      {"Pa", {1, {-1, 1, -2}}},
      {"kPa", {1e3, {-1, 1, -2}}},
      {"MPa", {1e6, {-1, 1, -2}}},
      {"GPa", {1e9, {-1, 1, -2}}},
  };
  return units;
}

Quantity power(Quantity base, int exponent) {
  Quantity result{1, {}};
  for (int i = 0; i < std::abs(exponent); ++i)
    result.value *= base.value;
  if (exponent < 0)
    result.value = 1 / result.value;
  auto const& d = base.dimension;
  result.dimension = {d.metre * exponent, d.kilogram * exponent, d.second * exponent};
  return result;
}

std::optional<Quantity> factor(std::string_view word, bool divide) {
  int exponent = 1;
  if (auto const caret = word.find('^'); caret != std::string_view::npos) {
    auto const digits = word.substr(caret + 1);
    auto const [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    if (error != std::errc{} || end != digits.data() + digits.size())
      return {};
    word = word.substr(0, caret);
  }
  auto const found = table().find(word);
  if (found == table().end())
    return {};
  return power(found->second, divide ? -exponent : exponent);
}

} // namespace

std::optional<Quantity> parse_unit(std::string_view text) {
  Quantity result{1, {}};
  bool divide = false;
  while (!text.empty()) {
    if (text.front() == ' ' || text.front() == '*') {
      text.remove_prefix(1);
      continue;
    }
    if (text.front() == '/') {
      divide = true;
      text.remove_prefix(1);
      continue;
    }
    auto const end = std::min(text.find_first_of(" */"), text.size());
    auto const next = factor(text.substr(0, end), divide);
    if (!next)
      return {};
    result.value *= next->value;
    result.dimension.metre += next->dimension.metre;
    result.dimension.kilogram += next->dimension.kilogram;
    result.dimension.second += next->dimension.second;
    divide = false;
    text.remove_prefix(end);
  }
  return result;
}

std::string to_string(Dimension dimension) {
  std::string text;
  auto append = [&](char const* name, int exponent) {
    if (exponent == 0)
      return;
    if (!text.empty())
      text += ' ';
    text += name;
    if (exponent != 1)
      text.append("^").append(std::to_string(exponent));
  };
  append("kg", dimension.kilogram);
  append("m", dimension.metre);
  append("s", dimension.second);
  return text.empty() ? "1" : text;
}

std::vector<std::string> unit_words() {
  std::vector<std::string> words;
  for (auto const& [word, unit] : table())
    words.push_back(word);
  return words;
}

} // namespace stiction::core
