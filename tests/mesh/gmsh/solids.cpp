// Volumes, areas, sets, quality and refusals of the generators in 3D.
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include "mesh/generators/generators.hpp"
#include "mesh/helpers.hpp"
#include "mesh/topology/quality.hpp"

using namespace stiction;
using namespace stiction::mesh;
using std::numbers::pi;
using test::mentions;
using test::refusal;
using test::surface_area;
using test::volume;

namespace {

bool tetrahedra(CellKind kind) {
  return info(kind).corners == 4;
}

bool second_order(CellKind kind) {
  return info(kind).nodes > info(kind).corners;
}

/// The block of an indentation study, mm as m.
QuarterCylinderOptions cylinder(double size, CellKind kind = CellKind::hex8) {
  return {
      .radius = 10, .height = 10, .fine = {4.5, 1}, .fine_size = size, .coarse_size = 4 * size, .kind = kind};
}

HalfBallOptions ball(double size, CellKind kind = CellKind::hex8, Part part = Part::quarter) {
  return {
      .radius = 10, .fine = {4.5, 1}, .fine_size = size, .coarse_size = 4 * size, .part = part, .kind = kind};
}

/// Sets lie in the boundary, face outwards, and together with nothing else make it up.
void check_sets(Mesh const& mesh) {
  check(mesh, "mesh");
  std::size_t facets = 0;
  for (auto const& [name, set] : mesh.sets) {
    CAPTURE(name);
    CHECK(test::consistent(mesh, set));
    facets += set.facets.size();
    if (name == "all")
      CHECK(set.nodes.size() == static_cast<std::size_t>(mesh.node_count()));
    else
      CHECK_NOTHROW(check_surface(mesh, set, name));
  }
  auto const whole = boundary(mesh);
  CHECK(facets == whole.size());
  CHECK(test::enclosed_volume(mesh, whole) == doctest::Approx(volume(mesh)).epsilon(1e-10));
  CHECK_NOTHROW(check_surface(mesh, {{}, whole}, "whole boundary"));
}

/// Node at exactly this position, or -1.
Index node_at(Mesh const& mesh, Eigen::RowVector3d const& position) {
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (mesh.nodes.row(i) == position)
      return i;
  return -1;
}

} // namespace

