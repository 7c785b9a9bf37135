// Shape functions of every cell kind on its reference cell.
#pragma once
#include "core/types.hpp"

namespace stiction::mesh {

using ReferencePoint = Eigen::RowVectorXd; ///< [dim]
/// Shape functions at a reference point.
struct ShapeValues {
  Eigen::RowVectorXd N; ///< [nodes]
  Matrix dN;            ///< [nodes, dim], derivatives by the reference coordinates
};
using Shape = ShapeValues (*)(ReferencePoint const& x);

[[nodiscard]] ShapeValues shape_tri3(ReferencePoint const& x);
[[nodiscard]] ShapeValues shape_tri6(ReferencePoint const& x);
[[nodiscard]] ShapeValues shape_quad4(ReferencePoint const& x);
[[nodiscard]] ShapeValues shape_quad8(ReferencePoint const& x);
[[nodiscard]] ShapeValues shape_tet4(ReferencePoint const& x);
[[nodiscard]] ShapeValues shape_tet10(ReferencePoint const& x);
[[nodiscard]] ShapeValues shape_hex8(ReferencePoint const& x);
[[nodiscard]] ShapeValues shape_hex20(ReferencePoint const& x);

/// Where the nodes lie, in the order of VTK: triangle, tetrahedron, [-1, 1]^2 and [-1, 1]^3 with mid-side
/// nodes, the corners first. [nodes, dim]
[[nodiscard]] Matrix const& triangle_nodes();
[[nodiscard]] Matrix const& tetrahedron_nodes();
[[nodiscard]] Matrix const& square_nodes();
[[nodiscard]] Matrix const& cube_nodes();

} // namespace stiction::mesh
