// One pass of a scene over its schedule: steps, their halving and growth, and what is recorded and kept on
// the way.
#pragma once
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <memory>

#include "dynamics/adaptivity/pace.hpp"
#include "dynamics/bulk/critical_step.hpp"
#include "dynamics/bulk/timer.hpp"
#include "dynamics/step/visit.hpp"
#include "linear/recycling.hpp"
#include "scene/explain/preview.hpp"
#include "scene/run/all_ranks.hpp"
#include "scene/run/alone.hpp"
#include "scene/run/at_border.hpp"
#include "scene/run/beside.hpp"
#include "scene/run/checkpoint.hpp"
#include "scene/run/course.hpp"
#include "scene/run/patience.hpp"
#include "scene/run/recorder.hpp"
#include "scene/run/remarks.hpp"
#include "scene/run/remesh.hpp"
#include "scene/run/resources.hpp"
#include "scene/run/work.hpp"

namespace stiction::scene {

/// The case as it runs. Scene, options, checkpoint and story must outlive it.
class Run {
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  }

public:
  /// Goes on from the checkpoint where the story is under way. Throws
  /// record::Unfit if it cannot.
  Run(Scene const& scene, RunOptions const& options, Checkpoint& checkpoint, Story const& story)
      : scene_(&scene), options_(&options), checkpoint_(&checkpoint), story_(&story), ranks_(options.ranks),
        stepper_(*scene.model),
        patience_(scene.part.schedule, {[this] { return operations(*scene_->model, stepper_); },
                                        [this] { return stepper_.bulk().effort().operations; }}),
        state_(stepper_.initial()), remarks_(scene), meshes_(scene, state_),
        course_(scene.part.schedule, scene.part.output.frames) {
    stepper_.interrupt_when([this] { return !stop_reason().empty() || patience_.spent(); });
    if (auto const& accuracy = scene.part.schedule.accuracy; accuracy) {
      stepper_.bulk().keep_factors(static_cast<std::size_t>(accuracy->factors));
      course_.choose(dynamics::pace_of(*accuracy, stepper_.bulk(), *scene.model));
    }
    for (auto const& shifted : options.beside)
      beside_.push_back(std::make_unique<Beside>(shifted, scene, stepper_));
    if (!beside_.empty())
      stepper_.lead();
    warnings_ = warnings_of(scene, state_);
    if (!story.under_way) {
      begin_files(nullptr);
      return;
    }
    auto rest = checkpoint.rest();
    RecordMark mark;
    rest(mark);
    visit(rest);
    begin_files(&mark);
    auto made = standing_.lasting;
    for (std::size_t k = 0; k < standing_.made.size(); ++k) {
      made.push_back(state_.factors.at(ix(standing_.made[k])));
      made.back().carried = standing_.carried.at(k);
    }
    stepper_.go_on(made, settled_);
  }

  RunResult go() {
    if (!story_->under_way && !begin())
      return finish();
    result_.verdict = "finished";
    course_.go(*this);
    ranks_.note_use();
    Timed const timed(*this);
    recorder_->close();
    for (auto const& one : beside_)
      one->close();
    return finish();
  }
  [[nodiscard]] double time() const { return state_.t; }
  [[nodiscard]] long steps() const { return result_.steps; }

  [[nodiscard]] std::map<std::string, double> alone() {
    auto const& stage = scene_->part.schedule.stages.front();
    return scene::alone(stepper_, *scene_->model, state_, stage.until / stage.steps);
  }
  [[nodiscard]] MeshControl const& meshes() const { return meshes_; }
  [[nodiscard]] std::vector<Warning> const& warnings() const { return warnings_; }

