// A round flat punch on a half space, without adhesion.
#pragma once
#include <cmath>
#include <numbers>

#include "formula/formula.hpp"

namespace stiction::formula {

/// s: depth over the radius. P = 2 E* a d; the pressure has no bound at the edge.
class Punch : public Formula {
public:
  Punch(double modulus, double radius) : modulus_(modulus), radius_(radius) {} ///< Pa, m
  [[nodiscard]] State at(double s) const override {
    double const area = s > 0 ? pi * radius_ * radius_ : 0, stiffness = 2 * modulus_ * radius_,
                 depth = s * radius_;
    return {depth, stiffness * depth, area, unknown, 0.5 * stiffness * depth * depth};
  }
  [[nodiscard]] Profile profile(double s) const override {
    double const depth = s * radius_, mean = 2 * modulus_ * s / pi, a = radius_;
    return [depth, mean, a](double r) -> Local {
      if (r < a)
        return {depth > 0, mean / (2 * std::sqrt(1 - r * r / (a * a))), 0, depth};
      return {false, 0, 0, 2 / pi * depth * std::asin(a / r)};
    };
  }
  [[nodiscard]] Gives gives() const override { return {true, false}; }
  [[nodiscard]] std::string_view name() const override { return "flat punch"; }
  [[nodiscard]] std::string_view source() const override { return "Boussinesq 1885; Sneddon 1946"; }

private:
  static constexpr double pi = std::numbers::pi;
  double modulus_, radius_;
};

} // namespace stiction::formula
