// Reads histories, cutting what a kill left incomplete.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"
#include "record/hdf5.hpp"
#include "record/series.hpp"

namespace stiction::record {

using hdf5::Handle;

namespace {

[[noreturn]] void refuse(std::filesystem::path const& path, std::string const& why) {
  throw core::InputError(core::Complaints{{path.string(), "", why}});
}

Handle open_file(std::filesystem::path const& path) {
  if (!std::filesystem::is_regular_file(path))
    refuse(path, "no such file");
  if (H5Fis_hdf5(path.c_str()) <= 0)
    refuse(path, "not an HDF5 file, or cut off before its first rows; give the series.h5 of a case");
  Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, hdf5::file_access()), H5Fclose);
  if (!file.valid())
    refuse(path, "truncated or damaged HDF5 file; run the case again");
  if (!hdf5::read_attribute(file, "format").starts_with("stiction series"))
    refuse(path, "an HDF5 file, but not a series of stiction (no attribute \"format\")");
  return file;
}

struct Shape {
  hsize_t rows = 0, width = 1;
};

/// Rows and width of a dataset; no rows when it is not a column.
Shape shape_of(hid_t dataset) {
  Handle const space(H5Dget_space(dataset), H5Sclose);
  int const rank = H5Sget_simple_extent_ndims(space);
  std::array<hsize_t, 2> size{0, 1};
  if (rank == 1 || rank == 2)
    H5Sget_simple_extent_dims(space, size.data(), nullptr);
  return {size[0], std::max<hsize_t>(size[1], 1)};
}

bool read_rows(hid_t dataset, Shape shape, std::vector<double>& values) {
  std::array<hsize_t, 2> const start{0, 0}, count{shape.rows, shape.width};
  values.resize(shape.rows * shape.width);
  Handle const source(H5Dget_space(dataset), H5Sclose);
  if (H5Sselect_hyperslab(source, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr) < 0)
    return false;
  hsize_t const total = values.size();
  Handle const target(H5Screate_simple(1, &total, nullptr), H5Sclose);
  return H5Dread(dataset, H5T_NATIVE_DOUBLE, target, source, H5P_DEFAULT, values.data()) >= 0;
}

/// Reads the longest prefix there is: a kill may leave the last chunk announced but not yet in the file.
std::vector<double> read_prefix(hid_t dataset, Shape shape) {
  std::vector<double> values;
  if (read_rows(dataset, shape, values))
    return values;
  hsize_t good = 0, bad = shape.rows;
  while (bad - good > 1) {
    hsize_t const middle = good + (bad - good) / 2;
    (read_rows(dataset, {middle, shape.width}, values) ? good : bad) = middle;
  }
  values.clear();
  if (good > 0)
    read_rows(dataset, {good, shape.width}, values);
  return values;
}

/// What visiting the file's objects collects.
struct Collection {
  hid_t file;
  hsize_t largest; ///< values the file can hold: more is damage, not data
  SeriesData data;
};

SeriesColumn read_column(hid_t dataset, hsize_t largest) {
  Shape shape = shape_of(dataset);
  SeriesColumn column{
      hdf5::read_attribute(dataset, "unit"), hdf5::read_attribute(dataset, "meaning"), shape.width, {}};
  shape.rows = std::min(shape.rows, largest / shape.width);
  if (shape.rows > 0)
    column.values = read_prefix(dataset, shape);
  auto const unwritten = std::ranges::find_if(column.values, [](double v) { return std::isnan(v); });
  column.values.erase(unwritten, column.values.end());
  return column;
}

herr_t collect(hid_t, char const* name, H5O_info_t const* info, void* pointer) {
  auto& collection = *static_cast<Collection*>(pointer);
  if (info->type != H5O_TYPE_DATASET)
    return 0;
  Handle const dataset(H5Dopen2(collection.file, name, H5P_DEFAULT), H5Dclose);
  if (dataset.valid())
    collection.data.columns[name] = read_column(dataset, collection.largest);
  return 0;
}

void cut_to_complete_rows(SeriesData& data) {
  std::size_t rows = data.time.size();
  for (auto const& [name, column] : data.columns)
    rows = std::min(rows, column.values.size() / column.width);
  data.time.resize(rows);
  for (auto& [name, column] : data.columns)
    column.values.resize(rows * column.width);
}

} // namespace

SeriesData read_series(std::filesystem::path const& path) {
  hdf5::keep_reasons();
  Handle const file = open_file(path);
  Collection collection{file, std::filesystem::file_size(path) / sizeof(double), {}};
  if (H5Ovisit2(file, H5_INDEX_NAME, H5_ITER_INC, collect, &collection, H5O_INFO_BASIC) < 0)
    refuse(path, "truncated or damaged HDF5 file; run the case again");
  SeriesData& data = collection.data;
  auto time = data.columns.extract("time");
  if (time.empty())
    refuse(path, "a series without \"time\"; run the case again");
  data.time = std::move(time.mapped().values);
  cut_to_complete_rows(data);
  return std::move(data);
}

} // namespace stiction::record
