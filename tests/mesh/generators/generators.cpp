// Areas, perimeters, sets and refusals of the structured generators.
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "mesh/generators/generators.hpp"
#include "mesh/helpers.hpp"
#include "mesh/topology/quality.hpp"

using namespace stiction;
using namespace stiction::mesh;
using test::area;
using test::length;
using test::mentions;
using test::refusal;

namespace {

std::vector<CellKind> all_kinds() {
  std::vector<CellKind> kinds;
  for (auto const& cell : cell_table(2))
    kinds.push_back(cell.kind);
  return kinds;
}

HalfDiscOptions disc(double size, CellKind kind = CellKind::quad4, double grading = 1) {
  return {.centre = {0, 0}, .radius = 5e-3, .size = size, .grading = grading, .kind = kind};
}

/// Node at exactly this position, or -1.
Index node_at(Mesh const& mesh, double x, double y) {
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (mesh.nodes(i, 0) == x && mesh.nodes(i, 1) == y)
      return i;
  return -1;
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("a block has its area, its sides as sets and its corners exactly") {
    for (auto const kind : all_kinds()) {
      CAPTURE(info(kind).name);
      Mesh const mesh = block(
          {.origin = {-9e-3, 5e-3}, .size = {18e-3, 2e-3}, .cells = {9, 4}, .grading = {1, 3}, .kind = kind});
      check(mesh, "block");
      CHECK(mesh.cell_count() == (info(kind).corners == 3 ? 72 : 36));
      CHECK(area(mesh) == doctest::Approx(36e-6));
      CHECK(length(mesh, mesh.sets.at("left")) == doctest::Approx(2e-3));
      CHECK(length(mesh, mesh.sets.at("right")) == doctest::Approx(2e-3));
      CHECK(length(mesh, mesh.sets.at("bottom")) == doctest::Approx(18e-3));
      CHECK(length(mesh, mesh.sets.at("top")) == doctest::Approx(18e-3));
      CHECK(mesh.sets.at("bottom").facets.size() == 9);
      CHECK(mesh.sets.at("all").nodes.size() == static_cast<std::size_t>(mesh.node_count()));
      CHECK(node_at(mesh, -9e-3, 5e-3) >= 0);
      for (auto const& [name, set] : mesh.sets)
        CHECK(test::consistent(mesh, set));
    }
  }

  TEST_CASE("grading is the size of the last cell over that of the first") {
    Mesh const mesh = block({.size = {1, 1}, .cells = {5, 1}, .grading = {4, 1}});
    double const first = mesh.nodes(1, 0) - mesh.nodes(0, 0), last = mesh.nodes(5, 0) - mesh.nodes(4, 0);
    CHECK(last / first == doctest::Approx(4));
    Mesh const up = block({.size = {1, 1}, .cells = {1, 3}, .grading = {4, 0.5}});
    double const lowest = up.nodes(2, 1) - up.nodes(0, 1), highest = up.nodes(6, 1) - up.nodes(4, 1);
    CHECK(highest / lowest == doctest::Approx(0.5));
  }

  TEST_CASE("facets of a block have the body to their left") {
    Mesh const mesh = block({.size = {2, 1}, .cells = {3, 2}, .kind = CellKind::tri6});
    CHECK(test::enclosed_area(mesh, boundary(mesh)) == doctest::Approx(2));
    auto const& facet = mesh.sets.at("bottom").facets.front();
    CHECK(mesh.nodes(facet.nodes[1], 0) > mesh.nodes(facet.nodes[0], 0));
    auto const& above = mesh.sets.at("top").facets.front();
    CHECK(mesh.nodes(above.nodes[1], 0) < mesh.nodes(above.nodes[0], 0));
  }

  TEST_CASE("a block refuses wrong numbers all at once") {
    auto const words = test::refusal([] {
      (void)block({.origin = {0}, .size = {-1, 1}, .cells = {2.5, 1}});
    });
    CHECK(test::mentions(words, "block.origin"));
    CHECK(test::mentions(words, "block.size"));
    CHECK(test::mentions(words, "block.cells"));
    CHECK(test::mentions(test::refusal([] {
                           (void)block({.size = {1, 1}, .cells = {1e4, 1e4}});
                         }),
                         "at most"));
  }

  TEST_CASE("the half disc has a node exactly at the crown and all arc nodes on the circle") {
    for (auto const kind : all_kinds())
      for (double const grading : {1.0, 2.0, 6.0}) {
        CAPTURE(info(kind).name);
        CAPTURE(grading);
        Mesh const mesh = half_disc(disc(0.25e-3, kind, grading));
        Index const crown = node_at(mesh, 0.0, 5e-3);
        auto const& arc = mesh.sets.at("arc");
        REQUIRE(crown >= 0);
        CHECK(std::binary_search(arc.nodes.begin(), arc.nodes.end(), crown));
        for (Index const node : arc.nodes)
          CHECK(std::abs(mesh.nodes.row(node).norm() - 5e-3) < 1e-15);
        for (auto const& facet : arc.facets) {
          double const size = (mesh.nodes.row(facet.nodes[1]) - mesh.nodes.row(facet.nodes[0])).norm();
          CHECK(size <= 0.25e-3);
          CHECK(size > 0.2e-3);
        }
      }
  }

  TEST_CASE("area and arc of the half disc converge at the order of the kind") {
    double const exact_area = std::numbers::pi * 25e-6 / 2, exact_arc = std::numbers::pi * 5e-3;
    for (auto const kind : all_kinds()) {
      CAPTURE(info(kind).name);
      bool const second_order = info(kind).nodes > info(kind).corners;
      Mesh const coarse = half_disc(disc(0.5e-3, kind)), fine = half_disc(disc(0.25e-3, kind));
      double const rate = std::log2(std::abs(area(coarse) - exact_area) / std::abs(area(fine) - exact_area));
      double const refinement = std::log2(static_cast<double>(fine.sets.at("arc").facets.size()) /
                                          static_cast<double>(coarse.sets.at("arc").facets.size()));
      CHECK(rate / refinement == doctest::Approx(second_order ? 4 : 2).epsilon(0.05));
      CHECK(length(fine, fine.sets.at("arc")) == doctest::Approx(exact_arc).epsilon(1e-3));
      CHECK(length(fine, fine.sets.at("flat")) == doctest::Approx(10e-3));
    }
  }

  TEST_CASE("cells of the half disc are well shaped at every size and grading") {
    for (double const grading : {1.0, 2.0, 3.0, 6.0, 9.0})
      for (double const size : {5.0, 2.5, 1.3, 0.7, 0.5, 0.25, 0.125}) {
        CAPTURE(grading);
        CAPTURE(size);
        Mesh const mesh = half_disc(disc(size * 1e-3, CellKind::quad4, grading));
        check(mesh, "half disc");
        CHECK(quality(mesh).min_jacobian >= 0.5);
        CHECK(test::enclosed_area(mesh, boundary(mesh)) == doctest::Approx(area(mesh)));
        CHECK(boundary(mesh).size() ==
              mesh.sets.at("arc").facets.size() + mesh.sets.at("flat").facets.size());
      }
  }

  TEST_CASE("grading makes interior cells larger and never more than asked") {
    Mesh const even = half_disc(disc(0.25e-3)), graded = half_disc(disc(0.25e-3, CellKind::quad4, 2));
    CHECK(graded.cell_count() < even.cell_count() / 2);
    CHECK(graded.sets.at("arc").facets.size() >= even.sets.at("arc").facets.size());
    double longest = 0;
    for (auto const& facet : graded.sets.at("flat").facets)
      longest =
          std::max(longest, (graded.nodes.row(facet.nodes[1]) - graded.nodes.row(facet.nodes[0])).norm());
    CHECK(longest < 2.6 * 0.25e-3); // rings may be a little thicker than wide
  }

  TEST_CASE("the half disc is mirror symmetric and moves with its centre") {
    Mesh const mesh = half_disc(disc(0.5e-3));
    auto moved_options = disc(0.5e-3);
    moved_options.centre = {1e-3, -2e-3};
    Mesh const moved = half_disc(moved_options);
    for (Index i = 0; i < mesh.node_count(); ++i)
      CHECK(node_at(mesh, -mesh.nodes(i, 0), mesh.nodes(i, 1)) >= 0);
    CHECK(moved.nodes.col(1).minCoeff() == -2e-3);
    CHECK(node_at(moved, 1e-3, 3e-3) >= 0);
    CHECK(area(moved) == doctest::Approx(area(mesh)));
  }

  TEST_CASE("the half disc refuses wrong numbers") {
    CHECK(test::mentions(test::refusal([] { (void)half_disc(disc(6e-3)); }), "half_disc.size"));
    CHECK(test::mentions(test::refusal([] { (void)half_disc(disc(1e-6)); }), "half_disc.size"));
    CHECK(
        test::mentions(test::refusal([] { (void)half_disc(disc(1e-3, CellKind::quad4, 0.5)); }), "grading"));
    CHECK(test::mentions(test::refusal([] { (void)half_disc({.radius = -1, .size = 1}); }), "radius"));
  }

  TEST_CASE("a graded block has fine cells of one size at its top left and no cell too large") {
    for (auto const kind : all_kinds()) {
      CAPTURE(info(kind).name);
      Mesh const mesh = graded_block({.origin = {1, -10},
                                      .size = {10, 10},
                                      .fine = {4.5, 1},
                                      .fine_size = 0.25,
                                      .coarse_size = 2,
                                      .kind = kind});
      check(mesh, "block");
      CHECK(area(mesh) == doctest::Approx(100));
      for (auto const* name : {"left", "right", "bottom", "top"})
        CHECK(length(mesh, mesh.sets.at(name)) == doctest::Approx(10));
      CHECK(node_at(mesh, 1, 0) >= 0);
      CHECK(node_at(mesh, 11, -10) >= 0);
      double before = 0.25;
      std::vector<double> xs;
      for (auto const& facet : mesh.sets.at("top").facets)
        xs.insert(xs.end(), {mesh.nodes(facet.nodes[0], 0), mesh.nodes(facet.nodes[1], 0)});
      std::sort(xs.begin(), xs.end());
      for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
        double const size = xs[i + 1] - xs[i];
        if (xs[i + 1] < 5.5 + 1e-9)
          CHECK(size == doctest::Approx(0.25));
        CHECK(size < before * 1.25 * (1 + 1e-9));
        CHECK(size <= 2);
        before = size;
      }
      std::vector<double> ys;
      for (auto const& facet : mesh.sets.at("left").facets)
        ys.insert(ys.end(), {mesh.nodes(facet.nodes[0], 1), mesh.nodes(facet.nodes[1], 1)});
      std::sort(ys.begin(), ys.end());
      CHECK(ys.end()[-1] - ys.end()[-2] == doctest::Approx(0.25));
      auto const below = std::lower_bound(ys.begin(), ys.end(), -3.0); // two metres under the fine zone
      CHECK(below[0] - below[-1] > 0.5);
    }
  }

