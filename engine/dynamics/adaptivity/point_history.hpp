// The error of bonds over a step, from its neighbours, and the events that the step holds.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "dynamics/model/model.hpp"
#include "dynamics/model/state.hpp"

namespace stiction::dynamics {

/// The local error of one step.
struct StepError {
  double displacement =
      0; ///< root mean square over the mass, over the largest u that motions ask for or that has been
  double bond = 0;        ///< largest of any beta
  double beta_change = 0; ///< largest of any beta
  int events = 0;         ///< points that touch or separate, betas that reach or leave 1 or reach 0
  [[nodiscard]] double largest() const { return std::max(displacement, bond); }
};

/// What happens to a contact point at one moment.
enum class EventKind { touch, separation, bond_full, bond_yields, bond_gone };
inline constexpr std::array<EventKind, 5> event_kinds = {EventKind::touch, EventKind::separation,
                                                         EventKind::bond_full, EventKind::bond_yields,
                                                         EventKind::bond_gone};
[[nodiscard]] char const* name_of(EventKind kind);
struct Event {
  EventKind kind = EventKind::touch;
  std::size_t pair = 0, point = 0;
  double after = 0; ///< s from the start of the step, as the rates before it say
};

/// How an event is told from the states around it, and the quantity that reaches 0 with it.
struct EventSign {
  bool (*happened)(ContactState const& old, ContactState const& next);
  bool (*possible)(ContactState const& old);
  double (*distance)(ContactState const& point);
};
[[nodiscard]] EventSign const& sign_of(EventKind kind);

/// Compares the contact points of a step with those of the step before.
///
/// beta: implicit Euler against the trapezoidal rule, dt/2 |beta'_1 - beta'_0|, where the rate of implicit
/// Euler is the change of the step over dt. A bond that ends at 0 or 1 is exact. The rate before the step is
/// not compared with across an event that was located at its start, but for the yield of a bond that takes
/// time, whose rate begins at 0.
///
/// Points says where a State keeps them: pairs(state), size(state, pair), at(state, pair, point),
/// keep(state), which is Kept and answers at() as well, beta(state, pair, point), which is what at() has,
/// adhesion(pair), set_beta(state, pair, point, beta), audited().
template<class Points> class PointHistory {
public:
  using State = typename Points::State;
  explicit PointHistory(Points points) : points_(points) {}

  [[nodiscard]] StepError error(State const& old, State const& next) const;
  /// Takes the local error of beta out of an accepted step, where a law integrates it: the pair advances with
  /// its trapezoidal member, damped by (beta_1 / beta_0)^2 so that a fast loss never turns about; global
  /// errors become of second order. Tractions of the step stay those of implicit Euler; the ledger follows
  /// beta.
  void advance_bonds(State const& old, State& next) const;
  /// The events between the states that lie farther than `within` from both ends, or in a step longer than
  /// it.
  [[nodiscard]] std::optional<Event> unlocated(State const& old, State const& next, double within) const;
  /// The first event after `old` to be expected by the rates of the last step, if any is. Wants accept() with
  /// `within` above 0.
  [[nodiscard]] std::optional<Event> next_event(State const& old) const;
  /// `next` follows; steps no longer than `within` may hold events.
  void accept(State const& old, State const& next, double within);
  /// Hands over all that steps change, to be written or read.
  template<class Archive> void visit(Archive& archive) { archive(dt_, before_, rates_, fresh_); }

protected:
  [[nodiscard]] double last() const { return dt_; } ///< size of the step before, s; 0: there was none

private:
  /// dt (beta'_1 - beta'_0) / 2 of implicit Euler; 0 where it is exact or the rate before is not known.
  [[nodiscard]] double bond_error(State const& old, State const& next, std::size_t pair,
                                  std::size_t point) const;
  struct BondChange {
    double from, to, dt; ///< beta at the step's start, and what it becomes at its end; s
  };
  void move_bond(State& next, std::size_t pair, std::size_t point, BondChange change) const;
  [[nodiscard]] double after(EventKind kind, State const& old, std::size_t pair, std::size_t point) const;

  /// Visits every contact point as (pair, point).
  template<class Visit> void each_point(State const& state, Visit&& visit) const {
    for (std::size_t p = 0; p < points_.pairs(state); ++p)
      for (std::size_t i = 0; i < points_.size(state, p); ++i)
        visit(p, i);
  }

  static constexpr double never = std::numeric_limits<double>::infinity();

  Points points_;
  double dt_ = 0;                          ///< of the step before, s; 0: there was none
  typename Points::Kept before_;           ///< points at its start; kept where events are located
  std::vector<std::vector<double>> rates_; ///< [pairs][points] beta' of implicit Euler at its end, 1/s
  std::vector<std::vector<bool>>
      fresh_; ///< [pairs][points] has the located event of a point just ended its rate?
};

template<class Points>
double PointHistory<Points>::bond_error(State const& old, State const& next, std::size_t p,
                                        std::size_t i) const {
  double const dt = next.t - old.t, beta = points_.beta(next, p, i);
  if (dt_ == 0 || beta <= 0 || beta >= 1 || fresh_[p][i])
    return 0;
  return 0.5 * (beta - points_.beta(old, p, i) - rates_[p][i] * dt);
}

template<class Points> StepError PointHistory<Points>::error(State const& old, State const& next) const {
  StepError error;
  each_point(next, [&](std::size_t p, std::size_t i) {
    auto const& from = points_.at(old, p, i);
    auto const& to = points_.at(next, p, i);
    error.beta_change = std::max(error.beta_change, std::abs(to.bond.beta - from.bond.beta));
    error.bond = std::max(error.bond, std::abs(bond_error(old, next, p, i)));
    error.events += static_cast<int>(
        std::ranges::count_if(event_kinds, [&](EventKind kind) { return sign_of(kind).happened(from, to); }));
  });
  return error;
}

template<class Points> void PointHistory<Points>::advance_bonds(State const& old, State& next) const {
  each_point(next, [&](std::size_t p, std::size_t i) {
    auto const& law = points_.adhesion(p);
    if (!law || interface::bond_time(*law) == 0)
      return;
    double const error = bond_error(old, next, p, i), before = points_.beta(old, p, i),
                 beta = points_.beta(next, p, i), share = before > 0 ? std::min(1.0, beta / before) : 1,
                 better = std::clamp(beta - share * share * error, 0.0, std::max(before, beta));
    if (better != beta)
      move_bond(next, p, i, {before, better, next.t - old.t});
  });
}

template<class Points>
void PointHistory<Points>::move_bond(State& next, std::size_t p, std::size_t i, BondChange change) const {
  auto const& law = *points_.adhesion(p);
  ContactState const point = points_.at(next, p, i);
  interface::BondMove move {
    {}, interface::opening_of(point.bond, point.gap), change.from, point.bond.beta, change.dt
  };
  double const dissipated = interface::dissipation(law, move),
               stored = interface::bond_energy(law, point.bond, point.gap);
  interface::Bond moved = point.bond;
  moved.beta = move.beta_to = change.to;
  double const more = point.area * (interface::bond_energy(law, moved, point.gap) - stored),
               loss = point.area * (interface::dissipation(law, move) - dissipated);
  points_.set_beta(next, p, i, change.to);
  next.ledger.bond += more;
  next.ledger.bonding_loss += loss;
  if (points_.audited())
    next.ledger.predicted.contact -= more + loss;
}

/// Where the distance falls by the rate of the step before; half the size of the last step where it does not.
template<class Points>
double PointHistory<Points>::after(EventKind kind, State const& old, std::size_t p, std::size_t i) const {
  auto const& sign = sign_of(kind);
  auto const& point = points_.at(old, p, i);
  if (dt_ == 0 || !sign.possible(point) || !sign.possible(points_.at(before_, p, i)))
    return never;
  double now = sign.distance(point);
  double const fall = sign.distance(points_.at(before_, p, i)) - now;
  if (kind == EventKind::bond_yields)
    now += interface::scales(*points_.adhesion(p)).work;
  return fall > 0 ? std::max(now, 0.0) * dt_ / fall : never;
}

template<class Points>
std::optional<Event> PointHistory<Points>::unlocated(State const& old, State const& next,
                                                     double within) const {
  double const dt = next.t - old.t;
  std::optional<Event> first;
  if (dt <= within)
    return first;
  each_point(next, [&](std::size_t p, std::size_t i) {
    for (auto const kind : event_kinds) {
      if (!sign_of(kind).happened(points_.at(old, p, i), points_.at(next, p, i)))
        continue;
      double const expected = after(kind, old, p, i), at = expected < dt ? expected : 0.5 * dt;
      if (at > within && at < dt - within && (!first || at < first->after))
        first = Event{kind, p, i, at};
    }
  });
  return first;
}

template<class Points> std::optional<Event> PointHistory<Points>::next_event(State const& old) const {
  std::optional<Event> first;
  each_point(old, [&](std::size_t p, std::size_t i) {
    for (auto const kind : event_kinds)
      if (double const at = after(kind, old, p, i); at < (first ? first->after : never))
        first = Event{kind, p, i, at};
  });
  return first;
}

template<class Points> void PointHistory<Points>::accept(State const& old, State const& next, double within) {
  dt_ = next.t - old.t;
  fresh_.resize(points_.pairs(next));
  rates_.resize(points_.pairs(next));
  for (std::size_t p = 0; p < points_.pairs(next); ++p) {
    fresh_[p].assign(points_.size(next, p), false);
    rates_[p].resize(points_.size(next, p));
    for (std::size_t i = 0; i < points_.size(next, p); ++i)
      rates_[p][i] = (points_.beta(next, p, i) - points_.beta(old, p, i)) / dt_;
  }
  if (within == 0)
    return;
  before_ = points_.keep(old);
  // a rate that ends or begins at this very moment is not to be compared with the next
  each_point(next, [&](std::size_t p, std::size_t i) {
    bool const viscous = points_.adhesion(p) && interface::bond_time(*points_.adhesion(p)) > 0;
    for (auto const kind : event_kinds)
      if (!(viscous && kind == EventKind::bond_yields) && // which begins at rate 0
          (sign_of(kind).happened(points_.at(old, p, i), points_.at(next, p, i)) ||
           after(kind, next, p, i) <= within))
        fresh_[p][i] = true;
  });
}

} // namespace stiction::dynamics
