// The few calls to HDF5 that writer and reader of histories share.
#pragma once
#include <hdf5.h>
#include <string>

#include "core/handle.hpp"

namespace stiction::record::hdf5 {

using core::Handle;

/// HDF5 prints its error stack by default; from here on the reason is kept for `last_reason` instead.
void keep_reasons();

/// File access that leaves a killed file readable (V18 bounds) and lets others read it meanwhile (no lock).
[[nodiscard]] Handle file_access();
/// Creation without time stamps: equal runs give equal files. `kind` is H5P_FILE_CREATE, ...
[[nodiscard]] Handle timeless(hid_t kind);

/// The system's reason ("No space left on device") of the last failed call, or "reason unknown".
[[nodiscard]] std::string last_reason();

/// Writes an attribute of `object`; false when the file cannot be written.
[[nodiscard]] bool write_attribute(hid_t object, std::string const& name, std::string const& text);
[[nodiscard]] bool write_attribute(hid_t object, std::string const& name, double value);

/// A string attribute of `object`, "" when there is none.
[[nodiscard]] std::string read_attribute(hid_t object, char const* name);

} // namespace stiction::record::hdf5
