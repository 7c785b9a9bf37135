// Integrals of the shape functions over facets: the nodal forces of a unit traction.
#pragma once
#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

/// Shape functions of an edge of two or three nodes (ends first) on [-1, 1] and their derivatives, [nodes].
[[nodiscard]] std::array<Vector, 2> edge_shape(std::size_t nodes, double x);

/// Integral of every node's shape function over a facet; nodes: [nodes, 2 or 3], m. In the order of
/// facet.nodes: m^2 in 3D, m in 2D, m^2 with the factor 2 pi r where `revolved`.
[[nodiscard]] Vector shape_integrals(Matrix const& nodes, Facet const& facet, bool revolved);

} // namespace stiction::mesh
