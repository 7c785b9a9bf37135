// Facets of cells: derivatives of their functions, normals at edges, and which of several facets faces a
// point.
#include "contact/surface/cell_surface.hpp"

#include <doctest/doctest.h>
#include <numbers>

#include "contact/mortar/mortar_cut.hpp"

using namespace stiction;
using namespace stiction::contact;

namespace {

/// Two facets of length 1 in the plane, the second turned to the left of the first by an angle, rad.
CellSurface folded(double angle, Matrix& nodes) {
  nodes.resize(3, 2);
  nodes << 0, 0, 1, 0, 1 + std::cos(angle), std::sin(angle);
  return {{{{0, 1}}, {{1, 2}}}, nodes, Vec3::UnitX()};
}

Positions positions(Matrix const& nodes) {
  return {nodes.data(), static_cast<std::size_t>(nodes.size())};
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("derivatives of the functions of facets are those of differences, the mixed one too") {
    double const h = 1e-4;
    for (auto const kind : {FacetKind::line2, FacetKind::line3, FacetKind::tri3, FacetKind::quad4,
                            FacetKind::tri6, FacetKind::quad8})
      for (int a = 0; a < (corner_count(kind) == 2 ? 1 : 2); ++a) {
        Vec2 const at(0.3, corner_count(kind) == 2 ? 0 : 0.17);
        auto const here = facet_shape(kind, at), ahead = facet_shape(kind, at + h * Vec2::Unit(a)),
                   behind = facet_shape(kind, at - h * Vec2::Unit(a));
        CAPTURE(static_cast<int>(kind));
        CAPTURE(a);
        CHECK(here.N.sum() == doctest::Approx(1));
        CHECK(((ahead.N - behind.N) / (2 * h) - here.by[ix(a)]).norm() < 1e-7);
        for (int b = 0; b < 2; ++b)
          CHECK(((ahead.by[ix(b)] - behind.by[ix(b)]) / (2 * h) - here.second(a, b)).norm() < 1e-7);
      }
  }

  TEST_CASE("normals are means where a surface turns by little and each facet's own at an edge") {
    for (double const degrees : {30.0, 60.0, 90.0}) {
      CAPTURE(degrees);
      double const angle = degrees * std::numbers::pi / 180;
      Matrix nodes;
      auto const surface = folded(angle, nodes);
      auto const normals = surface.fan_normals<2>(positions(nodes));
      bool const edge = degrees > 40;
      for (int f = 0; f < 2; ++f) {
        double const turned = edge ? f * angle : angle / 2; // from (0, -1)
        Vec2 const n = normals.unit[ix(surface.facet(f).fan[f == 0 ? 1 : 0])];
        CHECK((n - Vec2(std::sin(turned), -std::cos(turned))).norm() < 1e-12);
      }
      CHECK(normals.unit.size() == (edge ? 4 : 3));
    }
  }

  TEST_CASE("of facets one behind the other the nearest is faced, above or below") {
    for (double const first : {-0.1, 0.1})
      for (double const second : {-0.3, 0.3}) {
        CAPTURE(first);
        CAPTURE(second);
        Matrix nodes(6, 2);
        nodes << 0, 0, 1, 0, 1.2, first, -0.2, first, 1.2, second, -0.2, second;
        CellSurface const secondary({{{0, 1}}}, nodes, Vec3::UnitX()),
            primary({{{4, 5}}, {{2, 3}}}, nodes, Vec3::UnitX());
        auto const x = positions(nodes);
        auto const normals = secondary.fan_normals<2>(x);
        auto const opposite = primary.fan_normals<2>(x);
        auto const points = cut_facet<2>({secondary, primary, x, normals, opposite}, 0, {0, 1}, {-1, 1});
        double whole = 0;
        for (auto const& point : points) {
          CHECK(point.primary == (point.weight > 0 ? 1 : 0)); // what is hidden has no weight
          whole += point.weight;
        }
        CHECK(whole == doctest::Approx(2));
      }
  }
}
