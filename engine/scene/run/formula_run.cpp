// From state to state of the formula at every time of the stages; what is written is what other runs write.
#include "scene/run/formula_run.hpp"

#include <chrono>
#include <fmt/format.h>
#include <limits>
#include <numbers>

#include "dynamics/bulk/timer.hpp"
#include "formula/follow.hpp"
#include "record/fields.hpp"
#include "record/file.hpp"
#include "record/manifest.hpp"
#include "record/step_log.hpp"
#include "scene/probes/formula_points.hpp"
#include "scene/probes/probes.hpp"
#include "scene/run/beside.hpp"
#include "scene/run/frame.hpp"
#include "scene/run/manifest.hpp"
#include "scene/run/resources.hpp"

namespace stiction::scene {

namespace {

constexpr double any_size = std::numeric_limits<double>::infinity();

class FormulaRun {
public:
  FormulaRun(Scene const& scene, RunOptions const& options)
      : scene_(scene), options_(options), series_(options.out / "series.h5"), fields_(options.out),
        follower_(*scene.formula->normal, scene.formula->drive), along_(scene.formula->along),
        frames_(scene.formula->moved ? 0 : scene.part.output.frames) {
    record::StepLog const no_log(options.out);
    add_step_columns(scene, series_);
    samplers_ = add_formula_probes(scene, columns_of(series_));
  }

  RunResult go() {
    result_.verdict = "finished";
    if (reach(0, 0)) {
      if (frames_ > 0)
        frame();
      run_stages();
    }
    series_.flush();
    return finish();
  }

  RunResult finish() {
    result_.seconds = std::chrono::duration<double>(Clock::now() - began_).count();
    auto const evaluations = static_cast<double>(follower_.evaluations());
    constexpr double operations = 30; // of a state, about
    result_.phases = {{"assembly", 0},
                      {"factorization", 0},
                      {"contact", result_.seconds - output_},
                      {"solve", 0},
                      {"output", output_}};
    result_.counters = {{"unknowns", 0},
                        {"contact_unknowns", 0},
                        {"evaluations", evaluations},
                        {"work", operations * evaluations},
                        {"cpu_seconds", cpu_seconds()},
                        {"peak_memory", peak_memory()}};
    if (scene_.part.schedule.accuracy)
      result_.remarks.emplace_back(
          "a formula is exact at any step: `accuracy` chooses none, the stages' are taken");
    return result_;
  }

private:
  using Clock = std::chrono::steady_clock;

  void run_stages() {
    double start = 0;
    for (auto const& stage : scene_.part.schedule.stages) {
      double const dt = (stage.until - start) / stage.steps;
      for (int step = 1; step <= stage.steps; ++step) {
        if (stopped() || !reach(step == stage.steps ? stage.until : start + step * dt, dt))
          return;
        ++result_.steps;
        // frame j of the stage comes after step ceil(j * steps / frames)
        if (static_cast<long>(step) * frames_ / stage.steps >
            static_cast<long>(step - 1) * frames_ / stage.steps)
          frame();
      }
      start = stage.until;
    }
  }

  /// The state at a time, recorded; false where there is none.
  bool reach(double t, double dt) {
    auto const& model = *scene_.half_space;
    bool const forced = scene_.formula->drive == formula::Drive::force;
    double const drive = forced ? model.force->value(t) : -model.shift[2].value(t);
    double const before = follower_.size();
    auto const state = follower_.follow(drive);
    if (!state) {
      result_.verdict = "not converged";
      result_.reason = fmt::format(
          "at t = {:g} s the pull of {:g} {} is more than the contact holds (pull-off {:g}): it lets go", t,
          -drive, model.grid.line ? "N/m" : "N",
          -formula::largest_pull(*scene_.formula->normal, before > 0 ? before : any_size).force);
      return false;
    }
    bool const first = t == 0;
    FormulaState now{t, *state, {model.shift[0].value(t), model.shift[1].value(t)}, {}, follower_.size()};
    move_along(now);
    now.start = first ? now.normal.strain + now.normal.bond : now_.start;
    now.work = first ? 0
                     : now_.work + 0.5 * (now_.normal.force + now.normal.force) *
                                       (now.normal.depth - now_.normal.depth);
    now_ = now;
    dynamics::Timer const timer(output_);
    row_.assign({dt, 0});
    if (scene_.part.schedule.accuracy)
      add_step_error(dynamics::StepError(), row_); // of a step there is none
    for (auto const& sampler : samplers_)
      sampler(now, row_);
    series_.append(t, row_);
    return true;
  }

