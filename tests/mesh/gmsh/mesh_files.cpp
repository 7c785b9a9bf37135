// Mesh files of other programs: Abaqus, legacy VTK, closed surfaces; what is kept of them and what is
// refused.
#include <algorithm>
#include <doctest/doctest.h>
#include <fmt/format.h>

#include "mesh/gmsh/gmsh.hpp"
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

/// Two quadrilaterals side by side, 2 by 1, with the sets of all kinds.
std::string const two_quads =
    "** a comment\n*Heading\nanything, at all\n*Part, name=P\n"
    "*Node, nset=Nall\n1, 0., 0.\n2, 1., 0.\n3, 2, 0\n 4, 0., 1.D0\n5, 1e0, +1\n6, 2., 1.\n"
    "*Element, type=CPE4R, elset=Plate\n1, 1, 2, 5, 4\n2, 2, 3,\n 6, 5\n"
    "*Nset, nset=Odd, generate\n1, 5, 2\n*Nset, nset=More\nODD, 6\n"
    "*Elset, elset=_Bottom_S1, internal\n1, 2\n"
    "*Surface, type=ELEMENT, name=Bottom\n_Bottom_S1, S1\n*Surface, name=Right\n2, S2\n"
    "*Surface, type=NODE, name=Points\nOdd\n"
    "*End Part\n*Assembly\n*Instance, name=P-1, part=P\n*End Instance\n"
    "*Material, name=rubber\n*Elastic\n5e6, 0.4\n";

Mesh read(OwnCache const& cache, std::string const& name, std::string const& text) {
  return msh_file({cache.write(name, text), 1e-3});
}

std::string words(OwnCache const& cache, std::string const& name, std::string const& text, double size = 0) {
  auto const path = cache.write(name, text);
  return refusal([&] { (void)msh_file({path, 1, size}); });
}

