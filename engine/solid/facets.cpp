// Quadrature of area vectors over facets of every kind.
#include "solid/facets.hpp"

#include <Eigen/Geometry>
#include <numbers>

#include "mesh/cells/quadrature.hpp"
#include "mesh/topology/surface.hpp"
#include "mesh/topology/traction.hpp"

namespace stiction::solid {

namespace {

constexpr double turn = 2 * std::numbers::pi;

/// [v]x: its product with w is v x w.
Eigen::Matrix3d cross_matrix(Eigen::Vector3d const& v) {
  Eigen::Matrix3d m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

/// One quadrature point: weight, functions and their derivatives, area vector and its derivative by x.
struct Spot {
  double weight = 0;
  Vector N;        ///< [nodes]
  Dense dN;        ///< [nodes, dim - 1]
  Vector x, a;     ///< [dim]
  Dense a_by_x;    ///< [dim, dim nodes]
  double ring = 1; ///< 2 pi r about an axis
};

void set_area_vector(Matrix const& x, Spot& spot) {
  auto const n = spot.N.size(), dim = x.cols();
  Dense const tangents = x.transpose() * spot.dN;
  spot.a_by_x.setZero(dim, dim * n);
  if (dim == 2) { // the body lies to the left of the tangent
    spot.a = Eigen::Vector2d(tangents(1, 0), -tangents(0, 0));
    for (Eigen::Index j = 0; j < n; ++j) {
      spot.a_by_x(0, 2 * j + 1) = spot.dN(j, 0);
      spot.a_by_x(1, 2 * j) = -spot.dN(j, 0);
    }
    return;
  }
  Eigen::Vector3d const t1 = tangents.col(0), t2 = tangents.col(1);
  spot.a = t1.cross(t2);
  for (Eigen::Index j = 0; j < n; ++j)
    spot.a_by_x.middleCols<3>(3 * j) = spot.dN(j, 1) * cross_matrix(t1) - spot.dN(j, 0) * cross_matrix(t2);
}

/// Calls visit(spot) for every quadrature point.
template<class Visit> void each_spot(Kinematics kinematics, Matrix const& x, Visit const& visit) {
  auto const finish = [&](Spot& spot) {
    spot.x = x.transpose() * spot.N;
    set_area_vector(x, spot);
    if (kinematics == Kinematics::axisymmetric)
      spot.ring = turn * spot.x[0];
    visit(spot);
  };
  Spot spot;
  if (x.cols() == 2) {
    static mesh::Rule const rule = mesh::cube_rule(1, 4);
    for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
      auto const [N, dN] = mesh::edge_shape(static_cast<std::size_t>(x.rows()), rule.points(q, 0));
      spot.weight = rule.weights[q];
      spot.N = N;
      spot.dN = dN;
      finish(spot);
    }
    return;
  }
  mesh::Facet const of_so_many{Indices(static_cast<std::size_t>(x.rows()))};
  auto const& rule = mesh::mass_rule(mesh::facet_kind(of_so_many));
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    spot.weight = rule.weights[q];
    spot.N = rule.shape.row(q).transpose();
    spot.dN = rule.gradients[static_cast<std::size_t>(q)];
    finish(spot);
  }
}

void add_normals_by_x(Spot const& spot, bool revolved, Dense& sum) {
  auto const dim = spot.a.size();
  for (Eigen::Index i = 0; i < spot.N.size(); ++i) {
    auto rows = sum.middleRows(dim * i, dim);
    rows += (spot.weight * spot.ring * spot.N[i]) * spot.a_by_x;
    for (Eigen::Index j = 0; revolved && j < spot.N.size(); ++j)
      rows.col(dim * j) += (spot.weight * turn * spot.N[i] * spot.N[j]) * spot.a;
  }
}

/// |a| ring by x twice, from a by x once (a_by_x) and, in space, twice (the last part).
void add_area_by_x2(Spot const& spot, bool revolved, Dense& sum) {
  auto const dim = spot.a.size();
  double const size = spot.a.norm();
  Vector const n = spot.a / size, along = spot.a_by_x.transpose() * n;
  sum +=
      (spot.weight * spot.ring / size) * (spot.a_by_x.transpose() * spot.a_by_x - along * along.transpose());
  Vector radial = Vector::Zero(along.size());
  for (Eigen::Index j = 0; revolved && j < spot.N.size(); ++j)
    radial[dim * j] = turn * spot.N[j];
  if (revolved)
    sum += spot.weight * (radial * along.transpose() + along * radial.transpose());
  if (dim == 2)
    return;
  Eigen::Matrix3d const turned = cross_matrix(n).transpose();
  for (Eigen::Index i = 0; i < spot.N.size(); ++i)
    for (Eigen::Index j = 0; j < spot.N.size(); ++j)
      sum.block<3, 3>(3 * i, 3 * j) +=
          (spot.weight * (spot.dN(i, 0) * spot.dN(j, 1) - spot.dN(i, 1) * spot.dN(j, 0))) * turned;
}

} // namespace

