// Cells in plane strain: tri3, quad4, tri6, quad8.
#include "solid/passes.hpp"

namespace stiction::solid {

BlockPasses const& plane_strain_passes(int nodes) {
  return passes_among<Kinematics::plane_strain, 3, 4, 6, 8>(nodes);
}

} // namespace stiction::solid
