// A rigid surface of triangles in space.
#pragma once
#include <memory>

#include "contact/obstacle/obstacle_view.hpp"
#include "contact/surface/search.hpp"
#include "core/schema.hpp"
#include "mesh/files/surface_file.hpp"

namespace stiction::contact {

/// A surface that does not move, with the positions of its nodes and a search among its facets.
class FixedSurface {
public:
  /// Facets as Surface takes them, outward.
  explicit FixedSurface(mesh::SurfaceMesh const& mesh);
  FixedSurface(FixedSurface const&) = delete;
  FixedSurface& operator=(FixedSurface const&) = delete;

  [[nodiscard]] Surface const& surface() const { return surface_; }
  /// `facet`: where to start; -1 if unknown.
  [[nodiscard]] Foot project(Vec3 const& point, int facet) const;
  [[nodiscard]] FacetNow now(int facet) const { return surface_.now(facet, x_); }

private:
  std::vector<double> x_; ///< [3 nodes], m
  Surface surface_;
  Search<3> search_;
};

/// Triangulated surface of a solid. Its normal is a continuous field between edges of more than 40 degrees,
/// so that the gradient of the gap is the normal but for terms of the order of the angle between the two; in
/// the wedge outside an edge the normal points from the edge to the point.
struct RigidSurface {
  std::string path;
  double scale = 1;                             ///< length of the file's unit, m
  std::shared_ptr<FixedSurface const> prepared; ///< by prepare(), from the above
  [[nodiscard]] static core::Schema const& schema();
};

[[nodiscard]] std::string unfit(RigidSurface const& surface, int dim, bool axisymmetric);
/// Reads the file. Throws InputError where that fails or the facets make no surface.
void prepare(RigidSurface& surface);

/// Not found past a border.
[[nodiscard]] View3d view_3d(RigidSurface const& surface, Vec3 const& x, Foot guess);

} // namespace stiction::contact
