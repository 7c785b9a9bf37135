// Palettes and the spelling of units.
#include "page/style.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace stiction::postproc {

Colour palette(std::size_t index) {
  static constexpr std::array<Colour, palette_size> colours{{{0, 114, 178},
                                                             {213, 94, 0},
                                                             {0, 158, 115},
                                                             {204, 121, 167},
                                                             {230, 159, 0},
                                                             {86, 180, 233},
                                                             {0, 0, 0}}};
  return colours[index % palette_size];
}

Colour viridis(double fraction) {
  static constexpr std::array<Colour, 16> nodes{{{68, 1, 84},
                                                 {72, 26, 108},
                                                 {71, 47, 125},
                                                 {65, 68, 135},
                                                 {57, 86, 140},
                                                 {49, 104, 142},
                                                 {42, 120, 142},
                                                 {35, 136, 142},
                                                 {31, 152, 139},
                                                 {34, 168, 132},
                                                 {53, 183, 121},
                                                 {84, 197, 104},
                                                 {122, 209, 81},
                                                 {165, 219, 54},
                                                 {210, 226, 27},
                                                 {253, 231, 37}}};
  double const position = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(nodes.size() - 1);
  auto const left = std::min(static_cast<std::size_t>(position), nodes.size() - 2);
  double const weight = position - static_cast<double>(left);
  auto mix = [weight](unsigned char a, unsigned char b) {
    return static_cast<unsigned char>(std::lround((1 - weight) * a + weight * b));
  };
  auto const &a = nodes[left], &b = nodes[left + 1];
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

namespace {
char const* raised(char digit) {
  static constexpr char const* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return digit == '-' ? "⁻" : digits[digit - '0'];
}
bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}
} // namespace

std::string superscript(int exponent) {
  std::string text;
  for (char const c : std::to_string(exponent))
    text += raised(c);
  return text;
}

std::string printed_unit(std::string const& unit) {
  if (unit == "1")
    return "";
  std::string text;
  for (std::size_t i = 0; i < unit.size(); ++i) {
    bool const word_start = i == 0 || unit[i - 1] == ' ' || unit[i - 1] == '/' || unit[i - 1] == '*';
    if (unit[i] == '^') {
      while (i + 1 < unit.size() && (is_digit(unit[i + 1]) || unit[i + 1] == '-'))
        text += raised(unit[++i]);
    } else if (unit[i] == 'u' && word_start) {
      text += "µ";
    } else if (unit[i] == '*') {
      text += "·";
    } else {
      text += unit[i];
    }
  }
  return text;
}

std::string axis_title(std::string const& label, std::string const& unit, int power) {
  std::string const factor = power == 0 ? "" : "10" + superscript(power);
  std::string const printed = printed_unit(unit);
  std::string const inside = factor + (factor.empty() || printed.empty() ? "" : " ") + printed;
  return inside.empty() ? label : label + " [" + inside + "]";
}

} // namespace stiction::postproc
