// Lagrange functions on simplices, serendipity functions on square and cube.
#include "mesh/cells/shapes.hpp"

#include <array>
#include <vector>

namespace stiction::mesh {

namespace {

using RowVector = Eigen::RowVectorXd;

using Edges = std::vector<std::array<int, 2>>;

/// Quadratic functions of the barycentric coordinates L, whose derivatives are dL [corners, dim]:
/// L (2 L - 1) at the corners, 4 La Lb on the edges.
ShapeValues quadratic_simplex(RowVector const& L, Matrix const& dL, Edges const& edges) {
  auto const corners = L.size(), nodes = corners + static_cast<Eigen::Index>(edges.size());
  ShapeValues out{RowVector(nodes), Matrix(nodes, dL.cols())};
  for (Eigen::Index a = 0; a < corners; ++a) {
    out.N[a] = L[a] * (2 * L[a] - 1);
    out.dN.row(a) = (4 * L[a] - 1) * dL.row(a);
  }
  auto m = corners;
  for (auto const& [a, b] : edges) {
    out.N[m] = 4 * L[a] * L[b];
    out.dN.row(m++) = 4 * (L[a] * dL.row(b) + L[b] * dL.row(a));
  }
  return out;
}

/// Derivatives of the barycentric coordinates (1 - sum x, x). [dim + 1, dim]
Matrix barycentric_slopes(Eigen::Index dim) {
  Matrix slopes(dim + 1, dim);
  slopes << RowVector::Constant(dim, -1), Matrix::Identity(dim, dim);
  return slopes;
}

RowVector barycentric(ReferencePoint const& x) {
  RowVector L(x.size() + 1);
  L << 1 - x.sum(), x;
  return L;
}

/// Multilinear functions, product of (1 + s x) / 2, of the corners s. [corners, dim]
ShapeValues multilinear(Matrix const& corners, ReferencePoint const& x) {
  auto const dim = x.size();
  ShapeValues out{RowVector(corners.rows()), Matrix(corners.rows(), dim)};
  auto& [N, dN] = out;
  for (Eigen::Index a = 0; a < N.size(); ++a) {
    RowVector const factor = (1 + corners.row(a).array() * x.array()) / 2;
    N[a] = factor.prod();
    for (Eigen::Index d = 0; d < dim; ++d) {
      RowVector others = factor;
      others[d] = corners(a, d) / 2;
      dN(a, d) = others.prod();
    }
  }
  return out;
}

/// Serendipity functions on nodes s in {-1, 0, 1}: prod(1 + s x) (sum s x - dim + 1) / 2^dim at corners,
/// (1 - x_d^2) prod of the others / 2^(dim - 1) on the edge along d.
ShapeValues serendipity(Matrix const& nodes, ReferencePoint const& x) {
  auto const dim = x.size();
  ShapeValues out{RowVector(nodes.rows()), Matrix(nodes.rows(), dim)};
  auto& [N, dN] = out;
  for (Eigen::Index a = 0; a < N.size(); ++a) {
    RowVector const s = nodes.row(a);
    RowVector factor(dim), slope(dim);
    bool corner = true;
    for (Eigen::Index d = 0; d < dim; ++d) {
      bool const along = s[d] == 0;
      corner = corner && !along;
      factor[d] = along ? 1 - x[d] * x[d] : (1 + s[d] * x[d]) / 2;
      slope[d] = along ? -2 * x[d] : s[d] / 2;
    }
    double const sum = corner ? s.dot(x) - static_cast<double>(dim) + 1 : 1;
    N[a] = factor.prod() * sum;
    for (Eigen::Index d = 0; d < dim; ++d) {
      RowVector others = factor;
      others[d] = slope[d];
      dN(a, d) = others.prod() * sum + (corner ? factor.prod() * s[d] : 0);
    }
  }
  return out;
}

} // namespace

Matrix const& triangle_nodes() {
  static Matrix const nodes = (Matrix(6, 2) << 0, 0, 1, 0, 0, 1, .5, 0, .5, .5, 0, .5).finished();
  return nodes;
}

Matrix const& tetrahedron_nodes() {
  static Matrix const nodes = (Matrix(10, 3) << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, //
                               .5, 0, 0, .5, .5, 0, 0, .5, 0, 0, 0, .5, .5, 0, .5, 0, .5, .5)
                                  .finished();
  return nodes;
}

Matrix const& square_nodes() {
  static Matrix const nodes =
      (Matrix(8, 2) << -1, -1, 1, -1, 1, 1, -1, 1, 0, -1, 1, 0, 0, 1, -1, 0).finished();
  return nodes;
}

Matrix const& cube_nodes() {
  static Matrix const nodes = (Matrix(20, 3) << -1, -1, -1, 1, -1, -1, 1, 1, -1, -1, 1, -1, //
                               -1, -1, 1, 1, -1, 1, 1, 1, 1, -1, 1, 1,                      //
                               0, -1, -1, 1, 0, -1, 0, 1, -1, -1, 0, -1,                    //
                               0, -1, 1, 1, 0, 1, 0, 1, 1, -1, 0, 1,                        //
                               -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0)
                                  .finished();
  return nodes;
}

ShapeValues shape_tri3(ReferencePoint const& x) {
  return {barycentric(x), barycentric_slopes(2)};
}

ShapeValues shape_tri6(ReferencePoint const& x) {
  return quadratic_simplex(barycentric(x), barycentric_slopes(2), {{0, 1}, {1, 2}, {2, 0}});
}

ShapeValues shape_tet4(ReferencePoint const& x) {
  return {barycentric(x), barycentric_slopes(3)};
}

ShapeValues shape_tet10(ReferencePoint const& x) {
  return quadratic_simplex(barycentric(x), barycentric_slopes(3),
                           {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}});
}

ShapeValues shape_quad4(ReferencePoint const& x) {
  return multilinear(square_nodes().topRows(4), x);
}

ShapeValues shape_quad8(ReferencePoint const& x) {
  return serendipity(square_nodes(), x);
}

ShapeValues shape_hex8(ReferencePoint const& x) {
  return multilinear(cube_nodes().topRows(8), x);
}

ShapeValues shape_hex20(ReferencePoint const& x) {
  return serendipity(cube_nodes(), x);
}

} // namespace stiction::mesh
