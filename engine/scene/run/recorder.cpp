// Files of a case by way of record/.
#include "scene/run/recorder.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "record/checkpoint_file.hpp"
#include "record/file.hpp"
#include "record/problem_file.hpp"
#include "scene/run/frame.hpp"

namespace stiction::scene {

namespace {

/// What cannot be read is no series to go on from.
record::SeriesData series_in(std::filesystem::path const& folder) {
  try {
    return record::read_series(folder / "series.h5");
  } catch (core::InputError const& error) {
    throw record::Unfit(fmt::format("goes with a series.h5 that cannot be read ({})", error.what()));
  }
}

/// Where no fields are asked for, a case that runs as it should leaves histories and manifest, nothing else.
record::StepLog::Rows rows_of(Scene const& scene) {
  return scene.part.output.frames > 0 ? record::StepLog::Rows::all : record::StepLog::Rows::eventful;
}

/// Contact problems of an earlier run, which are not those of this.
void remove_problems(std::filesystem::path const& folder) {
  std::error_code ignored; // what cannot be removed is overwritten or reported when written
  std::vector<std::filesystem::path> old;
  for (auto const& entry : std::filesystem::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".h5")
      old.push_back(entry.path());
  for (auto const& file : old)
    std::filesystem::remove(file, ignored);
  std::filesystem::remove(folder, ignored); // if nothing is left in it
}

} // namespace

Recorder::Recorder(Scene const& scene, std::filesystem::path const& folder, RecordMark const* from)
    : scene_(&scene), folder_(folder), series_(folder / "series.h5"),
      fields_(folder, from != nullptr ? from->fields : record::FieldMark{}),
      log_(folder, from != nullptr ? from->steps : 0, rows_of(scene)) {
  add_step_columns(scene, series_);
  samplers_ = add_probes(scene, series_);
  if (from == nullptr) {
    remove_problems(folder / "problems");
    return;
  }
  series_.take_up(series_in(folder), from->series);
  changes_ = from->changes;
}

RecordMark Recorder::mark() {
  return {series_.mark(), fields_.mark(), log_.mark(), changes_};
}

void Recorder::step(dynamics::State const& state, double dt, int iterations,
                    dynamics::StepError const& error) {
  row_.assign({dt, static_cast<double>(iterations)});
  if (scene_->part.schedule.accuracy)
    row_.insert(row_.end(),
                {error.displacement, error.bond, error.beta_change, static_cast<double>(error.events)});
  for (auto const& sampler : samplers_)
    sampler(state, row_);
  series_.append(state.t, row_);
}

void Recorder::frame(dynamics::State const& state) {
  fields_.write(frame_of(*scene_, state));
}

std::string Recorder::problem(contact::Problem const& problem, std::string const& name) const {
  if (problem.points.empty())
    return "";
  if (problem.W.together() != nullptr)
    return "not written, as it has no matrix (control.bulk = \"direct\" makes one)";
  auto const folder = folder_ / "problems";
  record::prepare_output(folder);
  record::save_problem(folder / (name + ".h5"), problem);
  return (folder / (name + ".h5")).string();
}

void Recorder::change(record::StepChange const& change) {
  log_.add(change);
  if (change.what != "step")
    ++changes_[change.what == "cut" ? "cut_" + change.cause : change.what];
}

void Recorder::close() {
  series_.flush();
  log_.write();
}

} // namespace stiction::scene
