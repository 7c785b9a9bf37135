// Shape functions of every cell kind on its reference cell.
#pragma once
#include "core/types.hpp"

namespace stiction::mesh {

using ReferencePoint = Eigen::RowVectorXd; ///< [dim]
/// Values N [nodes] and derivatives dN [nodes, dim] at a reference point.
using Shape = void (*)(ReferencePoint const& x, Eigen::Ref<Eigen::RowVectorXd> N, Matrix& dN);

void shape_tri3(ReferencePoint const& x, Eigen::Ref<Eigen::RowVectorXd> N, Matrix& dN);
void shape_tri6(ReferencePoint const& x, Eigen::Ref<Eigen::RowVectorXd> N, Matrix& dN);
void shape_quad4(ReferencePoint const& x, Eigen::Ref<Eigen::RowVectorXd> N, Matrix& dN);
void shape_quad8(ReferencePoint const& x, Eigen::Ref<Eigen::RowVectorXd> N, Matrix& dN);
void shape_tet4(ReferencePoint const& x, Eigen::Ref<Eigen::RowVectorXd> N, Matrix& dN);
void shape_tet10(ReferencePoint const& x, Eigen::Ref<Eigen::RowVectorXd> N, Matrix& dN);
void shape_hex8(ReferencePoint const& x, Eigen::Ref<Eigen::RowVectorXd> N, Matrix& dN);
void shape_hex20(ReferencePoint const& x, Eigen::Ref<Eigen::RowVectorXd> N, Matrix& dN);

/// Where the nodes lie, in the order of VTK: triangle, tetrahedron, [-1, 1]^2 and [-1, 1]^3 with mid-side
/// nodes, the corners first. [nodes, dim]
[[nodiscard]] Matrix const& triangle_nodes();
[[nodiscard]] Matrix const& tetrahedron_nodes();
[[nodiscard]] Matrix const& square_nodes();
[[nodiscard]] Matrix const& cube_nodes();

} // namespace stiction::mesh
