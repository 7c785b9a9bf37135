// With K = 4 E*/3 in Maugis' units: a* = a (K / (pi w R^2))^(1/3), P* = P / (pi w R),
// d* = d (K^2 / (pi^2 w^2 R))^(1/3).
#include "formula/sphere.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stiction::formula {

using std::numbers::pi;

namespace {

/// Maugis' unit of contact radius, m.
double unit(Sphere const& sphere, double work) {
  return std::cbrt(0.75 * pi * work * sphere.radius * sphere.radius / sphere.modulus);
}

State dry(Sphere const& sphere, double a) {
  double const E = sphere.modulus, R = sphere.radius;
  return {a * a / R, 4 * E * a * a * a / (3 * R), pi * a * a, 2 * E * a / (pi * R)};
}

} // namespace

State Hertz::at(double s) const {
  return dry(sphere_, s * sphere_.radius);
}

State Jkr::at(double s) const {
  double const a = s * unit(sphere_, work_), E = sphere_.modulus;
  auto state = dry(sphere_, a);
  state.depth -= std::sqrt(2 * pi * work_ * a / E);
  state.force -= std::sqrt(8 * pi * work_ * E * a * a * a);
  state.peak = a > 0 ? std::max(0.0, state.peak - std::sqrt(2 * E * work_ / (pi * a))) : 0;
  return state;
}

State Dmt::at(double s) const {
  auto state = dry(sphere_, s * unit(sphere_, work_));
  state.force -= 2 * pi * work_ * sphere_.radius;
  return state;
}

double transition(Sphere const& sphere, double work, double traction) {
  return traction * std::cbrt(4.5 * sphere.radius / (pi * work * sphere.modulus * sphere.modulus));
}

/// The sphere's middle touches the surface where c^2 / 2R + (2 - 4/pi) sigma0 c / E* = h0.
Maugis::Maugis(Sphere const& sphere, double work, double traction)
    : sphere_(sphere), work_(work), traction_(traction), lambda_(transition(sphere, work, traction)) {
  double const half = (2 - 4 / pi) * traction / sphere.modulus * sphere.radius;
  double const square = 2 * sphere.radius * work / traction;
  first_ = square / (half + std::sqrt(half * half + square));
}

/// A uniform pull up to c raises the surface by 4 sigma0 c / (pi E*) there, where the gap is the range.
State Maugis::before(double c) const {
  double const rise = 4 * traction_ * c / (pi * sphere_.modulus);
  double const depth = c * c / (2 * sphere_.radius) - rise - work_ / traction_;
  return {depth, -pi * traction_ * c * c, 0, 0};
}

/// t with c = a / cos t: the gap at c is the range w / sigma0.
double Maugis::angle(double a) const {
  double low = 0, high = pi / 2;
  auto const excess = [&](double t) {
    double const tan = std::tan(t), over = 2 * std::pow(std::sin(t / 2), 2) / std::cos(t); // 1 / cos t - 1
    return lambda_ * a * a / 2 * ((tan - t) + t * tan * tan) +
           4 * lambda_ * lambda_ * a / 3 * (t * tan - over) - 1;
  };
  for (;;) {
    double const middle = 0.5 * (low + high);
    if (!(low < middle && middle < high))
      return middle;
    (excess(middle) < 0 ? low : high) = middle;
  }
}

State Maugis::at(double s) const {
  if (s <= 1)
    return before(s * first_);
  double const a = s - 1, length = unit(sphere_, work_), t = angle(a), tan = std::tan(t);
  auto state = dry(sphere_, a * length);
  state.depth -= 4.0 / 3 * a * lambda_ * tan * length * length / sphere_.radius;
  state.force -= lambda_ * a * a * (tan + t * (1 + tan * tan)) * pi * work_ * sphere_.radius;
  state.peak = std::max(0.0, state.peak - 2 * traction_ / pi * t);
  return state;
}

} // namespace stiction::formula
