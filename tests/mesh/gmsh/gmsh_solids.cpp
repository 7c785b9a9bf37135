// Solids meshed by gmsh and imported solid .msh files: sets, orientation, node order, refusals.
#include <doctest/doctest.h>
#include <numbers>

#include "mesh/gmsh/gmsh.hpp"
#include "mesh/gmsh/gmsh_solid.hpp"
#include "mesh/helpers.hpp"
#include "mesh/own_cache.hpp"
#include "mesh/topology/quality.hpp"

using namespace stiction;
using namespace stiction::mesh;
using std::numbers::pi;
using test::mentions;
using test::OwnCache;
using test::refusal;
using test::surface_area;
using test::volume;

namespace {

struct Case {
  SolidShape shape;
  core::Numbers extent;
  double volume;
  std::map<std::string, double> areas; ///< of the whole solid's faces
};

std::vector<Case> const cases{
    {SolidShape::box,
     {2e-3, 1e-3, 1e-3},
     2e-9,
     {{"left", 1e-6}, {"right", 1e-6}, {"front", 2e-6}, {"back", 2e-6}, {"bottom", 2e-6}, {"top", 2e-6}}},
    {SolidShape::cylinder,
     {1e-3, 1e-3},
     pi * 1e-9,
     {{"side", 2 * pi * 1e-6}, {"top", pi * 1e-6}, {"bottom", pi * 1e-6}}},
    {SolidShape::ball, {1e-3}, 4 * pi / 3 * 1e-9, {{"cap", 4 * pi * 1e-6}}},
    {SolidShape::half_ball, {1e-3}, 2 * pi / 3 * 1e-9, {{"cap", 2 * pi * 1e-6}, {"flat", pi * 1e-6}}}};

std::string data(std::string const& name) {
  return (std::filesystem::path(__FILE__).parent_path().parent_path() / "data" / name).string();
}

std::string tetrahedron(std::string const& elements) {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n"
         "$EndNodes\n$Elements\n" +
         elements + "$EndElements\n";
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("gmsh meshes each solid whole with its faces as sets that face outwards") {
    if (test::no_mesher())
      return;
    OwnCache const cache;
    for (auto const& wanted : cases)
      for (auto const kind : {CellKind::tet4, CellKind::tet10}) {
        CAPTURE(static_cast<int>(wanted.shape));
        CAPTURE(info(kind).name);
        Mesh const mesh = gmsh_solid({.shape = wanted.shape,
                                      .extent = wanted.extent,
                                      .at = {1e-3, 0, 5e-3},
                                      .size = 2e-4,
                                      .kind = kind});
        double const close = kind == CellKind::tet10 ? 1e-3 : 2e-2;
        CHECK(mesh.blocks.at(0).kind == kind);
        CHECK(volume(mesh) == doctest::Approx(wanted.volume).epsilon(close));
        CHECK(test::enclosed_volume(mesh, boundary(mesh)) == doctest::Approx(volume(mesh)).epsilon(1e-9));
        CHECK(mesh.sets.size() == wanted.areas.size() + 1);
        for (auto const& [name, area] : wanted.areas) {
          CAPTURE(name);
          REQUIRE(mesh.sets.contains(name));
          CHECK(surface_area(mesh, mesh.sets.at(name)) == doctest::Approx(area).epsilon(close));
          CHECK_NOTHROW(check_surface(mesh, mesh.sets.at(name), name));
          CHECK(test::consistent(mesh, mesh.sets.at(name)));
        }
        CHECK(quality(mesh).min_jacobian > 0.1);
      }
  }

  TEST_CASE("a quarter of each solid has its cuts as sets and a quarter of its volume") {
    if (test::no_mesher())
      return;
    OwnCache const cache;
    for (auto const& wanted : cases) {
      CAPTURE(static_cast<int>(wanted.shape));
      Mesh const mesh = gmsh_solid({.shape = wanted.shape,
                                    .extent = wanted.extent,
                                    .at = {1e-3, 0, 5e-3},
                                    .quarter = true,
                                    .size = 2e-4,
                                    .kind = CellKind::tet10});
      CHECK(volume(mesh) == doctest::Approx(wanted.volume / 4).epsilon(1e-3));
      for (auto const& [name, column] : {std::pair{"symmetry_x", 0}, std::pair{"symmetry_y", 1}}) {
        auto const& cut = mesh.sets.at(name);
        CHECK_FALSE(cut.facets.empty());
        for (Index const node : cut.nodes)
          CHECK(mesh.nodes(node, column) == doctest::Approx(column == 0 ? 1e-3 : 0).epsilon(1e-9));
      }
      CHECK(mesh.nodes.col(0).minCoeff() > 1e-3 - 1e-12);
      CHECK_FALSE(mesh.sets.contains("left"));
    }
  }

  TEST_CASE("a fine zone of a solid has small cells there and only there") {
    if (test::no_mesher())
      return;
    OwnCache const cache;
    Mesh const mesh = gmsh_solid({.shape = SolidShape::half_ball,
                                  .extent = {10},
                                  .quarter = true,
                                  .size = 3,
                                  .fine_size = 0.5,
                                  .within = 2,
                                  .until = 8});
    Eigen::RowVector3d const pole(0, 0, -10);
    double near = 0, far = 0;
    for (auto const& facet : mesh.sets.at("cap").facets) {
      auto const a = mesh.nodes.row(facet.nodes[0]), b = mesh.nodes.row(facet.nodes[1]);
      if (std::max((a - pole).norm(), (b - pole).norm()) < 2)
        near = std::max(near, (a - b).norm());
      far = std::max(far, (a - b).norm());
    }
    CHECK(near > 0.2);
    CHECK(near < 0.9);
    CHECK(far > 1.5);
  }

  TEST_CASE("solid files of second order keep cells and sets with their nodes in our order") {
    if (test::no_mesher())
      return;
    OwnCache const cache;
    for (auto const& [name, kind] : {std::pair{"bar_hex20_v41.msh", CellKind::hex20},
                                     std::pair{"bar_tet10_binary.msh", CellKind::tet10}}) {
      CAPTURE(name);
      Mesh const mesh = msh_file({data(name), 1e-3});
      REQUIRE(mesh.blocks.size() == 1);
      auto const& cell = info(kind);
      CHECK(mesh.dim == 3);
      CHECK(mesh.blocks[0].kind == kind);
      CHECK(volume(mesh) == doctest::Approx(6e-9).epsilon(1e-12));
      for (std::size_t first = 0; first < mesh.blocks[0].nodes.size(); first += ix(cell.nodes))
        for (std::size_t i = 0; i < cell.edges.size(); ++i) {
          auto const at = [&](int local) { return mesh.nodes.row(mesh.blocks[0].nodes[first + ix(local)]); };
          auto const middle = at(cell.corners + static_cast<int>(i));
          CHECK((middle - (at(cell.edges[i][0]) + at(cell.edges[i][1])) / 2).norm() < 1e-12);
        }
      CHECK(surface_area(mesh, mesh.sets.at("floor")) == doctest::Approx(2e-6).epsilon(1e-12));
      CHECK(surface_area(mesh, mesh.sets.at("roof")) == doctest::Approx(2e-6).epsilon(1e-12));
      CHECK(mesh.sets.at("body").nodes.size() == ix(mesh.node_count()));
      CHECK(mesh.sets.at("body").facets.empty());
      CHECK(test::enclosed_volume(mesh, boundary(mesh)) == doctest::Approx(6e-9).epsilon(1e-12));
      CHECK_NOTHROW(check_surface(mesh, mesh.sets.at("floor"), "floor"));
    }
  }

  TEST_CASE("solid cells alone are read and solid with surface cells need a physical volume") {
    if (test::no_mesher())
      return;
    OwnCache const cache;
    auto const alone = cache.write("alone.msh", tetrahedron("1\n1 4 2 0 1 1 2 3 4\n"));
    CHECK(volume(msh_file({alone})) == doctest::Approx(1.0 / 6));
    auto const mixed = cache.write("mixed.msh", tetrahedron("2\n1 2 2 0 1 1 3 2\n2 4 2 0 1 1 2 3 4\n"));
    auto const words = refusal([&] { (void)msh_file({mixed}); });
    CHECK(mentions(words, "no physical volume"));
    CHECK(mentions(words, "physical group"));
    auto const named = cache.write("named.msh", tetrahedron("2\n1 2 2 5 1 1 3 2\n2 4 2 7 1 1 2 3 4\n"));
    Mesh const mesh = msh_file({named});
    CHECK(mesh.sets.at("surface_5").facets.at(0).nodes == Indices{0, 2, 1});
    CHECK(mesh.sets.at("volume_7").nodes.size() == 4);
    auto const inverted = cache.write("inverted.msh", tetrahedron("1\n1 4 2 0 1 2 1 3 4\n"));
    CHECK(mentions(refusal([&] { (void)msh_file({inverted}); }), "inverted"));
    auto const prism = cache.write("prism.msh", tetrahedron("1\n1 7 2 0 1 1 2 3 4 1\n"));
    CHECK(mentions(refusal([&] { (void)msh_file({prism}); }), "gmsh's type 7"));
  }

  TEST_CASE("a solid gives the same cells in every unit of length") {
    if (test::no_mesher())
      return;
    OwnCache const cache;
    test::check_units([](double metre) {
      GmshSolid box;
      box.shape = SolidShape::box;
      box.extent = {3 * metre, 0.7 * metre, 1.1 * metre};
      box.size = 0.3 * metre;
      box.fine_size = 0.1 * metre;
      box.within = 0.2 * metre;
      box.until = 1.3 * metre;
      return gmsh_solid(box);
    });
  }

  TEST_CASE("a solid refuses wrong numbers with their names") {
    auto const words = [](auto change) {
      GmshSolid solid{.shape = SolidShape::cylinder, .extent = {1, 1}, .size = 0.2};
      change(solid);
      return refusal([&] { (void)gmsh_solid(solid); });
    };
    CHECK(mentions(words([](auto& s) { s.extent = {1}; }), "gmsh_solid.extent"));
    CHECK(mentions(words([](auto& s) { s.size = 0; }), "gmsh_solid.size"));
    CHECK(mentions(words([](auto& s) { s.at = {1}; }), "gmsh_solid.at"));
    CHECK(mentions(words([](auto& s) { s.fine_size = 0.3; }), "gmsh_solid.fine_size"));
    CHECK(mentions(words([](auto& s) { s.fine_size = 0.1; }), "gmsh_solid.beyond"));
    CHECK(mentions(words([](auto& s) { s.size = 0.005; }), "at most"));
  }
}