std::string replaced(std::string text, std::string const& from, std::string const& to) {
  auto const at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

/// One cell of 20 or 10 nodes by the places of its corners, nodes in the middle of edges in Abaqus' order.
std::string abaqus_solid(std::string const& type, CellKind kind, std::vector<std::array<double, 3>> places) {
  for (auto const& [a, b] : info(kind).edges)
    places.push_back({(places[static_cast<std::size_t>(a)][0] + places[static_cast<std::size_t>(b)][0]) / 2,
                      (places[static_cast<std::size_t>(a)][1] + places[static_cast<std::size_t>(b)][1]) / 2,
                      (places[static_cast<std::size_t>(a)][2] + places[static_cast<std::size_t>(b)][2]) / 2});
  std::string nodes, tags;
  for (std::size_t i = 0; i < places.size(); ++i) {
    nodes += fmt::format("{}, {}, {}, {}\n", i + 1, places[i][0], places[i][1], places[i][2]);
    tags += fmt::format("{} {}", i == 10 ? ",\n" : ",", i + 1);
  }
  return fmt::format("*NODE\n{}*ELEMENT, TYPE={}, ELSET=E\n7{}\n*SURFACE, NAME=down\nE, S1\n", nodes, type,
                     tags);
}

/// A file of format 2.2 with these sections' lines, each list after its length.
std::string msh22(std::string const& names, std::string const& nodes, std::string const& elements) {
  auto const section = [](char const* name, std::string const& lines) {
    return fmt::format("${0}\n{1}\n{2}$End{0}\n", name, std::ranges::count(lines, '\n'), lines);
  };
  return "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + section("PhysicalNames", names) +
         section("Nodes", nodes) + section("Elements", elements);
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("a cell or a side that is in two groups of a file of format 2.2 is there once and in both") {
    if (no_mesher())
      return;
    OwnCache const cache;
    auto const mesh =
        read(cache, "groups.msh",
             msh22("1 1 \"foot\"\n1 2 \"rim\"\n2 3 \"all_of_it\"\n2 4 \"left\"\n",
                   "1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n",
                   "1 1 2 1 1 1 2\n2 1 2 1 1 2 3\n3 1 2 2 1 1 2\n4 1 2 2 1 2 3\n5 3 2 3 1 1 2 5 4\n"
                   "6 3 2 4 1 1 2 5 4\n7 3 2 3 1 2 3 6 5\n"));
    CHECK(mesh.cell_count() == 2);
    CHECK(area(mesh) == doctest::Approx(2e-6));
    CHECK(mesh.sets.at("all_of_it").cells.size() == 2);
    for (auto const* side : {"foot", "rim"}) {
      CHECK(mesh.sets.at(side).facets.size() == 2);
      CHECK(mesh.sets.at(side).nodes.size() == 3);
    }
  }

  TEST_CASE("sides given by their corners have the nodes between, as their cells do") {
    if (no_mesher())
      return;
    OwnCache const cache;
    auto const mesh =
        read(cache, "corners.msh",
             msh22("1 1 \"foot\"\n2 2 \"body\"\n",
                   "1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n5 0.5 0 0\n6 1 0.5 0\n7 0.5 1 0\n8 0 0.5 0\n",
                   "1 1 2 1 1 1 2\n2 16 2 2 1 1 2 3 4 5 6 7 8\n"));
    CHECK(mesh.blocks.at(0).kind == CellKind::quad8);
    auto const& foot = mesh.sets.at("foot");
    REQUIRE(foot.facets.size() == 1);
    CHECK(foot.facets[0].nodes.size() == 3);
    CHECK(foot.nodes.size() == 3);
  }

  TEST_CASE("an input file of Abaqus keeps its cells, node sets, element sets and surfaces") {
    if (no_mesher())
      return;
    OwnCache const cache;
    Mesh const mesh = read(cache, "plate.inp", two_quads);
    REQUIRE(mesh.blocks.size() == 1);
    CHECK(mesh.blocks[0].kind == CellKind::quad4);
    CHECK(mesh.cell_count() == 2);
    CHECK(area(mesh) == doctest::Approx(2e-6));
    CHECK(mesh.sets.at("Nall").nodes.size() == 6);
    CHECK(mesh.sets.at("Plate").nodes.size() == 6);
    CHECK(mesh.sets.at("Plate").cells == Indices{0, 1});
    CHECK(mesh.sets.at("all").cells == Indices{0, 1});
    CHECK(mesh.sets.at("Odd").cells.empty());
    CHECK(mesh.sets.at("Odd").nodes == Indices{0, 2, 4});
    CHECK(mesh.sets.at("More").nodes == Indices{0, 2, 4, 5});
    CHECK(mesh.sets.at("Points").nodes == Indices{0, 2, 4});
    CHECK(mesh.sets.at("all").nodes.size() == 6);
    CHECK(length(mesh, mesh.sets.at("Bottom")) == doctest::Approx(2e-3));
    CHECK(length(mesh, mesh.sets.at("Right")) == doctest::Approx(1e-3));
    CHECK(mesh.sets.at("Right").facets.size() == 1);
    CHECK_FALSE(mesh.sets.contains("_Bottom_S1"));
    CHECK(test::consistent(mesh, mesh.sets.at("Bottom")));
  }

  TEST_CASE("solids of Abaqus have their middle nodes where ours are") {
    if (no_mesher())
      return;
    OwnCache const cache;
    std::vector<std::array<double, 3>> const cube{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                                                  {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    std::vector<std::array<double, 3>> const corner{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (auto const& [type, kind, places] :
         {std::tuple{"C3D20R", CellKind::hex20, cube}, {"C3D10", CellKind::tet10, corner}}) {
      CAPTURE(type);
      Mesh const mesh = read(cache, std::string(type) + ".inp", abaqus_solid(type, kind, places));
      REQUIRE(mesh.blocks.size() == 1);
      CHECK(mesh.blocks[0].kind == kind);
      auto const& nodes = mesh.blocks[0].nodes;
      auto const& edges = info(kind).edges;
      for (std::size_t i = 0; i < edges.size(); ++i) {
        auto const at = [&](std::size_t k) { return mesh.nodes.row(nodes[k]); };
        auto const middle = at(static_cast<std::size_t>(info(kind).corners) + i);
        auto const a = at(static_cast<std::size_t>(edges[i][0])),
                   b = at(static_cast<std::size_t>(edges[i][1]));
        CHECK((middle - (a + b) / 2).norm() < 1e-12);
      }
      auto const& down = mesh.sets.at("down");
      CHECK(down.facets.size() == 1);
      CHECK(down.nodes.size() == (kind == CellKind::hex20 ? 8 : 6));
    }
  }

  TEST_CASE("an input file that cannot be read is refused with its line and what is wanted") {
    if (no_mesher())
      return;
    OwnCache const cache;
    auto const changed = [&](std::string const& from, std::string const& to) {
      return words(cache, "bad.inp", replaced(two_quads, from, to));
    };
    CHECK(mentions(changed("1.D0", "one"), "bad.inp: line 9: \"one\" is no coordinate"));
    CHECK(mentions(changed("1, 2, 5, 4", "1, 2, 5, 9"),
                   "line 13: an element has node 9, which is not in the file"));
    CHECK(
        mentions(changed("1, 2, 5, 4", "1, 2, 5, 4, 6"), "element 1 has 5 nodes, those of its type have 4"));
    CHECK(mentions(changed(" 6, 5\n", ""), "element 2 ends after 2 nodes"));
    CHECK(mentions(changed("CPE4R", "CPE9"),
                   "line 12: elements of type CPE9 have nodes in the middle of their faces"));
    CHECK(mentions(changed("CPE4R", "C3D27"), "write them without (20 nodes)"));
    CHECK(mentions(changed("CPE4R", "C3D15"), "elements of type C3D15; known are"));
    CHECK(mentions(changed("ODD, 6", "ODDS, 6"), "names the set \"ODDS\", which does not stand above it"));
    CHECK(mentions(changed("2, S2", "2, S5"), "element 2 has no face S5"));
    CHECK(mentions(changed("2, S2", "2, TOP"), "\"TOP\" is no face; S1 to S6 are"));
    CHECK(mentions(changed("*Heading", "*Include, input=x"), "*INCLUDE names another file"));
    CHECK(mentions(changed("*End Instance", "1., 0.\n*End Instance"), "*INSTANCE moves its part"));
    CHECK(mentions(changed("*Nset, nset=Odd", "*Nset"), "*NSET has no NSET="));
    CHECK(mentions(words(cache, "none.inp", "*NODE\n1, 0, 0\n"), "the file has no cells"));
  }

  TEST_CASE("a grid of legacy VTK keeps its cells, an .stl is filled with tetrahedra") {
    if (no_mesher())
      return;
    OwnCache const cache;
    std::string const grid =
        "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
        "0 0 0 1 0 0 1 1 0 0 1 0\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n9\n";
    Mesh const quad = read(cache, "grid.vtk", grid);
    CHECK(area(quad) == doctest::Approx(1e-6));
    CHECK(mentions(words(cache, "poly.vtk", "# vtk DataFile Version 3.0\nx\nASCII\nDATASET POLYDATA\n"),
                   "no DATASET UNSTRUCTURED_GRID"));
    CHECK(mentions(words(cache, "text.vtk", "hello"), "not a legacy VTK file"));
    constexpr int faces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                  {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    std::string cube = "solid cube\n";
    for (auto const& face : faces) {
      cube += "facet normal 0 0 0\nouter loop\n";
      for (int const k : face)
        cube += fmt::format("vertex {} {} {}\n", k % 4 == 1 || k % 4 == 2 ? 1 : 0, k % 4 > 1 ? 1 : 0, k / 4);
      cube += "endloop\nendfacet\n";
    }
    cube += "endsolid cube\n";
    Mesh const solid = msh_file({cache.write("cube.stl", cube), 1e-3, 0.5e-3});
    CHECK(solid.dim == 3);
    CHECK(solid.cell_count() > 20);
    CHECK(solid.sets.at("surface").facets.size() > 20);
    CHECK(solid.sets.contains("face_1"));
    CHECK(mentions(words(cache, "cube.stl", cube), "give the size of the cells that fill it"));
    CHECK(mentions(words(cache, "grid.vtk", grid, 0.1), "size is for .stl"));
    auto const open = cube.substr(0, cube.find("facet normal", 30)) + "endsolid cube\n";
    CHECK_FALSE(words(cache, "open.stl", open, 0.5).empty());
    CHECK(mentions(words(cache, "a.vtu", "x"), "not an unstructured grid of VTK (.vtu)"));
  }

  TEST_CASE("cells with nodes in the middle of faces are refused with how to write them") {
    if (no_mesher())
      return;
    OwnCache const cache;
    CHECK(mentions(
        words(cache, "nine.msh",
              "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n9\n1 0 0 0\n2 2 0 0\n3 2 2 0\n4 0 2 0\n5 1 0 0\n"
              "6 2 1 0\n7 1 2 0\n8 0 1 0\n9 1 1 0\n$EndNodes\n$Elements\n1\n"
              "1 10 2 1 1 1 2 3 4 5 6 7 8 9\n$EndElements\n"),
        "kind quad9, with nodes in the middle of faces; quad8 is computed on: set "
        "Mesh.SecondOrderIncomplete"));
  }
}
