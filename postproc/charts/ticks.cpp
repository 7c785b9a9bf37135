// Tick positions by the 1-2-5 rule.
#include "charts/ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <initializer_list>
#include <utility>

#include "page/style.hpp"

namespace stiction::postproc {

double Scale::fraction(double value) const {
  if (log)
    return std::log10(value / low) / std::log10(high / low);
  return (value - low) / (high - low);
}

std::string printed_number(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  bool const zero = text.find_first_not_of("0.") == std::string::npos;
  return (value < 0 && !zero ? "−" : "") + text;
}

namespace {

double nice_step(double length, int wanted) {
  double const rough = length / std::max(wanted, 1);
  double const decade = std::pow(10, std::floor(std::log10(rough)));
  for (double const factor : {1.0, 2.0, 5.0})
    if (factor * decade >= rough * (1 - 1e-9))
      return factor * decade;
  return 10 * decade;
}

/// 0 while the plain numbers are short, else the power of ten (a multiple of 3) to take out.
int common_power(Scale const& scale) {
  double const largest = std::max(std::abs(scale.low), std::abs(scale.high));
  if (largest < 1e5 && largest >= 1e-2)
    return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
}

Ticks linear_ticks(Scale const& scale, int wanted) {
  Ticks result{{}, common_power(scale)};
  double const step = nice_step(scale.high - scale.low, wanted), unit = std::pow(10, result.power);
  int const decimals = std::max(0, -static_cast<int>(std::floor(std::log10(step / unit) + 1e-9)));
  auto const first = std::lround(std::ceil(scale.low / step - 1e-6));
  auto const last = std::lround(std::floor(scale.high / step + 1e-6));
  for (long i = first; i <= last; ++i) {
    double const value = static_cast<double>(i) * step;
    result.ticks.push_back({value, printed_number(value / unit, decimals)});
  }
  return result;
}

using Digits = std::array<bool, 10>; ///< which of 1, ..., 9 times a power of ten

Digits digits(std::initializer_list<std::size_t> list) {
  Digits result{};
  for (std::size_t const digit : list)
    result[digit] = true;
  return result;
}

/// 1, ..., 9 times powers of ten on the axis: {digit, power}.
std::vector<std::pair<int, int>> log_values(Scale const& scale) {
  std::vector<std::pair<int, int>> values;
  int const first = static_cast<int>(std::floor(std::log10(scale.low) + 1e-9));
  int const last = static_cast<int>(std::ceil(std::log10(scale.high) - 1e-9));
  for (int power = first; power <= last; ++power)
    for (int digit = 1; digit < 10; ++digit) {
      double const fraction = scale.fraction(digit * std::pow(10, power));
      if (fraction > -1e-6 && fraction < 1 + 1e-6)
        values.emplace_back(digit, power);
    }
  return values;
}

/// The digits to label on an axis with at most two powers of ten: the coarsest set that says two values, none
/// if no set does. A power of ten with a single other value beside it does not say how the axis runs.
Digits labelled_digits(std::vector<std::pair<int, int>> const& values, int wanted) {
  auto const count = [&values](Digits const& set) {
    return std::count_if(values.begin(), values.end(),
                         [&set](auto const& value) { return set[static_cast<std::size_t>(value.first)]; });
  };
  auto const powers = digits({1});
  if (count(powers) == 2 && count(digits({1, 2, 5})) > wanted)
    return powers;
  for (auto const& set : {digits({1, 2, 5}), digits({1, 2, 3, 4, 6, 8}), digits({1, 2, 3, 4, 5, 6, 7, 8, 9})})
    if (count(set) >= 2)
      return set;
  return {};
}

std::string log_label(int digit, int power, bool plain) {
  if (plain)
    return printed_number(digit * std::pow(10, power), std::max(0, -power));
  return (digit == 1 ? "" : fmt::format("{}·", digit)) + "10" + superscript(power);
}

/// Powers of ten alone from three of them on; else values between them too, written out where they are short.
Ticks log_ticks(Scale const& scale, int wanted) {
  auto const values = log_values(scale);
  auto const powers = static_cast<int>(
      std::count_if(values.begin(), values.end(), [](auto const& v) { return v.first == 1; }));
  auto const set = powers > 2 ? digits({1}) : labelled_digits(values, wanted);
  if (set == Digits{})
    return linear_ticks(scale, wanted);
  bool const plain = powers < 3 && scale.low >= 1e-3 && scale.high < 1e5;
  int const every = std::max(1, (powers + wanted - 1) / std::max(wanted, 1));
  Ticks result;
  int seen = -1;
  for (auto const& [digit, power] : values) {
    seen += digit == 1 ? 1 : 0;
    bool const labelled = set[static_cast<std::size_t>(digit)] && (powers < 3 || seen % every == 0);
    result.ticks.push_back({digit * std::pow(10, power), labelled ? log_label(digit, power, plain) : ""});
  }
  return result;
}

} // namespace

Ticks ticks_for(Scale const& scale, int wanted) {
  return scale.log ? log_ticks(scale, wanted) : linear_ticks(scale, wanted);
}

Scale padded_scale(double low, double high, bool log) {
  if (log) {
    double const factor = high > low ? std::pow(high / low, 0.04) : 2;
    return {low / factor, high * factor, true};
  }
  double length = high - low;
  if (!(length > 1e-12 * std::max(std::abs(low), std::abs(high))))
    length = low == 0 ? 1 : std::abs(low);
  double const margin = 0.04 * length;
  Scale scale{low - margin, high + margin, false};
  if (low >= 0 && low < 0.25 * high)
    scale.low = 0;
  if (high <= 0 && high > 0.25 * low)
    scale.high = 0;
  return scale;
}

} // namespace stiction::postproc
