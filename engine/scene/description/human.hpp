// Numbers for people: three digits and the unit in which they are short.
#pragma once
#include <string>
#include <string_view>

namespace stiction::scene {

/// 2.5e-4 of "m" -> "0.25 mm"; "B" are bytes, "1" a pure number.
[[nodiscard]] std::string human(double value, std::string_view unit);
/// 0.083 -> "8.3 %".
[[nodiscard]] std::string percent(double part);
/// 5049 -> "5049", 1.2e7 -> "12 million".
[[nodiscard]] std::string counted(double count);

} // namespace stiction::scene
