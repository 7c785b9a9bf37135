// Every way to get a mesh, as one choice.
#pragma once
#include <variant>

#include "mesh/generators/generators.hpp"
#include "mesh/gmsh/gmsh.hpp"
#include "mesh/gmsh/gmsh_solid.hpp"

namespace stiction::mesh {

/// What scripts make as mesh.block{...}, mesh.half_disc{...}, mesh.gmsh{...}, and so on by their schemas'
/// names.
using Generator =
    std::variant<BlockOptions, GradedBlockOptions, HalfDiscOptions, QuarterDiscOptions, BoxOptions,
                 QuarterCylinderOptions, HalfBallOptions, GmshGeometry, GmshSolid, MshFile>;

/// Makes the mesh. Throws InputError when the numbers make no mesh.
[[nodiscard]] Mesh make(Generator const& generator);

/// The descriptions of all generators, for help and constructors.
[[nodiscard]] std::vector<core::Schema> generator_schemas();

} // namespace stiction::mesh
