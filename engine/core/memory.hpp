// Memory that ran out, with what it was asked for.
#pragma once
#include <new>
#include <string>

namespace stiction::core {

/// A std::bad_alloc that says for what: "for the factor of 4000 unknowns, 1.2 GB". Ends in exit code 1.
class OutOfMemory : public std::bad_alloc {
public:
  explicit OutOfMemory(std::string purpose) : purpose_(std::move(purpose)) {}
  [[nodiscard]] char const* what() const noexcept override { return purpose_.c_str(); }

private:
  std::string purpose_;
};

} // namespace stiction::core
