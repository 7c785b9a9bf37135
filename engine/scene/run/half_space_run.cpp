// Stages, steps and their halves, as bodies with cells have them.
#include "scene/run/half_space_run.hpp"

#include <chrono>
#include <fmt/format.h>
#include <optional>
#include <utility>

#include "dynamics/bulk/timer.hpp"
#include "dynamics/step/visit.hpp"
#include "halfspace/points.hpp"
#include "halfspace/stepper.hpp"
#include "record/fields.hpp"
#include "record/file.hpp"
#include "record/step_log.hpp"
#include "scene/description/human.hpp"
#include "scene/explain/preview.hpp"
#include "scene/probes/half_space_probes.hpp"
#include "scene/run/alone.hpp"
#include "scene/run/course.hpp"
#include "scene/run/frame.hpp"
#include "scene/run/manifest.hpp"
#include "scene/run/patience.hpp"
#include "scene/run/recorder.hpp"
#include "scene/run/resources.hpp"

namespace stiction::scene {

namespace {

struct HalfSpaceMark {
  record::SeriesMark series;
  record::FieldMark fields;
  std::uintmax_t steps = 0;
  ChangeCounts changes;
  template<class Archive> void visit(Archive& archive) { archive(series, fields, steps, changes); }
};

class HalfSpaceRun {
  using Clock = std::chrono::steady_clock;

public:
  HalfSpaceRun(Scene const& scene, RunOptions const& options, Checkpoint& checkpoint, Story const& story)
      : scene_(scene), model_(*scene.half_space), options_(options), checkpoint_(checkpoint), story_(story),
        stepper_(model_),
        patience_(scene.part.schedule,
                  {[this] { return operations(); }, [this] { return stepper_.surface().operations(); }}),
        course_(scene.part.schedule, scene.part.output.frames), state_(stepper_.initial()) {
    stepper_.interrupt_when([this] { return !stop_reason().empty() || patience_.spent(); });
    if (auto const& accuracy = scene.part.schedule.accuracy; accuracy)
      course_.choose(halfspace::pace_of(*accuracy, model_));
    if (!story.under_way) {
      begin_files(nullptr);
      return;
    }
    auto rest = checkpoint.rest();
    HalfSpaceMark mark;
    rest(mark);
    visit(rest);
    begin_files(&mark);
  }

  RunResult go() {
    if (!story_.under_way) {
      record(0, 0);
      if (scene_.part.output.frames > 0)
        frame();
    }
    result_.verdict = "finished";
    course_.go(*this);
    series_->flush();
    log_->write();
    return finish();
  }

  RunResult finish() {
    auto const& cost = stepper_.cost();
    result_.seconds = seconds();
    result_.iterations = cost.iterations;
    result_.phases = {
        {"assembly", 0}, {"factorization", 0}, {"contact", contact_}, {"solve", 0}, {"output", output_}};
    result_.counters = {
        {"unknowns", stepper_.surface().rows()},
        {"contact_unknowns", stepper_.surface().rows()},
        {"products", static_cast<double>(cost.products)},
        {"preconditionings", static_cast<double>(cost.solutions)},
        {"krylov_iterations", static_cast<double>(cost.krylov)},
        {"contact_iterations", static_cast<double>(cost.iterations)},
        {"solves", static_cast<double>(cost.products + cost.solutions)},
        {"cells", 0},
        {"cells_evaluated", 0},
        {"work", stepper_.surface().operations() * static_cast<double>(cost.products + cost.solutions)},
        {"surface_bytes", 8 * static_cast<double>(stepper_.surface().memory())},
        {"cpu_seconds", cpu_before_ + cpu_seconds()},
        {"peak_memory", peak_memory()}};
    result_.counters.insert(changes_.begin(), changes_.end());
    if (course_.blind())
      result_.remarks.emplace_back(no_error_seen);
    for (auto const* remark : {&at_rim_, &steep_})
      if (!remark->empty())
        result_.remarks.push_back(*remark);
    return result_;
  }
  [[nodiscard]] std::map<std::string, double> alone() const { return scene::alone(stepper_.surface()); }
  [[nodiscard]] double time() const { return state_.t; }
  [[nodiscard]] long steps() const { return result_.steps; }
  [[nodiscard]] bool kept() const { return checkpoint_.stands(); }

private:
  void begin_files(HalfSpaceMark const* from) {
    log_.emplace(options_.out, from != nullptr ? from->steps : 0,
                 scene_.part.output.frames > 0 ? record::StepLog::Rows::all
                                               : record::StepLog::Rows::eventful);
    fields_.emplace(options_.out, from != nullptr ? from->fields : record::FieldMark{});
    record::SeriesData before;
    if (from != nullptr) {
      before = series_in(options_.out);
      changes_ = from->changes;
    } else
      remove_problems(options_.out / "problems");
    series_.emplace(options_.out / "series.h5");
    add_step_columns(scene_, *series_);
    samplers_ = add_half_space_probes(scene_, columns_of(*series_));
    if (from != nullptr)
      series_->take_up(before, from->series);
  }

