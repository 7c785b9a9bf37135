// Quality numbers of known shapes, and the refusal of meshes that cannot be computed on.
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "mesh/generators/generators.hpp"
#include "mesh/helpers.hpp"
#include "mesh/topology/quality.hpp"

using namespace stiction;
using namespace stiction::mesh;
using test::mentions;
using test::refusal;

namespace {

Mesh squares() {
  return block({.size = {3, 1}, .cells = {3, 1}});
}

std::string check_words(Mesh const& mesh) {
  return refusal([&] { check(mesh, "plate"); });
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("quality of squares and of right triangles") {
    Quality const q = quality(block({.size = {2, 1}, .cells = {2, 2}}));
    CHECK(q.cells == 4);
    CHECK(q.min_jacobian == doctest::Approx(1));
    CHECK(q.max_aspect == doctest::Approx(2));
    CHECK(q.min_angle == doctest::Approx(90));
    CHECK(q.min_edge == doctest::Approx(0.5));
    Quality const t = quality(block({.size = {1, 1}, .cells = {1, 1}, .kind = CellKind::tri3}));
    CHECK(t.min_jacobian == doctest::Approx(std::sqrt(2.0 / 3)));
    CHECK(t.min_angle == doctest::Approx(45));
    CHECK(t.max_angle == doctest::Approx(90));
    CHECK(mentions(report(squares(), "plate"), "3 cells"));
  }

  TEST_CASE("an arrowhead has an angle above a half turn") {
    Mesh mesh = block({.size = {1, 1}, .cells = {1, 1}});
    mesh.nodes.row(3) << 0.25, 0.25; // the corner across the origin
    CHECK(quality(mesh).max_angle == doctest::Approx(270 - 2 * std::atan(1.0 / 3) * 180 / std::numbers::pi));
    CHECK(quality(mesh).min_jacobian < 0);
  }

  TEST_CASE("an inverted cell is refused with its number, centre and Jacobian") {
    Mesh mesh = squares();
    std::swap(mesh.blocks[0].nodes[5], mesh.blocks[0].nodes[7]); // the second cell runs clockwise
    auto const words = check_words(mesh);
    CHECK(mentions(words, "plate: cell 2 (quad4) at (1.5, 0.5) m is inverted"));
    CHECK(mentions(words, "-1"));
    CHECK_FALSE(mentions(words, "cell 1 "));
  }

  TEST_CASE("degenerate cells are refused: a flat one and one whose mid node folds it") {
    Mesh flat = squares();
    flat.nodes(0, 0) = flat.nodes(1, 0);
    flat.nodes(0, 1) = flat.nodes(1, 1);
    CHECK(mentions(check_words(flat), "cell 1 (quad4)"));
    Mesh folded = block({.size = {1, 1}, .cells = {1, 1}, .kind = CellKind::quad8});
    folded.nodes.row(folded.blocks[0].nodes[4]) << 0.95, 0.0;
    CHECK(mentions(check_words(folded), "cell 1 (quad8)"));
  }

  TEST_CASE("numbers that are not finite, unused nodes, repeated nodes and empty sets are refused") {
    Mesh mesh = squares();
    mesh.nodes(2, 1) = std::nan("");
    CHECK(mentions(check_words(mesh), "node 3 has a coordinate"));

    mesh = squares();
    mesh.nodes.conservativeResize(mesh.nodes.rows() + 1, 2);
    mesh.nodes.row(mesh.nodes.rows() - 1) << 9, 9;
    CHECK(mentions(check_words(mesh), "node 9 belongs to no cell"));

    mesh = squares();
    mesh.blocks[0].nodes[1] = mesh.blocks[0].nodes[0];
    CHECK(mentions(check_words(mesh), "cell 1 (quad4)"));
    CHECK(mentions(check_words(mesh), "has node 1 twice"));

    mesh = squares();
    mesh.blocks[0].nodes[1] = 77;
    CHECK(mentions(check_words(mesh), "names a node outside 1..8"));

    mesh = squares();
    mesh.sets["hook"] = {};
    CHECK(mentions(check_words(mesh), "set \"hook\" is empty"));

    CHECK(mentions(check_words(Mesh{}), "no cells"));
  }

  TEST_CASE("many problems of one sort are counted, not listed") {
    Mesh mesh = block({.size = {10, 1}, .cells = {10, 1}});
    mesh.nodes.col(0) *= -1;
    CHECK(mentions(check_words(mesh), "and 7 more of this sort"));
  }
}