  TEST_CASE("the quarter disc has its sets and areas and is fine near its pole") {
    for (auto const kind : all_kinds())
      for (bool const standing : {false, true}) {
        CAPTURE(info(kind).name);
        Mesh const mesh = quarter_disc({.centre = {1, 2},
                                        .radius = 10,
                                        .fine = {4.5, 1},
                                        .fine_size = 0.1,
                                        .coarse_size = 1,
                                        .standing = standing,
                                        .kind = kind});
        check(mesh, "disc");
        CHECK(area(mesh) == doctest::Approx(25 * std::numbers::pi).epsilon(1e-3));
        CHECK(test::enclosed_area(mesh, boundary(mesh)) == doctest::Approx(area(mesh)).epsilon(1e-2));
        CHECK(length(mesh, mesh.sets.at("arc")) == doctest::Approx(5 * std::numbers::pi).epsilon(1e-3));
        CHECK(length(mesh, mesh.sets.at("flat")) == doctest::Approx(10));
        CHECK(length(mesh, mesh.sets.at("axis")) == doctest::Approx(10));
        Eigen::RowVector2d const pole(1, standing ? 12 : -8);
        CHECK(node_at(mesh, pole[0], pole[1]) >= 0);
        for (Index const node : mesh.sets.at("arc").nodes)
          CHECK((mesh.nodes.row(node) - Eigen::RowVector2d(1, 2)).norm() == doctest::Approx(10));
        for (auto const& facet : mesh.sets.at("arc").facets) {
          auto const a = mesh.nodes.row(facet.nodes[0]), b = mesh.nodes.row(facet.nodes[1]);
          double const size = (a - b).norm();
          CHECK(size < (std::max((a - pole).norm(), (b - pole).norm()) < 4.4 ? 0.1001 : 1.0));
        }
        CHECK(mesh.cell_count() < (info(kind).corners == 3 ? 6000 : 3000));
        if (info(kind).corners == 4)
          CHECK(quality(mesh).min_jacobian > 0.5);
      }
  }

