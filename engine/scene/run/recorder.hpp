// Everything that a case writes while it runs: histories, fields, the log of its steps, saved problems.
#pragma once
#include <filesystem>
#include <map>
#include <memory>

#include "dynamics/adaptivity/step_error.hpp"
#include "record/fields.hpp"
#include "record/series.hpp"
#include "record/step_log.hpp"
#include "scene/probes/probes.hpp"

namespace stiction::scene {

/// What stands in the files of a case.
struct RecordMark {
  record::SeriesMark series;
  record::FieldMark fields;
  std::uintmax_t steps = 0; ///< bytes of the log
  std::map<std::string, double> changes;
  template<class Archive> void visit(Archive& archive) {
    auto& [of_series, of_fields, bytes, counts] = *this;
    archive(of_series, of_fields, bytes, counts);
  }
};

/// The histories in a folder, to be gone on from. Throws Unfit where they cannot be read.
[[nodiscard]] record::SeriesData series_in(std::filesystem::path const& folder);

/// Contact problems of an earlier run, which are not those of this.
void remove_problems(std::filesystem::path const& folder);

class Recorder {
public:
  /// Into this folder, which exists. The scene must outlive it. from: what there is to go on from, or null.
  /// Throws Unfit where that is not there.
  Recorder(Scene const& scene, std::filesystem::path const& folder, RecordMark const* from = nullptr);
  /// Writes nothing: of a rank whose case another one writes.
  explicit Recorder(Scene const& scene, RecordMark const* from = nullptr);
  /// What stands now, once the histories are on the disk to stay.
  [[nodiscard]] RecordMark mark();
  /// A row of histories; dt in s.
  void step(dynamics::State const& state, double dt, int iterations, dynamics::StepError const& error = {});
  void frame(dynamics::State const& state);
  /// Returns the file, for messages; "" when there is no contact.
  [[nodiscard]] std::string problem(contact::Problem const& problem, std::string const& name) const;
  void change(record::StepChange const& change);
  /// How often the step was changed, and why it was cut.
  [[nodiscard]] std::map<std::string, double> const& changes() const { return changes_; }
  void close();

private:
  Scene const* scene_;
  std::filesystem::path folder_;
  struct Files {
    record::Series series;
    record::FieldSeries fields;
    record::StepLog log;
  };
  std::unique_ptr<Files> files_; ///< null: nothing is written
  std::map<std::string, double> changes_ = {
      {"cut_not_converged", 0}, {"cut_error", 0}, {"cut_beta_change", 0}, {"cut_event", 0}, {"grown", 0},
      {"at_floor", 0},          {"aimed", 0}};
  std::vector<Sampler> samplers_;
  std::vector<double> row_;
};

} // namespace stiction::scene
