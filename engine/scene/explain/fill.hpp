// What the factor of a model's matrix will take, from the graph of its nodes: nothing is assembled or
// factored.
#pragma once
#include "dynamics/bulk/bulk_system.hpp"

namespace stiction::scene {

struct Fill {
  double unknowns = 0, surface = 0; ///< free degrees of freedom; of contact surfaces
  double entries = 0;               ///< of the matrix's lower triangle
  linear::Effort factor;
  bool surface_last = true;
  bool multigrid = false; ///< `factor` is then what takes its place
  double seconds = 0;     ///< that ordering would take, of this machine
};

/// bulk: of the model, for any purpose. Where there are more nodes than `most`, neighbours are taken together
/// until there are fewer, and the rest follows from the laws of nested dissection: in the plane
/// n log n numbers and n^(3/2) operations, in space n^(4/3) and n^2.
[[nodiscard]] Fill fill_of(dynamics::Model const& model, dynamics::BulkSystem const& bulk,
                           Index most = 10000);

} // namespace stiction::scene
