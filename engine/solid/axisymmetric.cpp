// Axisymmetric cells: tri3, quad4, tri6, quad8.
#include "solid/passes.hpp"

namespace stiction::solid {

BlockPasses const& axisymmetric_passes(int nodes) {
  return passes_among<Kinematics::axisymmetric, 3, 4, 6, 8>(nodes);
}

} // namespace stiction::solid
