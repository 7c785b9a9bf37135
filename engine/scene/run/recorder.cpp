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

/// Where no fields are asked for, a case that runs as it should leaves histories and manifest, nothing else.
record::StepLog::Rows rows_of(Scene const& scene) {
  return scene.part.output.frames > 0 ? record::StepLog::Rows::all : record::StepLog::Rows::eventful;
}

} // namespace

record::SeriesData series_in(std::filesystem::path const& folder) {
  try {
    return record::read_series(folder / "series.h5");
  } catch (core::InputError const& error) {
    throw record::Unfit(fmt::format("goes with a series.h5 that cannot be read ({})", error.what()));
  }
}

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

Recorder::Recorder(Scene const& scene, std::filesystem::path const& folder, RecordMark const* from)
    : scene_(&scene), folder_(folder),
      files_(new Files{record::Series(folder / "series.h5"),
                       record::FieldSeries(folder, from != nullptr ? from->fields : record::FieldMark{}),
                       record::StepLog(folder, from != nullptr ? from->steps : 0, rows_of(scene))}) {
  add_step_columns(scene, files_->series);
  samplers_ = add_probes(scene, files_->series);
  if (from == nullptr) {
    remove_problems(folder / "problems");
    return;
  }
  files_->series.take_up(series_in(folder), from->series);
  changes_ = from->changes;
}

Recorder::Recorder(Scene const& scene, RecordMark const* from) : scene_(&scene) {
  if (from != nullptr)
    changes_ = from->changes;
}

RecordMark Recorder::mark() {
  return files_ ? RecordMark{files_->series.mark(), files_->fields.mark(), files_->log.mark(), changes_}
                : RecordMark{};
}

void Recorder::step(dynamics::State const& state, double dt, int iterations,
                    dynamics::StepError const& error) {
  if (!files_)
    return;
  row_.assign({dt, static_cast<double>(iterations)});
  if (scene_->part.schedule.accuracy)
    add_step_error(error, row_);
  for (auto const& sampler : samplers_)
    sampler(state, row_);
  files_->series.append(state.t, row_);
}

void Recorder::frame(dynamics::State const& state) {
  if (files_)
    files_->fields.write(frame_of(*scene_, state));
}

std::string Recorder::problem(contact::Problem const& problem, std::string const& name) const {
  if (problem.points.empty() || !files_)
    return "";
  if (problem.W.together() != nullptr)
    return "not written, as it has no matrix (control.bulk = \"direct\" makes one)";
  auto const folder = folder_ / "problems";
  record::prepare_output(folder);
  record::save_problem(folder / (name + ".h5"), problem);
  return (folder / (name + ".h5")).string();
}

void Recorder::change(record::StepChange const& change) {
  if (files_)
    files_->log.add(change);
  count(change, changes_);
}

void Recorder::close() {
  if (!files_)
    return;
  files_->series.flush();
  files_->log.write();
}

} // namespace stiction::scene
