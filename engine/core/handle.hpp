// An identifier of a C library, as HDF5 gives them, that closes itself.
#pragma once
#include <cstdint>
#include <utility>

namespace stiction::core {

/// An identifier with the function that closes it. A negative identifier is a failed call.
class Handle {
public:
  using Close = int (*)(std::int64_t);
  Handle() = default;
  Handle(std::int64_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  Handle(Handle const&) = delete;
  Handle& operator=(Handle const&) = delete;
  ~Handle() {
    if (id_ >= 0)
      close_(id_);
  }
  [[nodiscard]] bool valid() const { return id_ >= 0; }
  operator std::int64_t() const { return id_; } // NOLINT: the C API takes identifiers everywhere

private:
  std::int64_t id_ = -1;
  Close close_ = nullptr;
};

} // namespace stiction::core
