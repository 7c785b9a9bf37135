// Tick positions by the 1-2-5 rule.
#include "charts/ticks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

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

Ticks log_ticks(Scale const& scale, int wanted) {
  Ticks result;
  int const first = static_cast<int>(std::floor(std::log10(scale.low) + 1e-9));
  int const last = static_cast<int>(std::ceil(std::log10(scale.high) - 1e-9));
  int const every = std::max(1, (last - first + wanted - 1) / std::max(wanted, 1));
  auto inside = [&](double value) {
    double const fraction = scale.fraction(value);
    return fraction > -1e-6 && fraction < 1 + 1e-6;
  };
  bool const short_axis = last - first <= 2; // then label 2 and 5 too
  for (int decade = first; decade <= last; ++decade)
    for (int digit = 1; digit < 10; ++digit) {
      double const value = digit * std::pow(10, decade);
      if (!inside(value))
        continue;
      bool const major = digit == 1 && (decade - first) % every == 0;
      bool const extra = short_axis && (digit == 2 || digit == 5);
      std::string const base = "10" + superscript(decade);
      result.ticks.push_back({value, major   ? base
                                     : extra ? fmt::format("{}·{}", digit, base)
                                             : std::string()});
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
