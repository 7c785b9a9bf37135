// What is told of a step whose size followed from its error.
#pragma once
#include <map>
#include <vector>

#include "dynamics/adaptivity/pace.hpp"
#include "record/step_log.hpp"

namespace stiction::scene {

/// How often steps were changed, and why they were cut.
using ChangeCounts = std::map<std::string, double>;
[[nodiscard]] inline ChangeCounts no_changes() {
  return {{"cut_not_converged", 0}, {"cut_error", 0}, {"cut_beta_change", 0}, {"cut_event", 0}, {"grown", 0},
          {"at_floor", 0},          {"aimed", 0}};
}
inline void count(record::StepChange const& change, ChangeCounts& counts) {
  if (change.what != "step")
    ++counts[change.what == "cut" ? "cut_" + change.cause : change.what];
}

/// Of an attempt from `time` with `dt`, s.
[[nodiscard]] inline std::vector<record::StepChange>
changes(dynamics::StepSizes const& sizes, dynamics::Decision const& decision, double time, double dt) {
  std::vector<record::StepChange> told;
  auto const tell = [&](char const* what, char const* cause, std::string const& reason) {
    told.push_back({time, dt, sizes.wanted(), what, cause, reason, ""});
  };
  if (!decision.accepted()) {
    tell("cut", name_of(decision.cut), decision.reason);
    return told;
  }
  if (!sizes.aim().empty())
    tell("aimed", "event", sizes.aim());
  if (decision.at_floor)
    tell("at_floor", "smallest", decision.reason);
  else if (decision.grown)
    tell("grown", "error", decision.reason);
  return told;
}

inline constexpr char const* no_error_seen =
    "without inertia, bonds or events no error is seen by `accuracy`: steps grow to its `largest`; give the "
    "stages their steps, and no accuracy";

} // namespace stiction::scene
