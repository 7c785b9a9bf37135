// What the nodes of a surface stand for where shape functions leave them no area: hats on linear pieces.
#pragma once
#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

/// Local nodes of the linear pieces between the nodes of a facet of a mesh in `dim` dimensions: the facet
/// itself if it is of first order; 2 of an edge of three nodes; 4 triangles of tri6; 4 triangles and the
/// quadrilateral between them of quad8. None for other numbers of nodes.
[[nodiscard]] std::vector<std::vector<int>> const& linear_pieces(int dim, std::size_t nodes);

/// Integrals of hat i times shape function j over a facet, [hats, nodes] in the order of facet.nodes, in the
/// units of shape_integrals. Hats are linear or bilinear on the pieces of the reference facet; those of a
/// facet of first order are lumped: the shape integrals on the diagonal. The rows sum to the areas of the
/// hats, which are positive; the columns to the shape integrals, which may not be.
[[nodiscard]] Dense hat_products(Matrix const& nodes, Facet const& facet, bool revolved);

/// Part of a weighted mean of nodal values: whose, and its weight.
struct NodeShare {
  Index point = 0;
  double weight = 0;
};

/// What contact points at all nodes of a surface stand for. The functions N_c of corners c without a healthy
/// area (on the axis, of tri6 and quad8) get a part a_c of those of the middles m beside them, so much that
/// they have the area of their hat: N_c + a_c sum N_m, and (1 - a_c - a_d) N_m. Nodal values of these are
/// those of the N at corners and (x_m - a_c x_c - a_d x_d) / (1 - a_c - a_d) at middles (Popp, Wohlmuth, Gee
/// and Wall, SIAM J. Sci. Comput. 34, 2012, with a fixed part).
struct SurfaceShares {
  std::vector<double> areas;                 ///< [points] integrals of these functions, positive
  std::vector<std::vector<NodeShare>> means; ///< [points] nodal values of them; the own node first, sum 1
};

/// points: all nodes of the facets, in any order, which is that of the result. Throws InputError where facets
/// are so distorted that an area is not positive.
[[nodiscard]] SurfaceShares surface_shares(Matrix const& nodes, Set const& set, Indices const& points,
                                           bool revolved);

/// Whether the shape integrals of a facet may stand for the areas of its nodes: those of edges of three nodes
/// vanish on an axis of revolution, those at the corners of tri6 vanish, of quad8 are negative.
[[nodiscard]] bool shares_well(Matrix const& nodes, Facet const& facet, bool revolved);

} // namespace stiction::mesh
