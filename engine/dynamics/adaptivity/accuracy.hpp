// Bounds on the steps of a run that chooses them as it goes.
#pragma once
#include "core/reader.hpp"

namespace stiction::dynamics {

/// Steps of a stage that one may be where `largest` is not given.
inline constexpr double most_growth = 10;

/// Bounds on a single step of a run whose steps are chosen as it goes.
struct Accuracy {
  double tolerance = 1e-3;  ///< local error of a step: of u over the largest u so far, and of any beta
  double beta_change = 0.1; ///< largest change of any beta in a step
  double events = 0;        ///< s; events are located within it, 0: they are not
  int factors = 4; ///< kept of the last step sizes; of schemes with inertia alone the factor depends on it
  double smallest = 0, largest = 0; ///< s; 0: what `halvings` leaves of a stage's step; ten of them
  [[nodiscard]] core::Complaints check() const;
  [[nodiscard]] static core::Schema const& schema();
};

} // namespace stiction::dynamics
