// Physical dimensions as exponents of metre, kilogram and second, and the units that scripts and schemas
// name.
#pragma once
#include <compare>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stiction::core {

/// Exponents of the SI base units in use; all zero is a pure number.
struct Dimension {
  int metre = 0, kilogram = 0, second = 0;
  auto operator<=>(Dimension const&) const = default;
};

/// A number in SI with its dimension.
struct Quantity {
  double value = 0.0;
  Dimension dimension;
};

/// "J/m^2" -> {1, kg s^-2}; "mm" -> {1e-3, m}; "" and "1" are pure numbers; nothing if a word is unknown.
[[nodiscard]] std::optional<Quantity> parse_unit(std::string_view text);

/// "kg m^-1 s^-2", or "1" for a pure number.
[[nodiscard]] std::string to_string(Dimension dimension);

/// All unit words known, for help and for the script's unit table.
[[nodiscard]] std::vector<std::string> unit_words();

} // namespace stiction::core
