// Cutting a secondary facet where the borders of primary facets project on it.
#pragma once
#include "contact/mortar/mortar_sample.hpp"

namespace stiction::contact {

/// A point of the secondary facet's reference domain, the weight it has there and the primary facet it faces.
struct CutPoint {
  Vec2 at;
  double weight = 0;
  int primary = 0;
};

/// How deep and how far a counterpart may lie: low < gap < high, m.
struct GapRange {
  double low = 0, high = 0;
  [[nodiscard]] bool holds(double gap) const { return low < gap && gap < high; }
};

/// Quadrature points over the parts of secondary facet `facet` that face one of the `candidates` (primary
/// facets) along the averaged normals. Where several lie one behind the other the nearest counts.
template<int D>
[[nodiscard]] std::vector<CutPoint> cut_facet(Faced<D> const& faced, int facet,
                                              std::vector<int> const& candidates, GapRange range);

/// The part of a convex polygon, or of an interval given by its ends, that lies in the reference domain; its
/// corners in order, none if that is empty.
[[nodiscard]] std::vector<Vec2> clip_to_domain(FacetKind kind, std::vector<Vec2> polygon);

} // namespace stiction::contact
