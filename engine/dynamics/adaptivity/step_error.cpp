// The error of a step from its neighbours, and the events that it holds.
#include "dynamics/adaptivity/step_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace stiction::dynamics {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

bool closed(ContactState const& point) {
  return point.status != interface::Status::open;
}

/// How an event of this kind is told from the states around it, and the quantity that reaches 0 with it.
struct EventSign {
  bool (*happened)(ContactState const& old, ContactState const& next);
  bool (*possible)(ContactState const& old);
  double (*distance)(ContactState const& point);
};

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

EventSign const& sign_of(EventKind kind) {
  return signs[static_cast<std::size_t>(kind)];
}

constexpr std::array<EventKind, 5> kinds = {EventKind::touch, EventKind::separation, EventKind::bond_full,
                                            EventKind::bond_yields, EventKind::bond_gone};

/// Visits every contact point as (pair, point).
template<class Visit> void each_point(State const& state, Visit&& visit) {
  for (std::size_t p = 0; p < state.contacts.size(); ++p)
    for (std::size_t i = 0; i < state.contacts[p].size(); ++i)
      visit(p, i);
}

} // namespace

char const* name_of(EventKind kind) {
  constexpr std::array<char const*, 5> names = {"touches", "separates", "is fully bonded",
                                                "begins to lose its bond", "has lost its bond"};
  return names[static_cast<std::size_t>(kind)];
}

/// Where everything moves with the farthest motion.
History::History(BulkSystem const& bulk, Model const& model) : bulk_(&bulk), model_(&model) {
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

double History::bond_error(State const& old, State const& next, std::size_t p, std::size_t i) const {
  double const dt = next.t - old.t, beta = next.contacts[p][i].bond.beta;
  if (dt_ == 0 || beta <= 0 || beta >= 1 || fresh_[p][i])
    return 0;
  return 0.5 * (beta - old.contacts[p][i].bond.beta - rates_[p][i] * dt);
}

StepError History::error(State const& old, State const& next) const {
  StepError error;
  error.displacement = displacement_error(old, next);
  each_point(next, [&](std::size_t p, std::size_t i) {
    double const change = next.contacts[p][i].bond.beta - old.contacts[p][i].bond.beta;
    error.beta_change = std::max(error.beta_change, std::abs(change));
    error.bond = std::max(error.bond, std::abs(bond_error(old, next, p, i)));
    error.events += static_cast<int>(std::ranges::count_if(signs, [&](EventSign const& sign) {
      return sign.happened(old.contacts[p][i], next.contacts[p][i]);
    }));
  });
  return error;
}

void History::advance_bonds(State const& old, State& next) const {
  each_point(next, [&](std::size_t p, std::size_t i) {
    auto const& adhesion = model_->pairs[p].law.adhesion;
    if (!adhesion || interface::bond_time(*adhesion) == 0)
      return;
    auto& after = next.contacts[p][i];
    double const error = bond_error(old, next, p, i), before = old.contacts[p][i].bond.beta,
                 beta = after.bond.beta, share = before > 0 ? std::min(1.0, beta / before) : 1,
                 better = std::clamp(beta - share * share * error, 0.0, std::max(before, beta));
    if (better != beta)
      move_bond(*adhesion, {before, better, next.t - old.t}, after, next.ledger);
  });
}

void History::move_bond(interface::AdhesionLaw const& law, BondChange change, ContactState& point,
                        Ledger& ledger) const {
  interface::BondMove move {
    {}, interface::opening_of(point.bond, point.gap), change.from, point.bond.beta, change.dt
  };
  double const dissipated = interface::dissipation(law, move),
               stored = interface::bond_energy(law, point.bond, point.gap);
  point.bond.beta = move.beta_to = change.to;
  double const more = point.area * (interface::bond_energy(law, point.bond, point.gap) - stored),
               loss = point.area * (interface::dissipation(law, move) - dissipated);
  ledger.bond += more;
  ledger.bonding_loss += loss;
  if (model_->audited)
    ledger.predicted.contact -= more + loss;
}

double History::displacement_error(State const& old, State const& next) const {
  if (!weights(model_->scheme).inertia || dt_ == 0)
    return 0;
  double const dt = next.t - old.t;
  Vector e = next.u - old.u - 0.5 * dt * (old.v + next.v);
  e += dt * dt * dt / (6 * (dt + dt_)) * ((next.v - old.v) / dt - (old.v - v_) / dt_);
  for (Index dof = 0; dof < e.size(); ++dof)
    if (bulk_->unknown_of(dof) < 0)
      e[dof] = 0;
  double const scale = std::max(scale_, mean_square(next.u));
  return scale > 0 ? std::sqrt(mean_square(e) / scale) : 0;
}

/// Where the distance falls by the rate of the step before; half the size of the last step where it does not.
double History::after(EventKind kind, State const& old, std::size_t p, std::size_t i) const {
  auto const& point = old.contacts[p][i];
  if (dt_ == 0 || !sign_of(kind).possible(point) || !sign_of(kind).possible(contacts_[p][i]))
    return never;
  double now = sign_of(kind).distance(point);
  double const fall = sign_of(kind).distance(contacts_[p][i]) - now;
  if (kind == EventKind::bond_yields)
    now += interface::scales(*model_->pairs[p].law.adhesion).work;
  return fall > 0 ? std::max(now, 0.0) * dt_ / fall : never;
}

std::optional<Event> History::unlocated(State const& old, State const& next, double within) const {
  double const dt = next.t - old.t;
  std::optional<Event> first;
  if (dt <= within)
    return first;
  each_point(next, [&](std::size_t p, std::size_t i) {
    for (auto const kind : kinds) {
      if (!sign_of(kind).happened(old.contacts[p][i], next.contacts[p][i]))
        continue;
      double const expected = after(kind, old, p, i), at = expected < dt ? expected : 0.5 * dt;
      if (at > within && at < dt - within && (!first || at < first->after))
        first = Event{kind, p, i, at};
    }
  });
  return first;
}

std::optional<Event> History::next_event(State const& old) const {
  std::optional<Event> first;
  each_point(old, [&](std::size_t p, std::size_t i) {
    for (auto const kind : kinds)
      if (double const at = after(kind, old, p, i); at < (first ? first->after : never))
        first = Event{kind, p, i, at};
  });
  return first;
}

void History::accept(State const& old, State const& next, double within) {
  dt_ = next.t - old.t;
  fresh_.resize(next.contacts.size());
  rates_.resize(next.contacts.size());
  for (std::size_t p = 0; p < next.contacts.size(); ++p) {
    fresh_[p].assign(next.contacts[p].size(), false);
    rates_[p].resize(next.contacts[p].size());
    for (std::size_t i = 0; i < next.contacts[p].size(); ++i)
      rates_[p][i] = (next.contacts[p][i].bond.beta - old.contacts[p][i].bond.beta) / dt_;
  }
  v_ = old.v;
  contacts_ = old.contacts;
  if (weights(model_->scheme).inertia)
    scale_ = std::max(scale_, mean_square(next.u));
  if (within == 0)
    return;
  // a rate that ends or begins at this very moment is not to be compared with the next
  each_point(next, [&](std::size_t p, std::size_t i) {
    for (auto const kind : kinds)
      if (sign_of(kind).happened(old.contacts[p][i], next.contacts[p][i]) ||
          after(kind, next, p, i) <= within)
        fresh_[p][i] = true;
  });
}

} // namespace stiction::dynamics
