// Integrals of shape functions over edges and facets: closed values, sums, revolution.
#include "mesh/topology/traction.hpp"

#include <doctest/doctest.h>
#include <numbers>

#include "mesh/generators/generators.hpp"

using namespace stiction;

TEST_SUITE("mesh") {
  TEST_CASE("a straight edge shares its length as Simpson does") {
    Matrix nodes(3, 2);
    nodes << 1, 2, 4, 6, 2.5, 4; // length 5
    Vector const linear = mesh::shape_integrals(nodes, {{0, 1}}, false);
    CHECK(linear[0] == doctest::Approx(2.5).epsilon(1e-14));
    CHECK(linear[1] == doctest::Approx(2.5).epsilon(1e-14));
    Vector const quadratic = mesh::shape_integrals(nodes, {{0, 1, 2}}, false);
    CHECK(quadratic[0] == doctest::Approx(5.0 / 6).epsilon(1e-14));
    CHECK(quadratic[1] == doctest::Approx(5.0 / 6).epsilon(1e-14));
    CHECK(quadratic[2] == doctest::Approx(20.0 / 6).epsilon(1e-14));
  }

  TEST_CASE("a revolved edge sums to the area of its cone") {
    Matrix nodes(3, 2);
    nodes << 0, 0, 3, 4, 1.5, 2; // slant 5, radius 3
    for (mesh::Facet const& edge : {mesh::Facet{{0, 1}}, mesh::Facet{{0, 1, 2}}})
      CHECK(mesh::shape_integrals(nodes, edge, true).sum() ==
            doctest::Approx(std::numbers::pi * 3 * 5).epsilon(1e-13));
    CHECK(std::abs(mesh::shape_integrals(nodes, {{0, 1, 2}}, true)[0]) < 1e-13);
  }

  TEST_CASE("a plane facet in space: corners of quad8 pull the other way") {
    Matrix nodes(8, 3);
    nodes << 0, 0, 1, 2, 0, 1, 2, 3, 1, 0, 3, 1, 1, 0, 1, 2, 1.5, 1, 1, 3, 1, 0, 1.5, 1;
    Vector const shares = mesh::shape_integrals(nodes, {{0, 1, 2, 3, 4, 5, 6, 7}}, false);
    for (int k = 0; k < 4; ++k) {
      CHECK(shares[k] == doctest::Approx(-6.0 / 12).epsilon(1e-12));
      CHECK(shares[4 + k] == doctest::Approx(6.0 / 3).epsilon(1e-12));
    }
  }
}
