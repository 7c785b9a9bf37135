// Shape functions, quadrature and facets of every cell kind.
#include <cmath>
#include <doctest/doctest.h>

#include "mesh/cell.hpp"

using namespace stiction;
using namespace stiction::mesh;

namespace {

Matrix const inner_points = (Matrix(3, 2) << 0.2, 0.3, 0.11, 0.57, 0.45, 0.05).finished();

Matrix shape_at(CellKind kind, Matrix const& points) {
  return interpolate(kind, points, Vector::Ones(points.rows())).shape;
}

/// Integral of x^a y^b over the reference cell.
double exact_moment(CellInfo const& cell, int a, int b) {
  if (cell.corners == 3)
    return std::tgamma(a + 1) * std::tgamma(b + 1) / std::tgamma(a + b + 3);
  auto const line = [](int n) { return n % 2 == 1 ? 0.0 : 2.0 / (n + 1); };
  return line(a) * line(b);
}

double moment(Interpolation const& rule, int a, int b) {
  double sum = 0;
  for (Eigen::Index i = 0; i < rule.weights.size(); ++i)
    sum += rule.weights[i] * std::pow(rule.points(i, 0), a) * std::pow(rule.points(i, 1), b);
  return sum;
}

/// Largest total degree (triangles) or degree per direction (squares) that the rule integrates.
int degree(CellInfo const& cell, Interpolation const& rule) {
  for (int d = 0; d < 12; ++d)
    for (int a = 0; a <= d; ++a)
      for (int b = 0; b <= (cell.corners == 3 ? d - a : d); ++b)
        if (std::abs(moment(rule, a, b) - exact_moment(cell, a, b)) > 1e-13)
          return d - 1;
  return 12;
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
      Matrix const sums = shape_at(cell.kind, inner_points).rowwise().sum();
      CHECK((sums.array() - 1).abs().maxCoeff() < 1e-14);
      Matrix const own = shape_at(cell.kind, reference_nodes(cell.kind));
      CHECK((own - Matrix::Identity(cell.nodes, cell.nodes)).cwiseAbs().maxCoeff() < 1e-14);
    }
  }

  TEST_CASE("shape function derivatives match central differences at second order") {
    for (auto const& cell : cell_table()) {
      CAPTURE(cell.name);
      auto const exact = interpolate(cell.kind, inner_points, Vector::Ones(3)).gradients;
      auto const error = [&](double h) {
        double most = 0;
        for (int direction = 0; direction < 2; ++direction) {
          Matrix up = inner_points, down = inner_points;
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
    auto const exact = interpolate(CellKind::quad8, inner_points, Vector::Ones(3)).gradients[0];
    auto const error = [&](double h) {
      Matrix up = inner_points;
      up.col(0).array() += h;
      Matrix const slope = (shape_at(CellKind::quad8, up) - shape_at(CellKind::quad8, inner_points)) / h;
      return (slope.row(0).transpose() - exact.col(0)).cwiseAbs().maxCoeff();
    };
    CHECK(error(1e-3) / error(5e-4) == doctest::Approx(2).epsilon(0.01));
  }

  TEST_CASE("quadrature is exact to the degree each kind needs") {
    struct Wanted {
      CellKind kind;
      int points, stiffness, mass;
    };
    for (auto const& wanted : {Wanted{CellKind::tri3, 1, 1, 2}, Wanted{CellKind::tri6, 3, 2, 4},
                               Wanted{CellKind::quad4, 4, 3, 3}, Wanted{CellKind::quad8, 9, 5, 5}}) {
      auto const& cell = info(wanted.kind);
      CAPTURE(cell.name);
      CHECK(stiffness_rule(wanted.kind).points.rows() == wanted.points);
      CHECK(degree(cell, stiffness_rule(wanted.kind)) == wanted.stiffness);
      CHECK(degree(cell, mass_rule(wanted.kind)) == wanted.mass);
    }
  }

  TEST_CASE("facets run round the cell with the body to their left and their mid node in the middle") {
    for (auto const& cell : cell_table()) {
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
}
