// Operations of one pass over all cells.
#pragma once
#include "dynamics/model/model.hpp"

namespace stiction::scene {

struct PassOperations {
  double force = 0, stiffness = 0;
};
[[nodiscard]] PassOperations pass_operations(dynamics::Model const& model);

} // namespace stiction::scene
