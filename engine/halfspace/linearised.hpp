// The contact problem of a half space linearised at some forces: an equation at every point that the
// surface's compliance matters to.
#pragma once
#include <vector>

#include "contact/problem/problem.hpp"
#include "core/threads.hpp"
#include "halfspace/surface.hpp"

namespace stiction::halfspace {

using contact::Local;
using contact::LocalMatrix;

/// (a + b W) dp + b e lift = -F at those points, from the left with (a + b W_own)^-1: with B of that times b,
/// v + B (W - W_own) v + B e lift = r. The other points have their changes of force at once.
template<int D> struct Linearised {
  Indices points;                              ///< that count, ascending
  std::vector<LocalMatrix<D>> B;               ///< [points], N/m
  std::vector<Local<D>> left;                  ///< [points], -(a + b W_own)^-1 F, N
  LocalMatrix<D> own = LocalMatrix<D>::Zero(); ///< diagonal block of W, m/N
  double softness = 0;                         ///< mean of 1 / stiffness of what yields with W, m/N
  std::vector<bool> yields;                    ///< [points] does W govern it, and not its own law?
  bool definite = true; ///< does no point soften? Then, in one component, it is symmetric
  [[nodiscard]] Index size() const { return static_cast<Index>(points.size()); }
  /// Points that come after its own.
  void append(Linearised const& other) {
    points.insert(points.end(), other.points.begin(), other.points.end());
    B.insert(B.end(), other.B.begin(), other.B.end());
    left.insert(left.end(), other.left.begin(), other.left.end());
    yields.insert(yields.end(), other.yields.begin(), other.yields.end());
    softness += other.softness;
    definite = definite && other.definite;
  }
};

constexpr Index least_points = 1024; ///< that a thread takes at a time

/// act(k) for each of the points that count, shared by threads.
template<class Act> void each_of(Indices const& points, Act const& act) {
  core::each_piece(static_cast<Index>(points.size()), least_points, [&](Index first, Index last) {
    for (Index k = first; k < last; ++k)
      act(k);
  });
}

/// Values at points that count, [points, D], among all.
template<int D> void scatter(Indices const& points, Vector const& few, Vector& all) {
  all.setZero();
  each_of(points, [&](Index k) { all.segment<D>(D * points[ix(k)]) = few.segment<D>(D * k); });
}

} // namespace stiction::halfspace
