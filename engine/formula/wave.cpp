// A mean pressure q on the part between -a and a of each wave sinks it by 2 q L / (pi E*) ln(1 / sin(pi a /
// L)), as punches side by side: integrated over the growth of a it gives the depth of waves, subtracted once
// that of a crack.
#include "formula/wave.hpp"

#include <cmath>
#include <numbers>

namespace stiction::formula {

using std::numbers::pi;

double Waves::full() const {
  return pi * modulus * amplitude / length;
}

State Wave::with(double depth, double pressure, double peak, double share) const {
  double const area = share * waves_.extent;
  return {depth + pressure * waves_.mean_yield, pressure * waves_.extent, area, peak, 0, -work_ * area};
}

/// By which adhesion lessens the mean pressure where part of the surface touches, Pa.
double Wave::mean_pull(double s) const {
  return work_ > 0 ? std::sqrt(2 * waves_.modulus * work_ / waves_.length * std::tan(pi / 2 * s)) : 0;
}

State Wave::part(double s) const {
  double const sin = std::sin(pi / 2 * s), square = sin * sin, most = waves_.full(), pull = mean_pull(s);
  double const log = square > 0 ? std::log(square) : 0;
  double const depth =
      waves_.amplitude * square * (1 - log) + pull * waves_.length / (pi * waves_.modulus) * log;
  auto state = with(depth, most * square - pull, sin > 0 ? 2 * most * sin - pull / sin : 0, s);
  double const D = waves_.amplitude; // half of pressure times sink, over what touches
  state.strain =
      0.5 * (state.force * state.depth + waves_.extent * D * square * (pull - 0.5 * most * square));
  return state;
}

/// Without adhesion from p* on; with it under any force, each of which some s has.
State Wave::whole(double s) const {
  double const most = waves_.full();
  double const pressure = most * (work_ > 0 ? s - 1 / (s - 1) : s);
  auto state = with(waves_.amplitude, pressure, pressure + most, 1);
  state.strain =
      0.5 * (state.force * (state.depth - waves_.amplitude) + 0.5 * waves_.extent * most * waves_.amplitude);
  return state;
}

bool Wave::is_part(double s) const {
  return s < 1 || (s == 1 && work_ == 0);
}

State Wave::at(double s) const {
  return is_part(s) ? part(s) : whole(s);
}

/// With y = sin(pi x / L): p = (2 p* (b^2 - y^2) - pull) cos / sqrt(b^2 - y^2) up to y = b; beyond, the gap's
/// slope is the same with y^2 - b^2, over E*/2 (Johnson 1985, 13.2; Johnson 1995).
Profile Wave::profile(double s) const {
  auto const state = at(s);
  double const most = waves_.full(), L = waves_.length, E = waves_.modulus, D = waves_.amplitude;
  if (!is_part(s))
    return [state, most, L, D, mean = state.force / waves_.extent](double x) -> Local {
      double const cos = std::cos(2 * pi * x / L);
      return {true, mean + most * cos, 0, state.depth - D * (1 - cos)};
    };
  double const edge = std::sin(pi / 2 * s), pull = mean_pull(s);
  return [state, most, L, E, D, edge, pull](double x) -> Local {
    double const y = std::abs(std::sin(pi * x / L)), cos = std::abs(std::cos(pi * x / L)),
                 root = std::sqrt(std::abs(edge * edge - y * y));
    double const on_wave = state.depth - 2 * D * y * y;
    if (y < edge)
      return {true, (2 * most * root - pull / root) * cos, 0, on_wave};
    double const log = edge > 0 ? std::acosh(y / edge) : 0;
    double const gap = 2 * D * (y * root - edge * edge * log) + 2 * pull * L / (pi * E) * log;
    return {false, 0, 0, on_wave + gap};
  };
}

} // namespace stiction::formula
