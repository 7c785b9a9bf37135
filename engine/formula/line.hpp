// A parabolic cylinder on a half space, per length: Hertz, and JKR. Its depth is that of no place: it grows
// with the logarithm of the distance.
#pragma once
#include <cmath>
#include <numbers>

#include "formula/formula.hpp"

namespace stiction::formula {

/// s: half width over the radius, or, where it adheres, over (2 w R^2 / (pi E*))^(1/3): that at the pull-off.
/// P = pi E* a^2 / 4R - sqrt(2 pi E* w a).
class Line : public Formula {
public:
  Line(double modulus, double radius, double work)
      : modulus_(modulus), radius_(radius), work_(work) {} ///< Pa, m, J/m^2
  [[nodiscard]] State at(double s) const override {
    double const a = half_width(s), pull = middle_pull(a);
    return {unknown, pi * modulus_ * a * a / (4 * radius_) - pi * a * pull, 2 * a,
            modulus_ * a / (2 * radius_) - pull};
  }
  [[nodiscard]] Profile profile(double s) const override {
    double const a = half_width(s), pull = middle_pull(a), E = modulus_, R = radius_;
    return [a, pull, E, R](double x) -> Local {
      double const parabola = -x * x / (2 * R), root = std::sqrt(std::abs(a * a - x * x));
      if (x < a)
        return {true, E / (2 * R) * root - pull * a / root, 0, parabola};
      double const log = a > 0 ? std::acosh(x / a) : 0;
      return {false, 0, 0, parabola + (x * root - a * a * log) / (2 * R) + 2 * pull * a / E * log};
    };
  }
  [[nodiscard]] Gives gives() const override {
    return {false, true, "what lines store grows without end with the bodies' size, as their depth does"};
  }
  [[nodiscard]] std::string_view name() const override {
    return work_ > 0 ? "JKR of a line" : "Hertz of a line";
  }
  [[nodiscard]] std::string_view source() const override {
    return work_ > 0 ? "Barquins 1988; Chaudhury, Weaver, Hui and Kramer 1996"
                     : "Hertz 1882; Johnson 1985, 4.2";
  }

private:
  static constexpr double pi = std::numbers::pi;
  [[nodiscard]] double half_width(double s) const {
    return s * (work_ > 0 ? std::cbrt(2 * work_ * radius_ * radius_ / (pi * modulus_)) : radius_);
  }
  /// By which adhesion lessens the pressure of the middle, Pa.
  [[nodiscard]] double middle_pull(double a) const {
    return a > 0 ? std::sqrt(2 * modulus_ * work_ / (pi * a)) : 0;
  }
  double modulus_, radius_, work_;
};

} // namespace stiction::formula
