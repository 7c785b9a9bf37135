// Wording of the errors declared in error.hpp.
#include "core/error.hpp"

#include <fmt/format.h>

namespace stiction::core {

namespace {
std::string join(Complaints const& complaints) {
  std::string text;
  for (auto const& complaint : complaints) {
    if (!text.empty())
      text += '\n';
    text += complaint.message();
  }
  return text;
}
} // namespace

std::string Complaint::message() const {
  std::string message;
  for (auto const& part : {place, path})
    if (!part.empty())
      message.append(part).append(": ");
  return message.append(text);
}

InputError::InputError(Complaints complaints)
    : std::runtime_error(join(complaints)), complaints_(std::move(complaints)) {}

void fail_expectation(char const* what, std::source_location where) {
  throw Bug(
      fmt::format("defect in stiction: expected {} ({}:{}); please report it with the script that led here",
                  what, where.file_name(), where.line()));
}

} // namespace stiction::core
