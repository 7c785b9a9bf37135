// Creation, growth and abandonment of a history file.
#include "record/history_file.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <limits>
#include <sys/mman.h>
#include <unistd.h>

#include "core/error.hpp"
#include "record/file.hpp"

namespace stiction::record {

using hdf5::Handle;

namespace {

/// Rows of a chunk: 1 KiB where columns are narrow, as every case pays a whole one for each of its columns;
/// enough that a new chunk, which touches the file's index, is rare.
hsize_t chunk_rows(std::size_t width) {
  return std::clamp<hsize_t>(256 / width, 32, 128);
}

Handle create_dataset(hid_t file, std::string const& name, std::size_t width) {
  std::array<hsize_t, 2> const size{0, width}, limit{H5S_UNLIMITED, width}, chunk{chunk_rows(width), width};
  int const rank = width == 1 ? 1 : 2;
  double const unwritten = std::numeric_limits<double>::quiet_NaN(); // tells the reader where a kill struck
  Handle const space(H5Screate_simple(rank, size.data(), limit.data()), H5Sclose);
  Handle const creation = hdf5::timeless(H5P_DATASET_CREATE);
  H5Pset_chunk(creation, rank, chunk.data());
  H5Pset_fill_value(creation, H5T_NATIVE_DOUBLE, &unwritten);
  return {H5Dcreate2(file, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, creation, H5P_DEFAULT),
          H5Dclose};
}

bool write_rows(hid_t dataset, hsize_t first, std::span<double const> values, std::size_t width) {
  hsize_t const rows = values.size() / width;
  std::array<hsize_t, 2> const size{first + rows, width}, start{first, 0}, count{rows, width};
  if (H5Dset_extent(dataset, size.data()) < 0)
    return false;
  Handle const target(H5Dget_space(dataset), H5Sclose);
  Handle const source(H5Screate_simple(width == 1 ? 1 : 2, count.data(), nullptr), H5Sclose);
  return H5Sselect_hyperslab(target, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) >= 0 &&
         H5Dwrite(dataset, H5T_NATIVE_DOUBLE, source, target, H5P_DEFAULT, values.data()) >= 0;
}

} // namespace

HistoryFile::HistoryFile(std::filesystem::path path) : path_(std::move(path)), part_(part_name(path_)) {
  hdf5::keep_reasons();
  file_ =
      Handle(H5Fcreate(part_.c_str(), H5F_ACC_TRUNC, hdf5::timeless(H5P_FILE_CREATE), hdf5::file_access()),
             H5Fclose);
  if (!file_.valid())
    throw unwritable(path_, hdf5::last_reason());
}

HistoryFile::~HistoryFile() {
  columns_.clear();
  hsize_t size = 0;
  bool const whole = file_.valid() && H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0 &&
                     H5Fget_filesize(file_, &size) >= 0 &&
                     ftruncate(descriptor(), static_cast<off_t>(size)) == 0; // what `reserve` added
  if (file_.valid() && !whole)
    abandon();
  file_ = {};
  if (!published_)
    unlink(part_.c_str());
}

void HistoryFile::add_column(std::string const& name, int width, std::string const& unit,
                             std::string const& meaning) {
  auto const size = static_cast<std::size_t>(width);
  if (auto const slash = name.rfind('/'); slash != std::string::npos && slash > 0)
    require(open_group(name.substr(0, slash)).valid());
  columns_.push_back({create_dataset(file_, name, size), size});
  Handle const& dataset = columns_.back().handle;
  require(dataset.valid());
  require(hdf5::write_attribute(dataset, "unit", unit) && hdf5::write_attribute(dataset, "meaning", meaning));
}

/// Opens "a/b", making what is missing of the way.
Handle HistoryFile::open_group(std::string const& group) {
  Handle here(H5Gopen2(file_, "/", H5P_DEFAULT), H5Gclose);
  for (std::size_t begin = 0; begin < group.size();) {
    std::size_t const end = std::min(group.find('/', begin), group.size());
    std::string const name = group.substr(begin, end - begin);
    here = H5Lexists(here, name.c_str(), H5P_DEFAULT) > 0
               ? Handle(H5Gopen2(here, name.c_str(), H5P_DEFAULT), H5Gclose)
               : Handle(H5Gcreate2(here, name.c_str(), H5P_DEFAULT, hdf5::timeless(H5P_GROUP_CREATE),
                                   H5P_DEFAULT),
                        H5Gclose);
    begin = end + 1;
  }
  return here;
}

void HistoryFile::set_attribute(std::string const& group, std::string const& name, std::string const& text) {
  Handle const object = open_group(group);
  require(object.valid() && hdf5::write_attribute(object, name, text));
}

void HistoryFile::set_attribute(std::string const& group, std::string const& name, double value) {
  Handle const object = open_group(group);
  require(object.valid() && hdf5::write_attribute(object, name, value));
}

void HistoryFile::write(std::size_t column, std::span<double const> values) {
  auto const& [dataset, width] = columns_.at(column);
  pending_ += values.size_bytes();
  require(write_rows(dataset, committed_, values, width));
}

/// HDF5 writes the file's new end into its first block before it lengthens the file: lengthen it first, so
/// that neither a kill in between nor a full disk leaves a file shorter than it says.
void HistoryFile::reserve() {
  constexpr hsize_t margin = hsize_t{1024} * 1024; // more than one commit allocates beside its values
  hsize_t size = 0;
  H5Fget_filesize(file_, &size);
  if (int const failed = posix_fallocate(descriptor(), 0, static_cast<off_t>(size + pending_ + margin)))
    give_up(std::strerror(failed));
  pending_ = 0;
}

void HistoryFile::commit(std::size_t rows) {
  reserve();
  require(H5Fflush(file_, H5F_SCOPE_GLOBAL) >= 0);
  committed_ += rows;
  if (!published_)
    publish();
}

void HistoryFile::sync() {
  if (fdatasync(descriptor()) != 0 && errno != EINVAL) // EINVAL: a file that knows no such thing
    give_up(std::strerror(errno));
}

void HistoryFile::publish() {
  std::error_code error;
  std::filesystem::rename(part_, path_, error);
  if (error)
    throw unwritable(path_, error.message());
  published_ = true;
}

void HistoryFile::require(bool held) {
  if (held)
    return;
  give_up(hdf5::last_reason());
}

void HistoryFile::give_up(std::string const& reason) {
  abandon();
  throw unwritable(path_, reason);
}

int HistoryFile::descriptor() const {
  void* found = nullptr;
  if (H5Fget_vfd_handle(file_, H5P_DEFAULT, &found) < 0 || found == nullptr)
    throw core::Bug("no file descriptor below the HDF5 file");
  return *static_cast<int*>(found);
}

/// Puts a memory file under HDF5's descriptor: the library can then close in peace, what is on disk stays.
void HistoryFile::abandon() {
  int const memory = memfd_create("abandoned history", MFD_CLOEXEC);
  if (memory < 0)
    return;
  dup2(memory, descriptor());
  close(memory);
}

} // namespace stiction::record
