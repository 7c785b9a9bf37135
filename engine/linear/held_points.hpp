// What a preconditioner makes of the laws of contact points: how stiffly each holds its nodes.
#pragma once
#include "linear/bulk_factor.hpp"

namespace stiction::linear {

using SmallBlock = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3>;

/// H of each point by itself.
[[nodiscard]] std::vector<std::vector<SurfaceEntry>> by_point(SurfaceRows const& rows, Index components);
/// (A + softness B)^-1 of each point, with a part of its compliance (diagonal blocks of W) for softness.
[[nodiscard]] Dense softened(PointLaws const& laws, Dense const& compliance);
/// The symmetric stiffness in the directions in which S holds, as strongly; none where it pushes.
[[nodiscard]] SmallBlock holding(SmallBlock const& S);
/// The product of each point's block.
[[nodiscard]] Vector by_blocks(Dense const& blocks, Vector const& v);

/// Compliance of a node in a body over that of the node alone.
inline constexpr double compliance_in_body = 2.5;

} // namespace stiction::linear
