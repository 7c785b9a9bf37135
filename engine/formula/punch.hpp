// A round flat punch on a half space, without adhesion.
#pragma once
#include <numbers>

#include "formula/formula.hpp"

namespace stiction::formula {

/// s: depth over the radius. P = 2 E* a d; the pressure has no bound at the edge.
class Punch : public Formula {
public:
  Punch(double modulus, double radius) : modulus_(modulus), radius_(radius) {} ///< Pa, m
  [[nodiscard]] State at(double s) const override {
    double const area = s > 0 ? std::numbers::pi * radius_ * radius_ : 0;
    return {s * radius_, 2 * modulus_ * radius_ * radius_ * s, area, unknown};
  }
  [[nodiscard]] Gives gives() const override { return {true, false}; }
  [[nodiscard]] std::string_view name() const override { return "flat punch"; }
  [[nodiscard]] std::string_view source() const override { return "Boussinesq 1885; Sneddon 1946"; }

private:
  double modulus_, radius_;
};

} // namespace stiction::formula
