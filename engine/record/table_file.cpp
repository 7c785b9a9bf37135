// Writes a table to HDF5: one compound dataset, and one dataset per column.
#include "record/table_file.hpp"

#include <algorithm>
#include <cstring>

#include "core/error.hpp"
#include "record/file.hpp"
#include "record/hdf5.hpp"

namespace stiction::record {

using hdf5::Handle;

namespace {

constexpr hsize_t largest_chunk = 1024; // rows

/// Type and bytes of a column; texts are filled up with zeros to the length of the longest.
struct Packed {
  Handle type;
  std::size_t width = sizeof(double);
  std::vector<char> bytes; ///< [rows, width]
};

Packed pack(TableColumn const& column, std::size_t rows) {
  bool const numeric = column.texts.empty();
  core::expect((numeric ? column.numbers.size() : column.texts.size()) == rows, "columns of one length");
  Packed packed;
  if (numeric) {
    packed.type = Handle(H5Tcopy(H5T_IEEE_F64LE), H5Tclose);
    packed.bytes.resize(rows * packed.width);
    if (rows > 0)
      std::memcpy(packed.bytes.data(), column.numbers.data(), packed.bytes.size());
    return packed;
  }
  packed.width = 1;
  for (auto const& text : column.texts)
    packed.width = std::max(packed.width, text.size());
  packed.type = Handle(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(packed.type, packed.width);
  H5Tset_strpad(packed.type, H5T_STR_NULLPAD);
  H5Tset_cset(packed.type, H5T_CSET_UTF8);
  packed.bytes.resize(rows * packed.width);
  for (std::size_t i = 0; i < rows; ++i)
    std::ranges::copy(column.texts[i], packed.bytes.begin() + static_cast<std::ptrdiff_t>(i * packed.width));
  return packed;
}

/// A chunked dataset of `rows` rows of `type`, written; an invalid handle where that fails.
Handle write_rows(hid_t file, std::string const& name, hid_t type, hsize_t rows, void const* bytes) {
  hsize_t const chunk = std::clamp<hsize_t>(rows, 1, largest_chunk);
  Handle const space(H5Screate_simple(1, &rows, nullptr), H5Sclose);
  Handle const layout = hdf5::timeless(H5P_DATASET_CREATE);
  H5Pset_chunk(layout, 1, &chunk);
  Handle const links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
  H5Pset_create_intermediate_group(links, 1);
  H5Pset_char_encoding(links, H5T_CSET_UTF8);
  Handle set(H5Dcreate2(file, name.c_str(), type, space, links, layout, H5P_DEFAULT), H5Dclose);
  if (set.valid() && rows > 0 && H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes) < 0)
    return {};
  return set;
}

bool write_columns(hid_t file, std::vector<TableColumn> const& columns, std::vector<Packed> const& packed,
                   std::size_t rows) {
  for (std::size_t k = 0; k < columns.size(); ++k) {
    auto const set =
        write_rows(file, "columns/" + columns[k].name, packed[k].type, rows, packed[k].bytes.data());
    if (!set.valid() || !hdf5::write_attribute(set, "unit", columns[k].unit) ||
        !hdf5::write_attribute(set, "meaning", columns[k].meaning))
      return false;
  }
  return true;
}

bool write_whole(hid_t file, std::string const& name, std::vector<TableColumn> const& columns,
                 std::vector<Packed> const& packed, std::size_t rows) {
  std::size_t width = 0;
  for (auto const& column : packed)
    width += column.width;
  Handle const type(H5Tcreate(H5T_COMPOUND, width), H5Tclose);
  std::vector<char> bytes(rows * width);
  std::size_t offset = 0;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    auto const& own = packed[k];
    H5Tinsert(type, columns[k].name.c_str(), offset, own.type);
    for (std::size_t i = 0; i < rows; ++i)
      std::memcpy(&bytes[i * width + offset], &own.bytes[i * own.width], own.width);
    offset += own.width;
  }
  auto const set = write_rows(file, name, type, rows, bytes.data());
  return set.valid() && std::ranges::all_of(columns, [&](TableColumn const& column) {
           return hdf5::write_attribute(set, "unit_" + column.name, column.unit);
         });
}

} // namespace

void write_table(std::filesystem::path const& path, std::string const& name, std::size_t rows,
                 std::vector<TableColumn> const& columns) {
  hdf5::keep_reasons();
  std::vector<Packed> packed;
  packed.reserve(columns.size());
  for (auto const& column : columns)
    packed.push_back(pack(column, rows));
  auto const part = part_name(path);
  Handle file(H5Fcreate(part.c_str(), H5F_ACC_TRUNC, hdf5::timeless(H5P_FILE_CREATE), hdf5::file_access()),
              H5Fclose);
  bool held = file.valid() && write_whole(file, name, columns, packed, rows) &&
              write_columns(file, columns, packed, rows) && H5Fflush(file, H5F_SCOPE_LOCAL) >= 0;
  auto const reason = hdf5::last_reason();
  file = {};
  std::error_code failed;
  if (held)
    std::filesystem::rename(part, path, failed);
  if (!held || failed) {
    auto const words = held ? failed.message() : reason;
    std::filesystem::remove(part, failed);
    throw unwritable(path, words);
  }
}

} // namespace stiction::record
