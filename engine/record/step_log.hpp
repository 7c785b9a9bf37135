// Every change of the step of a run, with its reason, as a table of text.
#pragma once
#include <filesystem>
#include <string>

namespace stiction::record {

/// One change: the attempt from `time` with `dt`, what came of it, the size thought of next.
struct StepChange {
  double time = 0, dt = 0, next_dt = 0; ///< s
  /// "cut" (taken again, shorter), "grown" (the next one), "at_floor" (no shorter one is allowed), "aimed"
  /// (shorter this once, to end at an event)
  std::string what;
  std::string cause;  ///< one word
  std::string reason; ///< a sentence, may be empty
};

/// Collects changes and writes them as steps.csv: time_s,dt_s,next_dt_s,what,cause,reason.
class StepLog {
public:
  /// Removes the table of an earlier run.
  explicit StepLog(std::filesystem::path const& folder);
  void add(StepChange const& change);
  /// Writes what there is; no file without a change. Throws core::RunError.
  void write() const;

private:
  std::filesystem::path path_;
  std::string lines_;
};

} // namespace stiction::record
