// Line by line from text to HDF5.
#include "fuzz/tree.hpp"

#include <cstdlib>
#include <hdf5.h>
#include <sstream>
#include <vector>

#include "fuzz/scratch.hpp"

namespace stiction::fuzz {

namespace {

constexpr double most_written = 4096;
using Close = herr_t (*)(hid_t);

/// An identifier and what closes it.
class Id {
public:
  Id(hid_t id, Close close) : id_(id), close_(close) {}
  ~Id() {
    if (id_ >= 0)
      close_(id_);
  }
  Id(Id const&) = delete;
  Id& operator=(Id const&) = delete;
  operator hid_t() const { return id_; } // NOLINT: the C API takes identifiers everywhere

private:
  hid_t id_;
  Close close_;
};

/// What is to stand under a name.
struct Data {
  std::string type;
  std::vector<hsize_t> shape;
  std::string rest; ///< of the line
};

Data read_data(std::istream& words) {
  Data data;
  std::string shape;
  words >> data.type >> shape >> std::ws;
  std::getline(words, data.rest);
  std::istringstream extents(shape);
  for (std::string extent; data.shape.size() < 4 && std::getline(extents, extent, 'x');)
    if (extent != "-")
      data.shape.push_back(std::strtoull(extent.c_str(), nullptr, 10));
  return data;
}

/// Number of elements if they are few enough to be written, else 0.
std::size_t few(Data const& data) {
  double size = 1;
  for (hsize_t const extent : data.shape)
    size *= static_cast<double>(extent);
  return size <= most_written ? static_cast<std::size_t>(size) : 0;
}

std::vector<double> numbers(Data const& data) {
  std::vector<double> given, all(few(data));
  std::istringstream words(data.rest);
  for (std::string word; words >> word;)
    given.push_back(std::strtod(word.c_str(), nullptr));
  for (std::size_t i = 0; i < all.size() && !given.empty(); ++i)
    all[i] = given[i % given.size()];
  return all;
}

std::string texts(Data const& data) {
  std::string all;
  for (std::size_t i = few(data); i > 0; --i)
    all.append(data.rest.c_str(), data.rest.size() + 1);
  return all;
}

Id file_type(Data const& data) {
  hid_t const type = H5Tcopy(data.type == "text"    ? H5T_C_S1
                             : data.type == "float" ? H5T_IEEE_F32LE
                             : data.type == "int"   ? H5T_STD_I32LE
                             : data.type == "byte"  ? H5T_STD_I8LE
                                                    : H5T_IEEE_F64LE);
  if (data.type == "text")
    H5Tset_size(type, data.rest.size() + 1);
  return {type, H5Tclose};
}

Id space_of(Data const& data) {
  return {data.shape.empty()
              ? H5Screate(H5S_SCALAR)
              : H5Screate_simple(static_cast<int>(data.shape.size()), data.shape.data(), nullptr),
          H5Sclose};
}

/// write(type in memory, values)
template<class Write> void fill(Data const& data, hid_t file_type, Write write) {
  if (few(data) == 0)
    return;
  if (data.type == "text")
    write(file_type, texts(data).data());
  else
    write(H5T_NATIVE_DOUBLE, numbers(data).data());
}

void add_dataset(hid_t file, std::string const& path, Data const& data) {
  Id const type = file_type(data), space = space_of(data);
  Id const set(H5Dcreate2(file, path.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose);
  if (set >= 0)
    fill(data, type, [&](hid_t memory, void const* values) {
      H5Dwrite(set, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    });
}

void add_attribute(hid_t file, std::string const& path, std::string const& name, Data const& data) {
  Id const type = file_type(data), space = space_of(data);
  Id const attribute(
      H5Acreate_by_name(file, path.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  if (attribute >= 0)
    fill(data, type, [&](hid_t memory, void const* values) { H5Awrite(attribute, memory, values); });
}

void add(hid_t file, std::string const& line) {
  std::istringstream words(line);
  std::string verb, path, name;
  words >> verb >> path;
  if (verb == "group")
    Id const group(H5Gcreate2(file, path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose);
  else if (verb == "data")
    add_dataset(file, path, read_data(words));
  else if (verb == "attribute" && words >> name)
    add_attribute(file, path, name, read_data(words));
}

} // namespace

std::string tree_file(std::string const& name, std::string_view text) {
  auto const path = (scratch_folder() / name).string();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Id const file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose);
  std::istringstream lines{std::string(text)};
  for (std::string line; std::getline(lines, line);)
    add(file, line);
  return path;
}

} // namespace stiction::fuzz
