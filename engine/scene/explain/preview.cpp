// Asks the probes for their columns and explain for its warnings; nothing is assembled or written.
#include "scene/explain/preview.hpp"

#include "scene/explain/explain_half_space.hpp"
#include "scene/explain/facts.hpp"
#include "scene/probes/half_space_probes.hpp"

namespace stiction::scene {

std::vector<Warning> warnings_of(Scene const& scene, dynamics::State const& start) {
  Explanation explanation;
  add_warnings(facts_of(scene, start), explanation);
  return std::move(explanation.warnings);
}

std::vector<Warning> warnings_of(Scene const& scene) {
  if (scene.formula) // it has no grid
    return {};
  return explain_half_space(scene).warnings;
}

Preview preview(core::Input const& input) {
  auto const scene = build(input);
  record::Series series; // no file
  add_step_columns(scene, series);
  add_columns(scene, columns_of(series));
  Preview preview;
  for (auto const& [name, width] : series.names())
    preview.columns.push_back({name, width});
  preview.end = scene.part.schedule.stages.back().until;
  preview.unfit_for_ranks = unfit_for_ranks(scene);
  if (scene.half_space) {
    preview.warnings = warnings_of(scene);
    return preview;
  }
  dynamics::Stepper stepper(*scene.model, dynamics::Purpose::beginning);
  preview.warnings = warnings_of(scene, stepper.initial());
  return preview;
}

} // namespace stiction::scene
