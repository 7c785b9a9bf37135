// The leading terms: base and sides as a spring in series, inward motion and tilt of the surface, the law.
#include "scene/explain/reach.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stiction::scene {

namespace {

using std::numbers::pi;

/// What the end of a long bar is stiffer than bar and half space in series, over P / (pi E* L): 2.04 to 2.29
/// for Poisson's ratios from 0 to 0.5, measured with linear elasticity and a small contact.
constexpr double bar_end = 2;

/// What large strains change, over the slope: for laws of rubber on an endless block, measured. Neo-Hooke
/// -0.13 to -0.06 at Poisson's ratios of 0 to 0.49, Mooney-Rivlin without C10 -0.03 to 0.06 (at 0.3 and
/// 0.49).
constexpr double law_least = -0.13, law_most = 0.06;
/// Over the slope squared, always smaller: sphere against paraboloid -0.1, the rest the second order of what
/// is inward.
constexpr double second_order = -0.32;

/// Johnson 1985, 5.8: (1 - M) of a layer whose base is held, or slides.
double lack(double t, double poisson, bool stuck) {
  double const twice = std::sinh(2 * t), k = 3 - 4 * poisson;
  if (!stuck)
    return 1 - (std::cosh(2 * t) - 1) / (twice + 2 * t);
  return 1 - (2 * k * twice - 4 * t) / (2 * k * std::cosh(2 * t) + 1 + k * k + 4 * t * t);
}

/// F / F0 - 1 where F = F0(depth + c F) of a sphere, F0 ~ depth^1.5, x = 2 a c / pi, to the second order, and
/// no less than the next one.
double stiffened(double x) {
  return x + 7.0 / 6 * x * x + x * x * x;
}
/// 1 - F / F0 where F = F0(depth - c F): no less than to the second order, and less than all of it.
double softened(double x) {
  return x > 0 ? x / (1 + x) : 0;
}

} // namespace

double base_number(double poisson, bool stuck) {
  constexpr int n = 600; // Simpson; beyond t = 15 the rest is below 1e-11
  constexpr double end = 15, h = end / n;
  double sum = 1 + lack(end, poisson, stuck); // M(0) = 0
  for (int i = 1; i < n; ++i)
    sum += (i % 2 == 1 ? 4 : 2) * lack(i * h, poisson, stuck);
  return sum * h / 3;
}

double ReachError::total() const {
  return std::max(base + larger, sides + smaller);
}

ReachError error_of(Reach const& reach) {
  double const a = reach.contact, h = reach.thickness, L = reach.width, nu = reach.poisson, s = reach.slope;
  double const bar = h / ((1 - nu * nu) * L * L) - bar_end / L;
  double const inward = (1 - 2 * nu) / (1 - nu) / pi; // points move inward, and pressures tilt
  double const most = (inward + (reach.small_strain ? 0 : law_most)) * s;
  double const least =
      (inward + (reach.small_strain ? 0 : law_least)) * s + second_order * s * s - reach.softening;
  ReachError error{stiffened(2 * a / pi * base_number(nu, reach.stuck) / h), softened(2 * a / pi * bar),
                   std::max(0.0, most), std::max(0.0, -least)};
  if (reach.balance > 1) // where it pulls what is larger is smaller
    error.larger = error.smaller = reach.balance * std::max(error.larger, error.smaller);
  return error;
}

double contact_radius(double depth, double radius, double work_over_modulus) {
  double const pull = 2 * pi * work_over_modulus; // a^2 / R - sqrt(pull a) = depth
  double low = std::cbrt(radius * radius * pull / 16);
  double high = 2 * (std::sqrt(radius * std::max(depth, 0.0)) + std::cbrt(radius * radius * pull));
  for (int i = 0; i < 100; ++i) {
    double const a = 0.5 * (low + high);
    (a * a / radius - std::sqrt(pull * a) < depth ? low : high) = a;
  }
  return 0.5 * (low + high);
}

} // namespace stiction::scene
