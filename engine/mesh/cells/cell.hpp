// The table of cell kinds: topology, interpolation and quadrature, one row a kind.
#pragma once
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "core/schema.hpp"
#include "core/types.hpp"

namespace stiction::mesh {

/// Kinds of cells, those of the plane first.
enum class CellKind : std::uint8_t { tri3, tri6, quad4, quad8, tet4, tet10, hex8, hex20 };

/// What a kind is, apart from any mesh.
struct CellInfo {
  CellKind kind;
  std::string_view name; ///< "quad4"
  int dim;
  int nodes;
  int corners;
  std::vector<std::array<int, 2>> edges; ///< corners; with mid-side nodes, node corners + i is that of edge i
  /// Local nodes of each side, corners first, then mid-side nodes. In 3D each is a cell of the plane
  /// (facet_kind) whose corners run counter-clockwise seen from outside.
  std::vector<std::vector<int>> facets;
  int vtk_type;
  int gmsh_type;
  std::vector<int> gmsh_order; ///< gmsh's local number of our local node
};
[[nodiscard]] CellInfo const& info(CellKind kind);
/// All kinds, in the order of CellKind.
[[nodiscard]] std::vector<CellInfo> const& cell_table();
/// The kinds of dimension 2 or 3.
[[nodiscard]] std::vector<CellInfo> cell_table(int dim);
/// The kinds of dimension 2 or 3, for schemas.
[[nodiscard]] core::Choices<CellKind> cell_choices(int dim);
[[nodiscard]] std::optional<CellKind> kind_named(std::string_view name);
/// Where the nodes lie in the reference cell: triangle (0,0) (1,0) (0,1), tetrahedron likewise, square
/// [-1, 1]^2, cube [-1, 1]^3. [nodes, dim]
[[nodiscard]] Matrix const& reference_nodes(CellKind kind);

/// Shape functions and their derivatives at the quadrature points of a kind's reference cell.
struct Interpolation {
  Matrix points;                 ///< [points, dim], reference coordinates
  Vector weights;                ///< [points]
  Matrix shape;                  ///< [points, nodes]
  std::vector<Matrix> gradients; ///< per point [nodes, dim], d shape / d reference coordinate
};
/// Full quadrature for stiffness: tri3 and tet4 1 point, tri6 3, tet10 4, quad4 2x2, quad8 3x3, hex8 2x2x2,
/// hex20 3x3x3.
[[nodiscard]] Interpolation const& stiffness_rule(CellKind kind);
/// Quadrature exact for the consistent mass of an undistorted cell.
[[nodiscard]] Interpolation const& mass_rule(CellKind kind);
/// Shape functions at given reference points [points, dim] with weights [points].
[[nodiscard]] Interpolation interpolate(CellKind kind, Matrix const& points, Vector const& weights);

} // namespace stiction::mesh
