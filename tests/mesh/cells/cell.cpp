// Shape functions, quadrature and facets of every cell kind.
#include <cmath>
#include <doctest/doctest.h>
#include <numeric>
#include <set>

#include "mesh/cells/cell.hpp"
#include "mesh/cells/quadrature.hpp"
#include "mesh/helpers.hpp"
#include "mesh/topology/surface.hpp"

using namespace stiction;
using namespace stiction::mesh;

namespace {

/// Three points inside the reference cells of dimension 2 or 3.
Matrix inner_points(int dim) {
  Matrix points(3, 3);
  points << 0.2, 0.3, 0.15, 0.11, 0.57, 0.22, 0.45, 0.05, 0.31;
  return points.leftCols(dim);
}

Matrix shape_at(CellKind kind, Matrix const& points) {
  return interpolate(kind, points, Vector::Ones(points.rows())).shape;
}

bool simplex(CellInfo const& cell) {
  return cell.corners == cell.dim + 1;
}

using Powers = std::array<int, 3>;

/// Integral of x^a y^b z^c over the reference cell.
double exact_moment(CellInfo const& cell, Powers const& power) {
  double result = 1;
  int sum = 0;
  for (int d = 0; d < cell.dim; ++d) {
    int const n = power[static_cast<std::size_t>(d)];
    sum += n;
    result *= simplex(cell) ? std::tgamma(n + 1) : n % 2 == 1 ? 0.0 : 2.0 / (n + 1);
  }
  return simplex(cell) ? result / std::tgamma(sum + cell.dim + 1) : result;
}

double moment(Interpolation const& rule, Powers const& power) {
  double sum = 0;
  for (Eigen::Index i = 0; i < rule.weights.size(); ++i) {
    double term = rule.weights[i];
    for (Eigen::Index d = 0; d < rule.points.cols(); ++d)
      term *= std::pow(rule.points(i, d), power[static_cast<std::size_t>(d)]);
    sum += term;
  }
  return sum;
}

/// All powers up to the degree d: in total for simplices, per direction for others.
std::vector<Powers> powers(CellInfo const& cell, int d) {
  std::vector<Powers> result;
  for (int a = 0; a <= d; ++a)
    for (int b = 0; b <= d; ++b)
      for (int c = 0; c <= (cell.dim == 3 ? d : 0); ++c)
        if (!simplex(cell) || a + b + c <= d)
          result.push_back({a, b, c});
  return result;
}

/// Largest total degree (triangles) or degree per direction (squares) that the rule integrates.
int degree(CellInfo const& cell, Interpolation const& rule) {
  for (int d = 0; d < 12; ++d)
    for (auto const& power : powers(cell, d))
      if (std::abs(moment(rule, power) - exact_moment(cell, power)) > 1e-13)
        return d - 1;
  return 12;
}

/// The cell itself as a mesh, bent by a smooth map when asked.
Mesh single(CellKind kind, bool bent) {
  Mesh mesh;
  mesh.dim = info(kind).dim;
  mesh.nodes = reference_nodes(kind);
  for (Eigen::Index i = 0; bent && i < mesh.nodes.rows(); ++i) {
    Eigen::RowVectorXd const x = mesh.nodes.row(i);
    mesh.nodes(i, 0) += 0.1 * x[1] * x[mesh.dim - 1] - 0.05 * x[1] * x[1];
    mesh.nodes(i, 1) += 0.2 * x[0] + 0.07 * x[0] * x[0] * x[mesh.dim - 1];
  }
  Block block{kind, Indices(static_cast<std::size_t>(info(kind).nodes))};
  std::iota(block.nodes.begin(), block.nodes.end(), 0);
  mesh.blocks.push_back(std::move(block));
  return mesh;
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("the table of cells is in the order of CellKind and its names are found") {
    int position = 0;
    for (auto const& cell : cell_table()) {
      CHECK(static_cast<int>(cell.kind) == position++);
      CHECK(info(cell.kind).name == cell.name);
      CHECK(kind_named(cell.name) == cell.kind);
    }
    CHECK_FALSE(kind_named("quad9").has_value());
  }

  TEST_CASE("shape functions sum to one and are one at their own node") {
    for (auto const& cell : cell_table()) {
      CAPTURE(cell.name);
      Matrix const sums = shape_at(cell.kind, inner_points(cell.dim)).rowwise().sum();
      CHECK((sums.array() - 1).abs().maxCoeff() < 1e-14);
      Matrix const own = shape_at(cell.kind, reference_nodes(cell.kind));
      CHECK((own - Matrix::Identity(cell.nodes, cell.nodes)).cwiseAbs().maxCoeff() < 1e-14);
    }
  }

  TEST_CASE("shape function derivatives match central differences at second order") {
    for (auto const& cell : cell_table()) {
      CAPTURE(cell.name);
      Matrix const points = inner_points(cell.dim);
      auto const exact = interpolate(cell.kind, points, Vector::Ones(3)).gradients;
      auto const error = [&](double h) {
        double most = 0;
        for (int direction = 0; direction < cell.dim; ++direction) {
          Matrix up = points, down = points;
          up.col(direction).array() += h;
          down.col(direction).array() -= h;
          Matrix const slope = (shape_at(cell.kind, up) - shape_at(cell.kind, down)) / (2 * h);
          for (int i = 0; i < 3; ++i)
            most =
                std::max(most, (slope.row(i).transpose() - exact[static_cast<std::size_t>(i)].col(direction))
                                   .cwiseAbs()
                                   .maxCoeff());
        }
        return most;
      };
      // per direction all kinds are at most quadratic, for which central differences are exact
      CHECK(error(1e-2) < 1e-12);
      CHECK(error(1e-3) < 1e-11);
    }
  }

  TEST_CASE("one-sided differences of shape functions converge at first order") {
    for (auto const kind : {CellKind::quad8, CellKind::tet10, CellKind::hex20}) {
      Matrix const points = inner_points(info(kind).dim);
      auto const exact = interpolate(kind, points, Vector::Ones(3)).gradients[0];
      auto const error = [&](double h) {
        Matrix up = points;
        up.col(0).array() += h;
        Matrix const slope = (shape_at(kind, up) - shape_at(kind, points)) / h;
        return (slope.row(0).transpose() - exact.col(0)).cwiseAbs().maxCoeff();
      };
      CHECK(error(1e-3) / error(5e-4) == doctest::Approx(2).epsilon(0.01));
    }
  }

  TEST_CASE("linear fields and on second order kinds quadratic ones are interpolated exactly") {
    for (auto const& cell : cell_table()) {
      CAPTURE(cell.name);
      bool const second_order = cell.nodes > cell.corners;
      Eigen::RowVectorXd all(3);
      all << 1.5, -2, 0.7;
      Eigen::RowVectorXd const slope = all.head(cell.dim);
      Matrix curvature(3, 3);
      curvature << 0.3, -0.8, 0.4, -0.8, 1.1, 0.6, 0.4, 0.6, -0.5;
      Matrix const C = (second_order ? 1.0 : 0.0) * curvature.topLeftCorner(cell.dim, cell.dim);
      auto const field = [&](Eigen::RowVectorXd const& x) { return 2 + slope.dot(x) + x.dot(x * C) / 2; };
      Vector nodal(cell.nodes);
      for (int i = 0; i < cell.nodes; ++i)
        nodal[i] = field(reference_nodes(cell.kind).row(i));
      auto const at = interpolate(cell.kind, inner_points(cell.dim), Vector::Ones(3));
      for (int i = 0; i < 3; ++i) {
        Eigen::RowVectorXd const x = at.points.row(i);
        CHECK(at.shape.row(i).dot(nodal) == doctest::Approx(field(x)).epsilon(1e-13));
        CHECK((nodal.transpose() * at.gradients[static_cast<std::size_t>(i)] - slope - x * C).norm() < 1e-13);
      }
    }
  }

  TEST_CASE("quadrature is exact to the degree each kind needs") {
    struct Wanted {
      CellKind kind;
      int points, stiffness, mass;
    };
    for (auto const& wanted :
         {Wanted{CellKind::tri3, 1, 1, 2}, Wanted{CellKind::tri6, 3, 2, 4}, Wanted{CellKind::quad4, 4, 3, 3},
          Wanted{CellKind::quad8, 9, 5, 5}, Wanted{CellKind::tet4, 1, 1, 2}, Wanted{CellKind::tet10, 4, 2, 5},
          Wanted{CellKind::hex8, 8, 3, 3}, Wanted{CellKind::hex20, 27, 5, 5}}) {
      auto const& cell = info(wanted.kind);
      CAPTURE(cell.name);
      CHECK(stiffness_rule(wanted.kind).points.rows() == wanted.points);
      CHECK(degree(cell, stiffness_rule(wanted.kind)) == wanted.stiffness);
      CHECK(degree(cell, mass_rule(wanted.kind)) == wanted.mass);
    }
  }

  TEST_CASE("a Gauss rule of n points on a line is exact to degree 2 n - 1 and no further") {
    for (int const n : {1, 4, 8}) {
      Rule const rule = line_rule(n);
      CAPTURE(n);
      for (int degree = 0; degree <= 2 * n; ++degree) {
        double const sum = rule.weights.dot(rule.points.col(0).array().pow(degree).matrix());
        double const off = std::abs(sum - (degree % 2 == 0 ? 2.0 / (degree + 1) : 0));
        CHECK((degree < 2 * n ? off < 1e-14 : off > 1e-6));
      }
    }
  }

  TEST_CASE("facets run round the cell with the body to their left and their mid node in the middle") {
    for (auto const& cell : cell_table(2)) {
      CAPTURE(cell.name);
      Matrix const& nodes = reference_nodes(cell.kind);
      double area = 0;
      for (auto const& facet : cell.facets) {
        auto const a = nodes.row(facet[0]), b = nodes.row(facet[1]);
        area += (a[0] * b[1] - a[1] * b[0]) / 2;
        if (facet.size() == 3)
          CHECK((nodes.row(facet[2]) - (a + b) / 2).norm() < 1e-15);
      }
      CHECK(area == doctest::Approx(cell.corners == 3 ? 0.5 : 4.0));
    }
  }

  TEST_CASE("edges have their mid node at corners + i and every corner pair of a facet is an edge") {
    for (auto const& cell : cell_table()) {
      CAPTURE(cell.name);
      Matrix const& nodes = reference_nodes(cell.kind);
      std::set<std::pair<int, int>> edges;
      for (std::size_t i = 0; i < cell.edges.size(); ++i) {
        auto const [a, b] = cell.edges[i];
        edges.insert(std::minmax(a, b));
        if (cell.nodes > cell.corners)
          CHECK((nodes.row(cell.corners + static_cast<int>(i)) - (nodes.row(a) + nodes.row(b)) / 2).norm() <
                1e-15);
      }
      CHECK(edges.size() == cell.edges.size());
      if (cell.nodes > cell.corners)
        CHECK(static_cast<int>(edges.size()) == cell.nodes - cell.corners);
      for (auto const& facet : cell.facets)
        for (int k = 0; cell.dim == 3 && k < info(facet_kind({{facet.begin(), facet.end()}})).corners; ++k) {
          int const corners = info(facet_kind({{facet.begin(), facet.end()}})).corners;
          CHECK(edges.contains(std::minmax(facet[static_cast<std::size_t>(k)],
                                           facet[static_cast<std::size_t>((k + 1) % corners)])));
        }
    }
  }

  TEST_CASE("facets of solid cells face outwards: the flux of the position over three is the volume") {
    for (auto const& cell : cell_table(3))
      for (bool const bent : {false, true}) {
        CAPTURE(cell.name);
        CAPTURE(bent);
        Mesh const mesh = single(cell.kind, bent);
        auto const facets = boundary(mesh);
        CHECK(facets.size() == cell.facets.size());
        double const volume = test::volume(mesh);
        CHECK(volume > 0.9 * exact_moment(cell, {0, 0, 0}));
        CHECK(test::enclosed_volume(mesh, facets) == doctest::Approx(volume).epsilon(1e-12));
        for (auto const& facet : facets) { // each by itself, as seen from the middle
          Eigen::RowVectorXd const middle = mesh.nodes.colwise().mean();
          Mesh moved = mesh;
          moved.nodes.rowwise() -= middle;
          CHECK(test::enclosed_volume(moved, {facet}) > 0.1 * volume / static_cast<double>(facets.size()));
        }
      }
  }

  TEST_CASE("gmsh's orders are permutations that keep the corners") {
    for (auto const& cell : cell_table()) {
      auto order = cell.gmsh_order;
      for (int i = 0; i < cell.corners; ++i)
        CHECK(order[static_cast<std::size_t>(i)] == i);
      std::sort(order.begin(), order.end());
      for (int i = 0; i < cell.nodes; ++i)
        CHECK(order.at(static_cast<std::size_t>(i)) == i);
    }
  }
}
