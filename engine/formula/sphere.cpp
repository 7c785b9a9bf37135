// With K = 4 E*/3 in Maugis' units: a* = a (K / (pi w R^2))^(1/3), P* = P / (pi w R),
// d* = d (K^2 / (pi^2 w^2 R))^(1/3). Profiles and energies by Abel's transform q(x) = 2 int_x^inf p r dr /
// sqrt(r^2 - x^2): q = E* (d - x^2 / R) where it touches, -2 sigma0 sqrt(c^2 - x^2) where it is drawn
// (Sneddon 1946).
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

/// Strain energy, J: int q^2 dx / E* over x > 0.
double strain(Sphere const& sphere, Rim const& rim) {
  double const E = sphere.modulus, R = sphere.radius, a = rim.a, c = rim.c, d = rim.depth, t = rim.traction;
  double const touching = a * (d * d - a * a * (2 * d / (3 * R) - a * a / (5 * R * R)));
  return E * touching + 4 * t * t / E * (c * c * (c - a) - (c * c * c - a * a * a) / 3);
}

/// int r^2 p dA over all, N m^2: 4 int x^2 q dx over x > 0.
double second_moment(Sphere const& sphere, Rim const& rim) {
  double const R = sphere.radius, a = rim.a, c = rim.c;
  double const pulled = pi / 16 * std::pow(c, 4) - a * (2 * a * a - c * c) * std::sqrt(c * c - a * a) / 8 -
                        (c > 0 ? std::pow(c, 4) / 8 * std::asin(a / c) : 0);
  return 4 * sphere.modulus * a * a * a * (rim.depth / 3 - a * a / (5 * R)) - 8 * rim.traction * pulled;
}

/// int of the gap over the ring that is drawn, m^3: that of the surface's sink from twice the strain energy
/// less the work on what touches.
double gap_volume(Sphere const& sphere, Rim const& rim, double force) {
  double const R = sphere.radius, a2 = rim.a * rim.a, c2 = rim.c * rim.c, t = rim.traction;
  double const pressing = force + t * pi * (c2 - a2),
               moment = second_moment(sphere, rim) + t * pi / 2 * (c2 * c2 - a2 * a2),
               on_contact = rim.depth * pressing - moment / (2 * R),
               sinks = (on_contact - 2 * strain(sphere, rim)) / t;
  return pi * ((c2 * c2 - a2 * a2) / (4 * R) - rim.depth * (c2 - a2)) + sinks;
}

/// int from a to min(r, c) of sqrt((c^2 - x^2) / (r^2 - x^2)) dx, m.
double drawn(double a, double c, double r) {
  if (!(c / r < 1)) { // at r = c to the last bit, too
    double const k = std::min(1.0, r / c);
    return c * (std::comp_ellint_2(k) - std::ellint_2(k, std::asin(a / r)));
  }
  double const k = c / r, from = std::asin(a / c);
  return r * (std::comp_ellint_2(k) - std::ellint_2(k, from)) +
         (c * c - r * r) / r * (std::comp_ellint_1(k) - std::ellint_1(k, from));
}

Local local(Sphere const& sphere, Rim const& rim, double r) {
  double const E = sphere.modulus, R = sphere.radius, a = rim.a, c = rim.c;
  if (r < a) {
    double const root = std::sqrt(a * a - r * r), flat = rim.depth - a * a / R;
    double const reach = std::sqrt(std::max(0.0, c * c - a * a));
    double const pressure = 2 * E / (pi * R) * root + (rim.traction > 0 ? 0 : E * flat / (pi * root)) -
                            2 * rim.traction / pi * std::atan(reach / root);
    return {true, pressure, 0, rim.depth - r * r / (2 * R)};
  }
  Local at{false, 0, r < c ? rim.traction : 0, 0};
  if (r > 0) {
    double const rises = c > a ? 2 * rim.traction / E * drawn(a, c, r) : 0;
    double const sinks =
        (rim.depth - r * r / (2 * R)) * std::asin(a / r) + a * std::sqrt(r * r - a * a) / (2 * R);
    at.sink = 2 / pi * (sinks - rises);
  } else // nothing touches: that of a uniform pull's middle
    at.sink = -2 * rim.traction * c / E;
  return at;
}

Profile profile_of(Sphere const& sphere, Rim const& rim) {
  return [sphere, rim](double r) { return local(sphere, rim, r); };
}

} // namespace

State Hertz::at(double s) const {
  auto state = dry(sphere_, s * sphere_.radius);
  state.strain = 0.4 * state.force * state.depth;
  return state;
}

Profile Hertz::profile(double s) const {
  double const a = s * sphere_.radius;
  return profile_of(sphere_, {a, a, at(s).depth, 0});
}

State Jkr::at(double s) const {
  double const a = s * unit(sphere_, work_), E = sphere_.modulus;
  auto state = dry(sphere_, a);
  state.depth -= std::sqrt(2 * pi * work_ * a / E);
  state.force -= std::sqrt(8 * pi * work_ * E * a * a * a);
  state.peak -= a > 0 ? std::sqrt(2 * E * work_ / (pi * a)) : 0;
  state.strain = strain(sphere_, {a, a, state.depth, 0});
  state.bond = -work_ * state.area;
  return state;
}

Profile Jkr::profile(double s) const {
  double const a = s * unit(sphere_, work_);
  return profile_of(sphere_, {a, a, at(s).depth, 0});
}

State Dmt::at(double s) const {
  auto state = dry(sphere_, s * unit(sphere_, work_));
  state.force -= 2 * pi * work_ * sphere_.radius;
  return state;
}

Profile Dmt::profile(double s) const {
  double const a = s * unit(sphere_, work_);
  return profile_of(sphere_, {a, a, at(s).depth, 0});
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

/// Before it touches a uniform pull up to c raises the surface by 4 sigma0 c / (pi E*) there, where the gap
/// is the range.
Maugis::Drawn Maugis::drawn(double s) const {
  double const R = sphere_.radius, E = sphere_.modulus;
  if (s <= 1) {
    double const c = s * first_, rise = 4 * traction_ * c / (pi * E);
    return {{0, c, c * c / (2 * R) - rise - work_ / traction_, traction_}, pi / 2};
  }
  double const a = s - 1, length = unit(sphere_, work_), t = angle(a);
  double const depth = (a * a - 4.0 / 3 * a * lambda_ * std::tan(t)) * length * length / R;
  return {{a * length, a * length / std::cos(t), depth, traction_}, t};
}

State Maugis::at(double s) const {
  auto const [rim, t] = drawn(s);
  auto state = dry(sphere_, rim.a);
  state.depth = rim.depth;
  state.peak -= 2 * traction_ / pi * t;
  if (s <= 1)
    state.force = -pi * traction_ * rim.c * rim.c;
  else {
    double const a = s - 1, tan = std::tan(t);
    state.force -= lambda_ * a * a * (tan + t * (1 + tan * tan)) * pi * work_ * sphere_.radius;
  }
  state.strain = strain(sphere_, rim);
  state.bond = traction_ * gap_volume(sphere_, rim, state.force) - work_ * pi * rim.c * rim.c;
  return state;
}

Profile Maugis::profile(double s) const {
  return profile_of(sphere_, drawn(s).rim);
}

} // namespace stiction::formula
