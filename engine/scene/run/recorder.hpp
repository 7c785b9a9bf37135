// Everything that a case writes while it runs: histories, fields, the log of its steps, saved problems.
#pragma once
#include <filesystem>
#include <memory>

#include "record/fields.hpp"
#include "record/series.hpp"
#include "record/step_log.hpp"
#include "scene/probes/probes.hpp"
#include "scene/run/changes.hpp"

namespace stiction::scene {

/// What stands in the files of a case.
struct RecordMark {
  record::SeriesMark series;
  record::FieldMark fields;
  std::uintmax_t steps = 0; ///< bytes of the log
  ChangeCounts changes;
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
  [[nodiscard]] ChangeCounts const& changes() const { return changes_; }
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
  ChangeCounts changes_ = no_changes();
  std::vector<Sampler> samplers_;
  std::vector<double> row_;
};

} // namespace stiction::scene
