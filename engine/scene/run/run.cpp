// Runs a scene pass by pass, each on finer meshes if asked for, from where its checkpoint stands.
#include "scene/run/run.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

#include "core/threads.hpp"
#include "record/file.hpp"
#include "record/manifest.hpp"
#include "scene/run/formula_run.hpp"
#include "scene/run/half_space_run.hpp"
#include "scene/run/manifest.hpp"
#include "scene/run/pass.hpp"

namespace stiction::scene {

namespace {

/// One pass into the folder, on the meshes that the scene has.
RunResult run_once(Run& running, Checkpoint const& checkpoint) {
  try {
    return running.go();
  } catch (core::RunError const& error) {
    auto result = running.finish();
    result.verdict = "output failed";
    result.reason = error.what();
    result.goes_on = checkpoint.stands();
    return result;
  }
}

/// Makes the run of the story's pass, as far as it has come; false, and the story is a new one, if its
/// checkpoint does not fit.
bool take_up(std::optional<Run>& running, Scene const& scene, RunOptions const& options,
             Checkpoint& checkpoint, Story& story) {
  auto const mesh = mesh_checksum(*scene.model);
  try {
    if (story.under_way && story.mesh != mesh)
      throw record::Unfit("goes with other meshes");
    story.mesh = mesh;
    running.emplace(scene, options, checkpoint, story);
  } catch (record::Unfit const& unfit) {
    checkpoint.refuse(unfit.what());
    story = Story::anew();
    return false;
  }
  if (story.under_way || story.pass > 1)
    story.go_on(running->time(), running->steps(), checkpoint);
  return true;
}

/// What the meshes were and are to be, into the manifest and the counters.
void tell_of_meshes(MeshControl const& control, Story& story, RunResult& result, nlohmann::json& manifest) {
  story.cells_evaluated += result.counters["cells_evaluated"];
  result.counters["mesh_passes"] = story.pass;
  result.counters["mesh_error"] = control.error();
  result.counters["cells_evaluated_in_all_passes"] = story.cells_evaluated;
  auto meshes = nlohmann::json::parse(story.meshes);
  meshes.push_back({{"cells", result.counters["cells"]}, {"error", control.error()}});
  manifest["remeshed"] = meshes;
  story.meshes = meshes.dump();
  std::ranges::copy(control.doubts(), std::back_inserter(result.remarks));
}

/// The scene with these sizes of cells; where the mesher makes one of them that is no good, with others near
/// them.
Scene meshed(core::Input const& input, CellSizes const& sizes, linear::Ranks const* ranks,
             core::Input& asked) {
  std::string reason;
  for (double const factor : {1.0, 1.07, 0.93, 1.15, 0.86}) {
    auto near = sizes;
    for (auto& [name, numbers] : near)
      for (std::size_t i = 2; i < numbers.size(); i += 3)
        numbers[i] *= factor;
    asked = with_sizes(input, near);
    try {
      return build(asked, ranks);
    } catch (core::InputError const& error) {
      if (sizes.empty())
        throw;
      reason = error.what();
    }
  }
  throw core::RunError(fmt::format("no sound mesh was made of the sizes that remesh asks for: {}", reason));
}

} // namespace

void validate(core::Input const& scene) {
  static_cast<void>(build(scene));
}

RunResult run(core::Input const& input, RunOptions const& options) {
  core::use_threads(options.threads);
  keep_pages(1 << 25); // larger ones are few, and would leave holes behind
  Checkpoint checkpoint(options.keeping);
  auto story = checkpoint.open();
  AllRanks const ranks(options.ranks);
  if (bool const there = story.under_way; !ranks.same(there ? story.pass : 0)) {
    if (there)
      checkpoint.refuse("is not there for all ranks: they share no file system");
    story = Story::anew();
  }
  for (;;) {
    core::Input asked;
    auto scene = meshed(input, story.sizes, options.ranks, asked);
    ready_for(options.beside, scene);
    if (scene.formula)
      return run_formula(asked, scene, options, story);
    if (scene.half_space)
      return run_half_space(asked, scene, options, checkpoint, story);
    if (ranks.writes())
      record::prepare_output(options.out);
    if (ranks.writes() && !story.under_way)
      remove_runs_beside(options.out);
    std::optional<Run> running;
    if (!take_up(running, scene, options, checkpoint, story))
      continue;
    auto manifest = manifest_of(asked, scene, options, story, running->warnings());
    if (ranks.writes())
      record::write_manifest(options.out / "manifest.json", manifest);
    auto result = run_once(*running, checkpoint);
    if (options.alone && result.verdict == "finished")
      for (auto const& [name, seconds] : running->alone())
        result.counters["alone_" + name] = seconds;
    result.warnings = running->warnings();
    auto const& control = running->meshes();
    bool const last = result.verdict != "finished" || control.fine_enough() || story.pass >= control.passes();
    if (control.wanted())
      tell_of_meshes(control, story, result, manifest);
    story.add_remarks(result.remarks);
    result.continued = static_cast<long>(story.continued.size());
    if (!result.remarks.empty())
      manifest["remarks"] = result.remarks;
    manifest["ended"] = record::utc_now();
    if (ranks.writes() && result.verdict != "output failed")
      record::write_manifest(options.out / "manifest.json", manifest);
    if (last)
      return result;
    story.begin_pass(control.sizes());
    if (ranks.writes())
      checkpoint.keep(story);
  }
}

} // namespace stiction::scene
