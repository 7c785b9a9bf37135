// The two verbs of a scene: read it from a script's table, run it into an output folder.
#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/input.hpp"
#include "scene/explain/explain.hpp"

namespace stiction::scene {

/// A snapshot of a running case, for the progress line.
struct Progress {
  double time = 0, end_time = 0, dt = 0; ///< s, of the simulated problem
  long step = 0, iterations = 0;         ///< iterations of the last step
  int open = 0, stick = 0, slip = 0;     ///< contact points
  double seconds = 0, seconds_left = 0;  ///< of the machine
};

struct RunOptions {
  std::filesystem::path out; ///< the case's folder, made if missing
  std::string case_id;
  std::string manifest_json; ///< study part of the manifest (parameters given/chosen, ...), a JSON object
  std::function<void(Progress const&)> progress;
  std::atomic<bool> const* stop = nullptr; ///< set by a signal: the run ends with verdict "stopped"
  /// For tests: every so many steps is first made and thrown away, then made again; 0: none.
  int rehearse = 0;
  /// Measure at the end what passes, factorizations and solutions take alone: counters alone_force_pass, ...
  /// s.
  bool alone = false;
};

struct RunResult {
  std::string verdict; ///< "finished", "stopped" (by the user or by schedule.seconds), "not converged",
                       ///< "unstable" (not even begun), "output failed"
  std::string reason;  ///< one sentence, empty when finished
  std::vector<Warning> warnings; ///< known before the first step
  std::vector<std::string>
      remarks; ///< no single answer by theory, energy made or lost: one sentence per kind
  long steps = 0, iterations = 0, factorizations = 0, cuts = 0;
  std::string contact; ///< what answered its contact problems, and how many each: "sweeps 40 newton 2"
  double seconds = 0;
  std::map<std::string, double>
      phases; ///< processor seconds per phase: assembly, factorization, contact, solve, output
  std::map<std::string, double> counters; ///< cells evaluated, contact iterations, peak memory (bytes) ...
};

/// Checks the scene without running it. Throws InputError with every complaint.
void validate(core::Input const& scene);

/// Builds and runs. Throws InputError for bad input; numerical failure is a verdict.
[[nodiscard]] RunResult run(core::Input const& scene, RunOptions const& options);

} // namespace stiction::scene
