// Integrals over deformed facets with their derivatives by the places of the nodes: normals, area, volume.
#pragma once
#include "mesh/topology/mesh.hpp"
#include "solid/geometry.hpp"

namespace stiction::solid {

/// Sums over the quadrature points of one facet, by its dim nodes' coordinates, node by node. With a the area
/// vector, outward, and the factor 2 pi r about an axis (per metre of depth in plane strain):
struct FacetTerms {
  double area = 0; ///< int |a|, m^2
  double volume =
      0; ///< int (x - centre).a / dim, about an axis int pi r^2 a_r: over a closed surface its volume, m^3
  Vector normals;     ///< int N a: nodal forces of a unit traction along the normal, m^2
  Vector area_by_x;   ///< m
  Dense normals_by_x; ///< not symmetric but where the surface is closed or its edge is held, m
  Dense area_by_x2;   ///< symmetric, 1
};

enum class FacetOrder { values, first, second }; ///< derivatives wanted: none; of the area; of all

/// x: present places of the facet's nodes, [nodes, dim], m.
[[nodiscard]] FacetTerms facet_terms(Kinematics kinematics, Matrix const& x, Point const& centre,
                                     FacetOrder order);

/// A plane by a point and its normal of unit length.
struct Plane {
  Point point = Point::Zero(), normal = Point::Zero();
};

/// Sides of a facet of so many nodes: its ends in the plane, in space its edges.
[[nodiscard]] int sides_of(std::size_t nodes, Eigen::Index dim);
/// The corners of one of them.
[[nodiscard]] Indices corners_of(mesh::Facet const& facet, int side, Eigen::Index dim);

/// Adds to a facet's terms those of a skirt that hangs from one of its sides down to the plane along its
/// normal, as if the facet went on there. x: as above; area is left as it is.
void add_skirt(Kinematics kinematics, Matrix const& x, int side, Plane const& plane, FacetTerms& terms);

} // namespace stiction::solid
