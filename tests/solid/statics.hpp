// Loads and a sparse direct solution of small static problems, for the tests of solid against closed forms.
#pragma once
#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <numbers>

#include "mesh/topology/surface.hpp"
#include "solid/helpers.hpp"

namespace stiction::test {

/// One body to be solved: unknowns marked in `fixed` stay zero.
struct Problem {
  solid::Body body;
  Kinematics kinematics;
  Vector load;             ///< [dim * nodes], N
  std::vector<bool> fixed; ///< [dim * nodes]

  Problem(solid::Body the_body, Kinematics the_kinematics)
      : body(std::move(the_body)), kinematics(the_kinematics),
        load(Vector::Zero(body.mesh.dim * body.mesh.node_count())), fixed(ix(Index(load.size())), false) {}
  /// Fixes component i of every node where `where(X)`.
  template<class Where> void fix(int i, Where const& where) {
    for (Index node = 0; node < body.mesh.node_count(); ++node)
      if (where(body.mesh.nodes.row(node)))
        fixed[ix(body.mesh.dim * node + i)] = true;
  }
};

/// Calls act(position, N [nodes], outward area) at the quadrature points of a facet; per metre of depth in
/// 2D.
template<class Act> void over_facet(mesh::Mesh const& mesh, mesh::Facet const& facet, Act const& act) {
  Eigen::Matrix3Xd X(3, static_cast<Eigen::Index>(facet.nodes.size()));
  for (Eigen::Index k = 0; k < X.cols(); ++k)
    X.col(k) = node_position(mesh, facet.nodes[static_cast<std::size_t>(k)]);
  if (mesh.dim == 2) { // two points on a straight side; the body lies to the left
    Point const along = (X.col(1) - X.col(0)) / 2;
    for (double const s : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
      Vector const N = Eigen::Vector2d((1 - s) / 2, (1 + s) / 2);
      act(Point(X * N), N, Point(along.y(), -along.x(), 0));
    }
    return;
  }
  auto const& rule = mesh::mass_rule(mesh::facet_kind(facet));
  for (Eigen::Index q = 0; q < rule.weights.size(); ++q) {
    Eigen::Matrix<double, 3, 2> const t = X * rule.gradients[static_cast<std::size_t>(q)];
    Vector const N = rule.shape.row(q).transpose();
    act(Point(X * N), N, Point(rule.weights[q] * t.col(0).cross(t.col(1))));
  }
}

/// Adds the load of a pressure on the facets of linear cells whose every node is `where(X)`.
template<class Where> void add_pressure(Problem& problem, double pressure, Where const& where) {
  auto const& mesh = problem.body.mesh;
  bool const turn = problem.kinematics == Kinematics::axisymmetric;
  for (auto const& facet : mesh::boundary_where(mesh, where).facets)
    over_facet(mesh, facet, [&](Point const& X, Vector const& N, Point const& area) {
      Point const force = -pressure * (turn ? 2 * std::numbers::pi * X.x() : 1.0) * area;
      for (std::size_t k = 0; k < facet.nodes.size(); ++k)
        add_at_node(problem.load, facet.nodes[k], mesh.dim, N[static_cast<Eigen::Index>(k)] * force);
    });
}

/// K(u) with unit rows for the fixed unknowns.
inline Eigen::SparseMatrix<double> sparse_stiffness(Problem const& problem, solid::Cells const& cells,
                                                    Vector const& u) {
  int const dim = problem.body.mesh.dim;
  std::vector<Eigen::Triplet<double>> triplets;
  solid::ScatterMap map;
  each_entry(cells, dim, [&](Index row, Index column) {
    map.push_back(static_cast<Index>(map.size()));
    triplets.emplace_back(std::max(row, column), std::min(row, column), 0.0);
  });
  std::vector<double> values(map.size(), 0.0);
  cells.add_stiffness(view(u), 1, map, values);
  for (std::size_t k = 0; k < values.size(); ++k) {
    auto const row = triplets[k].row(), column = triplets[k].col();
    bool const fixed = problem.fixed[ix(row)] || problem.fixed[ix(column)];
    triplets[k] = {row, column, fixed ? 0.0 : values[k]};
  }
  for (Index i = 0; i < u.size(); ++i)
    if (problem.fixed[ix(i)])
      triplets.emplace_back(i, i, 1.0);
  Eigen::SparseMatrix<double> K(u.size(), u.size());
  K.setFromTriplets(triplets.begin(), triplets.end());
  return K;
}

/// Newton's method in equal steps of the load; a linear law takes one iteration a step. NaN where it fails.
inline Vector solve(Problem const& problem, int steps = 1) {
  solid::Cells const cells(problem.body, problem.kinematics);
  Vector u = Vector::Zero(problem.load.size());
  for (int step = 1; step <= steps; ++step)
    for (int iteration = 0;; ++iteration) {
      Vector residual = problem.load * step / steps - force(cells, u);
      for (Index i = 0; i < u.size(); ++i)
        if (problem.fixed[ix(i)])
          residual[i] = 0;
      if (residual.norm() <= 1e-7 * problem.load.norm())
        break;
      if (iteration == 20 || residual.hasNaN())
        return Vector::Constant(u.size(), std::numeric_limits<double>::quiet_NaN());
      u += Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(sparse_stiffness(problem, cells, u))
               .solve(residual);
    }
  return u;
}

} // namespace stiction::test
