// The sphere that formulas are tested with.
#pragma once
#include <doctest/doctest.h>

#include "formula/sphere.hpp"

namespace stiction::test {

inline constexpr double ball_modulus = 3e6, ball_radius = 2e-3, ball_work = 0.05; ///< Pa, m, J/m^2
inline constexpr formula::Sphere ball{ball_modulus, ball_radius};

/// Within a part of the number, however small that is.
inline doctest::Approx near(double number, double part) {
  return doctest::Approx(number).epsilon(part).scale(1e-30);
}

/// Of Maugis' parameter, Pa.
inline double traction(double lambda) {
  return lambda / formula::transition(ball, ball_work, 1);
}

} // namespace stiction::test
