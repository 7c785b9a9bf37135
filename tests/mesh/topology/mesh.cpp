// Boundary facets and sets by a predicate.
#include <doctest/doctest.h>

#include "mesh/generators/generators.hpp"
#include "mesh/helpers.hpp"

using namespace stiction;
using namespace stiction::mesh;

TEST_SUITE("mesh") {
  TEST_CASE("the boundary of two squares has six sides and leaves out the shared one") {
    Mesh mesh;
    mesh.nodes = (Matrix(6, 2) << 0, 0, 1, 0, 2, 0, 0, 1, 1, 1, 2, 1).finished();
    mesh.blocks.push_back({CellKind::quad4, {0, 1, 4, 3, 1, 2, 5, 4}});
    auto const facets = boundary(mesh);
    CHECK(mesh.cell_count() == 2);
    CHECK(facets.size() == 6);
    CHECK(test::enclosed_area(mesh, facets) == doctest::Approx(2));
  }

  TEST_CASE("the boundary is found across blocks of different kinds") {
    Mesh mesh;
    mesh.nodes = (Matrix(5, 2) << 0, 0, 1, 0, 1, 1, 0, 1, 2, 0).finished();
    mesh.blocks.push_back({CellKind::quad4, {0, 1, 2, 3}});
    mesh.blocks.push_back({CellKind::tri3, {1, 4, 2}});
    CHECK(boundary(mesh).size() == 5);
    CHECK(test::enclosed_area(mesh, boundary(mesh)) == doctest::Approx(1.5));
  }

  TEST_CASE("a set by a predicate holds whole facets and sorted nodes") {
    Mesh const mesh = block({.size = {2, 1}, .cells = {4, 2}, .kind = CellKind::quad8});
    Set const right = boundary_where(mesh, [](auto const& x) { return x[0] > 1.1; });
    CHECK(test::consistent(mesh, right));
    CHECK(right.facets.size() == 4); // two on the right, one below, one above
    CHECK(boundary_where(mesh, [](auto const&) { return false; }).nodes.empty());
  }
}
