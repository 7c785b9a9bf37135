// The contact condition on rates, written as a shift of gap and slip so that problem, solvers and laws stay.
#pragma once
#include "dynamics/model/model.hpp"
#include "dynamics/model/state.hpp"

namespace stiction::dynamics {

/// One contact point under a condition on rates.
struct RateCondition {
  contact::Vec3 shift; ///< (n, t1, t2), m: x - shift = rate dt (x' at the step's end + restitution x_n' at
                       ///< its start), x the gap at the end and the slip of the step
  double arrest =
      0; ///< gap at the step's end if the point came to rest, m: contact is due where this is <= 0
};

/// From x = old x + dt (1 - rate) x'_0 - rate rate_a dt^2 x''_0 + rate dt x'_1, which StepWeights says of any
/// motion; nodes with a balance of their own have rate = 1.
[[nodiscard]] inline RateCondition rate_condition(ContactState const& old, StepWeights const& weights,
                                                  double dt) {
  bool const apart = weights.surface_apart();
  double const rate = apart ? 1 : weights.rate, rate_a = apart ? 0 : weights.rate_a;
  RateCondition condition;
  condition.shift = dt * (1 - rate) * old.rate - rate * rate_a * dt * dt * old.second;
  condition.shift[0] += old.gap;
  condition.arrest = condition.shift[0];
  condition.shift[0] -= weights.restitution * rate * dt * old.rate[0];
  return condition;
}

/// H v at one point, (n, t1, t2).
template<int D>
[[nodiscard]] contact::Vec3 rate_of(contact::PointKinematics<D> const& point, Vector const& v) {
  interface::Local<D> sum = interface::Local<D>::Zero();
  for (int a = 0; a < point.count; ++a)
    sum += point.H.template block<D, D>(0, D * a) * v.segment<D>(D * point.nodes[ix(a)]);
  contact::Vec3 all = contact::Vec3::Zero();
  all.head<D>() = sum;
  return all;
}

/// The rates of gap and slip in the state `next`, for the step that follows; an obstacle on a path carries
/// its counterpart with it.
template<int D>
void set_rates(Pair const& pair, Model const& model, contact::PointKinematics<D> const& point,
               State const& next, ContactState& after) {
  after.rate = rate_of(point, next.v);
  if (next.a.size() > 0)
    after.second = rate_of(point, next.a);
  auto const* side = std::get_if<RigidSide>(&pair.primary);
  if (side == nullptr || model.rigids[side->body].free())
    return;
  for (int a = 0; a < point.count; ++a) {
    Index const node = point.nodes[ix(a)];
    contact::Vec3 x = contact::Vec3::Zero();
    for (int c = 0; c < D; ++c)
      x[c] = model.reference(node, c) + next.u[D * node + c];
    contact::Vec3 const carried = model.rigids[side->body].velocity(x, next.t);
    after.rate.head<D>() -= point.H.template block<D, D>(0, D * a) * carried.head<D>();
  }
}

} // namespace stiction::dynamics
