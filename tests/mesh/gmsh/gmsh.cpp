// Geometry meshed by gmsh and imported .msh files: sets, orientation, cache, refusals.
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <numbers>

#include "mesh/gmsh/gmsh.hpp"
#include "mesh/gmsh/mesh_cache.hpp"
#include "mesh/gmsh/mesher_process.hpp"
#include "mesh/helpers.hpp"
#include "mesh/own_cache.hpp"
#include "mesh/topology/quality.hpp"

using namespace stiction;
using namespace stiction::mesh;
using test::area;
using test::length;
using test::mentions;
using test::no_mesher;
using test::OwnCache;
using test::refusal;

namespace {

/// A quarter of a ring, inner radius 1, outer 2, with a square hole when asked.
GmshGeometry quarter_ring(CellKind kind) {
  GmshGeometry geometry;
  geometry.start = {1, 0};
  geometry.edges = {{{2, 0}, {}, {}, "bottom"},
                    {{0, 2}, {0, 0}, {}, "outer"},
                    {{0, 1}, {}, {}, "left"},
                    {{1, 0}, {0, 0}, {}, "inner"}};
  geometry.size = 0.2;
  geometry.kind = kind;
  return geometry;
}

/// Two triangles (1 0)-(0 0), version 2.2, with named groups; `cells` replaces the two surface elements.
std::string msh_text(std::string const& cells = "3 2 2 2 1 1 2 3\n4 2 2 2 1 1 3 4\n") {
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
         "$PhysicalNames\n2\n1 1 \"floor\"\n2 2 \"body\"\n$EndPhysicalNames\n"
         "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n$EndNodes\n"
         "$Elements\n4\n1 1 2 1 1 2 1\n2 15 2 3 3 1\n" +
         cells + "$EndElements\n";
}

std::string write(OwnCache const& folder, std::string const& name, std::string const& text) {
  return folder.write(name, text);
}

std::string import_words(std::string const& path) {
  return refusal([&] { (void)msh_file({path}); });
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("gmsh meshes a quarter ring in every kind with its sets and the body to the left") {
    if (no_mesher())
      return;
    OwnCache const cache;
    for (auto const& cell : cell_table(2)) {
      CAPTURE(cell.name);
      Mesh const mesh = gmsh_geometry(quarter_ring(cell.kind));
      REQUIRE(mesh.blocks.size() == 1);
      CHECK(mesh.blocks[0].kind == cell.kind);
      bool const second_order = cell.nodes > cell.corners;
      CHECK(area(mesh) == doctest::Approx(0.75 * std::numbers::pi).epsilon(second_order ? 1e-4 : 5e-3));
      CHECK(length(mesh, mesh.sets.at("outer")) == doctest::Approx(std::numbers::pi).epsilon(3e-3));
      CHECK(length(mesh, mesh.sets.at("bottom")) == doctest::Approx(1));
      CHECK(test::enclosed_area(mesh, boundary(mesh)) ==
            doctest::Approx(0.75 * std::numbers::pi).epsilon(1e-2));
      CHECK(mesh.sets.at("all").nodes.size() == static_cast<std::size_t>(mesh.node_count()));
      for (Index const node : mesh.sets.at("inner").nodes)
        CHECK(mesh.nodes.row(node).norm() == doctest::Approx(1));
      for (auto const& [name, set] : mesh.sets)
        CHECK(test::consistent(mesh, set));
      CHECK(quality(mesh).min_jacobian > 0.3);
    }
  }

  TEST_CASE("an outline written clockwise, a spline and a hole give the same orientation") {
    if (no_mesher())
      return;
    OwnCache const cache;
    GmshGeometry geometry;
    geometry.start = {0, 0};
    geometry.edges = {{{0, 2}, {}, {}, "left"},
                      {{4, 2}, {}, {1, 2.2, 2, 2.3, 3, 2.2}, "top"},
                      {{4, 0}, {}, {}, ""},
                      {{0, 0}, {}, {}, "bottom"}};
    geometry.holes = {
        {{1, 0.5}, {{{2, 0.5}, {}, {}, "hole"}, {{2, 1.5}, {}, {}, "hole"}, {{1, 0.5}, {}, {}, "hole"}}}};
    geometry.size = 0.25;
    geometry.kind = CellKind::tri3;
    Mesh const mesh = gmsh_geometry(geometry);
    CHECK(area(mesh) == doctest::Approx(test::enclosed_area(mesh, boundary(mesh))));
    CHECK(area(mesh) > 8 - 0.5);
    CHECK(length(mesh, mesh.sets.at("hole")) == doctest::Approx(2 + std::sqrt(2.0)));
  }

  TEST_CASE("sizes at points grow from there, however far they are") {
    if (no_mesher())
      return;
    OwnCache const cache;
    GmshGeometry square;
    square.edges = {{{1, 0}, {}, {}, ""}, {{1, 1}, {}, {}, ""}, {{0, 1}, {}, {}, ""}, {{0, 0}, {}, {}, ""}};
    square.start = {0, 0};
    square.size = 0.5;
    square.growth = 0.1;
    square.sizes = {0, 0, 0.04, 1, 0, 0.04, 0, 1, 0.04}; // 0.14 at the corner without a point
    Mesh const mesh = gmsh_geometry(square);
    long near = 0;
    for (Index node = 0; node < mesh.node_count(); ++node)
      near += mesh.nodes.row(node).minCoeff() > 0.6 ? 1 : 0;
    CHECK(near > 9);
    CHECK(near < 60);
    CHECK(mesh.node_count() > 6 * near);
  }

  TEST_CASE("refinement makes small cells near the named edges and only there") {
    if (no_mesher())
      return;
    OwnCache const cache;
    auto geometry = quarter_ring(CellKind::tri3);
    auto const before = gmsh_geometry(geometry);
    geometry.refine = {{"inner", 0.02, 0.05, 0.6}};
    auto const after = gmsh_geometry(geometry);
    CHECK(after.sets.at("inner").facets.size() > 6 * before.sets.at("inner").facets.size());
    CHECK(after.sets.at("outer").facets.size() < 2 * before.sets.at("outer").facets.size());
  }

  TEST_CASE("an outline gives the same cells in every unit of length") {
    if (no_mesher())
      return;
    OwnCache const cache;
    test::check_units([](double metre) {
      auto ring = quarter_ring(CellKind::quad4);
      auto const scale = [&](core::Numbers& lengths) {
        for (double& length : lengths)
          length *= metre;
      };
      scale(ring.start);
      for (auto& edge : ring.edges) {
        scale(edge.to);
        scale(edge.centre);
      }
      ring.size *= metre;
      ring.refine = {{"inner", 0.05 * metre, 0.1 * metre, 0.6 * metre}};
      return gmsh_geometry(ring);
    });
  }

  TEST_CASE("a mesh is made once and is the same from the cache, and a damaged cache is made anew") {
    if (no_mesher())
      return;
    OwnCache const cache;
    auto const made = gmsh_geometry(quarter_ring(CellKind::quad4));
    std::vector<std::filesystem::path> files;
    for (auto const& entry : std::filesystem::directory_iterator(cache_folder()))
      files.push_back(entry.path());
    REQUIRE(files.size() == 1);
    auto const time = std::filesystem::last_write_time(files[0]);
    auto const kept = gmsh_geometry(quarter_ring(CellKind::quad4));
    CHECK(std::filesystem::last_write_time(files[0]) == time);
    CHECK(kept.nodes == made.nodes);
    CHECK(kept.blocks[0].nodes == made.blocks[0].nodes);
    CHECK(kept.sets.at("outer").nodes == made.sets.at("outer").nodes);
    std::filesystem::resize_file(files[0], 100);
    auto const anew = gmsh_geometry(quarter_ring(CellKind::quad4));
    CHECK(anew.nodes == made.nodes);
    CHECK(anew.blocks[0].nodes == made.blocks[0].nodes);
  }

  TEST_CASE("a geometry refuses open outlines, arcs off their circle and unknown names") {
    auto open = quarter_ring(CellKind::tri3);
    open.edges.back().to = {1, 0.1};
    CHECK(mentions(refusal([&] { (void)gmsh_geometry(open); }), "must be closed"));
    auto arc = quarter_ring(CellKind::tri3);
    arc.edges[1].centre = {0.1, 0};
    CHECK(mentions(refusal([&] { (void)gmsh_geometry(arc); }), "gmsh.edges[2].centre"));
    auto name = quarter_ring(CellKind::tri3);
    name.refine = {{"iner", 0.1, 0, 1}};
    CHECK(mentions(refusal([&] { (void)gmsh_geometry(name); }), "did you mean \"inner\"?"));
    auto const square = [](double x, double y, double side) {
      return Outline{{x, y},
                     {{{x + side, y}, {}, {}, ""},
                      {{x + side, y + side}, {}, {}, ""},
                      {{x, y + side}, {}, {}, ""},
                      {{x, y}, {}, {}, ""}}};
    };
    auto const says_outside = [&](double x, double y, double side) {
      auto holed = quarter_ring(CellKind::tri3);
      holed.holes = {square(1.2, 0.2, 0.1), square(x, y, side)};
      return mentions(refusal([&] { (void)gmsh_geometry(holed); }), "gmsh.holes[2]: goes through (");
    };
    CHECK(says_outside(-1, -1, 4));     // round the region
    CHECK(says_outside(0.1, 0.1, 0.2)); // in the ring's own hole, within its hull
    CHECK(says_outside(1.9, 0.1, 0.2)); // across its rim
    if (!no_mesher()) {
      OwnCache const cache;
      CHECK_FALSE(says_outside(1.38, 1.38, 0.03)); // just within
    }
    auto fine = quarter_ring(CellKind::tri3);
    fine.size = 1e-6;
    CHECK(mentions(refusal([&] { (void)gmsh_geometry(fine); }), "gmsh.size"));
  }

  TEST_CASE("what gmsh refuses is said in its words") {
    if (no_mesher())
      return;
    OwnCache const cache;
    GmshGeometry bow;
    bow.start = {0, 0};
    bow.edges = {{{1, 1}, {}, {}, ""}, {{1, 0}, {}, {}, ""}, {{0, 1}, {}, {}, ""}, {{0, 0}, {}, {}, ""}};
    bow.size = 0.2;
    auto const words = refusal([&] { (void)gmsh_geometry(bow); });
    CHECK(mentions(words, "gmsh says: Error"));
    CHECK_FALSE(mentions(words, "crashed"));
  }

  TEST_CASE("an imported file keeps its groups, and facets get the body to their left") {
    if (no_mesher())
      return;
    OwnCache const cache;
    Mesh const mesh = msh_file({write(cache, "square.msh", msh_text()), 1e-3});
    CHECK(mesh.cell_count() == 2);
    CHECK(area(mesh) == doctest::Approx(1e-6));
    REQUIRE(mesh.sets.contains("floor"));
    auto const& floor = mesh.sets.at("floor");
    REQUIRE(floor.facets.size() == 1); // written from node 2 to node 1 in the file
    CHECK(floor.facets[0].nodes == Indices{0, 1});
    CHECK(mesh.sets.at("body").nodes.size() == 4);
    CHECK(mesh.sets.at("point_3").nodes.size() == 1);
    CHECK(mesh.sets.contains("all"));
  }

  TEST_CASE("files of version 4.1, second order text and first order binary, keep cells and groups") {
    if (no_mesher())
      return;
    OwnCache const cache;
    auto const data = std::filesystem::path(__FILE__).parent_path().parent_path() / "data";
    for (auto const& [name, kind] : {std::pair{"plate_quad8_v41.msh", CellKind::quad8},
                                     std::pair{"plate_quad4_binary.msh", CellKind::quad4}}) {
      CAPTURE(name);
      Mesh const mesh = msh_file({(data / name).string(), 1e-3});
      REQUIRE(mesh.blocks.size() == 1);
      CHECK(mesh.blocks[0].kind == kind);
      CHECK(mesh.cell_count() == 6);
      CHECK(area(mesh) == doctest::Approx(50e-6));
      CHECK(length(mesh, mesh.sets.at("floor")) == doctest::Approx(10e-3));
      CHECK(mesh.sets.at("ceiling").facets.size() == 3);
      CHECK(mesh.sets.at("plate").facets.empty());
      CHECK(test::consistent(mesh, mesh.sets.at("ceiling")));
    }
  }

  TEST_CASE("a mesh that is not plane is refused") {
    if (no_mesher())
      return;
    OwnCache const cache;
    std::string text = msh_text();
    text.replace(text.find("4 0 1 0"), 7, "4 0 1 1");
    CHECK(mentions(import_words(write(cache, "bent.msh", text)), "not plane"));
  }

  TEST_CASE("a mesh seen from behind is turned but an inverted cell among good ones is refused") {
    if (no_mesher())
      return;
    OwnCache const cache;
    auto const behind = write(cache, "behind.msh", msh_text("3 2 2 2 1 1 3 2\n4 2 2 2 1 1 4 3\n"));
    CHECK(area(msh_file({behind})) == doctest::Approx(1));
    auto const mixed = write(cache, "mixed.msh", msh_text("3 2 2 2 1 1 2 3\n4 2 2 2 1 1 4 3\n"));
    CHECK(mentions(import_words(mixed), "mixed.msh: cell 2 (tri3)"));
    CHECK(mentions(import_words(mixed), "inverted"));
  }

  TEST_CASE("truncated, foreign and missing files are refused with a reason") {
    if (no_mesher())
      return;
    OwnCache const cache;
    std::string const whole = msh_text();
    for (std::size_t part = 1; part < 10; ++part) {
      auto const path =
          write(cache, "cut" + std::to_string(part) + ".msh", whole.substr(0, whole.size() * part / 10));
      CAPTURE(part);
      CHECK(mentions(import_words(path), "truncated"));
      CHECK(mentions(import_words(path), path));
    }
    CHECK(mentions(import_words(write(cache, "text.msh", "hello")), "not a gmsh mesh file"));
    CHECK(mentions(import_words(write(cache, "empty.msh", "")), "empty"));
    CHECK(mentions(import_words(cache / "none.msh"), "cannot be read"));
    CHECK(mentions(import_words("mesh.geo"), "must end in .msh"));
  }

  TEST_CASE("a mesher that crashes or is missing becomes a message") {
    OwnCache const cache;
    auto const crash = write(cache, "crash", "#!/bin/sh\necho half way; kill -SEGV $$\n");
    std::filesystem::permissions(crash, std::filesystem::perms::owner_all);
    char const* before = std::getenv("STICTION_MESHER");
    std::string const kept = before == nullptr ? "" : before;
    setenv("STICTION_MESHER", crash.c_str(), 1);
    auto const words = refusal([] { (void)gmsh_geometry(quarter_ring(CellKind::tri3)); });
    CHECK(mentions(words, "crashed"));
    CHECK(mentions(words, "half way"));
    setenv("STICTION_MESHER", "/nowhere", 1);
    CHECK(mentions(refusal([] { (void)gmsh_geometry(quarter_ring(CellKind::tri3)); }), "stiction-mesher"));
    setenv("STICTION_MESHER", kept.c_str(), 1);
  }
}
