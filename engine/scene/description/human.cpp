// Prefixes by unit.
#include "scene/description/human.hpp"

#include <cmath>
#include <fmt/format.h>
#include <map>
#include <vector>

namespace stiction::scene {

namespace {

struct Scaled {
  double factor;
  char const* unit;
};

/// Largest first.
std::vector<Scaled> const& scales(std::string_view unit) {
  static std::map<std::string, std::vector<Scaled>, std::less<>> const known{
      {"m", {{1, "m"}, {1e-3, "mm"}, {1e-6, "um"}, {1e-9, "nm"}}},
      {"s", {{86400, "d"}, {3600, "h"}, {60, "min"}, {1, "s"}, {1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}}},
      {"Pa", {{1e9, "GPa"}, {1e6, "MPa"}, {1e3, "kPa"}, {1, "Pa"}}},
      {"kg", {{1, "kg"}, {1e-3, "g"}, {1e-6, "mg"}}},
      {"m/s", {{1e3, "km/s"}, {1, "m/s"}, {1e-3, "mm/s"}, {1e-6, "um/s"}}},
      {"B", {{1e9, "GB"}, {1e6, "MB"}, {1e3, "kB"}, {1, "B"}}},
  };
  static std::vector<Scaled> const none;
  auto const found = known.find(unit);
  return found == known.end() ? none : found->second;
}

/// Three digits; no exponent up to a million.
std::string digits(double value) {
  double const size = std::abs(value);
  return size >= 999.5 && size < 999999.5 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

} // namespace

std::string human(double value, std::string_view unit) {
  if (unit.empty() || unit == "1")
    return digits(value);
  Scaled const* chosen = nullptr;
  for (auto const& scale : scales(unit))
    if (chosen == nullptr || std::abs(value) < 0.9995 * chosen->factor)
      chosen = &scale;
  if (chosen == nullptr || value == 0 || !std::isfinite(value))
    return digits(value) + " " + std::string(unit);
  return digits(value / chosen->factor) + " " + chosen->unit;
}

std::string percent(double part) {
  return part < 0.995 ? fmt::format("{:.2g} %", 100 * part) : fmt::format("{:.0f} %", 100 * part);
}

std::string counted(double count) {
  return count < 1e6 ? fmt::format("{:.0f}", count) : fmt::format("{:.3g} million", count / 1e6);
}

} // namespace stiction::scene
