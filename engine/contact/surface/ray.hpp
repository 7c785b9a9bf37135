// Where a line meets a surface of cell facets, found by walking from facet to facet.
#pragma once
#include "contact/surface/cell_surface.hpp"

namespace stiction::contact {

/// The line from - g along, g any number; `along` a unit vector that points away from the surface's body.
template<int D> struct Ray { Vec<D> from, along; };

/// x2(foot) + g along = from on the facets that face the ray, from `start` on; a point up to `overhang` (in
/// parts of a facet) beyond a border still counts. Not found elsewhere.
template<int D>
[[nodiscard]] Foot meet(CellSurface const& surface, Ray<D> const& ray, Foot start, double overhang,
                        Positions x);

/// The point on one facet or its continuation, or one more than a facet beyond if it is there; false if there
/// is none. at: first guess and result; gap: g.
template<int D>
[[nodiscard]] bool meet_facet(FacetKind kind, FacetNodes<D> const& nodes, Ray<D> const& ray, Vec2& at,
                              double& gap);

} // namespace stiction::contact
