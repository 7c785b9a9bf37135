// The lines of steps.csv.
#include "record/step_log.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

#include "record/file.hpp"

namespace stiction::record {

StepLog::StepLog(std::filesystem::path const& folder) : path_(folder / "steps.csv") {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void StepLog::add(StepChange const& change) {
  std::string reason = change.reason;
  std::ranges::replace(reason, '"', '\'');
  lines_ += fmt::format("{},{},{},{},{},\"{}\"\n", change.time, change.dt, change.next_dt, change.what,
                        change.cause, reason);
}

void StepLog::write() const {
  if (!lines_.empty())
    replace_file(path_, "time_s,dt_s,next_dt_s,what,cause,reason\n" + lines_);
}

} // namespace stiction::record
