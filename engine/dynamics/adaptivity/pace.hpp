// How long the next step is: the controller of a run whose steps follow from their error.
#pragma once
#include <limits>

#include "dynamics/adaptivity/accuracy.hpp"
#include "dynamics/adaptivity/step_error.hpp"
#include "dynamics/step/stepper.hpp"

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
class Pace {
public:
  Pace(Accuracy const& accuracy, BulkSystem const& bulk, Model const& model);

  /// A stage begins whose own step is `nominal` and may be halved so often.
  void begin(double nominal, int halvings);
  /// The size of the next attempt from `old`, when `left` remains to a moment that must be met. s
  [[nodiscard]] double next(State const& old, double left);
  /// Does a step of that size end at the moment?
  [[nodiscard]] bool arrives(double dt, double left) const;
  /// The event that the last size asked for aims at; empty if none.
  [[nodiscard]] std::string const& aim() const { return aim_; }
  /// Judges an attempt of that size; an accepted one becomes part of the history, and its bonds are advanced.
  [[nodiscard]] Decision decide(State const& old, Outcome& outcome, double dt);
  /// Has anything an error, or an event to be located?
  [[nodiscard]] bool decides() const { return decides_; }
  [[nodiscard]] double wanted() const { return wanted_; } ///< size without aim at moments or events, s
  /// Hands over all that stages and steps change, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    auto& [accuracy, history, decides, rungs, wanted, smallest, largest, base, once, retry, patience, aim] =
        *this;
    archive(history, wanted, smallest, largest, base, once, retry, patience, aim);
  }

private:
  void look_for_cut(State const& old, State const& next, Decision& decision);
  void shorten(double dt, double factor);
  void grow(Decision& decision, double dt);
  [[nodiscard]] bool at_smallest(double dt) const;
  [[nodiscard]] double rung(double dt) const;
  [[nodiscard]] double slack() const;
  [[nodiscard]] std::string told(StepError const& error) const;

  Accuracy accuracy_;
  History history_;
  bool decides_ = false;
  bool rungs_;                                            ///< are sizes held to rungs?
  double wanted_ = 0, smallest_ = 0, largest_ = 0;        ///< s
  double base_ = 0;                                       ///< a stage's step, s
  double once_ = std::numeric_limits<double>::infinity(); ///< bound of this step alone, s
  bool retry_ = false;                                    ///< the last attempt was cut
  int patience_ = 0;                                      ///< steps to go before a longer one is tried again
  std::string aim_;
};

} // namespace stiction::dynamics
