// Nodes of a primary that lie within the body of its secondary, between the points there, which do not see
// them.
#pragma once
#include "dynamics/model/model.hpp"

namespace stiction::scene {

struct DugIn {
  Index node = -1;  ///< of the model; -1: none
  double depth = 0; ///< beneath the secondary's surface, straight between the corners of its facets, m
  double part = 0;  ///< the same over the size of a facet there
};

/// The deepest one, in parts of a facet, of a pair of two bodies by node to segment at the displacements u,
/// [degrees of freedom]. Those that lie less than `least` of a facet deep do not count.
[[nodiscard]] DugIn deepest_dug_in(dynamics::Model const& model, dynamics::Pair const& pair, Vector const& u,
                                   double least);

} // namespace stiction::scene