  void frame() {
    dynamics::Timer const timer(output_);
    FormulaPoints const points(scene_, now_);
    fields_.write(frame_of(*scene_.half_space, {now_.t, [&](Index i) { return points.displacement(i); },
                                                [&](Index i) { return points.at(i); }}));
  }

  /// Of the two ways along one is nothing, or nothing acts.
  void move_along(FormulaState& now) {
    if (!along_)
      return;
    std::size_t const axis = changes(scene_.half_space->shift[1]) ? 1 : 0;
    double const way = now.way[axis] - scene_.half_space->shift[axis].value(0);
    double const radius = std::sqrt(now.normal.area / std::numbers::pi);
    now.along[axis] = along_->move(way, now.normal.force, radius);
  }

  bool stopped() {
    if (!(options_.stop != nullptr && options_.stop->load()) &&
        !(options_.stop_after > 0 && ++asked_ >= options_.stop_after))
      return false;
    result_.verdict = "stopped";
    result_.reason = "stopped on request";
    return true;
  }

  Scene const& scene_;
  RunOptions const& options_;
  record::Series series_;
  record::FieldSeries fields_; ///< of an earlier run are removed
  formula::Follower follower_;
  std::optional<formula::Mindlin> along_;
  int frames_; ///< of fields, in each stage: formulas of what is moved along give none
  FormulaState now_;
  std::vector<FormulaSampler> samplers_;
  std::vector<double> row_;
  RunResult result_;
  double output_ = 0; ///< s
  long asked_ = 0;
  Clock::time_point began_ = Clock::now();
};

/// The same with a parameter that is a little different each, from the start; stopped on the way, the case
/// is.
void run_beside(Scene const& scene, RunOptions const& options, RunResult& result) {
  for (auto const& shifted : options.beside) {
    auto other = scene_beside(shifted, scene);
    other.part.output.frames = 0;
    RunOptions own;
    own.out = options.out / "derivatives" / shifted.name;
    own.stop = options.stop;
    record::prepare_output(own.out);
    auto const run = FormulaRun(other, own).go();
    if (run.verdict == "stopped") {
      result.verdict = run.verdict;
      result.reason = run.reason;
      return;
    }
    auto& beside = result.beside.emplace_back();
    beside.name = shifted.name;
    beside.steps = run.steps;
    beside.ended = run.reason;
  }
}

} // namespace

RunResult run_formula(core::Input const& input, Scene const& scene, RunOptions const& options, Story& story) {
  record::prepare_output(options.out);
  remove_runs_beside(options.out);
  auto manifest = manifest_of(input, scene, options, story, {});
  record::write_manifest(options.out / "manifest.json", manifest);
  FormulaRun running(scene, options);
  RunResult result;
  try {
    result = running.go();
    if (result.verdict != "stopped")
      run_beside(scene, options, result);
  } catch (core::RunError const& error) {
    result = running.finish();
    result.verdict = "output failed";
    result.reason = error.what();
    return result;
  }
  if (!scene.formula->neglects.empty())
    result.remarks.push_back(fmt::format("the formula ({}) leaves out {}", scene.formula->normal->name(),
                                         scene.formula->neglects));
  story.add_remarks(result.remarks);
  if (!result.remarks.empty())
    manifest["remarks"] = result.remarks;
  manifest["ended"] = record::utc_now();
  record::write_manifest(options.out / "manifest.json", manifest);
  return result;
}

} // namespace stiction::scene
