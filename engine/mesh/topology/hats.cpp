// Quadrature of hats piece by piece, and what corners borrow of the shape functions beside them.
#include "mesh/topology/hats.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <numbers>

#include "core/error.hpp"
#include "mesh/cells/quadrature.hpp"
#include "mesh/topology/surface.hpp"
#include "mesh/topology/traction.hpp"

namespace stiction::mesh {

namespace {

using Pieces = std::vector<std::vector<int>>;

/// Points of a reference facet of second order.
struct HatRule {
  Matrix points;  ///< [points, dim - 1]
  Vector weights; ///< [points], sum to the reference facet's measure
  Matrix hats;    ///< [points, nodes]
};

/// Points of the reference piece of 2, 3 or 4 corners: its hats, and weights that sum to 1.
HatRule piece_rule(int corners) {
  Rule const gauss = cube_rule(corners == 2 ? 1 : 2, 4);
  HatRule rule{{}, gauss.weights / gauss.weights.sum(), Matrix(gauss.weights.size(), corners)};
  for (Eigen::Index q = 0; q < gauss.weights.size(); ++q) {
    double const u = (1 + gauss.points(q, 0)) / 2, v = corners == 2 ? 0 : (1 + gauss.points(q, 1)) / 2;
    if (corners == 2) {
      rule.hats.row(q) << 1 - u, u;
    } else if (corners == 4) {
      rule.hats.row(q) << (1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v;
    } else { // the square shrunk to a triangle
      rule.hats.row(q) << 1 - u, u * (1 - v), u * v;
      rule.weights[q] *= 2 * u;
    }
  }
  return rule;
}

/// Length or area of a straight piece, [corners, dim - 1]; that of a quadrilateral is a parallelogram's.
double measure_of(Matrix const& corners) {
  if (corners.cols() == 1)
    return std::abs(corners(1, 0) - corners(0, 0));
  Eigen::Matrix2d sides;
  sides << corners.row(1) - corners.row(0), corners.row(corners.rows() - 1) - corners.row(0);
  return std::abs(sides.determinant()) / (corners.rows() == 3 ? 2 : 1);
}

HatRule make_rule(Pieces const& pieces, Matrix const& points) {
  HatRule all{Matrix(0, points.cols()), Vector(0), Matrix(0, points.rows())};
  for (auto const& piece : pieces) {
    Matrix const corners = points(piece, Eigen::all);
    HatRule const own = piece_rule(static_cast<int>(piece.size()));
    auto const before = all.weights.size(), count = own.weights.size();
    all.points.conservativeResize(before + count, Eigen::NoChange);
    all.points.bottomRows(count) = own.hats * corners;
    all.weights.conservativeResize(before + count);
    all.weights.tail(count) = measure_of(corners) * own.weights;
    all.hats.conservativeResize(before + count, Eigen::NoChange);
    all.hats.bottomRows(count).setZero();
    for (std::size_t k = 0; k < piece.size(); ++k)
      all.hats.block(before, piece[k], count, 1) = own.hats.col(static_cast<Eigen::Index>(k));
  }
  return all;
}

HatRule const& hat_rule(int dim, std::size_t nodes) {
  static HatRule const edge = make_rule(linear_pieces(2, 3), (Matrix(3, 1) << -1, 1, 0).finished()),
                       triangle = make_rule(linear_pieces(3, 6), reference_nodes(CellKind::tri6)),
                       square = make_rule(linear_pieces(3, 8), reference_nodes(CellKind::quad8));
  return dim == 2 ? edge : nodes == 6 ? triangle : square;
}

Matrix positions_of(Matrix const& nodes, Facet const& facet) {
  return nodes(facet.nodes, Eigen::all);
}

bool second_order(Matrix const& nodes, Facet const& facet) {
  return linear_pieces(static_cast<int>(nodes.cols()), facet.nodes.size()).size() > 1;
}

} // namespace

Pieces const& linear_pieces(int dim, std::size_t nodes) {
  static Pieces const none, edge2{{0, 1}}, edge3{{0, 2}, {2, 1}}, tri3{{0, 1, 2}}, quad4{{0, 1, 2, 3}},
      tri6{{0, 3, 5}, {1, 4, 3}, {2, 5, 4}, {3, 4, 5}},
      quad8{{0, 4, 7}, {1, 5, 4}, {2, 6, 5}, {3, 7, 6}, {4, 5, 6, 7}};
  if (dim == 2)
    return nodes == 2 ? edge2 : nodes == 3 ? edge3 : none;
  return nodes == 3 ? tri3 : nodes == 4 ? quad4 : nodes == 6 ? tri6 : nodes == 8 ? quad8 : none;
}

Dense hat_products(Matrix const& nodes, Facet const& facet, bool revolved) {
  if (!second_order(nodes, facet))
    return shape_integrals(nodes, facet, revolved).asDiagonal();
  Matrix const positions = positions_of(nodes, facet);
  HatRule const& rule = hat_rule(static_cast<int>(nodes.cols()), facet.nodes.size());
  Dense products = Dense::Zero(positions.rows(), positions.rows());
  if (nodes.cols() == 2) {
    for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
      auto const [N, dN] = edge_shape(3, rule.points(q, 0));
      double const turn = revolved ? 2 * std::numbers::pi * positions.col(0).dot(N) : 1.0;
      products += rule.weights[q] * (positions.transpose() * dN).norm() * turn *
                  rule.hats.row(q).transpose() * N.transpose();
    }
    return products;
  }
  auto const shape = interpolate(facet_kind(facet), rule.points, rule.weights);
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    Eigen::Matrix<double, 3, 2> const tangents =
        positions.transpose() * shape.gradients[static_cast<std::size_t>(q)];
    products += rule.weights[q] * tangents.col(0).cross(tangents.col(1)).norm() *
                rule.hats.row(q).transpose() * shape.shape.row(q);
  }
  return products;
}

