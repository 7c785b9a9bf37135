// The course of a run over its schedule: equal steps, in halves where they fail, or steps that follow from
// their error.
#pragma once
#include <optional>
#include <utility>

#include "scene/description/parts.hpp"
#include "scene/run/changes.hpp"
#include "scene/run/halves.hpp"
#include "scene/run/patience.hpp"

namespace stiction::scene {

/// Where a run stands in its schedule, and what step comes next. Pace: dynamics::Pace of the run's states.
///
/// A Run befriends it and has state_ (with a time t), patience_, and
/// goes_on(): before an attempt, whether it is to be made; stopped(): whether the run was told to end;
/// attempt(dt): an outcome {state, reason}, perhaps with a leap, for which it is wanted shorter;
/// answered(outcome): whether it has an answer; accept(outcome, dt, error); change(record::StepChange);
/// unanswered(outcome, dt): an attempt that will be made in halves; give_up(outcome, dt, which limit was
/// passed), false; frame(): writes fields; stage_ended().
template<class Pace> class Course {
public:
  /// frames: of fields, in each stage.
  Course(SchedulePart const& schedule, int frames)
      : schedule_(&schedule), frames_(frames), halves_(schedule.halvings) {}
  /// Steps are to follow from their error.
  void choose(Pace pace) { pace_.emplace(std::move(pace)); }
  /// Is that error that of nothing?
  [[nodiscard]] bool blind() const { return pace_ && !pace_->decides(); }
  /// Size of the step after one of dt, s.
  [[nodiscard]] double wanted(double dt) const { return pace_ ? pace_->wanted() : dt; }

  /// On from where it stands to the end; false if the run ended before.
  template<class Run> bool go(Run& run) {
    auto const& stages = schedule_->stages;
    for (auto& k = stage_; k < stages.size(); ++k) {
      if (!run_stage(run, stages[k], k > 0 ? stages[k - 1].until : 0))
        return false;
      run.stage_ended();
    }
    return true;
  }
  /// Hands over all that steps change, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    archive(stage_, step_, begun_, halves_);
    if (pace_)
      archive(*pace_);
  }

private:
  template<class Run> bool run_stage(Run& run, StagePart const& stage, double start) {
    double const nominal = (stage.until - start) / stage.steps;
    if (!std::exchange(begun_, true)) {
      run.patience_.begin(nominal);
      if (pace_)
        pace_->begin(nominal, schedule_->halvings);
    }
    for (; step_ < stage.steps; ++step_) {
      bool const last = step_ + 1 == stage.steps;
      double const to = last ? stage.until : start + (step_ + 1) * nominal;
      // frame j of the stage comes after step ceil(j * steps / frames)
      bool const framed = static_cast<long>(step_ + 1) * frames_ / stage.steps >
                          static_cast<long>(step_) * frames_ / stage.steps;
      if (pace_ && !framed && !last)
        continue;
      bool const done =
          pace_ ? run_controlled(run, to) : run_interval(run, start + step_ * nominal, to, nominal);
      if (framed || (!done && frames_ > 0))
        run.frame();
      if (!done)
        return false;
    }
    step_ = 0;
    begun_ = false;
    return true;
  }

  /// On to a time that must be met, in steps that follow from their error.
  template<class Run> bool run_controlled(Run& run, double to) {
    while (run.state_.t < to) {
      if (!run.goes_on())
        return false;
      double const left = to - run.state_.t, dt = pace_->next(run.state_, left);
      auto outcome = run.attempt(dt);
      bool const answered = run.answered(outcome);
      if (!answered && run.stopped())
        return false;
      auto const wrong = answered ? leap_of(outcome) : outcome.reason;
      auto decision =
          answered && wrong.empty() ? pace_->decide(run.state_, outcome.state, dt) : pace_->failed(wrong, dt);
      if (answered && decision.failed) // it leaps in the shortest as well
        decision = pace_->decide(run.state_, outcome.state, dt);
      for (auto const& change : changes(*pace_, decision, run.state_.t, dt))
        run.change(change);
      auto const lost = answered ? "" : run.patience_.lost();
      if (decision.failed || !lost.empty())
        return run.give_up(outcome, dt, lost);
      if (!decision.accepted())
        continue;
      if (pace_->arrives(dt, left))
        outcome.state.t = to;
      run.accept(std::move(outcome), dt, decision.error);
    }
    return true;
  }

  /// One nominal step, in halves where it fails.
  template<class Run> bool run_interval(Run& run, double from, double to, double nominal) {
    while (!halves_.all_done()) {
      if (!run.goes_on())
        return false;
      double const dt = nominal * halves_.part();
      auto outcome = run.attempt(dt);
      if (auto const leap = leap_of(outcome); run.answered(outcome) && !leap.empty() && !halves_.shortest()) {
        run.change({run.state_.t, dt, 0.5 * dt, "cut", "not_converged", leap, ""});
        static_cast<void>(halves_.cut());
        continue;
      }
      if (!run.answered(outcome)) {
        if (run.stopped() || !halve(run, outcome, dt))
          return false;
        continue;
      }
      bool const grown = halves_.advance();
      outcome.state.t = halves_.all_done() ? to : from + (to - from) * halves_.done();
      run.accept(std::move(outcome), dt, {});
      if (grown)
        run.change({run.state_.t, dt, 2 * dt, "grown", "success", "two steps converged", ""});
    }
    halves_.begin();
    return true;
  }

  template<class Outcome> static std::string leap_of(Outcome const& outcome) {
    if constexpr (requires { outcome.leap; })
      return outcome.leap;
    return "";
  }

  template<class Run, class Outcome> bool halve(Run& run, Outcome const& outcome, double dt) {
    run.unanswered(outcome, dt);
    run.change({run.state_.t, dt, 0.5 * dt, "cut", "not_converged", outcome.reason, ""});
    auto const lost = run.patience_.lost();
    return (halves_.cut() && lost.empty()) || run.give_up(outcome, dt, lost);
  }

  SchedulePart const* schedule_;
  int frames_;
  std::optional<Pace> pace_; ///< none: equal steps
  Halves halves_;
  std::size_t stage_ = 0;
  int step_ = 0;       ///< nominal, of the stage
  bool begun_ = false; ///< the stage
};

} // namespace stiction::scene
