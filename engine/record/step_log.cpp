// The lines of steps.csv.
#include "record/step_log.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

#include "record/file.hpp"

namespace stiction::record {

namespace {
constexpr std::size_t at_once = 1 << 16; // characters
}

StepLog::StepLog(std::filesystem::path const& folder)
    : path_(folder / "steps.csv"), lines_("time_s,dt_s,next_dt_s,what,cause,reason,contact\n") {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void StepLog::add(StepChange const& change) {
  std::string reason = change.reason;
  std::ranges::replace(reason, '"', '\'');
  lines_ += fmt::format("{},{},{},{},{},\"{}\",{}\n", change.time, change.dt, change.next_dt, change.what,
                        change.cause, reason, change.contact);
  any_ = true;
  if (lines_.size() >= at_once)
    write();
}

void StepLog::write() {
  if (!any_ || lines_.empty())
    return;
  append_file(path_, lines_);
  lines_.clear();
}

} // namespace stiction::record