  RunResult finish() {
    auto const& cost = stepper_.cost();
    result_.seconds = seconds();
    remarks_.rounded(cost.contact_rounded);
    result_.remarks = remarks_.texts();
    if (course_.blind())
      result_.remarks.emplace_back(no_error_seen);
    else if (auto unseen = unseen_by_accuracy(*scene_); !unseen.empty())
      result_.remarks.push_back(std::move(unseen));
    result_.iterations = cost.newton_iterations;
    result_.factorizations = cost.factorizations;
    result_.contact = contact::words(cost.answered);
    result_.phases = {{"assembly", cost.assembly},
                      {"factorization", cost.factorization},
                      {"contact", cost.contact},
                      {"solve", cost.solve},
                      {"output", output_}};
    result_.counters = counters_of(*scene_->model, stepper_);
    result_.counters["heap_blocks_of_factor_after_first_step"] =
        blocks_ ? static_cast<double>(linear::blocks_from_system() - *blocks_) : 0;
    result_.counters["cpu_seconds"] = cpu_before_ + ranks_.cpu_seconds();
    result_.counters["peak_memory"] = ranks_.peak_memory();
    if (ranks_.several())
      result_.counters["ranks"] = ranks_.count();
    result_.beside.clear();
    for (auto const& one : beside_)
      result_.beside.push_back(one->result());
    result_.counters.insert(recorder_->changes().begin(), recorder_->changes().end());
    return result_;
  }

private:
  /// Of several ranks the first writes, and what it finds unfit to go on from is unfit for all.
  void begin_files(RecordMark const* from) {
    std::string unfit;
    try {
      if (ranks_.writes())
        recorder_.emplace(*scene_, options_->out, from);
      else
        recorder_.emplace(*scene_, from);
      for (auto const& one : beside_)
        one->begin_files(options_->out, from == nullptr);
    } catch (record::Unfit const& why) {
      unfit = why.what();
    }
    if (ranks_.any(!unfit.empty()))
      throw record::Unfit(unfit);
  }

  /// The factors that need not be made when steps want them: all of a system whose factors do not depend on
  /// u, or else of the state's own those that no failed step has overwritten.
  struct Standing {
    std::vector<dynamics::FactorSource> lasting;
    Indices made;                                                ///< of the state's, by number
    std::vector<std::shared_ptr<linear::Carried const>> carried; ///< [made] by then
    template<class Archive> void visit(Archive& archive) { archive(lasting, made, carried); }
  };

  /// Adds its lifetime to the time spent on output.
  struct Timed {
    explicit Timed(Run& run) : timer(run.output_) {}
    dynamics::Timer timer;
  };

  /// An explicit scheme is not started with steps above its stability limit.
  bool too_long() {
    if (!dynamics::weights(scene_->model->scheme).explicit_forces)
      return false;
    double const limit = dynamics::critical_step(*scene_->model, state_.u, state_.t, state_.memory.get());
    double start = 0;
    for (auto const& stage : scene_->part.schedule.stages) {
      double const dt = (stage.until - start) / stage.steps;
      if (dt > limit * (1 + dynamics::critical_margin)) {
        result_.verdict = "unstable";
        result_.reason = fmt::format(
            "{}; give the stage to {:g} s at least {:.0f} steps, or take an implicit scheme",
            dynamics::above_critical(dt, limit), stage.until, std::ceil((stage.until - start) / limit));
        return true;
      }
      start = stage.until;
    }
    return false;
  }

  /// The state before the first step; false if there can be none.
  bool begin() {
    recorder_->step(state_, 0, 0);
    if (scene_->part.output.frames > 0)
      recorder_->frame(state_);
    return !too_long();
  }

  friend class Course<dynamics::Pace<dynamics::History>>;

  void frame() {
    Timed const timed(*this);
    recorder_->frame(state_);
  }
  void stage_ended() {
    meshes_.examine(state_);
    remarks_.seek_large_strain(state_);
    remarks_.seek_dug_in(state_);
  }
  void change(record::StepChange change) {
    bool const cut = change.what == "cut";
    result_.cuts += cut ? 1 : 0;
    change.contact = cut ? contact::words(answered()) : "";
    recorder_->change(change);
  }

