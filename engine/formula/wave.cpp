// A mean pressure q on the part between -a and a of each wave sinks it by 2 q L / (pi E*) ln(1 / sin(pi a /
// L)), as punches side by side: integrated over the growth of a it gives the depth of waves, subtracted once
// that of a crack.
#include "formula/wave.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stiction::formula {

using std::numbers::pi;

double Waves::full() const {
  return pi * modulus * amplitude / length;
}

State Wave::with(double depth, double pressure, double peak, double share) const {
  return {depth + pressure * waves_.mean_yield, pressure * waves_.extent, share * waves_.extent,
          std::max(0.0, peak)};
}

State Wave::part(double s) const {
  double const sin = std::sin(pi / 2 * s), cos = std::cos(pi / 2 * s), square = sin * sin,
               most = waves_.full();
  double const pull = work_ > 0 ? std::sqrt(2 * waves_.modulus * work_ / waves_.length * sin / cos) : 0;
  double const log = square > 0 ? std::log(square) : 0;
  double const depth =
      waves_.amplitude * square * (1 - log) + pull * waves_.length / (pi * waves_.modulus) * log;
  return with(depth, most * square - pull, sin > 0 ? 2 * most * sin - pull / sin : 0, s);
}

/// Without adhesion from p* on; with it under any force, each of which some s has.
State Wave::whole(double s) const {
  double const most = waves_.full();
  double const pressure = most * (work_ > 0 ? s - 1 / (s - 1) : s);
  return with(waves_.amplitude, pressure, pressure + most, 1);
}

State Wave::at(double s) const {
  return s < 1 || (s == 1 && work_ == 0) ? part(std::min(s, 1.0)) : whole(s);
}

} // namespace stiction::formula
