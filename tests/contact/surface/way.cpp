// The way over a chord: arcs round circles and balls, and its derivatives.
#include <Eigen/Geometry>
#include <numbers>

#include "contact/surface/way.hpp"
#include "differences.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// Component of a way along its tangent, of (chord, from, to, tangent) with normals of any length.
template<int D> Way<D> way_of(Vector const& y, ChordEnds ends) {
  return {y.head<D>(), y.segment<D>(D).normalized(), y.segment<D>(2 * D).normalized(), ends};
}

template<int D> void check_derivatives(std::vector<Vector> const& inputs) {
  for (auto const ends : {ChordEnds::over_surface, ChordEnds::on_facets})
    for (auto const& y : inputs) {
      auto const along = [&](Vector const& at) {
        return Vector(Vector::Constant(1, way_of<D>(at, ends).along(at.tail<D>())));
      };
      auto const by = way_of<D>(y, ends).by(y.tail<D>());
      Vec<D> const from = y.segment<D>(D), to = y.segment<D>(2 * D);
      Vector exact(4 * D);
      exact << by.chord, by.from - from * from.dot(by.from), by.to - to * to.dot(by.to), by.tangent;
      check_rate(rate(along, Dense(exact.transpose()), y, 1e-3, 1), "way");
    }
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("the way over a chord of a circle, and of a ball, is the arc") {
    for (auto const ends : {ChordEnds::over_surface, ChordEnds::on_facets})
      for (double const angle : {1e-5, 0.019, 0.021, 0.7, 2.0}) {
        Vec2 const from(0, 1), to(std::sin(angle), std::cos(angle)), tangent(to.y(), -to.x());
        CHECK(Way<2>(3 * (to - from), from, to, ends).along(tangent) ==
              doctest::Approx(3 * angle).epsilon(1e-13));
        CHECK(Way<2>(-3 * (to - from), -from, -to, ends).along(tangent) ==
              doctest::Approx(-3 * angle).epsilon(1e-13)); // from inside
        Vec3 const axis = Vec3(0.2, -0.5, 0.7).normalized(), a = axis.unitOrthogonal(),
                   b = Eigen::AngleAxisd(angle, axis) * a, t = axis.cross(b);
        CHECK(Way<3>(2 * (b - a), a, b, ends).along(t) == doctest::Approx(2 * angle).epsilon(1e-13));
        CHECK(std::abs(Way<3>(2 * (b - a), a, b, ends).along(axis)) < 1e-14);
      }
  }

  TEST_CASE(
      "on facets a way without a turn is the chord, however it leans, and over a surface its part across") {
    Vec3 const n = Vec3(0.1, 0.2, 1).normalized(), chord(0.4, -0.3, 0.05), tangent(1, 0, 0);
    CHECK(Way<3>(chord, n, n, ChordEnds::on_facets).along(tangent) == doctest::Approx(0.4).epsilon(1e-14));
    double const across = (chord - n * n.dot(chord)).dot(tangent);
    CHECK(std::abs(across - 0.4) > 1e-4);
    CHECK(Way<3>(chord, n, n, ChordEnds::over_surface).along(tangent) ==
          doctest::Approx(across).epsilon(1e-14));
  }

  TEST_CASE("derivatives of a way by its chord, its normals and its tangent") {
    std::vector<Vector> plane, space;
    for (double const turn : {1e-6, 0.004, 0.1, 0.9, 2.0}) {
      Vector y(8), z(12);
      y << 0.4, -0.3, std::sin(0.2), std::cos(0.2), std::sin(0.2 + turn), std::cos(0.2 + turn), 0.9, 0.5;
      Vec3 const a = Vec3(0.3, -0.2, 1).normalized(),
                 b = Eigen::AngleAxisd(turn, a.cross(Vec3(1, 0.4, 0)).normalized()) * a;
      z << 0.4, -0.3, 0.2, a, b, 0.6, 0.7, -0.4;
      plane.push_back(y);
      space.push_back(z);
    }
    check_derivatives<2>(plane);
    check_derivatives<3>(space);
  }

  TEST_CASE("between opposite normals a way is the chord") {
    Way<2> const back({1, 0.5}, {0, 1}, {0, -1}, ChordEnds::over_surface);
    CHECK(back.along({1, 0}) == 1);
    CHECK(back.by({1, 0}).chord == Vec2(1, 0));
    CHECK(back.by({1, 0}).to == Vec2(0, 0));
  }
}
