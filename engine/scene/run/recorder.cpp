// Files of a case by way of record/.
#include "scene/run/recorder.hpp"

#include "record/file.hpp"
#include "record/problem_file.hpp"
#include "scene/run/frame.hpp"

namespace stiction::scene {

Recorder::Recorder(Scene const& scene, std::filesystem::path const& folder)
    : scene_(&scene), folder_(folder), series_(folder / "series.h5"), fields_(folder), log_(folder) {
  add_step_columns(scene, series_);
  samplers_ = add_probes(scene, series_);
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
