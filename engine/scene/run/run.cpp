// Runs a scene's schedule: steps, their halving and growth, histories, frames, manifest, progress.
#include "scene/run/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sys/resource.h>

#include "dynamics/adaptivity/pace.hpp"
#include "dynamics/bulk/critical_step.hpp"
#include "dynamics/bulk/timer.hpp"
#include "linear/recycling.hpp"
#include "record/file.hpp"
#include "record/manifest.hpp"
#include "scene/explain/preview.hpp"
#include "scene/probes/probes.hpp"
#include "scene/run/alone.hpp"
#include "scene/run/manifest.hpp"
#include "scene/run/patience.hpp"
#include "scene/run/recorder.hpp"
#include "scene/run/remarks.hpp"
#include "scene/run/remesh.hpp"
#include "scene/run/work.hpp"

namespace stiction::scene {

namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Processor time of this process so far, s.
double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  auto const seconds = [](timeval const& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Of this program, bytes; getrusage would count what the process held before it became this program.
double peak_memory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0; word == "VmHWM:" && status >> kilobytes)
      return 1024 * kilobytes;
  return 0;
}

/// The case as it runs.
class Run {
public:
  Run(Scene const& scene, RunOptions const& options)
      : scene_(&scene), options_(&options), stepper_(*scene.model), recorder_(scene, options.out),
        patience_(scene.part.schedule, *scene.model, stepper_), state_(stepper_.initial()), remarks_(scene),
        meshes_(scene, state_) {
    stepper_.interrupt_when([this] { return !stop_reason().empty() || patience_.spent(); });
    if (auto const& accuracy = scene.part.schedule.accuracy; accuracy) {
      stepper_.bulk().keep_factors(static_cast<std::size_t>(accuracy->factors));
      pace_.emplace(*accuracy, stepper_.bulk(), *scene.model);
    }
  }

  RunResult go() {
    recorder_.step(state_, 0, 0);
    if (scene_->part.output.frames > 0)
      recorder_.frame(state_);
    if (too_long())
      return finish();
    result_.verdict = "finished";
    double start = 0;
    for (auto const& stage : scene_->part.schedule.stages) {
      if (!run_stage(stage, start))
        break;
      meshes_.examine(state_);
      start = stage.until;
    }
    Timed const timed(*this);
    recorder_.close();
    return finish();
  }

  [[nodiscard]] std::map<std::string, double> alone() {
    auto const& stage = scene_->part.schedule.stages.front();
    return scene::alone(stepper_, *scene_->model, state_, stage.until / stage.steps);
  }
  [[nodiscard]] MeshControl const& meshes() const { return meshes_; }
  [[nodiscard]] std::vector<Warning> warnings() const { return warnings_of(*scene_, state_); }

  RunResult finish() {
    auto const& cost = stepper_.cost();
    result_.seconds = seconds_since(began_);
    remarks_.rounded(cost.contact_rounded);
    result_.remarks = remarks_.texts();
    if (pace_ && !pace_->decides())
      result_.remarks.emplace_back(
          "without inertia, bonds or events no error is seen by `accuracy`: steps grow to its "
          "`largest`; give the stages their steps, and no accuracy");
    result_.iterations = cost.newton_iterations;
    result_.factorizations = cost.factorizations;
    result_.contact = contact::words(cost.answered);
    result_.phases = {{"assembly", cost.assembly},
                      {"factorization", cost.factorization},
                      {"contact", cost.contact},
                      {"solve", cost.solve},
                      {"output", output_}};
    double cells = 0;
    for (auto const& body : scene_->model->cells)
      cells += static_cast<double>(body.count());
    result_.counters = {
        {"force_passes", static_cast<double>(cost.force_passes)},
        {"stiffness_passes", static_cast<double>(cost.stiffness_passes)},
        {"shifted_factorizations", static_cast<double>(cost.shifted_factorizations)},
        {"solves", static_cast<double>(cost.solves)},
        {"compliance_columns", static_cast<double>(cost.compliance_columns)},
        {"contact_unknowns", static_cast<double>(stepper_.bulk().factor().surface())},
        {"surface_bytes", 8 * stepper_.bulk().factor().surface_numbers()},
        {"contact_iterations", static_cast<double>(cost.contact_iterations)},
        {"contact_problems", static_cast<double>(cost.contact_problems)},
        {"cells", cells},
        {"cells_evaluated", cells * static_cast<double>(cost.force_passes + cost.stiffness_passes)},
        {"cells_per_second",
         cells * static_cast<double>(cost.force_passes + cost.stiffness_passes) / cost.assembly},
        {"heap_blocks_of_factor_after_first_step",
         static_cast<double>(linear::blocks_from_system() - blocks_)},
        {"work", operations(*scene_->model, stepper_)},
        {"cpu_seconds", cpu_seconds()},
        {"unknowns", static_cast<double>(stepper_.bulk().unknowns())},
        {"peak_memory", peak_memory()}};
    result_.counters.insert(recorder_.changes().begin(), recorder_.changes().end());
    return result_;
  }

private:
  /// Adds its lifetime to the time spent on output.
  struct Timed {
    explicit Timed(Run& run) : timer(run.output_) {}
    dynamics::Timer timer;
  };

