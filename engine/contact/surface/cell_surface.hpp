// A contact surface with the shape functions of its cells, and normals averaged at its corners.
#pragma once
#include <span>
#include <vector>

#include "contact/surface/cell_facet.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::contact {

struct CellFacet {
  FacetKind kind = FacetKind::line2;
  std::array<Index, most_facet_nodes> nodes{};
  std::array<int, 4> neighbour{-1, -1, -1, -1}; ///< across side k; -1: border
  std::array<int, 4> across{};                  ///< which side of the neighbour that is
  std::array<int, 4> fan{}; ///< which averaged normal each corner has on this side of edges
  FacetNodes<3> reference = FacetNodes<3>::Zero(); ///< m
  Vec3 direction = Vec3::UnitX();                  ///< of the first tangent, in the reference (3D)
  [[nodiscard]] int count() const { return node_count(kind); }
  [[nodiscard]] int corners() const { return corner_count(kind); }
};

/// A facet seen from one of its corners.
struct FanPart {
  int facet = 0, corner = 0;
};

/// The averaged normals where the surface is now: of every fan, with the length of the sum they come from.
template<int D> struct FanNormals {
  std::vector<Vec<D>> unit;
  std::vector<double> length;
};

/// The derivative of an averaged normal by one node, 1/m.
template<int D> struct NormalByNode {
  Index node = 0;
  Mat<D> by;
};

/// Positions of all nodes, [dim nodes].
using Positions = std::span<double const>;

class CellSurface {
public:
  /// facets: outward. reference: all nodes of the model, [nodes, dim]. `direction`: the first tangent is its
  /// part along the surface. Edges are where facets turn by more than 40 degrees.
  CellSurface(std::vector<mesh::Facet> const& facets, Matrix const& reference, Vec3 const& direction);

  [[nodiscard]] int dim() const { return dim_; }
  [[nodiscard]] int size() const { return static_cast<int>(facets_.size()); }
  [[nodiscard]] CellFacet const& facet(int number) const { return facets_[ix(number)]; }
  [[nodiscard]] std::vector<CellFacet> const& facets() const { return facets_; }
  /// All of them and those at corners; sorted, each once.
  [[nodiscard]] Indices const& nodes() const { return nodes_; }
  [[nodiscard]] Indices const& corner_nodes() const { return corner_nodes_; }
  /// Mean length, or square root of the area, of a facet in the reference; and the largest, m.
  [[nodiscard]] double facet_size() const { return facet_size_; }
  [[nodiscard]] double largest_size() const { return largest_size_; }
  /// Facets that share an averaged normal.
  [[nodiscard]] std::vector<std::vector<FanPart>> const& fans() const { return fans_; }

  template<int D> [[nodiscard]] FacetNodes<D> positions(int facet, Positions x) const;
  /// Outward and as long as the surface is stretched there.
  template<int D> [[nodiscard]] Vec<D> normal(int facet, Vec2 const& at, Positions x) const;
  template<int D> [[nodiscard]] FanNormals<D> fan_normals(Positions x) const;
  /// Derivatives of the averaged normal of a fan; nodes that its facets share come more than once.
  template<int D>
  [[nodiscard]] std::vector<NormalByNode<D>> turn_of_fan(FanNormals<D> const& normals, Index fan,
                                                         Positions x) const;
  /// Reference length or area per unit of the reference domain; times 2 pi r where `around` an axis.
  [[nodiscard]] double measure(int facet, Vec2 const& at, bool around) const;
  /// Integrals of the hats over the reference surface, in the order of `points`, m^2 (m in plane strain).
  [[nodiscard]] std::vector<double> hat_areas(Indices const& points, bool around) const;

private:
  void link_sides();
  void gather_fans();
  void choose_directions(Vec3 const& direction);
  [[nodiscard]] Vec3 reference_normal(int facet, Vec2 const& at) const;

  int dim_ = 2;
  std::vector<CellFacet> facets_;
  Indices nodes_, corner_nodes_;
  std::vector<std::vector<FanPart>> fans_;
  double facet_size_ = 0, largest_size_ = 0;
};

/// Area vector from the tangents [D, D - 1] of a facet, outward.
template<int D> [[nodiscard]] Vec<D> across(Eigen::Matrix<double, D, D - 1> const& tangents) {
  if constexpr (D == 2)
    return {tangents(1, 0), -tangents(0, 0)};
  else
    return tangents.col(0).cross(tangents.col(1));
}

/// Tangents by (xi [, eta]).
template<int D>
[[nodiscard]] Eigen::Matrix<double, D, D - 1> tangents_of(FacetNodes<D> const& nodes,
                                                          FacetShape const& shape) {
  Eigen::Matrix<double, D, D - 1> tangents;
  for (int a = 0; a < D - 1; ++a)
    tangents.col(a) = nodes * shape.by[ix(a)];
  return tangents;
}

} // namespace stiction::contact