  friend class Course<halfspace::Pace>;

  void frame() {
    dynamics::Timer const timer(output_);
    int const D = model_.components();
    fields_->write(frame_of(model_, {state_.t,
                                     [&](Index i) {
                                       contact::Vec3 u = contact::Vec3::Zero();
                                       u.head(D) = state_.u.segment(D * i, D);
                                       return u;
                                     },
                                     [&](Index i) { return contact_state(model_, state_, i); }}));
  }
  void stage_ended() {
    constexpr double steep = 0.3; // (a/R)^2 of Hertz' sphere is 0.1 then, and with it what is left out
    if (double const slope = halfspace::slope_in_contact(model_, state_); steep_.empty() && slope > steep)
      steep_ =
          fmt::format("at t = {} the surfaces have a slope of {:.2g} (root mean square) where they touch: "
                      "half spaces, and formulas, know small ones only",
                      human(state_.t, "s"), slope);
  }

  /// Before an attempt: is it to be made?
  bool goes_on() {
    settled_ = stepper_.cost();
    if (checkpoint_.due())
      keep();
    return !stopped();
  }

  halfspace::Outcome attempt(double dt) {
    dynamics::Timer const timer(contact_);
    patience_.begin_attempt();
    return stepper_.step(state_, dt);
  }

  [[nodiscard]] static bool answered(halfspace::Outcome const& outcome) { return outcome.converged; }
  static void unanswered(halfspace::Outcome const&, double) {}

  void change(record::StepChange const& one) {
    result_.cuts += one.what == "cut" ? 1 : 0;
    log_->add(one);
    count(one, changes_);
  }

  /// Always false. lost: which limit has been passed, if one has.
  bool give_up(halfspace::Outcome const& outcome, double dt, std::string const& lost) {
    result_.verdict = "not converged";
    result_.reason =
        fmt::format("at t = {:g} s no step down to {:g} s converged: {}", state_.t, dt, outcome.reason);
    if (!lost.empty())
      result_.reason += "; gave up, as " + lost;
    return false;
  }

  void accept(halfspace::Outcome outcome, double dt, dynamics::StepError const& error) {
    state_ = std::move(outcome.state);
    patience_.reached(state_.t);
    ++result_.steps;
    look_at_rim();
    log_->add({state_.t, dt, dt, "step", "", "", ""});
    dynamics::Timer const timer(output_);
    record(dt, outcome.iterations, error);
    report(dt, outcome.iterations);
  }

  /// Beyond the points a free surface bears nothing.
  void look_at_rim() {
    if (!at_rim_.empty() || !halfspace::reaches_rim(model_, state_))
      return;
    at_rim_ =
        fmt::format("from t = {} on contact or adhesion reaches the border of the points, beyond which "
                    "the free surface bears nothing: a larger `size`, unless what touches it ends there",
                    human(state_.t, "s"));
  }

  void record(double dt, long iterations, dynamics::StepError const& error = {}) {
    row_.assign({dt, static_cast<double>(iterations)});
    if (scene_.part.schedule.accuracy)
      add_step_error(error, row_);
    for (auto const& sampler : samplers_)
      sampler(state_, row_);
    series_->append(state_.t, row_);
  }

  void report(double dt, long iterations) {
    if (!options_.progress || std::chrono::duration<double>(Clock::now() - reported_).count() < 0.1)
      return;
    reported_ = Clock::now();
    Progress progress;
    progress.time = state_.t;
    progress.end_time = scene_.part.schedule.stages.back().until;
    progress.dt = dt;
    progress.step = result_.steps;
    progress.iterations = iterations;
    for (auto const one : state_.status)
      ++(one == 0 ? progress.open : one == 1 ? progress.stick : progress.slip);
    progress.seconds = seconds();
    progress.seconds_left = progress.seconds * (progress.end_time / progress.time - 1);
    options_.progress(progress);
  }

