// Triangle surfaces from files: STL and the triangles of gmsh's files.
#pragma once
#include <string>
#include <vector>

#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

/// A surface of tri3 facets, for rigid bodies and obstacles.
struct SurfaceMesh {
  Matrix nodes; ///< [nodes, 3], m; every node once
  std::vector<Facet> facets;
};

/// Reads an STL file, text or binary; lengths times `scale`. Vertices nearer than 1e-7 of the extent become
/// one node, triangles that this makes degenerate are left out. Throws InputError when the file is missing,
/// truncated, empty, not STL or holds numbers that are not finite.
[[nodiscard]] SurfaceMesh read_stl(std::string const& path, double scale = 1);

/// Reads the triangles (tri3, or the corners of tri6) of a text .msh file of version 2 or 4.1; other cells
/// are passed over. Throws InputError as above, and for binary files.
[[nodiscard]] SurfaceMesh read_msh_triangles(std::string const& path, double scale = 1);

} // namespace stiction::mesh
