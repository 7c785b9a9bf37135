// How an answer stands for energy: what tells whether a step of displacement with bonds that have a potential
// made any.
#pragma once
#include <algorithm>
#include <cmath>

#include "core/threads.hpp"
#include "halfspace/linearised.hpp"
#include "halfspace/problem.hpp"

namespace stiction::halfspace {

/// Of all points, N.
template<int D> [[nodiscard]] double normal_force(Vector const& force) {
  return core::sum_of_pieces(static_cast<Index>(force.size()) / D, least_points,
                             [&](Index first, Index last) {
                               double part = 0;
                               for (Index i = first; i < last; ++i)
                                 part += force[D * i];
                               return part;
                             });
}

/// What an answer may go on from: forces, N, x and the lift of the counterpart, m.
struct Station {
  Vector force, x;
  double lift = 0;
};

/// Down by what a force takes at the nearest point alone, `alone`, at most to where a quarter of the points
/// touches, as more of them cost room and iterations, m; 0 where one touches.
template<int D>
[[nodiscard]] double drop_until_touched(Problem const& problem, Vector const& x, double alone) {
  Vector gaps(problem.size());
  for (Index i = 0; i < problem.size(); ++i)
    gaps[i] = x[D * i];
  double const nearest = gaps.minCoeff();
  if (nearest < 0)
    return 0;
  auto const some = gaps.begin() + problem.size() / 4;
  std::nth_element(gaps.begin(), some, gaps.end());
  double const quarter = *some - nearest;
  return nearest + (quarter > 0 ? std::min(alone, quarter) : alone);
}

struct Standing {
  double potential = 0; ///< that surfaces and bonds have stored and lost in the step, J
  double force = 0;     ///< that presses, N
  double deepest = 0;   ///< how far points are pressed into each other, m
  Index bonds = 0;      ///< points that are bonded
};

/// Adds what a point's bond at x has stored and lost in the step.
template<int D> void add_bond(Problem const& problem, Index i, contact::Local<D> const& x, Standing& sum) {
  if (!problem.adheres())
    return;
  auto const& law = problem.adhesion();
  auto const before = problem.bond(i);
  auto const bond = interface::advance<D>(law, before, x);
  sum.bonds += bond.beta > 0 ? 1 : 0;
  sum.potential +=
      problem.area * (interface::bond_energy(law, bond, x[0]) + interface::dissipation<D>(law, before, x));
}

/// Forces and x of every point, [D points], N and m.
template<int D>
[[nodiscard]] Standing standing(Problem const& problem, Vector const& force, Vector const& x) {
  Standing sum;
  for (Index i = 0; i < problem.size(); ++i) {
    contact::Local<D> const at = x.segment<D>(D * i), f = force.segment<D>(D * i);
    sum.deepest = std::max(sum.deepest, -at[0]);
    sum.force += f[0];
    sum.potential += 0.5 * f.dot(at - problem.free<D>(i));
    add_bond<D>(problem, i, at, sum);
  }
  return sum;
}

/// What pushes points out of each other that are pressed in at the start, at most, J.
template<int D>
[[nodiscard]] double work_of_pressing(Problem const& problem, Station const& from, Station const& to) {
  double sum = 0;
  for (Index i = 0; i < problem.size(); ++i) {
    double const depth = -from.x[D * i];
    if (depth > 0)
      sum += depth * std::max({0.0, from.force[D * i], to.force[D * i]});
  }
  return sum;
}

/// From where a step starts a displacement leads to less energy, but for the work of pressing, and with
/// friction to even less. Where friction acts energies are compared only if bonds broke: its own part is not
/// among them.
template<int D> [[nodiscard]] bool gained(Standing const& before, Standing const& after) {
  constexpr double rounding = 1e-9;
  double const pressing = before.deepest * std::max(std::abs(before.force), std::abs(after.force));
  double const more = after.potential - before.potential;
  return (D == 1 || after.bonds < before.bonds) && more > pressing + rounding * std::abs(before.potential);
}

[[nodiscard]] inline bool bonded_at_start(Problem const& problem, Index i) {
  return problem.beta(i) > 0;
}

[[nodiscard]] inline Index bonds_at_start(Problem const& problem) {
  Index sum = 0;
  for (Index i = 0; i < problem.size(); ++i)
    sum += bonded_at_start(problem, i) ? 1 : 0;
  return sum;
}

/// At least so much there is while bonds are held where they were at the start of a step, J, with the forces
/// of then: a body's energy is convex, and forces are its slope. x: what forces lead to now.
template<int D>
[[nodiscard]] double least_held(Problem const& problem, Vector const& force, Vector const& x) {
  Standing sum;
  for (Index i = 0; i < problem.size(); ++i) {
    contact::Local<D> const start = problem.start<D>(i), free = problem.free<D>(i);
    sum.potential += force.segment<D>(D * i).dot(start - 0.5 * (x.segment<D>(D * i) + free));
    add_bond<D>(problem, i, start, sum);
  }
  return sum.potential;
}

} // namespace stiction::halfspace