  /// Empty while there is none.
  [[nodiscard]] std::string stop_reason() {
    bool const asked = (options_.stop != nullptr && options_.stop->load()) ||
                       (options_.stop_after > 0 && ++asked_ >= options_.stop_after);
    return asked ? on_request : patience_.late(seconds());
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

  /// Keeps where the run stood before the present attempt; whether that could be written.
  bool keep() {
    if (!checkpoint_.wanted())
      return false;
    HalfSpaceMark mark{series_->mark(), fields_->mark(), log_->mark(), changes_};
    auto story = story_;
    story.under_way = true;
    return checkpoint_.keep(story, [&](auto& archive) {
      archive(mark);
      visit(archive);
    });
  }

  template<class Archive> void visit(Archive& archive) {
    double spent = seconds(), cpu = cpu_before_ + cpu_seconds();
    archive(state_, settled_, course_, patience_, result_.steps, result_.cuts, spent, cpu, output_, contact_,
            at_rim_, steep_);
    if constexpr (Archive::reads) {
      stepper_.go_on(settled_);
      before_ = spent;
      cpu_before_ = cpu;
    }
  }

  /// Of all products and preconditionings of this process.
  [[nodiscard]] double operations() const {
    auto const& surface = stepper_.surface();
    return surface.operations() * static_cast<double>(surface.products() + surface.solutions());
  }

  [[nodiscard]] double seconds() const {
    return before_ + std::chrono::duration<double>(Clock::now() - began_).count();
  }

  static constexpr char const* on_request = "on request";

  Scene const& scene_;
  halfspace::Model const& model_;
  RunOptions const& options_;
  Checkpoint& checkpoint_;
  Story const& story_;
  halfspace::Stepper stepper_;
  Patience patience_;
  Course<halfspace::Pace> course_;
  halfspace::State state_;
  halfspace::Cost settled_; ///< before the present attempt
  std::optional<record::StepLog> log_;
  std::optional<record::FieldSeries> fields_;
  std::optional<record::Series> series_;
  std::vector<HalfSpaceSampler> samplers_;
  std::vector<double> row_;
  RunResult result_;
  ChangeCounts changes_ = no_changes();
  std::string at_rim_, steep_;                                    ///< remarks
  double before_ = 0, cpu_before_ = 0, output_ = 0, contact_ = 0; ///< s
  long asked_ = 0;
  Clock::time_point began_ = Clock::now(), reported_{};
};

} // namespace

RunResult run_half_space(core::Input const& input, Scene const& scene, RunOptions const& options,
                         Checkpoint& checkpoint, Story& story) {
  keep_pages(1 << 30); // vectors of all points
  record::prepare_output(options.out);
  std::optional<HalfSpaceRun> running;
  try {
    running.emplace(scene, options, checkpoint, story);
  } catch (record::Unfit const& unfit) {
    checkpoint.refuse(unfit.what());
    story = Story::anew();
    running.emplace(scene, options, checkpoint, story);
  }
  if (story.under_way)
    story.go_on(running->time(), running->steps(), checkpoint);
  auto const warnings = warnings_of(scene);
  auto manifest = manifest_of(input, scene, options, story, warnings);
  record::write_manifest(options.out / "manifest.json", manifest);
  RunResult result;
  try {
    result = running->go();
    if (options.alone && result.verdict == "finished")
      for (auto const& [name, seconds] : running->alone())
        result.counters["alone_" + name] = seconds;
  } catch (core::RunError const& error) {
    result = running->finish();
    result.verdict = "output failed";
    result.reason = error.what();
    result.goes_on = checkpoint.stands();
    return result;
  }
  result.warnings = warnings;
  result.continued = static_cast<long>(story.continued.size());
  story.add_remarks(result.remarks);
  if (!result.remarks.empty())
    manifest["remarks"] = result.remarks;
  manifest["ended"] = record::utc_now();
  record::write_manifest(options.out / "manifest.json", manifest);
  return result;
}

} // namespace stiction::scene