  TEST_CASE("graded block and quarter disc refuse wrong numbers") {
    CHECK(mentions(refusal([] {
                     (void)graded_block({.size = {1, 1}, .fine = {1}, .fine_size = 0.1, .coarse_size = 0.2});
                   }),
                   "graded_block.fine"));
    CHECK(mentions(refusal([] {
                     (void)graded_block({.size = {1, 1}, .fine = {1, 1}, .fine_size = 2, .coarse_size = 0.2});
                   }),
                   "graded_block.coarse_size"));
    auto const fine = [](double size, double coarse) {
      return GradedBlockOptions{
          .size = {10, 10}, .fine = {0.5, 0.1}, .fine_size = size, .coarse_size = coarse};
    };
    CHECK(graded_block(fine(1e-3, 1)).nodes.rows() > 500); // ten thousand along the block, 500 in the zone
    CHECK(mentions(refusal([&] { (void)graded_block(fine(1e-4, 1)); }), "graded_block.fine_size"));
    CHECK(mentions(refusal([&] { (void)graded_block(fine(1e-3, 1e-3)); }), "graded_block.coarse_size"));
    CHECK(mentions(refusal([] {
                     (void)quarter_disc({.radius = 0, .fine = {1, 1}, .fine_size = 2, .coarse_size = 3});
                   }),
                   "quarter_disc.radius"));
    CHECK(mentions(refusal([] {
                     (void)quarter_disc({.radius = 1, .fine = {-1, 1}, .fine_size = 0.2, .coarse_size = 3});
                   }),
                   "quarter_disc.fine"));
  }
}