namespace {

/// What the surface's nodes, by their numbers among the points, have of it.
struct Ground {
  std::map<Index, Index> number;
  std::vector<double> shapes, hats;           ///< integrals of shape functions and hats
  std::map<Index, std::array<Index, 2>> ends; ///< of the side that a node is in the middle of
  std::vector<double> beside;                 ///< shapes of the middles at a corner
};

Ground survey(Matrix const& nodes, Set const& set, Indices const& points, bool revolved) {
  Ground ground{{},
                std::vector<double>(points.size(), 0.0),
                std::vector<double>(points.size(), 0.0),
                {},
                std::vector<double>(points.size(), 0.0)};
  for (Index const node : points)
    ground.number.emplace(node, static_cast<Index>(ground.number.size()));
  for (auto const& facet : set.facets) {
    Dense const products = hat_products(nodes, facet, revolved);
    auto const here = [&](std::size_t k) { return ground.number.at(facet.nodes[k]); };
    for (std::size_t k = 0; k < facet.nodes.size(); ++k) {
      ground.shapes[ix(here(k))] += products.col(static_cast<Eigen::Index>(k)).sum();
      ground.hats[ix(here(k))] += products.row(static_cast<Eigen::Index>(k)).sum();
    }
    if (!second_order(nodes, facet))
      continue;
    std::size_t const corners = nodes.cols() == 2 ? 2 : facet.nodes.size() / 2;
    for (std::size_t k = 0; corners + k < facet.nodes.size(); ++k)
      ground.ends[here(corners + k)] = {here(k), here((k + 1) % corners)};
  }
  for (auto const& [middle, ends] : ground.ends)
    for (Index const corner : ends)
      ground.beside[ix(corner)] += ground.shapes[ix(middle)];
  return ground;
}

/// What a corner needs of the functions of its middles, in parts of them, to have the area of its hat; none
/// where its own function has a good part of that.
double lent_to(Ground const& ground, std::size_t corner) {
  double const own = ground.shapes[corner], wanted = ground.hats[corner];
  return own > 0.5 * wanted ? 0 : std::min((wanted - own) / ground.beside[corner], 0.45);
}

} // namespace

SurfaceShares surface_shares(Matrix const& nodes, Set const& set, Indices const& points, bool revolved) {
  auto const ground = survey(nodes, set, points, revolved);
  SurfaceShares result{ground.shapes, {}};
  for (Index i = 0; i < static_cast<Index>(points.size()); ++i)
    result.means.push_back({{i, 1}});
  for (auto const& [middle, ends] : ground.ends) {
    std::array<double, 2> const lent{lent_to(ground, ix(ends[0])), lent_to(ground, ix(ends[1]))};
    double const kept = 1 - lent[0] - lent[1];
    auto& mean = result.means[ix(middle)] = {{middle, 1 / kept}};
    result.areas[ix(middle)] *= kept;
    for (std::size_t e = 0; e < 2; ++e)
      if (lent[e] > 0) {
        mean.push_back({ends[e], -lent[e] / kept});
        result.areas[ix(ends[e])] += lent[e] * ground.shapes[ix(middle)];
      }
  }
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!(result.areas[i] > 0))
      throw core::InputError(fmt::format("the facets around node {} are so distorted that no area is left "
                                         "to its contact point; use better shaped or linear cells, or mortar",
                                         points[i]));
  return result;
}

bool shares_well(Matrix const& nodes, Facet const& facet, bool revolved) {
  if (!second_order(nodes, facet))
    return true;
  if (revolved || nodes.cols() == 3)
    return false;
  Vector const shares = shape_integrals(nodes, facet, false);
  return shares.minCoeff() > 0.05 * shares.sum(); // 1/6 where the middle is in the middle
}

} // namespace stiction::mesh
