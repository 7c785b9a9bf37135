// Cells in three dimensions: tet4, hex8, tet10, hex20.
#include "solid/passes.hpp"

namespace stiction::solid {

BlockPasses const& three_dimensional_passes(int nodes) {
  return passes_among<Kinematics::three_dimensional, 4, 8, 10, 20>(nodes);
}

} // namespace stiction::solid
