// How long the next step is: the controller of a run whose steps follow from their error.
#pragma once
#include <limits>

#include "dynamics/accuracy.hpp"
#include "dynamics/step_error.hpp"
#include "dynamics/stepper.hpp"

namespace stiction::dynamics {

/// Why a step is taken again with a smaller size.
enum class Cut { none, not_converged, error, beta_change, event };
[[nodiscard]] char const* name_of(Cut cut);

/// What became of an attempt.
struct Judgement {
  Cut cut = Cut::none;   ///< none: accepted
  bool failed = false;   ///< cut, but no smaller step is allowed
  bool at_floor = false; ///< accepted only because no smaller step is allowed
  bool grown = false;    ///< the next step is to be longer
  std::string reason;    ///< empty for a plain acceptance
  StepError error;
  [[nodiscard]] bool accepted() const { return cut == Cut::none; }
};

/// Control of the step by its error, bounds on beta's change, and aim at events.
class Pace {
public:
  Pace(Accuracy const& accuracy, Structure const& structure, Model const& model);

  /// A stage begins whose own step is `nominal` and may be halved so often.
  void begin(double nominal, int halvings);
  /// The size of the next attempt from `old`, when `left` remains to a moment that must be met; equal to
  /// `left` for the last. s
  [[nodiscard]] double next(State const& old, double left) const;
  /// Judges an attempt of that size; an accepted one becomes part of the history, and its bonds are advanced.
  [[nodiscard]] Judgement judge(State const& old, Outcome& outcome, double dt);
  [[nodiscard]] double wanted() const { return wanted_; } ///< size without aim at moments or events, s

private:
  void look_for_cut(State const& old, State const& next, Judgement& judgement);
  void shorten(double dt, double factor);
  void grow(Judgement& judgement, double dt);
  [[nodiscard]] bool at_smallest(double dt) const;

  Accuracy accuracy_;
  History history_;
  double wanted_ = 0, smallest_ = 0, largest_ = 0;        ///< s
  double once_ = std::numeric_limits<double>::infinity(); ///< bound of this step alone, s
  bool retry_ = false;                                    ///< the last attempt was cut
};

} // namespace stiction::dynamics
