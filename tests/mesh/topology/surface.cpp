// Areas of nodes on surfaces, and the refusal of surfaces that contact cannot use.
#include <doctest/doctest.h>

#include "mesh/helpers.hpp"
#include "mesh/topology/surface.hpp"

using namespace stiction;
using namespace stiction::mesh;
using test::mentions;
using test::refusal;

namespace {

/// One facet, the reference cell of its kind stretched to a plane region of this size, and lifted in z.
Mesh sheet(CellKind kind) {
  Mesh mesh;
  mesh.dim = 3;
  mesh.nodes = Matrix::Zero(info(kind).nodes, 3);
  mesh.nodes.leftCols(2) = reference_nodes(kind);
  mesh.nodes.col(0) *= 3;
  mesh.nodes.col(2) = 0.5 * mesh.nodes.col(1);
  return mesh;
}

Set surface(std::vector<Facet> facets) {
  Set set{{}, std::move(facets)};
  for (auto const& facet : set.facets)
    set.nodes.insert(set.nodes.end(), facet.nodes.begin(), facet.nodes.end());
  std::sort(set.nodes.begin(), set.nodes.end());
  set.nodes.erase(std::unique(set.nodes.begin(), set.nodes.end()), set.nodes.end());
  return set;
}

Set whole(Mesh const& mesh) {
  Facet facet;
  for (Index i = 0; i < mesh.node_count(); ++i)
    facet.nodes.push_back(i);
  return surface({facet});
}

/// Two unit squares side by side in the plane z = 0, split along the diagonals of the first.
Mesh strip() {
  Mesh mesh;
  mesh.dim = 3;
  mesh.nodes = (Matrix(6, 3) << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0).finished();
  return mesh;
}

std::string words(std::vector<Facet> facets) {
  return refusal([&] { check_surface(strip(), surface(std::move(facets)), "sole"); });
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("the areas of nodes are positive and sum to the area of every kind of facet") {
    for (auto const& cell : cell_table(2)) {
      CAPTURE(cell.name);
      Mesh const mesh = sheet(cell.kind);
      Vector const areas = nodal_areas(mesh, whole(mesh));
      double const area = (cell.corners == 3 ? 0.5 : 4.0) * 3 * std::sqrt(1.25);
      CHECK(areas.sum() == doctest::Approx(area).epsilon(1e-13));
      CHECK(areas.minCoeff() > 0.03 * area);
      for (int i = 0; i < cell.corners; ++i) // a plane facet shares by its symmetry
        CHECK(areas[i] == doctest::Approx(areas[0]));
    }
  }

  TEST_CASE("first order facets share by the integrals of their shape functions") {
    Mesh mesh = sheet(CellKind::quad4);
    mesh.nodes << 0, 0, 0, 2, 0, 0, 1, 1, 0, 0, 1, 0; // a trapezoid of area 1.5, heavier at the longer side
    Vector const areas = nodal_areas(mesh, whole(mesh));
    Vector const exact = (Vector(4) << 5.0 / 12, 5.0 / 12, 1.0 / 3, 1.0 / 3).finished();
    CHECK((areas - exact).cwiseAbs().maxCoeff() < 1e-14);
  }

  TEST_CASE("areas of shared nodes add up") {
    Mesh const mesh = strip();
    Vector const areas = nodal_areas(mesh, surface({{{0, 1, 2, 3}}, {{1, 4, 5, 2}}}));
    Vector const exact = (Vector(6) << .25, .5, .5, .25, .25, .25).finished();
    CHECK((areas - exact).cwiseAbs().maxCoeff() < 1e-14);
  }

  TEST_CASE("a surface whose facets run alike along an edge is refused with its facets and the remedy") {
    CHECK(words({{{0, 1, 2, 3}}, {{1, 4, 5, 2}}}).empty());
    CHECK(words({{{0, 1, 2}}, {{0, 2, 3}}, {{1, 4, 5, 2}}}).empty());
    auto const turned = words({{{0, 1, 2, 3}}, {{1, 2, 5, 4}}});
    CHECK(mentions(turned, "set \"sole\""));
    CHECK(mentions(turned, "facets 1 and 2"));
    CHECK(mentions(turned, "(1, 0.5, 0) m"));
    CHECK(mentions(turned, "turn the order"));
    CHECK(mentions(words({{{0, 1, 2, 3}}, {{1, 4, 5, 2}}, {{2, 1, 4}}}), "3 facets share"));
  }

  TEST_CASE("a surface without facets is refused in both dimensions") {
    Mesh flat;
    CHECK(mentions(refusal([&] { check_surface(flat, {{0, 1}, {}}, "sole"); }), "has no facets"));
    CHECK(mentions(refusal([&] { check_surface(strip(), {{0, 1}, {}}, "sole"); }), "set \"sole\""));
  }
}
