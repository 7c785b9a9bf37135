// The way of a step along a surface, from its chord and the normals at both of its ends.
#pragma once
#include "contact/surface/foot.hpp"

namespace stiction::contact {

/// Where the ends of a way lie: of points over a surface, which may rise and sink, or on its facets, where a
/// chord leans to the normals by the facets alone.
enum class ChordEnds : std::uint8_t { over_surface, on_facets };

/// The chord's part across the normal half-way, as long as its circle's arc in the plane in which the normal
/// turns, and turned to the end: all of the way round spheres and cylinders, else but for the third order
/// (physics.md 1).
template<int D> class Way {
public:
  /// chord: m; from, to: unit normals before and after.
  Way(Vec<D> const& chord, Vec<D> const& from, Vec<D> const& to, ChordEnds ends);
  /// Component along a tangent at the end, m; between opposite normals the chord's.
  [[nodiscard]] double along(Vec<D> const& tangent) const;

  /// Derivatives of that component by the chord, the normals (m), and the tangent (m).
  struct By {
    Vec<D> chord, from, to, tangent;
  };
  [[nodiscard]] By by(Vec<D> const& tangent) const;

private:
  Vec<D> chord_, from_, to_, middle_;
  bool told_ = true;          ///< which way round
  double leaning_ = 0;        ///< 1: less what the chord has along the middle
  double cosine_ = 1;         ///< of half of the angle
  double excess_, excess_by_; ///< (arc / chord - 1) / (2 sin^2) of a circle, of half of the angle; by cosine_
  double risen_ = 0;          ///< what is taken away along the middle, m
};

} // namespace stiction::contact
