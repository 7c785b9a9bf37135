// The error of a step of bodies, and the signs of what happens to contact points.
#include "dynamics/adaptivity/step_error.hpp"

namespace stiction::dynamics {

template class PointHistory<BodyPoints>;

namespace {

bool closed(ContactState const& point) {
  return point.status != interface::Status::open;
}

constexpr std::array<EventSign, 5> signs = {{
    {[](ContactState const& a, ContactState const& b) { return !closed(a) && closed(b); },
     [](ContactState const& a) { return !closed(a) && a.in_reach; },
     [](ContactState const& a) { return a.gap; }},
    {[](ContactState const& a, ContactState const& b) { return closed(a) && !closed(b); },
     [](ContactState const& a) { return closed(a); }, [](ContactState const& a) { return a.dry[0]; }},
    {[](ContactState const& a, ContactState const& b) { return a.bond.beta < 1 && b.bond.beta >= 1; },
     [](ContactState const& a) { return a.bond.beta < 1; },
     [](ContactState const& a) { return 1 - a.bond.beta; }},
    {[](ContactState const& a, ContactState const& b) { return a.bond.beta >= 1 && b.bond.beta < 1; },
     [](ContactState const& a) { return a.bond.beta >= 1; },
     [](ContactState const& a) { // of RCC: w - q; other laws may yield elsewhere
       return a.adhesion.dot(interface::opening_of(a.bond, a.gap));
     }},
    {[](ContactState const& a, ContactState const& b) { return a.bond.beta > 0 && b.bond.beta <= 0; },
     [](ContactState const& a) { return a.bond.beta > 0; },
     [](ContactState const& a) { return a.bond.beta; }},
}};

} // namespace

EventSign const& sign_of(EventKind kind) {
  return signs[static_cast<std::size_t>(kind)];
}

char const* name_of(EventKind kind) {
  constexpr std::array<char const*, 5> names = {"touches", "separates", "is fully bonded",
                                                "begins to lose its bond", "has lost its bond"};
  return names[static_cast<std::size_t>(kind)];
}

/// Where everything moves with the farthest motion.
History::History(BulkSystem const& bulk, Model const& model)
    : PointHistory(BodyPoints{&model}), bulk_(&bulk), model_(&model) {
  if (!weights(model.scheme).inertia)
    return;
  double farthest = 0;
  for (auto const& motion : model.motions)
    if (motion.nodes.empty() || motion.nodes.front() < model.first_node.back())
      farthest = std::max(farthest, motion.farthest());
  for (auto const& rigid : model.rigids)
    for (auto const& path : rigid.shift)
      farthest = std::max(farthest, path.farthest());
  for (auto const& spring : model.springs)
    for (auto const& path : spring.to.shift)
      farthest = std::max(farthest, path.farthest());
  Vector u = Vector::Zero(model.dofs());
  for (Index node = 0; node < model.first_node.back(); ++node)
    u[model.dim() * node] = farthest;
  scale_ = mean_square(u);
}

double History::mean_square(Vector const& u) const {
  Vector momentum;
  bulk_->mass().times(u, momentum);
  return u.dot(momentum);
}

StepError History::error(State const& old, State const& next) const {
  StepError error = PointHistory::error(old, next);
  error.displacement = displacement_error(old, next);
  return error;
}

double History::displacement_error(State const& old, State const& next) const {
  if (!weights(model_->scheme).inertia || last() == 0)
    return 0;
  double const dt = next.t - old.t;
  Vector e = next.u - old.u - 0.5 * dt * (old.v + next.v);
  e += dt * dt * dt / (6 * (dt + last())) * ((next.v - old.v) / dt - (old.v - v_) / last());
  for (Index dof = 0; dof < e.size(); ++dof)
    if (bulk_->unknown_of(dof) < 0)
      e[dof] = 0;
  double const scale = std::max(scale_, mean_square(next.u));
  return scale > 0 ? std::sqrt(mean_square(e) / scale) : 0;
}

void History::accept(State const& old, State const& next, double within) {
  PointHistory::accept(old, next, within);
  v_ = old.v;
  if (weights(model_->scheme).inertia)
    scale_ = std::max(scale_, mean_square(next.u));
}

} // namespace stiction::dynamics