  dynamics::Outcome attempt(double dt) {
    patience_.begin_attempt();
    if (options_->rehearse > 0 && ++attempts_ % options_->rehearse == 0)
      static_cast<void>(stepper_.step(state_, dt));
    answered_before_ = stepper_.cost().answered;
    return stepper_.step(state_, dt);
  }

  [[nodiscard]] static bool answered(dynamics::Outcome const& outcome) { return outcome.converged(); }

  /// Contact problems of the last attempt.
  [[nodiscard]] contact::Methods answered() const {
    auto counts = stepper_.cost().answered;
    std::ranges::transform(counts, answered_before_, counts.begin(), std::minus{});
    return counts;
  }

  /// Empty while there is none.
  [[nodiscard]] std::string stop_reason() {
    bool const asked = (options_->stop != nullptr && options_->stop->load()) ||
                       (options_->stop_after > 0 && ++asked_ >= options_->stop_after);
    bool const late = !patience_.late(seconds()).empty();
    constexpr double when_asked = 2, when_late = 1;
    double const why = ranks_.largest(asked ? when_asked : late ? when_late : 0); // clocks and signals differ
    if (why == 0)
      return "";
    return why == when_asked ? on_request : patience_.late(std::numeric_limits<double>::infinity());
  }

  bool stopped() {
    auto const reason = stop_reason();
    if (reason.empty())
      return false;
    result_.verdict = "stopped";
    result_.reason = fmt::format("stopped {} at t = {:g} s", reason, state_.t);
    result_.goes_on = reason == on_request && keep();
    if (result_.goes_on)
      result_.reason += "; the next run of the case goes on from there";
    return true;
  }

  /// Before an attempt, when all that the last one has left is in its place: is it to be made?
  bool goes_on() {
    settled_ = stepper_.cost();
    if (checkpoint_->wanted())
      standing_ = standing();
    if (ranks_.any(checkpoint_->due()))
      keep();
    return !stopped();
  }

  [[nodiscard]] Standing standing() {
    Standing now{stepper_.bulk().lasting(), {}, {}};
    for (std::size_t k = 0; !stepper_.bulk().linear() && k < state_.factors.size(); ++k)
      if (auto held = stepper_.bulk().held(state_.factors[k])) {
        now.made.push_back(static_cast<Index>(k));
        now.carried.push_back(std::move(held->carried));
      }
    return now;
  }

  /// Keeps where the run stood before the present attempt; whether that could be written.
  bool keep() {
    if (!checkpoint_->wanted())
      return false;
    Timed const timed(*this);
    if (!ranks_.writes())
      return checkpoint_->pass_over();
    auto mark = recorder_->mark();
    auto story = *story_;
    story.under_way = true;
    return checkpoint_->keep(story, [&](auto& archive) {
      archive(mark);
      visit(archive);
    });
  }

  /// Hands over all that a run changes on its way but its files, to be written or read.
  template<class Archive> void visit(Archive& archive) {
    double spent = seconds(), cpu = cpu_before_ + cpu_seconds();
    archive(state_, standing_, settled_, course_, attempts_, patience_, remarks_, meshes_, result_.steps,
            result_.cuts, spent, cpu, output_);
    for (auto const& one : beside_)
      one->visit(archive);
    if constexpr (Archive::reads) {
      before_ = spent;
      cpu_before_ = cpu;
    }
  }

  void unanswered(dynamics::Outcome const& outcome, double dt) {
    if (outcome.verdict == dynamics::StepVerdict::contact_failed)
      remarks_.examine_unanswered(stepper_.contact(), state_.t + dt);
  }

