// Layout: /nodes [n, dim]; /blocks/<i>: kind, nodes; /sets/<i>: name, nodes, facet_nodes, facet_sizes, cells.
#include "mesh/files/mesh_file.hpp"

#include <fmt/format.h>
#include <hdf5.h>

#include "core/error.hpp"
#include "core/handle.hpp"

namespace stiction::mesh {

namespace {

using core::Handle;

/// An open HDF5 object; throws with these words where it could not be opened.
Handle held(hid_t id, Handle::Close close, std::string const& what) {
  if (id < 0)
    throw core::RunError(what);
  return {id, close};
}

/// Keeps HDF5 from printing its error stack; failures are exceptions here.
void quiet() {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

template<class T> hid_t memory_type() {
  if constexpr (std::is_same_v<T, double>)
    return H5T_NATIVE_DOUBLE;
  else if constexpr (std::is_same_v<T, char>)
    return H5T_NATIVE_CHAR;
  else
    return H5T_NATIVE_INT32;
}

template<class T>
void write(hid_t parent, char const* name, T const* data, std::vector<hsize_t> const& shape) {
  std::string const what = fmt::format("cannot write \"{}\" of a mesh file (disk full?)", name);
  Handle const space =
      held(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose, what);
  Handle const set =
      held(H5Dcreate2(parent, name, memory_type<T>(), space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Dclose,
           what);
  if (H5Dwrite(set, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    throw core::RunError(what);
}

void write(hid_t parent, char const* name, Indices const& values) {
  write(parent, name, values.data(), {values.size()});
}
void write(hid_t parent, char const* name, std::string const& text) {
  write(parent, name, text.data(), {text.size()});
}

/// A whole dataset: values row after row, and its shape.
template<class T> struct Array {
  std::vector<T> values;
  std::vector<hsize_t> shape;
};

template<class T> Array<T> read(hid_t parent, char const* name) {
  std::string const what = fmt::format("the mesh file lacks \"{}\"", name);
  Handle const set = held(H5Dopen2(parent, name, H5P_DEFAULT), H5Dclose, what);
  Handle const space = held(H5Dget_space(set), H5Sclose, what);
  Array<T> array;
  array.shape.resize(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  H5Sget_simple_extent_dims(space, array.shape.data(), nullptr);
  auto const count = H5Sget_simple_extent_npoints(space);
  if (count < 0 ||
      static_cast<hsize_t>(count) * sizeof(T) > H5Dget_storage_size(set)) // never written in full
    throw core::RunError(what);
  array.values.resize(static_cast<std::size_t>(count));
  if (!array.values.empty() &&
      H5Dread(set, memory_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, array.values.data()) < 0)
    throw core::RunError(what);
  return array;
}

std::string read_text(hid_t parent, char const* name) {
  auto const array = read<char>(parent, name);
  return {array.values.begin(), array.values.end()};
}

Handle new_group(hid_t parent, std::string const& name) {
  return held(H5Gcreate2(parent, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), H5Gclose,
              "cannot write a mesh file (disk full?)");
}

Handle open_group(hid_t parent, std::string const& name) {
  return held(H5Gopen2(parent, name.c_str(), H5P_DEFAULT), H5Gclose,
              fmt::format("the mesh file lacks \"{}\"", name));
}

hsize_t group_size(hid_t group) {
  H5G_info_t about{};
  return H5Gget_info(group, &about) < 0 ? 0 : about.nlinks;
}

void write_set(hid_t group, std::string const& name, Set const& set) {
  Indices facet_nodes, facet_sizes;
  for (auto const& facet : set.facets) {
    facet_nodes.insert(facet_nodes.end(), facet.nodes.begin(), facet.nodes.end());
    facet_sizes.push_back(static_cast<Index>(facet.nodes.size()));
  }
  write(group, "name", name);
  write(group, "nodes", set.nodes);
  write(group, "facet_nodes", facet_nodes);
  write(group, "facet_sizes", facet_sizes);
  write(group, "cells", set.cells);
}

Set read_set(hid_t group) {
  Set set{read<Index>(group, "nodes").values, {}, read<Index>(group, "cells").values};
  auto const nodes = read<Index>(group, "facet_nodes").values;
  auto const sizes = read<Index>(group, "facet_sizes").values;
  auto next = nodes.begin();
  for (Index const size : sizes) {
    if (size < 1 || size > nodes.end() - next)
      throw core::RunError("the mesh file has facets that do not add up");
    set.facets.push_back({Indices(next, next + size)});
    next += size;
  }
  return set;
}

void refuse_unless_there(Indices const& nodes, Mesh const& mesh) {
  for (Index const node : nodes)
    if (node < 0 || node >= mesh.node_count())
      throw core::RunError("the mesh file has sets or cells of nodes that it lacks");
}

/// What mesh::check takes for granted: whole cells of the mesh's dimension, and only nodes that are there.
void refuse_unless_whole(Mesh const& mesh) {
  for (auto const& block : mesh.blocks) {
    auto const& cell = info(block.kind);
    if (cell.dim != mesh.dim || block.nodes.size() % static_cast<std::size_t>(cell.nodes) != 0)
      throw core::RunError("the mesh file has cells of another dimension, or parts of cells");
    refuse_unless_there(block.nodes, mesh);
  }
  for (auto const& [name, set] : mesh.sets) {
    refuse_unless_there(set.nodes, mesh);
    for (auto const& facet : set.facets)
      refuse_unless_there(facet.nodes, mesh);
    for (Index const cell : set.cells)
      if (cell < 0 || cell >= mesh.cell_count())
        throw core::RunError("the mesh file has sets of cells that it lacks");
  }
}

} // namespace

void write_mesh(std::filesystem::path const& file, Mesh const& mesh, std::string const& request) {
  quiet();
  Handle const out = held(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose,
                          fmt::format("cannot create mesh file {}", file.string()));
  write(out, "version", Indices{mesher_version});
  write(out, "request", request);
  write(out, "nodes", mesh.nodes.data(),
        {static_cast<hsize_t>(mesh.nodes.rows()), static_cast<hsize_t>(mesh.nodes.cols())});
  Handle const blocks = new_group(out, "blocks");
  for (std::size_t i = 0; i < mesh.blocks.size(); ++i) {
    Handle const group = new_group(blocks, std::to_string(i));
    write(group, "kind", std::string(info(mesh.blocks[i].kind).name));
    write(group, "nodes", mesh.blocks[i].nodes);
  }
  Handle const sets = new_group(out, "sets");
  int number = 0;
  for (auto const& [name, set] : mesh.sets) {
    Handle const group = new_group(sets, std::to_string(number++));
    write_set(group, name, set);
  }
  if (H5Fflush(out, H5F_SCOPE_GLOBAL) < 0)
    throw core::RunError(fmt::format("cannot write mesh file {} (disk full?)", file.string()));
}

StoredMesh read_mesh(std::filesystem::path const& file) {
  quiet();
  Handle const in = held(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose,
                         fmt::format("cannot read mesh file {}", file.string()));
  if (read<Index>(in, "version").values != Indices{mesher_version})
    throw core::RunError(fmt::format("mesh file {} is of another version", file.string()));
  StoredMesh result;
  result.request = read_text(in, "request");
  auto const nodes = read<double>(in, "nodes");
  if (nodes.shape.size() != 2 || (nodes.shape[1] != 2 && nodes.shape[1] != 3))
    throw core::RunError(fmt::format("mesh file {} has no table of nodes", file.string()));
  auto const rows = static_cast<Eigen::Index>(nodes.shape[0]),
             dim = static_cast<Eigen::Index>(nodes.shape[1]);
  result.mesh.dim = static_cast<int>(dim);
  result.mesh.nodes = Eigen::Map<Matrix const>(nodes.values.data(), rows, dim);
  Handle const blocks = open_group(in, "blocks");
  for (hsize_t i = 0; i < group_size(blocks); ++i) {
    Handle const group = open_group(blocks, std::to_string(i));
    auto const kind = kind_named(read_text(group, "kind"));
    if (!kind)
      throw core::RunError(fmt::format("mesh file {} has cells of an unknown kind", file.string()));
    result.mesh.blocks.push_back({*kind, read<Index>(group, "nodes").values});
  }
  Handle const sets = open_group(in, "sets");
  for (hsize_t i = 0; i < group_size(sets); ++i) {
    Handle const group = open_group(sets, std::to_string(i));
    result.mesh.sets[read_text(group, "name")] = read_set(group);
  }
  refuse_unless_whole(result.mesh);
  return result;
}

} // namespace stiction::mesh
