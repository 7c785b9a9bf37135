// The contact problem of a step of a half space, whose points have one law and differ by their past alone.
#pragma once
#include <array>

#include "contact/problem/problem.hpp"
#include "halfspace/model.hpp"
#include "halfspace/surface.hpp"

namespace stiction::halfspace {

/// As contact::Problem, but that points are made as they are asked for: a list of them would be the largest
/// of all arrays.
struct Problem {
  contact::Problem shared;          ///< dim, W, free and laws; it lists no points
  double area;                      ///< of a point, m^2 (m in plane strain)
  double dt = 0;                    ///< s
  std::array<double, 3> mu;         ///< friction coefficients by the status that a point starts from
  State const* old = nullptr;       ///< bonds, status and, if known, gaps that the step starts from
  std::vector<std::uint8_t> closed; ///< [points] do they touch, as bonds are told?

  /// At rest, without a past.
  Problem(Surface const& surface, interface::Law const& law);

  [[nodiscard]] Index size() const { return static_cast<Index>(closed.size()); }
  [[nodiscard]] bool adheres() const { return !shared.adhesions.empty(); }
  [[nodiscard]] interface::AdhesionLaw const& adhesion() const { return shared.adhesions.front(); }
  [[nodiscard]] double beta(Index i) const { return old->beta.size() > 0 ? old->beta[i] : 0; }
  [[nodiscard]] interface::BondStep bond(Index i) const { return {old->bond_of(i), dt, closed[ix(i)] != 0}; }
  [[nodiscard]] contact::ProblemPoint point(Index i) const {
    contact::ProblemPoint made;
    made.area = area;
    made.mu = mu[old->status[ix(i)]];
    made.adhesion = adheres() ? 0 : -1;
    made.bond = bond(i);
    made.friction = shared.frictions.empty() ? -1 : 0;
    return made;
  }
  /// Is it known where points were at the start of the step?
  [[nodiscard]] bool has_start() const { return old->gap.size() > 0; }
  /// (gap, no slip) then, m.
  template<int D> [[nodiscard]] contact::Local<D> start(Index i) const {
    contact::Local<D> x = contact::Local<D>::Zero();
    x[0] = old->gap[i];
    return x;
  }
  template<int D> [[nodiscard]] contact::Local<D> free(Index i) const {
    return shared.free.segment<D>(D * i);
  }
  /// With a list of its points.
  [[nodiscard]] contact::Problem listed() const;
};

/// As contact::judge.
[[nodiscard]] contact::Verdict judge(Problem const& problem, Vector const& force, Vector const& x,
                                     double lift);

} // namespace stiction::halfspace