  /// Always false. enough: which limit has been passed, if one has.
  bool give_up(dynamics::Outcome const& outcome, double dt, std::string const& enough) {
    result_.verdict = "not converged";
    remarks_.seek_dug_in(state_);
    result_.reason =
        fmt::format("at t = {:g} s no step down to {:g} s converged: {}", state_.t, dt, outcome.reason);
    if (auto const words = slid_off(*scene_, state_, stepper_.contact()); !words.empty())
      result_.reason += "; " + words;
    if (!enough.empty())
      result_.reason += "; gave up, as " + enough;
    if (outcome.verdict == dynamics::StepVerdict::contact_failed)
      result_.reason +=
          fmt::format("; its problem is {}", recorder_->problem(stepper_.contact().problem(), "failed"));
    return false;
  }

  void accept(dynamics::Outcome outcome, double dt, dynamics::StepError const& error) {
    if (auto const contact = contact::words(answered()); !contact.empty())
      recorder_->change({state_.t, dt, course_.wanted(dt), "step", "", "", contact});
    Beside::follow(beside_, stepper_, outcome, dt);
    remarks_.seek_let_go(state_, outcome.state);
    auto const before = state_.ledger;
    state_ = std::move(outcome.state);
    patience_.reached(state_.t);
    ++result_.steps;
    if (!blocks_)
      blocks_ = linear::blocks_from_system();
    remarks_.examine(stepper_.contact(), state_.t, lost_part(before, state_.ledger));
    remarks_.seek_met(state_);
    remarks_.seek_beneath(state_);
    remarks_.weigh(before, state_.ledger, stepper_.rounding_energy(state_));
    remarks_.balance(outcome);
    if (result_.steps % 16 == 0) { // beside the ends of stages: a blow is over by then
      remarks_.seek_large_strain(state_);
      remarks_.seek_dug_in(state_);
    }
    Timed const timed(*this);
    recorder_->step(state_, dt, outcome.iterations, error);
    int const every = scene_->part.output.problems_every;
    if (every > 0 && result_.steps % every == 0)
      static_cast<void>(
          recorder_->problem(stepper_.contact().problem(), fmt::format("{:06}", result_.steps)));
    report(dt, outcome.iterations);
  }

  void report(double dt, int iterations) {
    if (!options_->progress || seconds_since(reported_) < 0.1)
      return;
    reported_ = Clock::now();
    Progress progress;
    progress.time = state_.t;
    progress.end_time = scene_->part.schedule.stages.back().until;
    progress.dt = dt;
    progress.step = result_.steps;
    progress.iterations = iterations;
    for (auto const& pair : state_.contacts)
      for (auto const& point : pair)
        if (point.in_reach)
          ++(point.status == interface::Status::open    ? progress.open
             : point.status == interface::Status::stick ? progress.stick
                                                        : progress.slip);
    progress.seconds = seconds();
    progress.seconds_left = progress.seconds * (progress.end_time / progress.time - 1);
    options_->progress(progress);
  }

  /// Of the machine, those before it was taken up included, s.
  [[nodiscard]] double seconds() const { return before_ + seconds_since(began_); }

  static constexpr char const* on_request = "on request";

  Scene const* scene_;
  RunOptions const* options_;
  Checkpoint* checkpoint_;
  Story const* story_;
  AllRanks ranks_;
  dynamics::Stepper stepper_;
  std::optional<Recorder> recorder_;
  std::vector<std::unique_ptr<Beside>> beside_;
  Patience patience_;
  dynamics::State state_;
  Remarks remarks_;
  MeshControl meshes_;
  RunResult result_;
  std::vector<Warning> warnings_;
  dynamics::Cost settled_;             ///< before the present attempt
  Standing standing_;                  ///< before the present attempt
  double before_ = 0, cpu_before_ = 0; ///< s, before it was taken up
  long asked_ = 0;                     ///< whether it is to stop
  Clock::time_point began_ = Clock::now(), reported_{};
  double output_ = 0;
  Course<dynamics::Pace<dynamics::History>> course_;
  long attempts_ = 0;
  contact::Methods answered_before_{}; ///< the last attempt
  std::optional<std::size_t>
      blocks_; ///< that SuiteSparse had taken from the system after this process's first step
};

} // namespace stiction::scene
