// One quadrature point of a mortar pair: its pairing along the secondary's normals, its rows and stiffness.
#pragma once
#include <optional>

#include "contact/node_to_segment/kinematics.hpp"
#include "contact/surface/ray.hpp"
#include "contact/surface/way.hpp"

namespace stiction::contact {

/// A material point of the secondary surface over one step.
struct Sample {
  int facet = 0;
  double area = 0;                    ///< reference area it stands for, m^2 (m in plane strain)
  FacetShape shape;                   ///< of the secondary facet, there
  PerNode hats = PerNode::Zero();     ///< of the facet's corners, there
  PerNode material = PerNode::Zero(); ///< sum_k material_k x_k is the first tangent's direction, carried (3D)
  Start start;                        ///< counterpart at the step's start
  std::optional<double> bearing; ///< of the counterpart's material in the frame then, rad; none: not asked
  Vec3 tangent = Vec3::Zero();   ///< of an obstacle, in place of its direction; zero: that
};

/// The sample on a facet of `surface` at local coordinates; domain_weight: what it stands for
/// there.
[[nodiscard]] Sample make_sample(CellSurface const& surface, int facet, Vec2 const& at, double domain_weight,
                                 bool around);

/// Both surfaces where they are now.
template<int D> struct Faced {
  CellSurface const& secondary;
  CellSurface const& primary;
  Positions x;
  FanNormals<D> const &normals, &opposite; ///< averaged, of the secondary and of the primary
};

/// Where a sample stands against its counterpart.
template<int D> struct SamplePairing {
  Foot foot;
  double gap = 0;                           ///< m
  Local<D - 1> slip = Local<D - 1>::Zero(); ///< since the step's start, m
  Mat<D> frame = Mat<D>::Zero();            ///< columns n, t1 [, t2], as in PointKinematics
  double spin = 0;                          ///< of x2(start)'s material against it since then, rad, if asked
  [[nodiscard]] bool found() const { return foot.found(); }
};

/// The ray of a sample from its averaged normal.
template<int D> [[nodiscard]] Ray<D> ray_of(Faced<D> const& faced, Sample const& sample);
/// x1 - x2 = gap n with n against the secondary's averaged normal; slip is the way from x2(start) to x2(foot)
/// by the primary's averaged normals there (Way), along (t1 [, t2]). Not found where nothing faces the sample
/// within half a facet beyond the primary's border.
template<int D>
[[nodiscard]] SamplePairing<D> pairing(Faced<D> const& faced, Sample const& sample, Foot guess);

/// Direction of the primary's material at a foot about n, from t1 to t2, rad; 0 in the plane.
template<int D> [[nodiscard]] double bearing(Faced<D> const& faced, Foot foot, Mat<D> const& frame);

/// Rows over the nodes of the secondary facet, then over those of the primary: (n, t1 [, t2]). Forces and
/// moments of every row balance; a tangential force at a distance makes a moment, which the primary facet
/// bears by forces along n.
template<int D>
using SampleRows = Eigen::Matrix<double, D, Eigen::Dynamic, Eigen::ColMajor, D, 2 * D * most_facet_nodes>;
template<int D>
[[nodiscard]] SampleRows<D> sample_rows(Faced<D> const& faced, Sample const& sample,
                                        SamplePairing<D> const& pairing);

/// Derivatives of gap and slip, which the rows are where the sample slides a little and normals agree.
template<int D> struct SampleMotion {
  Rows<D> by_nodes;   ///< of the secondary facet, the primary's at the foot and that at the start
  Rows<D> by_normals; ///< by the averaged normals at the corners of the same facets, m
};
template<int D>
[[nodiscard]] SampleMotion<D> sample_motion(Faced<D> const& faced, Sample const& sample,
                                            SamplePairing<D> const& pairing);

/// Derivative of a sample's nodal forces at fixed force (n, t1 [, t2]). Rows as the columns of SampleRows.
template<int D> struct SampleStiffness {
  Dense by_nodes;   ///< by the positions of the same nodes, N/m
  Dense by_normals; ///< by the averaged normals of the secondary facet's corners, N
};
template<int D>
[[nodiscard]] SampleStiffness<D> sample_stiffness(Faced<D> const& faced, Sample const& sample,
                                                  SamplePairing<D> const& pairing, Local<D> const& force);

} // namespace stiction::contact
