// Gap and normal of a fixed triangulated surface, and how the normal turns with the point.
#include "contact/obstacle/obstacle_surface.hpp"

#include <Eigen/LU>

#include "core/error.hpp"

namespace stiction::contact {

using core::Need;

namespace {

bool ends_in(std::string const& text, std::string const& ending) {
  return text.size() > ending.size() && text.ends_with(ending);
}

/// Far enough to find a foot from anywhere near the whole surface, m.
double extent(Matrix const& nodes) {
  return (nodes.colwise().maxCoeff() - nodes.colwise().minCoeff()).norm();
}

/// Derivative of the normal by the point above a facet, where point = x2(xi, eta) + gap n(xi, eta).
Mat<3> turn_above_face(Facet const& facet, FacetNow const& now, Foot const& foot, double gap) {
  auto const N = shape(facet.count, foot.xi, foot.eta);
  Vec3 const sum = combine<double>(N.N, now.normals, facet.count), n = sum.normalized();
  Mat<3> const across = (Mat<3>::Identity() - n * n.transpose()) / sum.norm();
  Mat<3> turn = Mat<3>::Zero(), J; // of n and of the point, by (xi, eta, gap)
  turn.col(0) = across * combine<double>(N.by_xi, now.normals, facet.count);
  turn.col(1) = across * combine<double>(N.by_eta, now.normals, facet.count);
  J << combine<double>(N.by_xi, now.x, facet.count), combine<double>(N.by_eta, now.x, facet.count), n;
  J += gap * turn;
  return turn * J.inverse();
}

/// On an edge this near (in facets) the direction to the point says nothing; the facet's own normal is taken.
constexpr double at_edge = 1e-6;

/// In the wedge of an edge or vertex: the normal lies along d, the way from there to the point, and `side` is
/// 1 where d points outward, else -1.
View3d look_from_wedge(Facet const& facet, FacetNow const& now, Foot const& foot, Vec3 const& d,
                       double side) {
  double const gap = side * d.norm();
  Vec3 const n = d / gap;
  Mat<3> turn = Mat<3>::Identity() - n * n.transpose();
  if (auto const feature = FootFeature::of(foot); feature.kind == FootFeature::edge) {
    auto const last = ix((feature.side + 1) % facet.count);
    Vec3 const along = (now.x[last] - now.x[ix(feature.side)]).normalized();
    turn -= along * along.transpose();
  }
  return {foot.segment, gap, n, turn / gap};
}

} // namespace

FixedSurface::FixedSurface(mesh::SurfaceMesh const& mesh)
    : x_(mesh.nodes.data(), mesh.nodes.data() + mesh.nodes.size()),
      surface_(mesh.facets, mesh.nodes, Vec3::UnitX()), search_(surface_, extent(mesh.nodes)) {
  search_.update(x_);
}

Foot FixedSurface::project(Vec3 const& point, int facet) const {
  if (facet < 0)
    return search_.project(-1, point, {}, x_);
  bool const triangle = surface_.facets()[ix(facet)].count == 3;
  double const middle = triangle ? 1.0 / 3 : 0.0;
  return search_.project(-1, point, {facet, middle, middle}, x_);
}

core::Schema const& RigidSurface::schema() {
  static auto const made =
      core::Describe<RigidSurface>{"surface", "rigid surface of triangles, in 3D", ""}
          .file("path", &RigidSurface::path, Need::required,
                "file of its triangles, seen from outside counter-clockwise; ends in .stl or .msh")
          .number("scale", &RigidSurface::scale, "m", core::positive, Need::optional,
                  "length of the file's unit")
          .build();
  return made;
}

std::string unfit(RigidSurface const& surface, int dim, bool /*axisymmetric*/) {
  if (dim == 2)
    return "a surface needs 3D; in the plane use a polyline";
  if (!ends_in(surface.path, ".stl") && !ends_in(surface.path, ".msh"))
    return "path is \"" + surface.path + "\"; give a file that ends in .stl or .msh";
  return "";
}

void prepare(RigidSurface& surface) {
  auto const& [path, scale, prepared] = surface;
  surface.prepared = std::make_shared<FixedSurface const>(
      ends_in(path, ".stl") ? mesh::read_stl(path, scale) : mesh::read_msh_triangles(path, scale));
}

View3d view_3d(RigidSurface const& rigid, Vec3 const& x, Foot guess) {
  core::expect(rigid.prepared != nullptr, "the surface was prepared");
  auto const& fixed = *rigid.prepared;
  Foot const foot = fixed.project(x, guess.segment);
  if (!foot.found())
    return {};
  auto const& facet = fixed.surface().facets()[ix(foot.segment)];
  auto const now = fixed.now(foot.segment);
  auto const N = shape(facet.count, foot.xi, foot.eta);
  Vec3 const d = x - combine<double>(N.N, now.x, facet.count);
  Vec3 const n = combine<double>(N.N, now.normals, facet.count).normalized();
  auto const feature = FootFeature::of(foot);
  if (feature.kind == FootFeature::face)
    return {foot.segment, n.dot(d), n, turn_above_face(facet, now, foot, n.dot(d))};
  bool const on_it = d.squaredNorm() < at_edge * at_edge * area_vector(now.x, facet.count).norm();
  return on_it ? View3d{foot.segment, n.dot(d), n}
               : look_from_wedge(facet, now, foot, d, n.dot(d) < 0 ? -1 : 1);
}

} // namespace stiction::contact
