// Points that go through rigid obstacles within a step, beside them, round them, and out of them.
#include <numbers>

#include "contact/obstacles.hpp"
#include "contact/tunnelling/obstacle_tunnelling.hpp"

using namespace stiction;
using namespace stiction::contact;

namespace {

constexpr double reach = 0.05;

/// A point that goes from a to b; the obstacle shifts and turns (about the z axis) meanwhile.
template<int D> struct Trip {
  Vec<D> a, b, shift = Vec<D>::Zero();
  double turn = 0;
  bool held = false;
};

template<int D> bool through(Obstacle const& shape, Trip<D> const& trip) {
  Pose<D> first, last;
  last.position = trip.shift;
  last.rotation =
      Eigen::AngleAxisd(trip.turn, Vec3::UnitZ()).toRotationMatrix().template topLeftCorner<D, D>();
  return passes<D>(shape, {trip.a, trip.b, first, last}, {reach, trip.held, {}, {}});
}

std::vector<Obstacle> discs() {
  return {RigidCircle{{}, 1, Side::outside}, RigidSphere{{}, 1, Side::outside},
          RigidTorus{{-3, 0}, {}, 3, 1, Side::outside},
          test::polyline(test::ellipse(24, 1, 1), true, Smoothing::spline),
          test::polyline(test::ellipse(24, 1, 1), true, Smoothing::polyline)};
}

std::vector<Obstacle> lumps() {
  std::vector<Obstacle> all{RigidSphere{{}, 1, Side::outside}, RigidCylinder{{}, {0, 0, 1}, 1, Side::outside},
                            RigidTorus{{-3, 0, 0}, {}, 3, 1, Side::outside}};
  for (auto const kind : {mesh::CellKind::tri3, mesh::CellKind::quad4})
    all.emplace_back(test::cube(1, kind));
  return all;
}

Vec2 on_circle(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("a point that goes straight through a disc from outside has passed it") {
    for (auto const& disc : discs()) {
      INFO("shape " << disc.index());
      for (double const far : {1.2, 4.0, 300.0}) {
        CHECK(through<2>(disc, {{-2, 0.1}, {far, 0.3}}));
        CHECK(through<2>(disc, {{-1, 0}, {far, 0.1}})); // it was on it
      }
      CHECK(through<2>(disc, {.a = {-1, 0}, .b = {1, 0}, .held = true})); // to the other side of it
      CHECK_FALSE(through<2>(disc, {{-2, 1.1}, {3, 1.2}}));
      CHECK_FALSE(through<2>(disc, {{-2, 0}, {-1.1, 0}}));
      CHECK_FALSE(through<2>(disc, {{-1, 0}, {-40, 0}}));
      CHECK_FALSE(through<2>(disc, {{0.3, 0}, {3, 0}})); // it was inside
    }
  }
  TEST_CASE("a point that goes straight through a lump from outside has passed it") {
    for (auto const& lump : lumps()) {
      INFO("shape " << lump.index());
      for (double const far : {1.2, 4.0, 300.0})
        CHECK(through<3>(lump, {{-2, 0.1, 0.2}, {far, 0.3, -0.1}}));
      CHECK(through<3>(lump, {.a = {-1, 0, 0}, .b = {1, 0, 0}, .held = true}));
      CHECK_FALSE(through<3>(lump, {{-2, 1.1, 1.1}, {3, 1.2, 1.2}}));
      CHECK_FALSE(through<3>(lump, {{-2, 0, 0}, {-1.1, 0, 0}}));
      CHECK_FALSE(through<3>(lump, {{-1, 0, 0}, {-3, 0, 0}}));
      CHECK_FALSE(through<3>(lump, {{0.3, 0, 0}, {3, 0, 0}}));
    }
  }
  TEST_CASE("a point may slide round a part of a shape, and round a corner") {
    for (auto const& disc : discs())
      for (double const angle : {0.05, 0.4, 1.0, 1.5})
        CHECK_FALSE(through<2>(disc, {.a = on_circle(0.2), .b = on_circle(0.2 + angle), .held = true}));
    Obstacle const square = test::polyline({-1, -1, 1, -1, 1, 1, -1, 1}, true, Smoothing::polyline);
    CHECK_FALSE(through<2>(square, {.a = {0.5, 1}, .b = {1, 0.4}, .held = true}));
    CHECK_FALSE(through<3>(test::cube(1, mesh::CellKind::tri3),
                           {.a = {0.5, 1, 0}, .b = {1, 0.4, 0.1}, .held = true}));
    CHECK_FALSE(through<2>(square, {.a = {0.999, 1.001}, .b = {1.001, 0.99}}));
  }
  TEST_CASE("what counts is how point and obstacle move to each other") {
    for (auto const& disc : discs()) {
      INFO("shape " << disc.index());
      CHECK(through<2>(disc, {.a = {-2, 0}, .b = {-2, 0}, .shift = {-5, 0}}));
      CHECK_FALSE(through<2>(disc, {.a = {-2, 0}, .b = {3, 0}, .shift = {5, 0}}));
      CHECK_FALSE(through<2>(disc, {.a = {-2, 0}, .b = {2, 0}, .shift = {0, 30}}));
      CHECK_FALSE(through<2>(disc, {.a = {-1, 0}, .b = {-1, 0}, .turn = 3})); // it turns under the point
    }
    Obstacle const blade =
        test::polyline({-1, -0.01, 1, -0.01, 1, 0.01, -1, 0.01}, true, Smoothing::polyline);
    CHECK(through<2>(blade, {.a = {0.6, 0.3}, .b = {0.6, 0.3}, .turn = 1})); // it sweeps past the point
    CHECK_FALSE(through<2>(blade, {.a = {1.1, 0.3}, .b = {1.1, 0.3}, .turn = 1}));
    CHECK_FALSE(through<2>(blade, {.a = {0.6, 0.3}, .b = {0.6, 0.3}, .turn = -1}));
  }
  TEST_CASE("what has no other side is passed by what ends in it out of contact") {
    for (bool const held : {false, true}) {
      CHECK(through<2>(RigidPlane{}, {.a = {0, 2}, .b = {50, -3}, .held = held}) == !held);
      CHECK(through<3>(RigidPlane{}, {.a = {0, 0, 2}, .b = {0, 1, -3}, .held = held}) == !held);
      CHECK(through<2>(RigidCircle{{}, 1, Side::inside}, {.a = {0.1, 0}, .b = {9, 0}, .held = held}) ==
            !held);
      CHECK(through<3>(RigidCylinder{{}, {}, 1, Side::inside},
                       {.a = {0.1, 0, 0}, .b = {9, 0, 0}, .held = held}) == !held);
    }
    CHECK_FALSE(through<2>(RigidPlane{}, {{0, 2}, {0, -0.1}}));
    CHECK_FALSE(through<2>(RigidPlane{}, {{0, -2}, {0, -3}}));
    CHECK_FALSE(through<2>(RigidPlane{}, {{0, 2}, {9, 0.001}}));
  }
  TEST_CASE("an open profile and an open surface are passed between their ends") {
    Obstacle const shelf = test::polyline({1, 0, 0, 0, -1, 0}, false, Smoothing::polyline); // solid below
    CHECK(through<2>(shelf, {{0.2, 1}, {0.3, -2}}));
    CHECK(through<2>(shelf, {{0.2, 1}, {1.8, -2}}));     // and then beyond its end
    CHECK_FALSE(through<2>(shelf, {{2, 1}, {0.3, -2}})); // round its end
    CHECK_FALSE(through<2>(shelf, {{2, 1}, {2, -2}}));
    CHECK_FALSE(through<2>(shelf, {{0.3, -2}, {0.3, 1}})); // out of it
    Matrix nodes(4, 3);
    nodes << -1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0;
    Obstacle const sheet = test::surface_of(nodes, mesh::CellKind::quad4, {0, 1, 2, 3});
    CHECK(through<3>(sheet, {{0.2, 0.1, 1}, {0.3, 0.1, -2}}));
    CHECK_FALSE(through<3>(sheet, {{2, 0.1, 1}, {2, 0.1, -2}}));
    CHECK_FALSE(through<3>(sheet, {{0.3, 0.1, -2}, {0.3, 0.1, 1}}));
  }
  TEST_CASE("a wall much thinner than the way through it is not overlooked") {
    Obstacle const wall = test::polyline({-5, 0, 5, 0, 5, 0.03, -5, 0.03}, true, Smoothing::polyline);
    for (double const far : {0.2, 20.0, 2e4})
      CHECK(through<2>(wall, {{0.3, 1}, {0.9, -far}}));
    Obstacle const ring = RigidTorus{{}, {}, 2, 0.1, Side::outside};
    CHECK(through<3>(ring, {{2, 0, 1}, {2, 0, -9}}));
    CHECK_FALSE(through<3>(ring, {{0, 0, 1}, {0, 0, -9}})); // through its hole
  }
}
