// How an answer stands for energy: what tells whether a step of displacement with bonds that have a potential
// made any.
#pragma once
#include <algorithm>
#include <array>
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

/// Force and x of a point, N and m.
template<int D> struct PointStation { contact::Local<D> force, x; };

/// Where points are so far on the straight way between two, 0 to 1: what has `force` and `x`. Both have to
/// stay.
template<int D> [[nodiscard]] auto on_way(auto const& from, auto const& to, double part) {
  return [&from, &to, part](Index i) {
    contact::Local<D> const f = from.force.template segment<D>(D * i), x = from.x.template segment<D>(D * i);
    return PointStation<D>{f + part * (to.force.template segment<D>(D * i) - f),
                           x + part * (to.x.template segment<D>(D * i) - x)};
  };
}

/// at(i): PointStation of each point. Shared by threads, with the same sums however many there are.
template<int D, class At> [[nodiscard]] Standing standing(Problem const& problem, At const& at) {
  std::array<Standing, core::most_pieces> parts;
  core::each_piece(problem.size(), least_points, [&](Index first, Index last) {
    auto& part = parts[ix(core::piece_of(problem.size(), least_points, first))];
    for (Index i = first; i < last; ++i) {
      PointStation<D> const here = at(i);
      part.deepest = std::max(part.deepest, -here.x[0]);
      part.force += here.force[0];
      part.potential += 0.5 * here.force.dot(here.x - problem.free<D>(i));
      add_bond<D>(problem, i, here.x, part);
    }
  });
  Standing sum;
  for (auto const& part : parts) {
    sum.potential += part.potential;
    sum.force += part.force;
    sum.deepest = std::max(sum.deepest, part.deepest);
    sum.bonds += part.bonds;
  }
  return sum;
}

/// What pushes points out of each other that are pressed in at the start, at most, J.
template<int D>
[[nodiscard]] double work_of_pressing(Problem const& problem, Vector const& x, Vector const& from,
                                      Vector const& to) {
  double sum = 0;
  for (Index i = 0; i < problem.size(); ++i) {
    double const depth = -x[D * i];
    if (depth > 0)
      sum += depth * std::max({0.0, from[D * i], to[D * i]});
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
