// Points inside and outside closed surfaces with linear and quadratic facets.
#include <doctest/doctest.h>

#include "contact/tunnelling/inside.hpp"
#include "mesh/generators/generators.hpp"

using namespace stiction;
using namespace stiction::contact;

namespace {

template<int D> double depth(mesh::Mesh const& mesh, Vec<D> const& point) {
  return depth_inside<D>(panels_of<D>(mesh), {mesh.nodes.data(), static_cast<std::size_t>(mesh.nodes.size())},
                         point);
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("how deep a point is inside a rectangle") {
    for (auto const kind :
         {mesh::CellKind::tri3, mesh::CellKind::tri6, mesh::CellKind::quad4, mesh::CellKind::quad8}) {
      auto const block = mesh::block({{0, 0}, {4, 2}, {4, 2}, {1, 1}, kind});
      CHECK(depth<2>(block, {1.3, 0.25}) == doctest::Approx(0.25).epsilon(1e-12));
      CHECK(depth<2>(block, {2, 1}) == doctest::Approx(1).epsilon(1e-12));
      CHECK(depth<2>(block, {1.3, -0.25}) == 0);
      CHECK(depth<2>(block, {9, 1}) == 0);
    }
  }
  TEST_CASE("in a notched body a wall bounds the depth only where it stands") {
    std::vector<double> const x{0, 0, 3, 0, 3, 1, 1, 1, 1, 3, 0, 3};
    std::vector<Panel<2>> panels;
    for (Index i = 0; i < 6; ++i)
      panels.push_back({i, (i + 1) % 6});
    CHECK(depth_inside<2>(panels, x, {1.1, 0.5}) ==
          doctest::Approx(0.5)); // 0.1 from the line of a wall above
    CHECK(depth_inside<2>(panels, x, {0.8, 0.8}) == doctest::Approx(std::hypot(0.2, 0.2)));
    CHECK(depth_inside<2>(panels, x, {0.5, 1.1}) == doctest::Approx(0.5));
  }
  TEST_CASE("how deep a point is inside a box") {
    for (auto const kind :
         {mesh::CellKind::tet4, mesh::CellKind::tet10, mesh::CellKind::hex8, mesh::CellKind::hex20}) {
      auto const box = mesh::box({{0, 0, 0}, {4, 2, 3}, {4, 2, 3}, {1, 1, 1}, kind});
      CHECK(depth<3>(box, {1.3, 0.9, 0.25}) == doctest::Approx(0.25).epsilon(1e-12));
      CHECK(depth<3>(box, {1.3, 0.9, -0.25}) == 0);
      CHECK(depth<3>(box, {-1, 1, 1}) == 0);
    }
  }
}
