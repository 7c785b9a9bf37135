// Owning handles for HDF5 identifiers, and the few calls that writer and reader of histories share.
#pragma once
#include <hdf5.h>
#include <string>
#include <utility>

namespace stiction::record::hdf5 {

/// An identifier with the function that closes it. A negative identifier is a failed call.
class Handle {
public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  Handle(hid_t id, Close close) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
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
  operator hid_t() const { return id_; } // NOLINT: the C API takes identifiers everywhere

private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// HDF5 prints its error stack by default; from here on the reason is kept for `last_reason` instead.
void keep_reasons();

/// File access that leaves a killed file readable (V18 bounds) and lets others read it meanwhile (no lock).
[[nodiscard]] Handle file_access();

/// The system's reason ("No space left on device") of the last failed call, or "reason unknown".
[[nodiscard]] std::string last_reason();

/// Writes an attribute of `object`; false when the file cannot be written.
[[nodiscard]] bool write_attribute(hid_t object, std::string const& name, std::string const& text);
[[nodiscard]] bool write_attribute(hid_t object, std::string const& name, double value);

/// A string attribute of `object`, "" when there is none.
[[nodiscard]] std::string read_attribute(hid_t object, char const* name);

} // namespace stiction::record::hdf5
