// Wording of ranges and values, and the search for what a misspelt word meant.
#include "core/schema.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace stiction::core {

bool Range::contains(double value) const {
  if (!std::isfinite(value))
    return false;
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

std::string Range::words(std::string_view unit) const {
  std::string const tail = unit.empty() || unit == "1" ? "" : fmt::format(" {}", unit);
  bool const below = std::isfinite(low), above = std::isfinite(high);
  if (below && above)
    return fmt::format("in {}{:g}, {:g}{}{}", low_open ? '(' : '[', low, high, high_open ? ')' : ']', tail);
  if (below)
    return fmt::format("{} {:g}{}", low_open ? ">" : ">=", low, tail);
  if (above)
    return fmt::format("{} {:g}{}", high_open ? "<" : "<=", high, tail);
  return "any finite number" + (tail.empty() ? tail : " in" + tail);
}

Parameter const* Schema::find(std::string_view parameter) const {
  auto const found = std::find_if(parameters.begin(), parameters.end(),
                                  [&](Parameter const& p) { return p.name == parameter; });
  return found == parameters.end() ? nullptr : &*found;
}

std::vector<Parameter const*> Schema::idle(void const* object) const {
  std::vector<Parameter const*> found;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    if (auto const& p = parameters[i]; p.acts && !p.acts(object) && p.get(object) != fallback(i))
      found.push_back(&p);
  return found;
}

std::optional<double> whole_number(double value) {
  double const whole = std::round(value);
  if (std::abs(value - whole) <= 1e-9 * std::max(1.0, std::abs(value)))
    return whole;
  return {};
}

std::string to_string(Value const& value) {
  struct {
    std::string operator()(bool v) const { return v ? "true" : "false"; }
    std::string operator()(double v) const { return fmt::format("{:g}", v); }
    std::string operator()(std::string const& v) const { return '"' + v + '"'; }
    std::string operator()(Numbers const& v) const { return fmt::format("{{{:g}}}", fmt::join(v, ", ")); }
  } words;
  return std::visit(words, value);
}

/// Levenshtein's distance of two words, by one row of its table.
static std::size_t edit_distance(std::string_view word, std::string_view other) {
  std::vector<std::size_t> row(other.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < word.size(); ++i) {
    std::size_t corner = row[0]++;
    for (std::size_t j = 0; j < other.size(); ++j) {
      std::size_t const substitute = corner + (word[i] == other[j] ? 0 : 1);
      corner = row[j + 1];
      row[j + 1] = std::min({substitute, row[j] + 1, corner + 1});
    }
  }
  return row.back();
}

std::string nearest(std::string_view word, std::vector<std::string> const& known) {
  std::string best;
  std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;
  for (auto const& candidate : known)
    if (auto const d = edit_distance(word, candidate); d < least) {
      least = d;
      best = candidate;
    }
  return best;
}

} // namespace stiction::core
