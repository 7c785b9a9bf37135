// What a step is off by: an estimate that needs no other solve.
#pragma once
#include <algorithm>
#include <optional>

#include "dynamics/bulk/bulk_system.hpp"
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
[[nodiscard]] char const* name_of(EventKind kind);
struct Event {
  EventKind kind = EventKind::touch;
  std::size_t pair = 0, point = 0;
  double after = 0; ///< s from the start of the step, as the rates before it say
};

/// Compares steps with the steps before them.
///
/// u: the step's increment against the integral of the parabola through the velocities at its ends and at the
/// start of the step before. Of whatever scheme, this is the local error of u: of the trapezoidal rule
/// -dt^3 v''/12, of backward Euler dt^2 v'/2. Without inertia u integrates nothing and has no error of its
/// own.
///
/// beta: implicit Euler against the trapezoidal rule, dt/2 |beta'_1 - beta'_0|, where the rate of implicit
/// Euler is the change of the step over dt. A bond that ends at 0 or 1 is exact. The rate before the step is
/// not compared with across an event that was located at its start.
class History {
public:
  History(BulkSystem const& bulk, Model const& model);

  [[nodiscard]] StepError error(State const& old, State const& next) const;
  /// Takes the local error of beta out of an accepted step, where a law integrates it: the pair advances with
  /// its trapezoidal member, damped by (beta_1 / beta_0)^2 so that a fast loss never turns about; global
  /// errors become of second order. Tractions of the step stay those of implicit Euler; the ledger follows
  /// beta.
  void advance_bonds(State const& old, State& next) const;
  /// The events between the states that lie farther than `within` from both ends, or in a step longer than
  /// it.
  [[nodiscard]] std::optional<Event> unlocated(State const& old, State const& next, double within) const;
  /// The first event after `old` to be expected by the rates of the last step, if any is.
  [[nodiscard]] std::optional<Event> next_event(State const& old) const;
  /// `next` follows; steps no longer than `within` may hold events.
  void accept(State const& old, State const& next, double within);
  /// Hands over all that steps change, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    auto& [bulk, model, dt, v, contacts, rates, fresh, scale] = *this;
    archive(dt, v, contacts, rates, fresh, scale);
  }

private:
  [[nodiscard]] double displacement_error(State const& old, State const& next) const;
  [[nodiscard]] double mean_square(Vector const& u) const;
  /// dt (beta'_1 - beta'_0) / 2 of implicit Euler; 0 where it is exact or the rate before is not known.
  [[nodiscard]] double bond_error(State const& old, State const& next, std::size_t pair,
                                  std::size_t point) const;
  struct BondChange {
    double from, to, dt; ///< beta at the step's start, and what it becomes at its end; s
  };
  void move_bond(interface::AdhesionLaw const& law, BondChange change, ContactState& point,
                 Ledger& ledger) const;
  [[nodiscard]] double after(EventKind kind, State const& old, std::size_t pair, std::size_t point) const;

  BulkSystem const* bulk_;
  Model const* model_;
  double dt_ = 0;                                   ///< of the step before, s; 0: there was none
  Vector v_;                                        ///< at its start, m/s
  std::vector<std::vector<ContactState>> contacts_; ///< at its start
  std::vector<std::vector<double>> rates_; ///< [pairs][points] beta' of implicit Euler at its end, 1/s
  std::vector<std::vector<bool>>
      fresh_;        ///< [pairs][points] has the located event of a point just ended its rate?
  double scale_ = 0; ///< largest mean square of u so far, or of what motions ask for, kg m^2
};

} // namespace stiction::dynamics
