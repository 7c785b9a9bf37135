// Quadrature of shape functions over edges and facets.
#include "mesh/topology/traction.hpp"

#include <Eigen/Geometry>
#include <numbers>

#include "core/error.hpp"
#include "mesh/cells/quadrature.hpp"
#include "mesh/topology/surface.hpp"

namespace stiction::mesh {

std::array<Vector, 2> edge_shape(std::size_t nodes, double x) {
  if (nodes == 2)
    return {Eigen::Vector2d((1 - x) / 2, (1 + x) / 2), Eigen::Vector2d(-0.5, 0.5)};
  core::expect(nodes == 3, "an edge has two or three nodes");
  return {Eigen::Vector3d(x * (x - 1) / 2, x * (x + 1) / 2, 1 - x * x),
          Eigen::Vector3d(x - 0.5, x + 0.5, -2 * x)};
}

namespace {

Vector edge_integrals(Matrix const& positions, bool revolved) {
  Rule const rule = cube_rule(1, 3);
  Vector sum = Vector::Zero(positions.rows());
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    auto const [N, dN] = edge_shape(static_cast<std::size_t>(positions.rows()), rule.points(q, 0));
    double const length = (positions.transpose() * dN).norm();
    double const turn = revolved ? 2 * std::numbers::pi * positions.col(0).dot(N) : 1.0;
    sum += rule.weights[q] * length * turn * N;
  }
  return sum;
}

} // namespace

Vector shape_integrals(Matrix const& nodes, Facet const& facet, bool revolved) {
  Matrix positions(static_cast<Eigen::Index>(facet.nodes.size()), nodes.cols());
  for (std::size_t i = 0; i < facet.nodes.size(); ++i)
    positions.row(static_cast<Eigen::Index>(i)) = nodes.row(facet.nodes[i]);
  if (nodes.cols() == 2)
    return edge_integrals(positions, revolved);
  auto const& rule = mass_rule(facet_kind(facet));
  Vector sum = Vector::Zero(positions.rows());
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    Eigen::Matrix<double, 3, 2> const tangents =
        positions.transpose() * rule.gradients[static_cast<std::size_t>(q)];
    sum += rule.weights[q] * tangents.col(0).cross(tangents.col(1)).norm() * rule.shape.row(q).transpose();
  }
  return sum;
}

} // namespace stiction::mesh
