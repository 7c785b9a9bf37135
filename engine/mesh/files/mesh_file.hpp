// Meshes as HDF5 files, the form in which the mesher hands them to the engine.
#pragma once
#include <filesystem>
#include <string>

#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

/// Goes up whenever the mesher would answer the same request differently, so that older files are made anew.
inline constexpr int mesher_version = 4;

/// Writes `mesh` and the request that it answers. Throws RunError when the file cannot be written.
void write_mesh(std::filesystem::path const& file, Mesh const& mesh, std::string const& request);

/// The mesh of a file and the request it answers.
struct StoredMesh {
  Mesh mesh;
  std::string request;
};
/// Throws RunError when the file is missing, damaged or of another version.
[[nodiscard]] StoredMesh read_mesh(std::filesystem::path const& file);

} // namespace stiction::mesh
