// The table of cell kinds: topology, interpolation and quadrature, one row a kind.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace stiction::mesh {

/// Kinds of cells. tet4, tet10, hex8 and hex20 are to follow as further rows of the table.
enum class CellKind : std::uint8_t { tri3, tri6, quad4, quad8 };

/// What a kind is, apart from any mesh.
struct CellInfo {
  CellKind kind;
  std::string_view name; ///< "quad4"
  int dim;
  int nodes;
  int corners;
  std::vector<std::vector<int>> facets; ///< local nodes of each side, corners first, outward orientation
  int vtk_type;
  int gmsh_type;
};
[[nodiscard]] CellInfo const& info(CellKind kind);
/// All kinds, in the order of CellKind.
[[nodiscard]] std::vector<CellInfo> const& cell_table();
/// Names of all kinds in the order of CellKind, for schemas and messages.
[[nodiscard]] std::vector<std::string> cell_names();
[[nodiscard]] std::optional<CellKind> kind_named(std::string_view name);
/// Where the nodes lie in the reference cell: triangle (0,0) (1,0) (0,1), square [-1, 1]^2. [nodes, dim]
[[nodiscard]] Matrix const& reference_nodes(CellKind kind);

/// Shape functions and their derivatives at the quadrature points of a kind's reference cell.
struct Interpolation {
  Matrix points;                 ///< [points, dim], reference coordinates
  Vector weights;                ///< [points]
  Matrix shape;                  ///< [points, nodes]
  std::vector<Matrix> gradients; ///< per point [nodes, dim], d shape / d reference coordinate
};
/// Full quadrature for stiffness: tri3 1 point, tri6 3, quad4 2x2, quad8 3x3.
[[nodiscard]] Interpolation const& stiffness_rule(CellKind kind);
/// Quadrature exact for the consistent mass of an undistorted cell.
[[nodiscard]] Interpolation const& mass_rule(CellKind kind);
/// Shape functions at given reference points [points, dim] with weights [points].
[[nodiscard]] Interpolation interpolate(CellKind kind, Matrix const& points, Vector const& weights);

} // namespace stiction::mesh
