// Momenta after a step, and the impulses that changed them.
#include "dynamics/model/spin.hpp"
#include "dynamics/step/stepper.hpp"

namespace stiction::dynamics {

/// Momentum of every body; explicit schemes keep half an impulse in v that belongs to the next step.
void Stepper::set_momenta(State& state) const {
  Vector const v = state.kick.size() > 0 ? Vector(state.v - state.kick) : state.v;
  Vector momentum;
  bulk_.mass().times(v, momentum);
  for (std::size_t r = 0; r < model_->rigids.size(); ++r)
    if (auto const& rigid = model_->rigids[r]; tensorial(rigid))
      momentum.segment<3>(rigid.turn()) = inertia_in_space(*model_, r, state) * v.segment<3>(rigid.turn());
  auto& bodies = state.momenta.bodies;
  bodies.clear();
  for (std::size_t b = 0; b + 1 < model_->first_node.size(); ++b)
    bodies.push_back(resultant(*model_, state.u, momentum, model_->first_node[b], model_->first_node[b + 1]));
  for (auto const& rigid : model_->rigids)
    bodies.push_back(rigid.free() ? resultant(*model_, state.u, momentum, rigid.node, rigid.node + 2)
                                  : Screw{});
}

namespace {

/// Is the primary side a free rigid body? It has nothing inside that hands the mean of R on.
bool alone(Model const& model, Pair const& pair) {
  auto const* side = std::get_if<RigidSide>(&pair.primary);
  return side != nullptr && model.rigids[side->body].free();
}

} // namespace

/// Adds the step's impulses to those of old, by the force averages of the scheme.
void Stepper::tally(State const& old, State& next) const {
  auto& all = next.momenta;
  all = old.momenta;
  double const dt = next.t - old.t, chi = weights_.contact_work, omega = weights_.work;
  Index const nodes = model_->node_count();
  set_momenta(next);
  Vector const half_way = 0.5 * (old.u + next.u);
  all.loads += dt * resultant(*model_, half_way, (1 - omega) * external_old_ + omega * external_, 0, nodes);
  all.motions += dt * resultant(*model_, half_way, mean_drive_, 0, nodes);
  if (!bulk_.springs().empty()) {
    Vector first = Vector::Zero(next.u.size()), last = first;
    bulk_.springs().add_force(old.u, old.t, first);
    bulk_.springs().add_damping({old.u, old.v, old.t}, first);
    bulk_.springs().add_force(next.u, next.t, last);
    bulk_.springs().add_damping({next.u, next.v, next.t}, last);
    all.springs += -dt * resultant(*model_, half_way, (1 - omega) * first + omega * last, 0, nodes);
  }
  Vector force;
  for (std::size_t p = 0; p < model_->pairs.size(); ++p) {
    contact_->reaction(force, static_cast<int>(p));
    auto const& pair = model_->pairs[p];
    auto const now = resultants(*model_, pair, next.u, force);
    double const own = alone(*model_, pair) && weights_.surface_apart() ? 1 : chi;
    auto& sum = all.pairs[p];
    sum.secondary += dt * ((1 - chi) * all.forces[p].secondary);
    sum.secondary += dt * (chi * now.secondary);
    sum.primary += dt * ((1 - own) * all.forces[p].primary);
    sum.primary += dt * (own * now.primary);
    all.forces[p] = now;
  }
}

} // namespace stiction::dynamics
