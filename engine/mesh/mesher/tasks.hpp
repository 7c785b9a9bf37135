// The steps of the mesher: build or read a model in gmsh, then take our mesh out of it.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "mesh/topology/mesh.hpp"

namespace stiction::mesher {

/// Meshes the outlines of a request in gmsh's current model; named edges become physical curves.
/// Throws InputError or what gmsh throws.
void build_geometry(nlohmann::json const& request);

/// Meshes one of a few solids about the origin with tetrahedra; its faces become physical surfaces.
void build_solid(nlohmann::json const& request);

/// Reads the mesh file of a request (.msh, .inp, .vtu, legacy .vtk) into gmsh's current model, or fills the
/// surface of an .stl with tetrahedra of the request's "size". Throws InputError when the file is truncated
/// or not a mesh file.
void import_file(nlohmann::json const& request, std::string const& output);

/// The plane or solid mesh of gmsh's current model, lengths times `scale`, with its physical groups as sets.
/// Throws InputError for shells, for solid and surface cells without a physical volume, and for cells of a
/// kind we lack.
[[nodiscard]] mesh::Mesh extract(double scale);

} // namespace stiction::mesher
