// Integrals of the shape functions over facets: the nodal forces of a unit traction.
#pragma once
#include "mesh/mesh.hpp"

namespace stiction::mesh {

/// Integral of every node's shape function over a facet of the reference mesh, in the order of facet.nodes:
/// m^2 in 3D, m in 2D, m^2 with the factor 2 pi r where `revolved`.
[[nodiscard]] Vector shape_integrals(Mesh const& mesh, Facet const& facet, bool revolved);

} // namespace stiction::mesh