  /// An explicit scheme is not started with steps above its stability limit.
  bool too_long() {
    if (!dynamics::weights(scene_->model->scheme).explicit_forces)
      return false;
    double const limit = dynamics::critical_step(*scene_->model, state_.u);
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

  bool run_stage(StagePart const& stage, double start) {
    double const nominal = (stage.until - start) / stage.steps;
    patience_.begin(nominal);
    if (pace_)
      pace_->begin(nominal, scene_->part.schedule.halvings);
    for (int k = 0; k < stage.steps; ++k) {
      bool const last = k + 1 == stage.steps;
      double const to = last ? stage.until : start + (k + 1) * nominal;
      int const frames = scene_->part.output.frames;
      // frame j of the stage comes after step ceil(j * steps / frames)
      bool const framed = frames > 0 && static_cast<long>(k + 1) * frames / stage.steps >
                                            static_cast<long>(k) * frames / stage.steps;
      if (pace_ && !framed && !last)
        continue;
      if (pace_ ? !run_controlled(to) : !run_interval(start + k * nominal, to, nominal)) {
        if (frames > 0)
          recorder_.frame(state_);
        return false;
      }
      if (framed) {
        Timed const timed(*this);
        recorder_.frame(state_);
      }
    }
    return true;
  }

  /// On to a time that must be met, in steps that follow from their error.
  bool run_controlled(double to) {
    while (state_.t < to) {
      if (stopped())
        return false;
      double const left = to - state_.t, dt = pace_->next(state_, left);
      auto outcome = attempt(dt);
      bool const converged = outcome.converged();
      if (!converged && stopped())
        return false;
      auto const decision = pace_->decide(state_, outcome, dt);
      note(decision, dt);
      auto const enough = converged ? "" : patience_.lost();
      if (decision.failed || !enough.empty())
        return give_up(outcome, dt, enough);
      if (!decision.accepted())
        continue;
      if (pace_->arrives(dt, left))
        outcome.state.t = to;
      accept(std::move(outcome), dt, decision.error);
    }
    return true;
  }

  void note(dynamics::Decision const& decision, double dt) {
    auto tell = [&](char const* what, char const* cause, std::string const& reason) {
      recorder_.change({state_.t, dt, pace_->wanted(), what, cause, reason, ""});
    };
    if (!decision.accepted()) {
      ++result_.cuts;
      return recorder_.change({state_.t, dt, pace_->wanted(), "cut", name_of(decision.cut), decision.reason,
                               contact::words(answered())});
    }
    if (!pace_->aim().empty())
      tell("aimed", "event", pace_->aim());
    if (decision.at_floor)
      tell("at_floor", "smallest", decision.reason);
    else if (decision.grown)
      tell("grown", "error", decision.reason);
  }

  /// One nominal step, in halves of halves where it fails; sizes grow back where the halves align.
  bool run_interval(double from, double to, double nominal) {
    int const floor = scene_->part.schedule.halvings;
    long const whole = 1L << floor;
    for (long done = 0; done < whole;) {
      if (stopped())
        return false;
      long const size = whole >> halved_;
      double const dt = nominal * static_cast<double>(size) / static_cast<double>(whole);
      auto outcome = attempt(dt);
      if (!outcome.converged()) {
        if (stopped() || !halve(outcome, dt, floor))
          return false;
        continue;
      }
      done += size;
      outcome.state.t =
          done == whole ? to : from + (to - from) * static_cast<double>(done) / static_cast<double>(whole);
      accept(std::move(outcome), dt);
      if (halved_ > 0 && ++successes_ >= 2 && done % (2 * size) == 0) {
        --halved_;
        successes_ = 0;
        recorder_.change({state_.t, dt, 2 * dt, "grown", "success", "two steps converged", ""});
      }
    }
    return true;
  }

  dynamics::Outcome attempt(double dt) {
    patience_.begin_attempt();
    if (options_->rehearse > 0 && ++attempts_ % options_->rehearse == 0)
      static_cast<void>(stepper_.step(state_, dt));
    answered_before_ = stepper_.cost().answered;
    return stepper_.step(state_, dt);
  }

  /// Contact problems of the last attempt.
  [[nodiscard]] contact::Methods answered() const {
    auto counts = stepper_.cost().answered;
    std::ranges::transform(counts, answered_before_, counts.begin(), std::minus{});
    return counts;
  }

  /// Empty while there is none.
  [[nodiscard]] std::string stop_reason() const {
    if (options_->stop != nullptr && options_->stop->load())
      return "on request";
    return patience_.late(seconds_since(began_));
  }

  bool stopped() {
    auto const reason = stop_reason();
    if (reason.empty())
      return false;
    result_.verdict = "stopped";
    result_.reason = fmt::format("stopped {} at t = {:g} s", reason, state_.t);
    return true;
  }

  bool halve(dynamics::Outcome const& outcome, double dt, int floor) {
    ++result_.cuts;
    successes_ = 0;
    if (outcome.verdict == dynamics::StepVerdict::contact_failed)
      remarks_.examine(stepper_.contact(), state_.t + dt, contact::Checked::all);
    recorder_.change(
        {state_.t, dt, 0.5 * dt, "cut", "not_converged", outcome.reason, contact::words(answered())});
    auto const enough = patience_.lost();
    return (++halved_ <= floor && enough.empty()) || give_up(outcome, dt, enough);
  }

  /// Always false. enough: which limit has been passed, if one has.
  bool give_up(dynamics::Outcome const& outcome, double dt, std::string const& enough) {
    result_.verdict = "not converged";
    result_.reason =
        fmt::format("at t = {:g} s no step down to {:g} s converged: {}", state_.t, dt, outcome.reason);
    if (!enough.empty())
      result_.reason += "; gave up, as " + enough;
    if (outcome.verdict == dynamics::StepVerdict::contact_failed)
      result_.reason +=
          fmt::format("; its problem is {}", recorder_.problem(stepper_.contact().problem(), "failed"));
    return false;
  }

  void accept(dynamics::Outcome outcome, double dt, dynamics::StepError const& error = {}) {
    if (auto const contact = contact::words(answered()); !contact.empty())
      recorder_.change({state_.t, dt, pace_ ? pace_->wanted() : dt, "step", "", "", contact});
    state_ = std::move(outcome.state);
    patience_.reached(state_.t);
    if (++result_.steps == 1)
      blocks_ = linear::blocks_from_system();
    remarks_.examine(stepper_.contact(), state_.t, contact::Checked::bearing);
    remarks_.seek_beneath(state_);
    remarks_.weigh(state_.ledger);
    remarks_.balance(outcome);
    Timed const timed(*this);
    recorder_.step(state_, dt, outcome.iterations, error);
    int const every = scene_->part.output.problems_every;
    if (every > 0 && result_.steps % every == 0)
      static_cast<void>(recorder_.problem(stepper_.contact().problem(), fmt::format("{:06}", result_.steps)));
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
    progress.seconds = seconds_since(began_);
    progress.seconds_left = progress.seconds * (progress.end_time / progress.time - 1);
    options_->progress(progress);
  }

  Scene const* scene_;
  RunOptions const* options_;
  dynamics::Stepper stepper_;
  std::optional<dynamics::Pace> pace_; ///< none: equal steps
  Recorder recorder_;
  Patience patience_;
  dynamics::State state_;
  Remarks remarks_;
  MeshControl meshes_;
  RunResult result_;
  Clock::time_point began_ = Clock::now(), reported_{};
  double output_ = 0;
  int halved_ = 0, successes_ = 0;
  long attempts_ = 0;
  contact::Methods answered_before_{}; ///< the last attempt
  std::size_t blocks_ = 0;             ///< that SuiteSparse had taken from the system after the first step
};

/// One run into the folder, on the meshes that the scene has.
RunResult run_once(Run& running) {
  try {
    return running.go();
  } catch (core::RunError const& error) {
    auto result = running.finish();
    result.verdict = "output failed";
    result.reason = error.what();
    return result;
  }
}

} // namespace

