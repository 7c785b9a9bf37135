// How long the next step is: the controller of a run whose steps follow from their error.
#pragma once
#include <limits>
#include <string>
#include <utility>

#include "dynamics/adaptivity/accuracy.hpp"
#include "dynamics/adaptivity/step_error.hpp"

namespace stiction::dynamics {

/// Why a step is taken again with a smaller size.
enum class Cut { none, not_converged, error, beta_change, event };
[[nodiscard]] char const* name_of(Cut cut);

/// What became of an attempt.
struct Decision {
  Cut cut = Cut::none;   ///< none: accepted
  bool failed = false;   ///< cut, but no smaller step is allowed
  bool at_floor = false; ///< accepted only because no smaller step is allowed
  bool grown = false;    ///< the next step is to be longer
  std::string reason;    ///< in words; empty for a plain acceptance
  StepError error;
  [[nodiscard]] bool accepted() const { return cut == Cut::none; }
};

/// Control of the step by its error, bounds on beta's change, and aim at events.
///
/// With inertia every step size wants a factor of its own. Sizes are then rungs, the stage's step times a
/// power of two, and the stage's moments are met by rungs: a size comes back, and its kept factor serves.
class StepSizes {
public:
  enum class Kind { any, rungs };
  /// decides: has anything an error, or an event to be located?
  StepSizes(Accuracy const& accuracy, Kind kind, bool decides)
      : accuracy_(accuracy), decides_(decides), rungs_(kind == Kind::rungs) {}

  /// A stage begins whose own step is `nominal` and may be halved so often.
  void begin(double nominal, int halvings);
  /// Does a step of that size end at the moment?
  [[nodiscard]] bool arrives(double dt, double left) const;
  /// The event that the last size asked for aims at; empty if none.
  [[nodiscard]] std::string const& aim() const { return aim_; }
  /// Of an attempt of that size that has no answer.
  [[nodiscard]] Decision failed(std::string reason, double dt);
  [[nodiscard]] bool decides() const { return decides_; }
  [[nodiscard]] double wanted() const { return wanted_; } ///< size without aim at moments or events, s
  /// Hands over all that stages and steps change, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    archive(wanted_, smallest_, largest_, base_, once_, retry_, patience_, aim_);
  }

protected:
  [[nodiscard]] double next(std::optional<Event> const& expected, double left);
  [[nodiscard]] Decision judge(StepError const& error, std::optional<Event> const& unlocated, double dt);
  [[nodiscard]] bool aims() const { return accuracy_.events > 0 && !retry_; }
  [[nodiscard]] double within() const { return accuracy_.events; } ///< s; 0: events are not located

private:
  void look_for_cut(std::optional<Event> const& unlocated, double dt, Decision& decision);
  void shorten(double dt, double factor);
  void grow(Decision& decision, double dt);
  [[nodiscard]] bool at_smallest(double dt) const;
  [[nodiscard]] double rung(double dt) const;
  [[nodiscard]] double slack() const;
  [[nodiscard]] std::string told(StepError const& error) const;

  Accuracy accuracy_;
  bool decides_;
  bool rungs_;                                            ///< are sizes held to rungs?
  double wanted_ = 0, smallest_ = 0, largest_ = 0;        ///< s
  double base_ = 0;                                       ///< a stage's step, s
  double once_ = std::numeric_limits<double>::infinity(); ///< bound of this step alone, s
  bool retry_ = false;                                    ///< the last attempt was cut
  int patience_ = 0;                                      ///< steps to go before a longer one is tried again
  std::string aim_;
};

/// Step sizes of states whose errors and events a history tells.
template<class History> class Pace : public StepSizes {
public:
  using State = typename History::State;
  Pace(History history, StepSizes sizes) : StepSizes(std::move(sizes)), history_(std::move(history)) {}

  /// The size of the next attempt from `old`, when `left` remains to a moment that must be met. s
  [[nodiscard]] double next(State const& old, double left) {
    return StepSizes::next(aims() ? history_.next_event(old) : std::nullopt, left);
  }
  /// Judges a converged attempt of that size; an accepted one becomes part of the history, and its bonds are
  /// advanced.
  [[nodiscard]] Decision decide(State const& old, State& next, double dt) {
    auto decision = judge(history_.error(old, next),
                          within() > 0 ? history_.unlocated(old, next, within()) : std::nullopt, dt);
    if (!decision.accepted())
      return decision;
    State advanced = next;
    history_.advance_bonds(old, advanced);
    history_.accept(old, next, within());
    next = std::move(advanced);
    return decision;
  }
  /// Hands over all that stages and steps change, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    archive(history_);
    StepSizes::visit(archive);
  }

private:
  History history_;
};

/// Of bodies.
[[nodiscard]] Pace<History> pace_of(Accuracy const& accuracy, BulkSystem const& bulk, Model const& model);

} // namespace stiction::dynamics
