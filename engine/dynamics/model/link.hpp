// Displacement components that follow others: oblique rollers, periodic sides.
#pragma once
#include <utility>
#include <vector>

#include "core/types.hpp"

namespace stiction::dynamics {

/// u[dof] = sum of weight u[master]; no master follows another.
struct Link {
  Index dof = 0; ///< degree of freedom, dim node + component
  std::vector<std::pair<Index, double>> masters;
};

} // namespace stiction::dynamics