void validate(core::Input const& scene) {
  static_cast<void>(build(scene));
}

RunResult run(core::Input const& input, RunOptions const& options) {
  core::Input asked = input;
  double cells_evaluated = 0;
  auto meshes = nlohmann::json::array();
  auto const started = record::utc_now();
  for (int pass = 1;; ++pass) {
    auto const scene = build(asked);
    record::prepare_output(options.out);
    auto manifest = manifest_of(asked, scene, options);
    manifest["started"] = started;
    Run running(scene, options);
    auto const warnings = running.warnings();
    auto& told = manifest["warnings"] = nlohmann::json::array();
    for (auto const& warning : warnings)
      told.push_back({{"text", warning.text}, {"change", warning.change}});
    record::write_manifest(options.out / "manifest.json", manifest);
    auto result = run_once(running);
    if (options.alone && result.verdict == "finished")
      for (auto const& [name, seconds] : running.alone())
        result.counters["alone_" + name] = seconds;
    result.warnings = warnings;
    auto const& control = running.meshes();
    bool const last = result.verdict != "finished" || control.fine_enough() || pass >= control.passes();
    if (control.wanted()) {
      cells_evaluated += result.counters["cells_evaluated"];
      result.counters["mesh_passes"] = pass;
      result.counters["mesh_error"] = control.error();
      result.counters["cells_evaluated_in_all_passes"] = cells_evaluated;
      meshes.push_back({{"cells", result.counters["cells"]}, {"error", control.error()}});
      manifest["remeshed"] = meshes;
      std::ranges::copy(control.doubts(), std::back_inserter(result.remarks));
    }
    if (!result.remarks.empty())
      manifest["remarks"] = result.remarks;
    manifest["ended"] = record::utc_now();
    if (result.verdict != "output failed")
      record::write_manifest(options.out / "manifest.json", manifest);
    if (last)
      return result;
    asked = control.finer(std::move(asked));
  }
}

} // namespace stiction::scene
