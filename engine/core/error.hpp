// What can go wrong, as types: input errors with a place, and expectations that guard against our own bugs.
#pragma once
#include <source_location>
#include <stdexcept>
#include <string>
#include <vector>

namespace stiction::core {

/// One thing wrong with what the user gave.
struct Complaint {
  std::string place; ///< "study.lua:12" or a file name; may be empty
  std::string path;  ///< "bodies.plate.material.density"; may be empty
  std::string text;  ///< value, unit, admissible range and remedy
  [[nodiscard]] std::string message() const;
};
using Complaints = std::vector<Complaint>;

/// Bad input: every problem found, not only the first. Ends in exit code 2.
class InputError : public std::runtime_error {
public:
  explicit InputError(Complaints complaints);
  explicit InputError(std::string const& text) : InputError(Complaints{{"", "", text}}) {}
  [[nodiscard]] Complaints const& complaints() const { return complaints_; }

private:
  Complaints complaints_;
};

/// The run could not go on for a reason outside the input (disk full, output vanished). Ends in exit code 1.
class RunError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A defect of this program, found by one of its own expectations.
class Bug : public std::logic_error {
  using std::logic_error::logic_error;
};

[[noreturn]] void fail_expectation(char const* what, std::source_location where);

/// Checks an assumption of ours, in release too.
inline void expect(bool held, char const* what,
                   std::source_location where = std::source_location::current()) {
  if (!held) [[unlikely]]
    fail_expectation(what, where);
}

} // namespace stiction::core
