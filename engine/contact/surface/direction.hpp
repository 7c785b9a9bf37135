// Along what the first tangent of a surface in space lies where nobody says it.
#pragma once
#include "contact/surface/facet.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::contact {

/// The axis least in line with the mean normal; where some facet lies across it, so that tangents would turn
/// about there, the one that all facets lie along best, as along a drum. reference: all nodes of the model,
/// [nodes, 3].
[[nodiscard]] Vec3 first_direction(std::vector<mesh::Facet> const& facets, Matrix const& reference);

} // namespace stiction::contact
