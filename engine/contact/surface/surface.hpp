// The primary side in space: triangles and quadrilaterals with a continuous field of normals.
#pragma once
#include <span>
#include <vector>

#include "contact/surface/facet.hpp"
#include "contact/surface/grid.hpp"
#include "mesh/topology/mesh.hpp"

namespace stiction::contact {

template<int D> class Search;

/// Nodes and nodal normals of a facet where it is now.
struct FacetNow {
  std::array<Vec3, 4> x, normals;
};

/// The surface at one foot: position, its derivatives, unit normal.
struct SurfacePoint {
  Vec3 x, by_xi, by_eta, normal;
};

/// Where the counterpart lies: inside a facet, where the field of normals points at the contact point, or on
/// an edge or vertex in whose wedge the point is. Kept in Foot::zeta.
struct FootFeature {
  enum Kind { face, edge, vertex } kind = face;
  int side = 0; ///< side of the facet, or its node
  [[nodiscard]] double code() const { return kind == face ? 0 : kind == edge ? 1 + side : 5 + side; }
  static FootFeature of(Foot const& foot) {
    int const code = static_cast<int>(foot.zeta);
    return code == 0 ? FootFeature{} : code < 5 ? FootFeature{edge, code - 1} : FootFeature{vertex, code - 5};
  }
};

/// A deformable primary surface. Facets with mid-side nodes are split through them into linear ones: tri6
/// into 4 triangles, quad8 into 4 triangles and the quadrilateral between them.
class Surface {
public:
  /// facets: tri3, quad4, tri6 or quad8, outward. reference: all nodes of the model, [nodes, 3].
  /// `direction`: the first tangent is its part along the surface. Edges are where facets turn by more than
  /// 40 degrees. Throws InputError where three facets share a side, where two are oriented against each other
  /// or where too many facets meet.
  Surface(std::vector<mesh::Facet> const& facets, Matrix const& reference, Vec3 const& direction);

  [[nodiscard]] std::vector<Facet> const& facets() const { return facets_; }
  [[nodiscard]] int size() const { return static_cast<int>(facets_.size()); }
  /// Sorted, each once.
  [[nodiscard]] Indices const& nodes() const { return nodes_; }
  /// Mean square root of a facet's reference area, m.
  [[nodiscard]] double facet_size() const { return facet_size_; }
  /// The facet's nodes, then all others on which its nodal normals depend.
  [[nodiscard]] std::span<Index const> stencil(int facet) const;
  /// Facets whose vector areas make the nodal normal `corner`.
  [[nodiscard]] std::span<int const> fan(int corner) const;
  /// Facets that share a node with `facet`, itself among them.
  [[nodiscard]] std::span<int const> around(int facet) const;

  /// Of the facet's nodes, m.
  [[nodiscard]] std::array<Vec3, 4> positions(int facet, std::span<double const> x) const;
  [[nodiscard]] Vec3 position(Foot foot, std::span<double const> x) const;
  [[nodiscard]] FacetNow now(int facet, std::span<double const> x) const;
  [[nodiscard]] SurfacePoint evaluate(Foot foot, std::span<double const> x) const;

  /// The foot from which the normal points at `point`, found by walking from `guess`; from the nearest facet
  /// if it has none or leads nowhere. Not found beyond the border of the surface. x[3 nodes]: positions.
  [[nodiscard]] Foot project(Vec3 const& point, Foot guess, std::span<double const> x,
                             Search<3> const* search = nullptr) const;
  /// The same from `start` alone; not found if that leads nowhere.
  [[nodiscard]] Foot follow(Vec3 const& point, Foot start, std::span<double const> x,
                            Overhang overhang = Overhang::found) const;
  /// The nearest point of any facet, by looking at all of them.
  [[nodiscard]] Foot nearest_start(Vec3 const& point, std::span<double const> x) const;
  /// The nearest point of one facet; `distance2`: squared distance, m^2.
  [[nodiscard]] Foot sample(int facet, Vec3 const& point, std::span<double const> x, double& distance2) const;
  [[nodiscard]] Box<3> box(int facet, std::span<double const> x) const;

private:
  void split(std::vector<mesh::Facet> const& facets, Matrix const& reference);
  void link_sides();
  void gather_fans();
  void gather_stencils();
  void choose_directions(Vec3 const& direction);
  [[nodiscard]] Vec3 reference_normal(int facet) const;

  std::vector<Facet> facets_;
  Indices nodes_;
  double facet_size_ = 0;
  // lists of lists: those of i stand from starts[i] to starts[i + 1]
  std::vector<int> fan_starts_, fan_facets_, around_starts_, around_facets_, stencil_starts_;
  Indices stencil_nodes_;
};

} // namespace stiction::contact
