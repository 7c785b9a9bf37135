// Asks the probes for their columns and explain for its warnings; nothing is assembled or written.
#include "scene/explain/preview.hpp"

#include "scene/explain/facts.hpp"
#include "scene/probes/probes.hpp"

namespace stiction::scene {

std::vector<Warning> warnings_of(Scene const& scene, dynamics::State const& start) {
  Explanation explanation;
  add_warnings(facts_of(scene, start), explanation);
  return std::move(explanation.warnings);
}

Preview preview(core::Input const& input) {
  auto const scene = build(input);
  record::Series series; // no file
  add_step_columns(scene, series);
  static_cast<void>(add_probes(scene, series));
  Preview preview;
  for (auto const& [name, width] : series.names())
    preview.columns.push_back({name, width});
  preview.end = scene.part.schedule.stages.back().until;
  dynamics::Stepper stepper(*scene.model, dynamics::Purpose::beginning);
  preview.unfit_for_ranks = unfit_for_ranks(scene);
  preview.warnings = warnings_of(scene, stepper.initial());
  return preview;
}

} // namespace stiction::scene
