// Reading triangle surfaces: STL in both forms and .msh, welded, and the refusal of damaged files.
#include <cstring>
#include <doctest/doctest.h>
#include <fstream>
#include <limits>

#include "mesh/files/surface_file.hpp"
#include "mesh/helpers.hpp"

using namespace stiction;
using namespace stiction::mesh;
using test::mentions;
using test::refusal;

namespace {

/// The tetrahedron of corners (0 0 0) (2 0 0) (0 2 0) (0 0 2), faces outwards.
std::vector<std::array<std::array<float, 3>, 3>> const faces{{{{0, 0, 0}, {0, 2, 0}, {2, 0, 0}}},
                                                             {{{0, 0, 0}, {2, 0, 0}, {0, 0, 2}}},
                                                             {{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}}},
                                                             {{{0, 0, 0}, {0, 0, 2}, {0, 2, 0}}}};

std::string text_stl() {
  std::string text = "solid tip\n";
  for (auto const& face : faces) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (auto const& v : face)
      text += "   vertex " + std::to_string(v[0]) + " " + std::to_string(v[1]) + " " + std::to_string(v[2]) +
              "\n";
    text += "  endloop\n endfacet\n";
  }
  return text + "endsolid tip\n";
}

/// `start` is what the header begins with.
std::string binary_stl(std::string const& start) {
  std::string bytes = start;
  bytes.resize(80, ' ');
  auto const append = [&](auto const& value) {
    bytes.append(reinterpret_cast<char const*>(&value), sizeof value);
  };
  append(static_cast<std::uint32_t>(faces.size()));
  for (auto const& face : faces) {
    append(std::array<float, 3>{});
    append(face);
    append(std::uint16_t{0});
  }
  return bytes;
}

std::string put(test::Folder const& folder, std::string const& name, std::string const& bytes) {
  std::ofstream(folder / name, std::ios::binary) << bytes;
  return folder / name;
}

void check_tip(SurfaceMesh const& surface, double scale) {
  CHECK(surface.nodes.rows() == 4);
  CHECK(surface.facets.size() == 4);
  Mesh const mesh{.dim = 3, .nodes = surface.nodes, .blocks = {}, .sets = {}};
  CHECK(test::enclosed_volume(mesh, surface.facets) ==
        doctest::Approx(8.0 / 6 * scale * scale * scale).epsilon(1e-6));
  CHECK_NOTHROW(check_surface(mesh, {{}, surface.facets}, "tip"));
}

std::string words_of(std::string const& path) {
  return refusal([&] { (void)read_stl(path); });
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("text and binary STL give the same welded surface") {
    test::Folder const folder;
    check_tip(read_stl(put(folder, "text.stl", text_stl())), 1);
    check_tip(read_stl(put(folder, "text.stl", text_stl()), 1e-3), 1e-3);
    check_tip(read_stl(put(folder, "binary.stl", binary_stl("made for a test"))), 1);
    check_tip(read_stl(put(folder, "solid.stl", binary_stl("solid but binary"))), 1);
  }

  TEST_CASE("vertices that differ by rounding are welded and others are not") {
    test::Folder const folder;
    auto text = text_stl();
    text.replace(text.find("2.000000"), 8, "2.0000001");
    check_tip(read_stl(put(folder, "near.stl", text)), 1);
    text.replace(text.find("2.0000001"), 9, "2.00001");
    CHECK(read_stl(put(folder, "far.stl", text)).nodes.rows() == 5);
  }

  TEST_CASE("truncated empty and missing STL files are refused with their path") {
    test::Folder const folder;
    for (auto const& [name, whole] :
         {std::pair{"text", text_stl()}, std::pair{"binary", binary_stl("made for a test")}})
      for (std::size_t part = 1; part < 10; ++part) {
        CAPTURE(name);
        CAPTURE(part);
        auto const path = put(folder, "cut.stl", whole.substr(0, whole.size() * part / 10));
        CHECK(mentions(words_of(path), "truncated"));
        CHECK(mentions(words_of(path), path));
      }
    CHECK(mentions(words_of(put(folder, "none.stl", "")), "empty"));
    CHECK(mentions(words_of(folder / "nowhere.stl"), "cannot be read"));
    CHECK(mentions(words_of(put(folder, "hollow.stl", "solid x\nendsolid x\n")), "no triangle"));
  }

  TEST_CASE("numbers that are not finite and surfaces without area are refused") {
    test::Folder const folder;
    auto text = text_stl();
    text.replace(text.find("2.000000"), 8, "nan");
    CHECK(
        mentions(words_of(put(folder, "nan.stl", text)), "triangle 1 has a coordinate that is not a finite"));
    text.replace(text.find("nan"), 3, "two");
    CHECK(mentions(words_of(put(folder, "two.stl", text)), "triangle 1 lacks a coordinate"));
    auto bytes = binary_stl("made for a test");
    float const infinite = std::numeric_limits<float>::infinity();
    std::memcpy(bytes.data() + 84 + 50 + 12, &infinite, sizeof infinite);
    CHECK(mentions(words_of(put(folder, "inf.stl", bytes)), "triangle 2"));
    CHECK(mentions(
        words_of(put(folder, "point.stl",
                     "solid\nouter loop\nvertex 1 1 1\nvertex 1 1 1\nvertex 1 1 1\nendloop\nendsolid")),
        "without an area"));
  }

  TEST_CASE("triangles of msh files of versions 2 and 4 are read and other cells passed over") {
    test::Folder const folder;
    std::string const nodes = "1 0 0 0\n2 2 0 0\n3 0 2 0\n4 0 0 2\n";
    std::string const two = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n4\n" + nodes +
                            "$EndNodes\n$Elements\n5\n1 1 2 0 1 1 2\n2 2 2 0 1 1 3 2\n3 2 2 0 1 1 2 4\n"
                            "4 2 2 0 1 2 3 4\n5 2 2 0 1 1 4 3\n$EndElements\n";
    check_tip(read_msh_triangles(put(folder, "two.msh", two), 1e-3), 1e-3);
    std::string const four = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 4 1 4\n2 1 0 4\n1\n2\n3\n4\n0 "
                             "0 0\n2 0 0\n0 2 0\n0 0 2\n"
                             "$EndNodes\n$Elements\n2 5 1 5\n1 1 1 1\n1 1 2\n2 1 2 4\n2 1 3 2\n3 1 2 4\n4 2 "
                             "3 4\n5 1 4 3\n$EndElements\n";
    check_tip(read_msh_triangles(put(folder, "four.msh", four)), 1);
    auto const words = [&](std::string const& text) {
      return refusal([&] { (void)read_msh_triangles(put(folder, "bad.msh", text)); });
    };
    for (auto const& whole : {two, four})
      for (std::size_t part = 1; part < 10; ++part)
        CHECK(mentions(words(whole.substr(0, whole.size() * part / 10)), "truncated"));
    CHECK(mentions(words("hello"), "not a gmsh mesh file"));
    CHECK(mentions(words("$MeshFormat\n4.1 1 8\n"), "without binary"));
    auto nan = two;
    nan.replace(nan.find("2 2 0 0"), 7, "2 nan 0 0");
    CHECK(mentions(words(nan), "not a finite"));
  }
}
