// Facets as the cells behind them interpolate: shape functions to second derivatives, hats, reference
// domains.
#pragma once
#include <array>

#include "contact/surface/foot.hpp"

namespace stiction::contact {

/// Facets of plane cells, then those of cells in space; nodes in the order of mesh::Facet.
enum class FacetKind : std::uint8_t { line2, line3, tri3, quad4, tri6, quad8 };

inline constexpr int most_facet_nodes = 8;
/// One number per node, zero beyond the facet's own.
using PerNode = Eigen::Matrix<double, most_facet_nodes, 1>;
/// Positions or displacements of the nodes, column by column. [D, 8]
template<int D> using FacetNodes = Eigen::Matrix<double, D, most_facet_nodes>;

/// Shape functions at one point with their derivatives by (xi [, eta]).
struct FacetShape {
  PerNode N = PerNode::Zero();
  std::array<PerNode, 2> by{PerNode::Zero(), PerNode::Zero()};
  std::array<PerNode, 3> by2{PerNode::Zero(), PerNode::Zero(), PerNode::Zero()}; ///< 11, 12, 22
  [[nodiscard]] PerNode const& second(int a, int b) const { return by2[ix(a + b)]; }
};

[[nodiscard]] int node_count(FacetKind kind);
[[nodiscard]] int corner_count(FacetKind kind);
/// The kind of a facet of so many nodes in `dim` dimensions.
[[nodiscard]] FacetKind kind_of(int dim, std::size_t nodes);
/// The kind with the same corners and no mid-side nodes.
[[nodiscard]] FacetKind linear_kind(FacetKind kind);

/// At (xi, eta) of a line [-1, 1], a triangle (xi, eta >= 0, xi + eta <= 1) or a square [-1, 1]^2.
[[nodiscard]] FacetShape facet_shape(FacetKind kind, Vec2 const& at);
/// Local coordinates of a corner and of the middle.
[[nodiscard]] Vec2 corner_coordinates(FacetKind kind, int corner);
[[nodiscard]] Vec2 middle_coordinates(FacetKind kind);
/// Length or area of the reference domain.
[[nodiscard]] double domain_size(FacetKind kind);

/// Sides run from corner k to corner k + 1; those of a line are its ends. How far inside of side k: 0 on it,
/// 1 on the opposite side or corner, negative beyond.
[[nodiscard]] double inside_of(FacetKind kind, int side, Vec2 const& at);
/// A part of the way from the first to the last corner of side k; of a line the end itself.
[[nodiscard]] Vec2 coordinates_on_side(FacetKind kind, int side, double part);
[[nodiscard]] double part_of_side(FacetKind kind, int side, Vec2 const& at);

/// Points and weights over a whole reference domain.
struct FacetRule {
  std::vector<Vec2> points;
  std::vector<double> weights; ///< sum to domain_size
};
/// By the number of corners. Lines: Gauss with 2 points or, `fine`, 3; triangles: 3 points, exact to degree
/// 2, or 6, to degree 4; squares: 2 x 2 or 3 x 3.
[[nodiscard]] FacetRule const& facet_rule(int corners, bool fine);

} // namespace stiction::contact
