// Polygons on a plane, their common part, and the points of both facets that lie over it.
#include "contact/mortar/tied_cut.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "mesh/cells/quadrature.hpp"
#include "mesh/topology/hats.hpp"

namespace stiction::contact {

namespace {

using Polygon = std::vector<Vec2>; ///< counter-clockwise; of an interval its ends, the lower first

constexpr double face_to_face = 0.5; ///< cosine between one normal and the other turned
constexpr double crumb = 1e-12;      ///< of the piece's area: smaller parts are left out
constexpr double same_place = 1e-12; ///< of a facet's size: nodes where an affine image has them

double parallelogram(Vec2 const& a, Vec2 const& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double area_of(Polygon const& polygon) {
  if (polygon.size() == 2)
    return polygon[1].x() - polygon[0].x();
  double area = 0;
  for (std::size_t k = 2; k < polygon.size(); ++k)
    area += 0.5 * parallelogram(polygon[k - 1] - polygon[0], polygon[k] - polygon[0]);
  return area;
}

/// The part of a polygon left of the line from a to b (Sutherland and Hodgman 1974).
Polygon left_of(Polygon const& polygon, Vec2 const& a, Vec2 const& b) {
  Polygon kept;
  kept.reserve(polygon.size() + 1);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    Vec2 const &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
    double const here = parallelogram(b - a, from - a), there = parallelogram(b - a, to - a);
    if (here >= 0)
      kept.push_back(from);
    if ((here < 0) != (there < 0))
      kept.push_back(from + here / (here - there) * (to - from));
  }
  return kept;
}

Polygon common_part(Polygon polygon, Polygon const& window) {
  if (window.size() == 2)
    return {Vec2(std::max(polygon[0].x(), window[0].x()), 0),
            Vec2(std::min(polygon[1].x(), window[1].x()), 0)};
  for (std::size_t k = 0; k < window.size() && !polygon.empty(); ++k)
    polygon = left_of(polygon, window[k], window[(k + 1) % window.size()]);
  return polygon;
}

/// Are all nodes where three corners (of a line its ends) say?
bool affine(CellFacet const& facet) {
  auto const& x = facet.reference;
  int const corners = facet.corners();
  Vec3 const origin = x.col(0), along = x.col(1) - origin,
             up = corners == 2 ? Vec3(Vec3::Zero()) : Vec3(x.col(corners - 1) - origin);
  Vec2 const first = corner_coordinates(facet.kind, 0);
  double const span = (corner_coordinates(facet.kind, 1) - first).x();
  for (int k = 2; k < facet.count(); ++k) {
    Vec2 at = k < corners ? corner_coordinates(facet.kind, k) : Vec2(0, 0);
    if (k >= corners && corners == 2)
      at = middle_coordinates(facet.kind);
    else if (k >= corners)
      at = coordinates_on_side(facet.kind, k - corners, 0.5);
    Vec2 const part = (at - first) / span;
    if ((origin + part.x() * along + part.y() * up - x.col(k)).norm() >
        same_place * (along.norm() + up.norm()))
      return false;
  }
  return true;
}

/// visit(point, weight) over an interval, or over the triangles that a polygon falls into.
template<class Visit> void each_quadrature_point(Polygon const& polygon, int order, Visit const& visit) {
  static mesh::Rule const coarse = mesh::line_rule(4), fine = mesh::line_rule(8);
  auto const& rule = order == 4 ? coarse : fine;
  auto const along = [&](Eigen::Index q) { return 0.5 * (1 + rule.points(q, 0)); };
  if (polygon.size() == 2)
    for (Eigen::Index q = 0; q < order; ++q)
      visit(polygon[0] + along(q) * (polygon[1] - polygon[0]), 0.5 * rule.weights[q] * area_of(polygon));
  for (std::size_t k = 2; k < polygon.size(); ++k) { // a square each, shrunk at one side
    Vec2 const u = polygon[k - 1] - polygon[0], v = polygon[k] - polygon[k - 1];
    for (Eigen::Index q = 0; q < order * order; ++q) {
      auto const i = q / order, j = q % order;
      double const weight = 0.25 * rule.weights[i] * rule.weights[j] * along(i) * parallelogram(u, v);
      visit(polygon[0] + along(i) * (u + along(j) * v), weight);
    }
  }
}

} // namespace

TiedGround::TiedGround(CellFacet const& facet, int dim, bool around)
    : facet_(&facet), dim_(dim), around_(around) {
  auto const& x = facet.reference;
  for (auto const& nodes : mesh::linear_pieces(dim, ix(facet.count()))) {
    Piece piece{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), {}, 0};
    for (int const node : nodes)
      piece.middle += x.col(node) / static_cast<double>(nodes.size());
    piece.right = (x.col(nodes[1]) - x.col(nodes[0])).normalized();
    if (dim == 2) {
      piece.normal = Vec3(piece.right.y(), -piece.right.x(), 0);
    } else {
      for (std::size_t k = 2; k < nodes.size(); ++k)
        piece.normal +=
            Vec3(x.col(nodes[k - 1]) - x.col(nodes[0])).cross(Vec3(x.col(nodes[k]) - x.col(nodes[0])));
      piece.normal.normalize();
      piece.right = (piece.right - piece.normal.dot(piece.right) * piece.normal).normalized();
      piece.up = piece.normal.cross(piece.right);
    }
    for (int const node : nodes)
      piece.corners.push_back(piece.on(x.col(node)));
    piece.area = area_of(piece.corners);
    area_ += piece.area;
    pieces_.push_back(std::move(piece));
  }
}

