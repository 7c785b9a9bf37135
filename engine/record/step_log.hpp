// Every step of a run and every change of its size, with its reason, as a table of text.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace stiction::record {

/// The attempt from `time` with `dt`, what came of it, the size thought of next.
struct StepChange {
  double time = 0, dt = 0, next_dt = 0; ///< s
  /// "step" (accepted), "cut" (taken again, shorter), "grown" (the next one), "at_floor" (no shorter one is
  /// allowed), "aimed" (shorter this once, to end at an event)
  std::string what;
  std::string cause;  ///< one word
  std::string reason; ///< a sentence, may be empty
  /// Of a step or a cut: what answered its contact problems, and how many each, "sweeps 3 newton 1"
  std::string contact;
};

/// Writes them as steps.csv: time_s,dt_s,next_dt_s,what,cause,reason,contact.
class StepLog {
public:
  enum class Rows {
    all,
    eventful ///< none of accepted steps whose contact problems all were answered by one method
  };
  /// Removes the table of an earlier run but for its first bytes, to be gone on from. Throws Unfit if it is
  /// shorter.
  explicit StepLog(std::filesystem::path const& folder, std::uintmax_t bytes = 0, Rows rows = Rows::all);
  /// Throws core::RunError, as many lines go to the file at a time.
  void add(StepChange const& change);
  /// Writes what is left; no file without a line. Throws core::RunError.
  void write();
  /// Writes what is left; bytes of the file. Throws core::RunError.
  [[nodiscard]] std::uintmax_t mark();

private:
  std::filesystem::path path_;
  Rows rows_;
  std::string lines_;        ///< not yet on disk
  bool any_ = false;         ///< beside the head
  std::uintmax_t bytes_ = 0; ///< on disk
};

} // namespace stiction::record
