// Boundaries as surfaces: their cells' kinds, areas of their nodes, consistency of their orientation.
#pragma once
#include <string>

#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

/// The plane kind that a facet of a 3D mesh is, by its number of nodes.
[[nodiscard]] CellKind facet_kind(Facet const& facet);

/// The area that each node of a surface stands for, all positive, in the order of set.nodes, m^2: integrals
/// of the hats of hats.hpp, so that the sum is the area. For meshes in 3D.
[[nodiscard]] Vector nodal_areas(Mesh const& mesh, Set const& set);

/// Refuses surfaces that contact cannot use: without facets or, in 3D, with an edge that two facets run
/// through in the same direction or that more than two share. Throws InputError naming the set and the first
/// facets.
void check_surface(Mesh const& mesh, Set const& set, std::string const& name);

} // namespace stiction::mesh
