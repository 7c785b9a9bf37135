// The two verbs of a scene: read it from a script's table, run it into an output folder.
#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/input.hpp"
#include "linear/ranks.hpp"
#include "record/checkpoint_file.hpp"
#include "scene/explain/explain.hpp"

namespace stiction::scene {

/// A snapshot of a running case, for the progress line.
struct Progress {
  double time = 0, end_time = 0, dt = 0; ///< s, of the simulated problem
  long step = 0, iterations = 0;         ///< iterations of the last step
  int open = 0, stick = 0, slip = 0;     ///< contact points
  double seconds = 0, seconds_left = 0;  ///< of the machine
};

/// Where a case stands, kept on the way and when it is stopped: the next run of it goes on from there, to the
/// last bit as if it had not been stopped.
struct Keeping {
  std::filesystem::path file; ///< the checkpoint; empty: none is kept, and none taken up
  record::CheckpointOwner owner;
  double every = 600;                           ///< s of the clock; 0: after every step
  bool anew = false;                            ///< what is kept is not taken up
  std::function<void(std::string const&)> tell; ///< one line on what was taken up, or why it was not
};

/// The scene of a case with one parameter a little different.
struct Shifted {
  std::string name; ///< of the parameter
  core::Input scene;
};

/// What became of the run beside a case's own that one parameter's derivatives come from.
struct BesideResult {
  std::string name;    ///< of the parameter
  long steps = 0;      ///< that it followed
  long turned = 0;     ///< of them, at whose ends some point's status is another
  long rough = 0;      ///< of them, which the case itself left so far out of balance that it shows
  long iterations = 0; ///< of its own
  std::string ended;   ///< why it was left before the case's end; empty: it was not
};

struct RunOptions {
  std::filesystem::path out; ///< the case's folder, made if missing
  std::string case_id;
  std::string manifest_json; ///< study part of the manifest (parameters given/chosen, ...), a JSON object
  std::function<void(Progress const&)> progress;
  std::atomic<bool> const* stop = nullptr; ///< set by a signal: the run ends with verdict "stopped"
  Keeping keeping;
  int threads = 1; ///< that share its loops; its numbers do not depend on how many
  /// The processes that share the case, each of which runs it: the first writes its files; or null.
  linear::Ranks const* ranks = nullptr;
  /// Runs beside the case's own, for derivatives; its steps then end with a factor of where they end.
  std::vector<Shifted> beside;
  /// For tests: stopped when the run has asked so often whether it is to stop, within steps too; 0: never.
  long stop_after = 0;
  /// For tests: every so many steps is first made and thrown away, then made again; 0: none.
  int rehearse = 0;
  /// Measure at the end what passes, factorizations and solutions take alone: counters alone_force_pass, ...
  /// s.
  bool alone = false;
};

struct RunResult {
  std::string verdict;  ///< "finished", "stopped" (by the user or by schedule.seconds), "not converged",
                        ///< "unstable" (not even begun), "output failed"
  std::string reason;   ///< one sentence, empty when finished
  bool goes_on = false; ///< not ended: what its checkpoint holds is to be kept
  long continued = 0;   ///< times that it was taken up
  std::vector<Warning> warnings; ///< known before the first step
  std::vector<std::string>
      remarks; ///< no single answer by theory, energy made or lost: one sentence per kind
  long steps = 0, iterations = 0, factorizations = 0, cuts = 0;
  std::string contact; ///< what answered its contact problems, and how many each: "sweeps 40 newton 2"
  double seconds = 0;
  std::map<std::string, double>
      phases; ///< processor seconds per phase: assembly, factorization, contact, solve, output
  std::vector<BesideResult> beside;       ///< in the order asked for
  std::map<std::string, double> counters; ///< cells evaluated, contact iterations, peak memory (bytes) ...
};

/// Checks the scene without running it. Throws InputError with every complaint.
void validate(core::Input const& scene);

/// Builds and runs. Throws InputError for bad input; numerical failure is a verdict.
[[nodiscard]] RunResult run(core::Input const& scene, RunOptions const& options);

} // namespace stiction::scene
