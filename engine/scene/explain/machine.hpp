// How fast this machine is now: what seconds of a forecast are made of.
#pragma once
#include "dynamics/model/model.hpp"
#include "halfspace/surface.hpp"

namespace stiction::scene {

struct Machine {
  double products = 0; ///< operations of dense products, 1/s
  double stream = 0;   ///< bytes read from memory, 1/s
};
/// Takes some milliseconds.
[[nodiscard]] Machine measure_machine();

/// Seconds of one pass over all cells at rest.
struct PassSeconds {
  double force = 0, stiffness = 0;
};
/// From some cells of each block.
[[nodiscard]] PassSeconds measure_passes(dynamics::Model const& model);

/// Seconds of one product with the compliance.
[[nodiscard]] double measure_product(halfspace::Surface const& surface);

} // namespace stiction::scene
