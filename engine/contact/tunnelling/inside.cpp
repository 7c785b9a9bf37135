// The winding number of a closed surface about a point: the angles under which it sees the panels.
#include "contact/tunnelling/inside.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace stiction::contact {

namespace {

template<int D> using Corners = std::array<Vec<D>, D>; ///< of a panel, from the point

/// Part of the full angle: 1 in sum if the surface goes once around the point.
double angle(Corners<2> const& c) {
  return std::atan2(c[0].x() * c[1].y() - c[0].y() * c[1].x(), c[0].dot(c[1])) / (2 * std::numbers::pi);
}

/// Solid angle of a triangle (Van Oosterom and Strackee 1983) over the full one.
double angle(Corners<3> const& c) {
  double const a = c[0].norm(), b = c[1].norm(), d = c[2].norm();
  double const below = a * b * d + c[0].dot(c[1]) * d + c[1].dot(c[2]) * a + c[2].dot(c[0]) * b;
  return std::atan2(c[0].dot(c[1].cross(c[2])), below) / (2 * std::numbers::pi);
}

/// Distance from the origin to a segment, or to a triangle where it lies over it, else to a corner.
template<int D> double distance(Corners<D> const& c) {
  Eigen::Matrix<double, D, D - 1> sides;
  for (int k = 1; k < D; ++k)
    sides.col(k - 1) = c[ix(k)] - c[0];
  Eigen::Matrix<double, D - 1, D - 1> const gram = sides.transpose() * sides;
  Eigen::Matrix<double, D - 1, 1> const part = gram.inverse() * (sides.transpose() * -c[0]);
  if (part.minCoeff() >= 0 && part.sum() <= 1)
    return (c[0] + sides * part).norm();
  double nearest = c[0].norm();
  for (auto const& corner : c)
    nearest = std::min(nearest, corner.norm());
  return nearest;
}

} // namespace

template<int D> std::vector<Panel<D>> panels_of(mesh::Mesh const& mesh) {
  std::vector<Panel<D>> panels;
  for (auto const& facet : mesh::boundary(mesh)) {
    std::size_t const corners = D == 2 ? 2 : facet.nodes.size() % 3 == 0 ? 3 : 4;
    for (std::size_t k = D - 1; k < corners; ++k) {
      Panel<D> panel{};
      panel[0] = facet.nodes[0];
      for (std::size_t c = 1; c < D; ++c)
        panel[c] = facet.nodes[k - D + 1 + c];
      panels.push_back(panel);
    }
  }
  return panels;
}

template<int D>
double depth_inside(std::vector<Panel<D>> const& closed, std::span<double const> x, Vec<D> const& point) {
  double turns = 0, nearest = std::numeric_limits<double>::max();
  for (auto const& panel : closed) {
    Corners<D> corners;
    for (std::size_t k = 0; k < D; ++k)
      corners[k] = Eigen::Map<Vec<D> const>(x.data() + D * panel[k]) - point;
    turns += angle(corners);
    nearest = std::min(nearest, distance<D>(corners));
  }
  return turns > 0.5 ? nearest : 0;
}

template std::vector<Panel<2>> panels_of<2>(mesh::Mesh const&);
template std::vector<Panel<3>> panels_of<3>(mesh::Mesh const&);
template double depth_inside<2>(std::vector<Panel<2>> const&, std::span<double const>, Vec2 const&);
template double depth_inside<3>(std::vector<Panel<3>> const&, std::span<double const>, Vec3 const&);

} // namespace stiction::contact
