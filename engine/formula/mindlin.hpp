// A pressed sphere that is moved along under constant pressure: Cattaneo 1938, Mindlin 1949, and back:
// Mindlin and Deresiewicz 1953.
#pragma once
#include <vector>

namespace stiction::formula {

/// From where it was pressed, along a line. Sides are alike (pressure makes no shear), friction is along the
/// motion.
class Mindlin {
public:
  /// Sum of (2 - nu) / G of both sides, 1/Pa, and the coefficient of friction.
  Mindlin(double yield, double mu) : yield_(yield), mu_(mu) {}
  /// Force along, N, once moved to there, m, by a straight way, under this force, N, and contact radius, m.
  [[nodiscard]] double move(double to, double force, double radius);

private:
  [[nodiscard]] double first(double way) const;
  double yield_, mu_;
  double range_ = 0, at_ = 0; ///< at which all slips, and where it is, m
  std::vector<double> turns_; ///< where it turned round, m; those that later ways have passed are gone
};

} // namespace stiction::formula
