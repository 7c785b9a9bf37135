// How well shaped the cells of a mesh are, and the refusal of meshes that cannot be computed on.
#pragma once
#include <string>

#include "mesh/topology/mesh.hpp"

namespace stiction::mesh {

/// Shape of the cells by their corners, all kinds together.
struct Quality {
  Index cells = 0, nodes = 0;
  double min_jacobian = 1,
         median_jacobian = 1; ///< scaled Jacobian: 1 is ideal (square, cube, equilateral), <= 0 inverted
  double min_angle = 0, max_angle = 0; ///< between sides, degrees
  double max_aspect = 1;               ///< longest over shortest side of a cell
  double min_edge = 0;                 ///< m
};
[[nodiscard]] Quality quality(Mesh const& mesh);

/// Smallest over the cells' corners and quadrature points, so that curved sides count; check() refuses what
/// is not above `degenerate`.
[[nodiscard]] double least_jacobian(Mesh const& mesh);
constexpr double degenerate = 1e-3;

/// Several lines of plain text for logs and `explain`.
[[nodiscard]] std::string report(Mesh const& mesh, std::string const& name);

/// Refuses what cannot be computed on: no cells, coordinates that are not finite, a node twice in a cell,
/// inverted or degenerate cells (also by their Jacobian at the quadrature points), nodes no cell uses, empty
/// sets. Throws InputError with every kind of problem, the first few of each, cells numbered from 1.
void check(Mesh const& mesh, std::string const& name);

} // namespace stiction::mesh
