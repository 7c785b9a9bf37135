// Lame's tube of axisymmetric cells under inner pressure, in its limit and its rate.
#include <Eigen/Cholesky>
#include <doctest/doctest.h>
#include <numbers>

#include "solid/helpers.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

constexpr double inner = 1, outer = 2, height = 0.25, pressure = 1e3, young = 1e6, poisson = 0.3;

/// Root mean square error of u_r at the nodes over its largest value, in plane strain along z.
double error_of_tube(mesh::CellKind kind, int cells_across) {
  mesh::BlockOptions options;
  options.origin = {inner, 0};
  options.size = {outer - inner, height};
  options.cells = {static_cast<double>(cells_across), static_cast<double>(cells_across) / 4};
  options.kind = kind;
  solid::Body const body{"tube", mesh::block(options), material::LinearElastic{young, poisson}, 1};
  solid::Cells const cells(body, solid::Kinematics::axisymmetric);
  Index const n = 2 * body.mesh.node_count();
  Dense K = stiffness(cells, Vector::Zero(n), 2);
  Vector f = Vector::Zero(n);
  double const total = 2 * std::numbers::pi * inner * height * pressure;
  for (auto const& facet : body.mesh.sets.at("left").facets)
    for (std::size_t k = 0; k < facet.nodes.size(); ++k)
      f[2 * facet.nodes[k]] +=
          total * (facet.nodes.size() == 2 ? 0.5 : (k == 2 ? 4.0 / 6 : 1.0 / 6)) / (cells_across / 4.0);
  for (Index i = 1; i < n; i += 2) { // u_z = 0
    K.row(i).setZero();
    K.col(i).setZero();
    K(i, i) = young;
  }
  Vector const u = K.ldlt().solve(f);
  double const factor = (1 + poisson) * pressure * inner * inner / (young * (outer * outer - inner * inner));
  double sum = 0;
  for (Index i = 0; i < body.mesh.node_count(); ++i) {
    double const r = body.mesh.nodes(i, 0);
    double const exact = factor * ((1 - 2 * poisson) * r + outer * outer / r);
    sum += std::pow(u[2 * i] - exact, 2);
  }
  return std::sqrt(sum / body.mesh.node_count()) /
         (factor * ((1 - 2 * poisson) * inner + outer * outer / inner));
}

} // namespace

TEST_SUITE("solid") {
  TEST_CASE("Lame's tube: linear cells converge at order 2 and quadratic ones at 3 or more") {
    for (auto const kind : {mesh::CellKind::tri3, mesh::CellKind::quad4}) {
      double const coarse = error_of_tube(kind, 16), fine = error_of_tube(kind, 32);
      CHECK(fine < 2e-3);
      CHECK(std::log2(coarse / fine) > 1.7);
    }
    for (auto const kind : {mesh::CellKind::tri6, mesh::CellKind::quad8}) {
      double const coarse = error_of_tube(kind, 4), fine = error_of_tube(kind, 8);
      CHECK(fine < 2e-4);
      CHECK(std::log2(coarse / fine) > 2.7);
    }
  }
}
