// Heights in HDF5 files.
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <hdf5.h>

#include "core/handle.hpp"
#include "halfspace/height_file.hpp"

namespace stiction::halfspace::detail {

namespace {

using core::Handle;

bool is_table(hid_t file, std::string const& name) {
  Handle const set(H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose);
  Handle const space(set.valid() ? H5Dget_space(set) : -1, H5Sclose);
  return space.valid() && H5Sget_simple_extent_ndims(space) == 2;
}

/// Of the file's first folder.
std::string only_table(std::string const& path, hid_t file) {
  std::vector<std::string> names;
  H5G_info_t about{};
  if (H5Gget_info(file, &about) < 0)
    about.nlinks = 0;
  for (hsize_t i = 0; i < about.nlinks; ++i) {
    constexpr std::size_t most = 256;
    std::string name(most, '\0');
    auto const length =
        H5Lget_name_by_idx(file, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), most, H5P_DEFAULT);
    name.resize(static_cast<std::size_t>(std::clamp<long>(length, 0, most - 1)));
    if (is_table(file, name))
      names.push_back(std::move(name));
  }
  if (names.size() != 1)
    refuse_heights(path,
                   names.empty() ? "has no data set of two dimensions outside of groups; name the data set"
                                 : fmt::format("has {} data sets of two dimensions; name one of {}",
                                               names.size(), fmt::join(names, ", ")),
                   "dataset");
  return names.front();
}

/// Of fixed or of variable length; "" where there is none.
std::string text_attribute(hid_t object, char const* name) {
  if (H5Aexists(object, name) <= 0)
    return "";
  Handle const attribute(H5Aopen(object, name, H5P_DEFAULT), H5Aclose);
  Handle const type(attribute.valid() ? H5Aget_type(attribute) : -1, H5Tclose);
  Handle const space(attribute.valid() ? H5Aget_space(attribute) : -1, H5Sclose);
  if (!type.valid() || H5Tget_class(type) != H5T_STRING || H5Sget_simple_extent_npoints(space) != 1)
    return "";
  if (H5Tis_variable_str(type) > 0) {
    char* text = nullptr;
    if (H5Aread(attribute, type, static_cast<void*>(&text)) < 0 || text == nullptr)
      return "";
    std::string read = text;
    H5free_memory(text);
    return read;
  }
  std::string text(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, text.data()) < 0)
    return "";
  return text.substr(0, text.find('\0'));
}

} // namespace

HeightFile read_hdf5(std::string const& path, std::string const& dataset) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Handle const in(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!in.valid())
    refuse_heights(path, "is a damaged HDF5 file; write it anew");
  auto const name = dataset.empty() ? only_table(path, in) : dataset;
  Handle const set(H5Dopen2(in, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!set.valid())
    refuse_heights(path, fmt::format("has no data set \"{}\"", name), "dataset");
  Handle const type(H5Dget_type(set), H5Tclose), space(H5Dget_space(set), H5Sclose);
  auto const kind = H5Tget_class(type);
  int const dimensions = H5Sget_simple_extent_ndims(space);
  if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || dimensions < 1 || dimensions > 2)
    refuse_heights(path, fmt::format("\"{}\" is no table of numbers {{y, x}}, and no line of them", name),
                   "dataset");
  std::array<hsize_t, 2> shape{1, 1};
  H5Sget_simple_extent_dims(space, dimensions == 2 ? shape.data() : shape.data() + 1, nullptr);
  check_count(path, static_cast<double>(shape[1]), static_cast<double>(shape[0]));
  HeightFile file{
      static_cast<Index>(shape[1]), static_cast<Index>(shape[0]), {}, text_attribute(set, "unit"), {}, {}};
  if (file.unit.empty())
    file.unit = text_attribute(set, "units");
  file.heights.resize(shape[0] * shape[1]);
  if (H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, file.heights.data()) < 0)
    refuse_heights(path, fmt::format("\"{}\" cannot be read; write it anew", name), "dataset");
  return file;
}

} // namespace stiction::halfspace::detail