TEST_SUITE("mesh") {
  TEST_CASE("a box has its volume, its six sides as sets facing outwards and its corners exactly") {
    for (auto const& cell : cell_table(3)) {
      CAPTURE(cell.name);
      Mesh const mesh = box({.origin = {-1e-3, 2e-3, 5e-3},
                             .size = {3e-3, 2e-3, 1e-3},
                             .cells = {3, 2, 4},
                             .grading = {1, 2, 0.5},
                             .kind = cell.kind});
      check_sets(mesh);
      CHECK(mesh.cell_count() == (tetrahedra(cell.kind) ? 144 : 24));
      CHECK(volume(mesh) == doctest::Approx(6e-9).epsilon(1e-12));
      for (auto const& [name, area] :
           {std::pair{"left", 2e-6}, std::pair{"right", 2e-6}, std::pair{"front", 3e-6},
            std::pair{"back", 3e-6}, std::pair{"bottom", 6e-6}, std::pair{"top", 6e-6}}) {
        CAPTURE(name);
        CHECK(surface_area(mesh, mesh.sets.at(name)) == doctest::Approx(area).epsilon(1e-12));
        CHECK(nodal_areas(mesh, mesh.sets.at(name)).sum() == doctest::Approx(area).epsilon(1e-12));
      }
      CHECK(node_at(mesh, {-1e-3, 2e-3, 5e-3}) == 0);
      CHECK(mesh.nodes(mesh.sets.at("back").nodes.front(), 1) == 2e-3 + 2e-3);
    }
  }

  TEST_CASE("sides of a box face outwards one by one") {
    for (auto const& cell : cell_table(3)) {
      Mesh const mesh = box({.size = {1, 1, 1}, .cells = {2, 2, 2}, .kind = cell.kind});
      for (auto const& [name, outward] :
           {std::pair{"left", Eigen::Vector3d(-1, 0, 0)}, std::pair{"right", Eigen::Vector3d(1, 0, 0)},
            std::pair{"front", Eigen::Vector3d(0, -1, 0)}, std::pair{"back", Eigen::Vector3d(0, 1, 0)},
            std::pair{"bottom", Eigen::Vector3d(0, 0, -1)}, std::pair{"top", Eigen::Vector3d(0, 0, 1)}}) {
        auto const flux = test::over_facets(
            mesh, mesh.sets.at(name).facets,
            [&, n = outward](Eigen::Vector3d const&, Eigen::Vector3d const& dA) { return dA.dot(n); });
        CHECK(flux == doctest::Approx(1).epsilon(1e-12));
      }
    }
  }

  TEST_CASE("quality of cubes, of regular and of split cells in 3D") {
    Quality const cubes = quality(box({.size = {2, 1, 1}, .cells = {2, 1, 2}}));
    CHECK(cubes.min_jacobian == doctest::Approx(1));
    CHECK(cubes.max_aspect == doctest::Approx(2));
    CHECK(cubes.min_edge == doctest::Approx(0.5));
    CHECK(cubes.min_angle == doctest::Approx(90));
    Quality const split = quality(box({.size = {1, 1, 1}, .cells = {2, 2, 2}, .kind = CellKind::tet4}));
    CHECK(split.min_jacobian == doctest::Approx(std::sqrt(1.0 / 3)));
    CHECK(split.max_aspect == doctest::Approx(std::sqrt(3.0)));
    Mesh regular;
    regular.dim = 3;
    regular.nodes = (Matrix(4, 3) << 1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1).finished();
    regular.blocks = {{CellKind::tet4, {0, 2, 1, 3}}};
    if (volume(regular) < 0)
      std::swap(regular.blocks[0].nodes[0], regular.blocks[0].nodes[1]);
    CHECK(quality(regular).min_jacobian == doctest::Approx(1));
    CHECK(quality(regular).max_angle == doctest::Approx(60));
  }

  TEST_CASE("inverted and folded cells are refused in 3D with their centre") {
    Mesh mesh = box({.size = {2, 1, 1}, .cells = {2, 1, 1}});
    std::swap_ranges(mesh.blocks[0].nodes.begin() + 8, mesh.blocks[0].nodes.begin() + 12,
                     mesh.blocks[0].nodes.begin() + 12);
    auto const words = refusal([&] { check(mesh, "plate"); });
    CHECK(mentions(words, "cell 2 (hex8) at (1.5, 0.5, 0.5) m is inverted"));
    Mesh folded = box({.size = {1, 1, 1}, .cells = {1, 1, 1}, .kind = CellKind::hex20});
    folded.nodes.row(folded.blocks[0].nodes[8]) << 0.95, 0, 0;
    CHECK(mentions(refusal([&] { check(folded, "plate"); }), "cell 1 (hex20)"));
  }

  TEST_CASE("the quarter cylinder has its sets, areas and volume in every kind") {
    for (auto const& cell : cell_table(3)) {
      CAPTURE(cell.name);
      auto options = cylinder(1, cell.kind);
      options.centre = {1, -2, 3};
      Mesh const mesh = quarter_cylinder(options);
      check_sets(mesh);
      double const close = second_order(cell.kind) ? 1e-4 : 1e-2;
      CHECK(volume(mesh) == doctest::Approx(250 * pi).epsilon(close));
      CHECK(surface_area(mesh, mesh.sets.at("top")) == doctest::Approx(25 * pi).epsilon(close));
      CHECK(surface_area(mesh, mesh.sets.at("bottom")) == doctest::Approx(25 * pi).epsilon(close));
      CHECK(surface_area(mesh, mesh.sets.at("side")) == doctest::Approx(50 * pi).epsilon(close));
      CHECK(surface_area(mesh, mesh.sets.at("symmetry_x")) == doctest::Approx(100).epsilon(1e-10));
      CHECK(surface_area(mesh, mesh.sets.at("symmetry_y")) == doctest::Approx(100).epsilon(1e-10));
      for (Index const node : mesh.sets.at("side").nodes)
        CHECK(std::hypot(mesh.nodes(node, 0) - 1, mesh.nodes(node, 1) + 2) == doctest::Approx(10));
      CHECK(node_at(mesh, {1, -2, 3}) >= 0);
    }
  }

  TEST_CASE("volume and top of the quarter cylinder converge at second order") {
    auto const error = [](double size) {
      QuarterCylinderOptions const even{
          .radius = 10, .height = 2, .fine = {10, 2}, .fine_size = size, .coarse_size = size};
      return 1 - volume(quarter_cylinder(even)) / (50 * pi);
    };
    CHECK(std::log2(error(1.0) / error(0.5)) == doctest::Approx(2).epsilon(0.05));
  }

  TEST_CASE("cells of the quarter cylinder are well shaped and fine where asked") {
    for (double const size : {1.0, 0.5, 0.25})
      for (double const fine : {1.5, 4.5, 10.0}) {
        CAPTURE(size);
        CAPTURE(fine);
        auto options = cylinder(size);
        options.fine[0] = fine;
        if (size < 0.5 && fine > 5)
          continue; // many cells, nothing new
        Mesh const mesh = quarter_cylinder(options);
        check(mesh, "cylinder");
        CHECK(quality(mesh).min_jacobian > 0.75);
        for (auto const& facet : mesh.sets.at("top").facets)
          for (std::size_t i = 0; i < 4; ++i) {
            auto const a = mesh.nodes.row(facet.nodes[i]), b = mesh.nodes.row(facet.nodes[(i + 1) % 4]);
            double const farther = std::max(a.norm(), b.norm());
            if (farther <= fine)
              CHECK((a - b).norm() < 1.25 * size);
            else
              CHECK((a - b).norm() < std::max(4.0, 10 / fine) * size * (1 + 1e-9));
          }
      }
  }

  TEST_CASE("the half ball has its sets, areas and volume in every kind and part") {
    for (auto const& cell : cell_table(3))
      for (auto const part : {Part::quarter, Part::half, Part::full})
        for (bool const standing : {false, true}) {
          CAPTURE(cell.name);
          CAPTURE(standing);
          auto options = ball(1.5, cell.kind, part);
          options.centre = {1, -2, 3};
          options.standing = standing;
          double const share = part == Part::quarter ? 0.25 : part == Part::half ? 0.5 : 1;
          Mesh const mesh = half_ball(options);
          check_sets(mesh);
          double const close = second_order(cell.kind) ? 1e-3 : 2e-2;
          CHECK(volume(mesh) == doctest::Approx(share * 2000 * pi / 3).epsilon(close));
          CHECK(surface_area(mesh, mesh.sets.at("cap")) == doctest::Approx(share * 200 * pi).epsilon(close));
          CHECK(surface_area(mesh, mesh.sets.at("flat")) == doctest::Approx(share * 100 * pi).epsilon(close));
          CHECK(mesh.sets.contains("symmetry_x") == (part == Part::quarter));
          CHECK(mesh.sets.contains("symmetry_y") == (part != Part::full));
          if (part == Part::quarter)
            CHECK(surface_area(mesh, mesh.sets.at("symmetry_x")) == doctest::Approx(25 * pi).epsilon(close));
          for (Index const node : mesh.sets.at("cap").nodes)
            CHECK((mesh.nodes.row(node) - Eigen::RowVector3d(1, -2, 3)).norm() == doctest::Approx(10));
          Index const pole = node_at(mesh, {1, -2, standing ? 13.0 : -7.0});
          CHECK(pole >= 0);
        }
  }

  TEST_CASE("cells of the half ball are well shaped and fine near the pole") {
    for (double const size : {1.0, 0.5, 0.35}) {
      CAPTURE(size);
      Mesh const mesh = half_ball(ball(size));
      check(mesh, "ball");
      CHECK(quality(mesh).min_jacobian > 0.65);
      Eigen::RowVector3d const pole(0, 0, -10);
      for (auto const& facet : mesh.sets.at("cap").facets)
        for (std::size_t i = 0; i < 4; ++i) {
          auto const a = mesh.nodes.row(facet.nodes[i]), b = mesh.nodes.row(facet.nodes[(i + 1) % 4]);
          if (std::max((a - pole).norm(), (b - pole).norm()) < 4)
            CHECK((a - b).norm() < 1.01 * size);
          CHECK((a - b).norm() < 4.5 * size);
        }
    }
  }

  TEST_CASE("tetrahedra split from cells about as long as wide are well shaped") {
    HalfBallOptions const even_ball{
        .radius = 10, .fine = {8, 6}, .fine_size = 1, .coarse_size = 1, .kind = CellKind::tet4};
    CHECK(quality(half_ball(even_ball)).min_jacobian > 0.15);
    QuarterCylinderOptions const even_cylinder{.radius = 10,
                                               .height = 10,
                                               .fine = {10, 10},
                                               .fine_size = 1,
                                               .coarse_size = 1,
                                               .kind = CellKind::tet4};
    CHECK(quality(quarter_cylinder(even_cylinder)).min_jacobian > 0.15);
  }

  TEST_CASE("the generators in 3D refuse wrong numbers with their names") {
    auto const boxed = refusal([] {
      (void)box({.origin = {0, 0}, .size = {1, 1, -1}, .cells = {1, 2, 2.5}});
    });
    CHECK(mentions(boxed, "box.origin"));
    CHECK(mentions(boxed, "box.size"));
    CHECK(mentions(boxed, "box.cells"));
    CHECK(mentions(refusal([] { (void)box({.size = {1, 1, 1}, .cells = {1e3, 1e3, 1e3}}); }), "at most"));
    auto const words = [](auto change) {
      auto options = cylinder(0.5);
      change(options);
      return refusal([&] { (void)quarter_cylinder(options); });
    };
    CHECK(mentions(words([](auto& o) { o.radius = -1; }), "quarter_cylinder.radius"));
    CHECK(mentions(words([](auto& o) { o.fine = {1}; }), "quarter_cylinder.fine"));
    CHECK(mentions(words([](auto& o) { o.fine = {0, 1}; }), "below fine_size"));
    CHECK(mentions(words([](auto& o) { o.fine_size = 1e-5; }), "quarter_cylinder.fine_size"));
    CHECK(mentions(words([](auto& o) { o.fine_size = 11; }), "quarter_cylinder.fine_size"));
    CHECK(mentions(words([](auto& o) { o.coarse_size = 0.4; }), "quarter_cylinder.coarse_size"));
    CHECK(mentions(words([](auto& o) { o.growth = 1; }), "quarter_cylinder.growth"));
    CHECK(mentions(words([](auto& o) { o.fine_size = o.coarse_size = 0.02; }), "at most"));
    CHECK(mentions(refusal([] { (void)half_ball(ball(0.02)); }), "half_ball: makes"));
    CHECK(mentions(refusal([] { (void)half_ball(ball(-1)); }), "half_ball.fine_size"));
  }
}