TiedPart TiedGround::common(CellFacet const& other) const {
  TiedPart part;
  TiedGround const beyond(other, dim_, false);
  for (auto const& piece : pieces_)
    for (auto const& facet : beyond.pieces_) {
      if (piece.normal.dot(facet.normal) > -face_to_face)
        continue;
      Polygon polygon;
      for (auto corner = facet.corners.rbegin(); corner != facet.corners.rend(); ++corner)
        polygon.push_back(piece.on(facet.middle + corner->x() * facet.right + corner->y() * facet.up));
      polygon = common_part(std::move(polygon), piece.corners);
      if (polygon.size() >= ix(dim_) && area_of(polygon) > crumb * piece.area)
        add_points(piece, polygon, other, part);
    }
  return part;
}

void TiedGround::add_points(Piece const& piece, Polygon const& polygon, CellFacet const& other,
                            TiedPart& part) const {
  int const order = affine(*facet_) && affine(other) ? 4 : 8;
  part.area += area_of(polygon);
  each_quadrature_point(polygon, order, [&](Vec2 const& at, double weight) {
    TiedPoint point{weight, shape_at(piece, *facet_, at), shape_at(piece, other, at)};
    Vec3 const here = facet_->reference * point.own, there = other.reference * point.other;
    part.gap = std::max(part.gap, std::abs(piece.normal.dot(there - here)));
    if (around_)
      point.weight *= 2 * std::numbers::pi * here.x();
    part.points.push_back(point);
  });
}

/// Shape functions where a facet lies over a point of the plane, by Newton's method from the middle.
PerNode TiedGround::shape_at(Piece const& piece, CellFacet const& facet, Vec2 const& point) const {
  Vec2 at = middle_coordinates(facet.kind);
  FacetNodes<3> const nodes = facet.reference.colwise() - piece.middle; // far off it digits are lost else
  for (int iteration = 0; iteration < 30; ++iteration) {
    auto const shape = facet_shape(facet.kind, at);
    Vec3 const here = nodes * shape.N;
    Vec2 const off = point - Vec2(piece.right.dot(here), piece.up.dot(here));
    Eigen::Matrix2d J = Eigen::Matrix2d::Identity();
    for (int a = 0; a < dim_ - 1; ++a) {
      Vec3 const along = facet.reference * shape.by[ix(a)];
      J.col(a) = Vec2(piece.right.dot(along), piece.up.dot(along));
    }
    if (dim_ == 2)
      J(1, 0) = 0;
    Vec2 const move = J.inverse() * off;
    at += move;
    if (!(move.norm() > same_place))
      return facet_shape(facet.kind, at).N;
  }
  throw core::InputError("a facet is too distorted to be projected on its counterpart");
}

} // namespace stiction::contact
