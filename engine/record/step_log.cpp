// The lines of steps.csv.
#include "record/step_log.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <system_error>

#include "record/checkpoint_file.hpp"
#include "record/file.hpp"

namespace stiction::record {

namespace {

constexpr std::size_t at_once = 1 << 16; // characters

bool eventful(StepChange const& change) {
  bool const one_method = std::ranges::count(change.contact, ' ') <= 1; // "newton 3"
  return change.what != "step" || !change.cause.empty() || !change.reason.empty() || !one_method;
}

} // namespace

StepLog::StepLog(std::filesystem::path const& folder, std::uintmax_t bytes, Rows rows)
    : path_(folder / "steps.csv"), rows_(rows), any_(bytes > 0), bytes_(bytes) {
  std::error_code failed;
  if (!any_) {
    lines_ = "time_s,dt_s,next_dt_s,what,cause,reason,contact\n";
    std::filesystem::remove(path_, failed);
    return;
  }
  auto const there = std::filesystem::file_size(path_, failed);
  if (!failed && there >= bytes)
    std::filesystem::resize_file(path_, bytes, failed);
  if (failed || there < bytes)
    throw Unfit("has more lines than steps.csv");
}

void StepLog::add(StepChange const& change) {
  if (rows_ == Rows::eventful && !eventful(change))
    return;
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
  bytes_ += lines_.size();
  lines_.clear();
}

std::uintmax_t StepLog::mark() {
  write();
  return bytes_;
}

} // namespace stiction::record
