// HDF5 file access, reasons of failure and attributes.
#include "record/hdf5.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>

namespace stiction::record::hdf5 {

namespace {

/// HDF5 may fail to close a file whose disk is full, and then must not try again, and crash, at exit. Said
/// before its first use, that is before main.
[[maybe_unused]] bool const no_closing_at_exit = H5dont_atexit() >= 0;

thread_local int reason_number = 0; ///< errno of the last failed call, 0 when it had none

/// HDF5 words a failed system call as "..., errno = 28, error message = ...".
herr_t find_errno(unsigned, H5E_error2_t const* error, void* found) {
  constexpr char const* key = "errno = ";
  if (error->desc != nullptr)
    if (char const* at = std::strstr(error->desc, key))
      *static_cast<int*>(found) = std::atoi(at + std::strlen(key)); // NOLINT: 0 when it is not a number
  return 0;
}

/// Called by HDF5 when a call of its interface fails: later calls, even closing, clear its error stack.
herr_t keep_reason(hid_t stack, void*) {
  reason_number = 0;
  return H5Ewalk2(stack, H5E_WALK_UPWARD, find_errno, &reason_number);
}

bool write_value(hid_t object, std::string const& name, hid_t type, void const* value) {
  if (H5Aexists(object, name.c_str()) > 0 && H5Adelete(object, name.c_str()) < 0)
    return false;
  Handle const space(H5Screate(H5S_SCALAR), H5Sclose);
  Handle const attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  return attribute.valid() && H5Awrite(attribute, type, value) >= 0;
}

} // namespace

void keep_reasons() {
  H5Eset_auto2(H5E_DEFAULT, keep_reason, nullptr);
}

Handle file_access() {
  constexpr hsize_t block = hsize_t{256} * 1024; // the file grows by blocks: fewer changes of its end
  Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18);
  H5Pset_fclose_degree(access, H5F_CLOSE_STRONG);
  H5Pset_file_locking(access, false, true);
  H5Pset_small_data_block_size(access, block);
  H5Pset_meta_block_size(access, 0); // closing gives a reserve back: a kill then found the file cut short
  return access;
}

Handle timeless(hid_t kind) {
  Handle creation(H5Pcreate(kind), H5Pclose);
  H5Pset_obj_track_times(creation, false);
  return creation;
}

std::string last_reason() {
  return reason_number != 0 ? std::strerror(reason_number) : "reason unknown";
}

bool write_attribute(hid_t object, std::string const& name, std::string const& text) {
  Handle const type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type, text.size() + 1);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return write_value(object, name, type, text.c_str());
}

bool write_attribute(hid_t object, std::string const& name, double value) {
  return write_value(object, name, H5T_NATIVE_DOUBLE, &value);
}

std::string read_attribute(hid_t object, char const* name) {
  Handle const attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  if (!attribute.valid())
    return {};
  Handle const type(H5Aget_type(attribute), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING)
    return {};
  Handle const space(H5Aget_space(attribute), H5Sclose);
  if (!space.valid() || H5Sget_simple_extent_npoints(space) != 1)
    return {};                        // an array of texts
  if (H5Tis_variable_str(type) > 0) { // as Python's h5py writes them
    char* kept = nullptr;
    bool const held = H5Aread(attribute, type, &kept) >= 0 && kept != nullptr;
    std::string text = held ? kept : "";
    H5free_memory(kept);
    return text;
  }
  std::string text(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, text.data()) < 0)
    return {};
  return text.c_str(); // up to the terminating zero
}

} // namespace stiction::record::hdf5
