// Hats on the linear pieces of facets, and what corners borrow to have their areas.
#include <doctest/doctest.h>
#include <numbers>

#include "mesh/topology/hats.hpp"
#include "mesh/topology/surface.hpp"
#include "mesh/topology/traction.hpp"

using namespace stiction;
using namespace stiction::mesh;

namespace {

/// One facet with its nodes, [nodes, 2 or 3].
struct Sample {
  Matrix nodes;
  Facet facet;
  bool revolved = false;
};

Facet all_of(Matrix const& nodes) {
  Facet facet;
  for (Index i = 0; i < static_cast<Index>(nodes.rows()); ++i)
    facet.nodes.push_back(i);
  return facet;
}

/// Mid-side nodes in the middle of the straight sides of these corners.
Matrix with_middles(Matrix const& corners) {
  auto const n = corners.rows();
  Matrix all(2 * n, corners.cols());
  all.topRows(n) = corners;
  for (Eigen::Index k = 0; k < n; ++k)
    all.row(n + k) = 0.5 * (corners.row(k) + corners.row((k + 1) % n));
  return all;
}

/// Straight and oblique, of every kind; a quadrilateral each that is a parallelogram and that is none.
std::vector<Sample> samples() {
  Matrix const edge = (Matrix(2, 2) << 0, 1, 3, 5).finished(),
               edge3 = (Matrix(3, 2) << 0, 1, 3, 5, 1.5, 3).finished(),
               triangle = (Matrix(3, 3) << 0, 0, 1, 2, 0.5, 1, 0.5, 3, 2).finished(),
               even = (Matrix(4, 3) << 0, 0, 1, 2, 0, 1, 1.5, 2, 2, -0.5, 2, 2).finished(),
               uneven = (Matrix(4, 3) << 0, 0, 1, 2, 0, 1, 1.5, 2, 2, -0.5, 1, 1.5).finished();
  std::vector<Sample> all;
  for (bool const revolved : {false, true})
    for (auto const& nodes : {edge, edge3})
      all.push_back({nodes, all_of(nodes), revolved});
  for (auto const& nodes :
       {triangle, even, uneven, with_middles(triangle), with_middles(even), with_middles(uneven)})
    all.push_back({nodes, all_of(nodes)});
  return all;
}

bool quadratic(Sample const& sample) {
  return sample.facet.nodes.size() > (sample.nodes.cols() == 2 ? 2U : 4U);
}

/// Whether positions are linear on the reference facet.
bool affine(Sample const& sample) {
  auto const& x = sample.nodes;
  return x.rows() != 8 || (x.row(0) + x.row(2) - x.row(1) - x.row(3)).norm() < 1e-12;
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("hats have positive areas that sum to the facet, and hand a uniform traction over exactly") {
    for (auto const& sample : samples()) {
      CAPTURE(sample.nodes.rows());
      CAPTURE(sample.revolved);
      Dense const products = hat_products(sample.nodes, sample.facet, sample.revolved);
      Vector const shapes = shape_integrals(sample.nodes, sample.facet, sample.revolved);
      Vector const areas = products.rowwise().sum(), forces = products.colwise().sum();
      CHECK(areas.minCoeff() > 0.025 * areas.sum());
      CHECK(areas.sum() == doctest::Approx(shapes.sum()).epsilon(1e-13));
      CHECK((forces - shapes).cwiseAbs().maxCoeff() < 1e-13 * areas.sum());
    }
  }

  TEST_CASE("a linear traction keeps its moments in the nodal forces") {
    for (auto const& sample : samples()) {
      if (!quadratic(sample) || !affine(sample))
        continue;
      CAPTURE(sample.nodes.rows());
      CAPTURE(sample.revolved);
      Dense const products = hat_products(sample.nodes, sample.facet, sample.revolved);
      for (Eigen::Index c = 0; c < sample.nodes.cols(); ++c)
        for (Eigen::Index d = 0; d < sample.nodes.cols(); ++d) {
          // integral of the traction x_c times x_d, which is that of x_d times x_c
          Vector const forces = products.transpose() * sample.nodes.col(c),
                       others = products.transpose() * sample.nodes.col(d);
          CHECK(forces.dot(sample.nodes.col(d)) ==
                doctest::Approx(others.dot(sample.nodes.col(c))).epsilon(1e-12));
          // and of x_c alone, whose nodal forces the shape functions know
          CHECK(forces.sum() ==
                doctest::Approx(
                    shape_integrals(sample.nodes, sample.facet, sample.revolved).dot(sample.nodes.col(c)))
                    .epsilon(1e-12));
        }
    }
  }

  TEST_CASE("the traction r on an edge from the axis pulls at the node there") {
    Matrix nodes(3, 2);
    nodes << 0, 0, 2, 0, 1, 0;
    Dense const products = hat_products(nodes, {{0, 1, 2}}, true);
    Vector const forces = products.transpose() * nodes.col(0);
    double const unit = 2 * std::numbers::pi * 8; // 2 pi L^3
    CHECK(forces[0] == doctest::Approx(-unit / 60).epsilon(1e-12));
    CHECK(forces[1] == doctest::Approx(unit * 3 / 20).epsilon(1e-12));
    CHECK(forces[2] == doctest::Approx(unit / 5).epsilon(1e-12));
    Vector const areas = products.rowwise().sum(); // 2 pi times 1/6, 5/6 and 1
    CHECK(areas[0] == doctest::Approx(std::numbers::pi / 3).epsilon(1e-12));
    CHECK(areas[2] == doctest::Approx(2 * std::numbers::pi).epsilon(1e-12));
    CHECK(areas[1] == doctest::Approx(std::numbers::pi * 5 / 3).epsilon(1e-12));
  }

  TEST_CASE("about an axis only the node there borrows of the middle beside it, as much as its hat has") {
    Matrix nodes(5, 2); // two edges of 1 and 2 m from the axis
    nodes << 3, 0, 0, 0, 1, 0, 2, 0, 0.5, 0;
    Indices const points{1, 4, 2, 3, 0}; // in walking order
    auto const shares = surface_shares(nodes, {{}, {{{1, 2, 4}}, {{2, 0, 3}}}}, points, true);
    double const turn = 2 * std::numbers::pi;
    std::vector<double> const areas{turn / 24, turn * 7 / 24, turn * (1.0 / 6 + 2.0 / 6), turn * 8 / 3, turn};
    for (std::size_t i = 0; i < points.size(); ++i)
      CHECK(shares.areas[i] == doctest::Approx(areas[i]).epsilon(1e-12));
    REQUIRE(shares.means[1].size() == 2); // one eighth lent
    CHECK(shares.means[1][0].point == 1);
    CHECK(shares.means[1][0].weight == doctest::Approx(8.0 / 7).epsilon(1e-12));
    CHECK(shares.means[1][1].point == 0);
    CHECK(shares.means[1][1].weight == doctest::Approx(-1.0 / 7).epsilon(1e-12));
    for (std::size_t const i : {0, 2, 3, 4})
      CHECK(shares.means[i].size() == 1);
  }

  TEST_CASE(
      "corners in space get the area of their hat, and uniform tractions the nodal forces of the cells") {
    for (auto const& sample : samples()) {
      if (sample.nodes.cols() == 2 || !quadratic(sample))
        continue;
      CAPTURE(sample.nodes.rows());
      auto const shares = surface_shares(sample.nodes, {{}, {sample.facet}}, sample.facet.nodes, false);
      Vector const hats = hat_products(sample.nodes, sample.facet, false).rowwise().sum();
      Vector forces = Vector::Zero(sample.nodes.rows());
      double area = 0;
      for (std::size_t i = 0; i < shares.means.size(); ++i) {
        bool const corner = i < shares.means.size() / 2;
        CHECK(shares.areas[i] > 0.025 * hats.sum());
        if (corner)
          CHECK(shares.areas[i] == doctest::Approx(hats[static_cast<Eigen::Index>(i)]).epsilon(1e-12));
        double sum = 0;
        for (auto const& [point, weight] : shares.means[i]) {
          forces[point] += weight * shares.areas[i];
          sum += weight;
        }
        CHECK(shares.means[i].front().point == static_cast<Index>(i));
        CHECK(sum == doctest::Approx(1).epsilon(1e-13));
        area += shares.areas[i];
      }
      CHECK(area == doctest::Approx(hats.sum()).epsilon(1e-13));
      CHECK((forces - shape_integrals(sample.nodes, sample.facet, false)).cwiseAbs().maxCoeff() <
            1e-13 * area);
    }
  }

  TEST_CASE("only facets whose shape functions leave a node without an area need hats") {
    for (auto const& sample : samples()) {
      bool const flat_edge = sample.nodes.cols() == 2 && !sample.revolved;
      CHECK(shares_well(sample.nodes, sample.facet, sample.revolved) == (flat_edge || !quadratic(sample)));
    }
    Matrix quarter(3, 2); // a middle node at a quarter of the edge
    quarter << 0, 0, 4, 0, 1, 0;
    CHECK_FALSE(shares_well(quarter, {{0, 1, 2}}, false));
    CHECK(hat_products(quarter, {{0, 1, 2}}, false).rowwise().sum().minCoeff() > 0.3);
  }
}
