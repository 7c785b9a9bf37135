// A parabolic cylinder on a half space, per length: Hertz, and JKR. Its depth is that of no place: it grows
// with the logarithm of the distance.
#pragma once
#include <algorithm>
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
    using std::numbers::pi;
    double const E = modulus_;
    double const a = s * (work_ > 0 ? std::cbrt(2 * work_ * radius_ * radius_ / (pi * E)) : radius_);
    double const pull = a > 0 ? std::sqrt(2 * E * work_ / (pi * a)) : 0; // of the middle, Pa
    return {unknown, pi * E * a * a / (4 * radius_) - pi * a * pull, 2 * a,
            std::max(0.0, E * a / (2 * radius_) - pull)};
  }
  [[nodiscard]] Gives gives() const override { return {false, true}; }
  [[nodiscard]] std::string_view name() const override {
    return work_ > 0 ? "JKR of a line" : "Hertz of a line";
  }
  [[nodiscard]] std::string_view source() const override {
    return work_ > 0 ? "Barquins 1988; Chaudhury, Weaver, Hui and Kramer 1996"
                     : "Hertz 1882; Johnson 1985, 4.2";
  }

private:
  double modulus_, radius_, work_;
};

} // namespace stiction::formula