FacetTerms facet_terms(Kinematics kinematics, Matrix const& x, Point const& centre, FacetOrder order) {
  auto const n = x.rows(), dim = x.cols();
  bool const revolved = kinematics == Kinematics::axisymmetric;
  FacetTerms sum;
  sum.normals.setZero(dim * n);
  if (order != FacetOrder::values)
    sum.area_by_x.setZero(dim * n);
  if (order == FacetOrder::second) {
    sum.normals_by_x.setZero(dim * n, dim * n);
    sum.area_by_x2.setZero(dim * n, dim * n);
  }
  each_spot(kinematics, x, [&](Spot const& spot) {
    double const size = spot.a.norm(), weight = spot.weight;
    sum.area += weight * spot.ring * size;
    sum.volume += revolved ? weight * 0.5 * spot.ring * spot.x[0] * spot.a[0]
                           : weight * (spot.x - centre.head(dim)).dot(spot.a) / static_cast<double>(dim);
    for (Eigen::Index i = 0; i < n; ++i)
      sum.normals.segment(dim * i, dim) += (weight * spot.ring * spot.N[i]) * spot.a;
    if (order == FacetOrder::values)
      return;
    sum.area_by_x += (weight * spot.ring / size) * (spot.a_by_x.transpose() * spot.a);
    for (Eigen::Index j = 0; revolved && j < n; ++j)
      sum.area_by_x[dim * j] += weight * turn * spot.N[j] * size;
    if (order != FacetOrder::second)
      return;
    add_normals_by_x(spot, revolved, sum.normals_by_x);
    add_area_by_x2(spot, revolved, sum.area_by_x2);
  });
  return sum;
}

int sides_of(std::size_t nodes, Eigen::Index dim) {
  return dim == 2 ? 2 : nodes % 4 == 0 ? 4 : 3;
}

Indices corners_of(mesh::Facet const& facet, int side, Eigen::Index dim) {
  auto const first = static_cast<std::size_t>(side);
  if (dim == 2)
    return {facet.nodes[first]};
  return {facet.nodes[first],
          facet.nodes[(first + 1) % static_cast<std::size_t>(sides_of(facet.nodes.size(), dim))]};
}

namespace {

/// Of an end: the strip down to the plane goes on with the facet after its second node, before its first.
void add_end(Kinematics kinematics, Vector const& x, int side, Plane const& plane, FacetTerms& terms) {
  bool const revolved = kinematics == Kinematics::axisymmetric;
  Eigen::Vector2d const n = plane.normal.head<2>(), off = x - plane.point.head<2>();
  Eigen::Vector2d const by_height = (side == 1 ? 1 : -1) * Eigen::Vector2d(-n.y(), n.x());
  Eigen::Vector2d const a = off.dot(n) * by_height;
  double const ring = revolved ? turn * x[0] : 1;
  terms.volume += 0.5 * (revolved ? ring * x[0] * a[0] : off.dot(a));
  terms.normals.segment<2>(2 * side) += ring * a;
  if (terms.normals_by_x.size() == 0)
    return;
  auto own = terms.normals_by_x.block<2, 2>(2 * side, 2 * side);
  own += ring * by_height * n.transpose();
  if (revolved)
    own.col(0) += turn * a;
}

/// Of an edge, whose nodes are these of the facet's.
void add_edge(Matrix const& x, Indices const& nodes, Plane const& plane, FacetTerms& terms) {
  static mesh::Rule const rule = mesh::cube_rule(1, 4);
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    auto const [N, dN] = mesh::edge_shape(nodes.size(), rule.points(q, 0));
    Eigen::Vector3d off = -plane.point, along = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      off += N[static_cast<Eigen::Index>(i)] * x.row(nodes[i]).transpose();
      along += dN[static_cast<Eigen::Index>(i)] * x.row(nodes[i]).transpose();
    }
    double const height = off.dot(plane.normal);
    Eigen::Vector3d const across = rule.weights[q] * along.cross(plane.normal);
    terms.volume += height * off.dot(across) / 3;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      double const own = N[static_cast<Eigen::Index>(i)];
      terms.normals.segment<3>(3 * nodes[i]) += own * height * across;
      for (std::size_t j = 0; terms.normals_by_x.size() > 0 && j < nodes.size(); ++j)
        terms.normals_by_x.block<3, 3>(3 * nodes[i], 3 * nodes[j]) +=
            own * (N[static_cast<Eigen::Index>(j)] * across * plane.normal.transpose() -
                   rule.weights[q] * height * dN[static_cast<Eigen::Index>(j)] * cross_matrix(plane.normal));
    }
  }
}

} // namespace

void add_skirt(Kinematics kinematics, Matrix const& x, int side, Plane const& plane, FacetTerms& terms) {
  auto const dim = x.cols();
  if (dim == 2)
    return add_end(kinematics, x.row(side).transpose(), side, plane, terms);
  int const corners = sides_of(static_cast<std::size_t>(x.rows()), dim);
  Indices nodes{side, (side + 1) % corners};
  if (x.rows() > corners)
    nodes.push_back(corners + side);
  add_edge(x, nodes, plane, terms);
}

} // namespace stiction::solid
