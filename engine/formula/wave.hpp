// A cosine along x pressed onto a half space that is repeated for ever: Westergaard, and Johnson where it
// adheres.
#pragma once
#include "formula/formula.hpp"

namespace stiction::formula {

struct Waves {
  double modulus = 0;    ///< E*, Pa
  double amplitude = 0;  ///< D of the heights D (1 - cos 2 pi x / L), m
  double length = 0;     ///< L, m
  double extent = 0;     ///< of all that is pressed, m^2 (in plane strain m)
  double mean_yield = 0; ///< by which the mean of the surface sinks under a mean pressure, m/Pa
  /// p* = pi E* D / L, under which waves that do not adhere touch everywhere, Pa.
  [[nodiscard]] double full() const;
};

/// s <= 1: part of the surface that touches; beyond, all of it does. Depths are against the mean of what lies
/// far below the surface. Adhesion has no range: where all touches, no pull is enough to part it.
class Wave : public Formula {
public:
  Wave(Waves const& waves, double work) : waves_(waves), work_(work) {} ///< J/m^2
  [[nodiscard]] State at(double s) const override;
  [[nodiscard]] Profile profile(double s) const override;
  [[nodiscard]] std::string_view name() const override {
    return work_ > 0 ? "Johnson's adhesive wave" : "Westergaard";
  }
  [[nodiscard]] std::string_view source() const override {
    return work_ > 0 ? "Johnson 1995" : "Westergaard 1939; Johnson 1985, 13.2";
  }

private:
  [[nodiscard]] bool is_part(double s) const;
  [[nodiscard]] State part(double s) const;
  [[nodiscard]] State whole(double s) const;
  [[nodiscard]] double mean_pull(double s) const;
  [[nodiscard]] State with(double depth, double pressure, double peak, double share) const;
  Waves waves_;
  double work_;
};

} // namespace stiction::formula
