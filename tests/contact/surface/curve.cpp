// The primary curve: chains, smoothness across nodes, accuracy on a circle, projection and path length.
#include <algorithm>
#include <doctest/doctest.h>
#include <string>

#include "contact/helpers.hpp"
#include "core/error.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

constexpr double pi = std::numbers::pi;

Vec2 direction(Curve const& curve, Foot foot, std::vector<double> const& x) {
  return curve.evaluate(foot, x).by_xi[1].normalized();
}

/// Largest errors of distance from the circle, normal angle and curvature over the inner segments.
std::array<double, 3> circle_errors(int count) {
  auto const arc = circle(count);
  auto const curve = arc.curve();
  auto const x = flat(arc.nodes);
  std::array<double, 3> errors{};
  for (int s = 0; s < count; ++s)
    for (double const xi : {0.0, 0.15, 0.35, 0.5, 0.8}) {
      auto const [c, a, aa, aaa] = curve.evaluate({s, xi}, x).by_xi;
      double const bend = (a.x() * aa.y() - a.y() * aa.x()) / std::pow(a.norm(), 3);
      errors[0] = std::max(errors[0], std::abs(c.norm() - 1));
      errors[1] = std::max(errors[1], std::abs(a.normalized().dot(c.normalized())));
      errors[2] = std::max(errors[2], std::abs(bend - 1));
    }
  return errors;
}

/// A unit square, walked with the inside to the left, `per_side` facets a side; one free node behind.
Arc square(int per_side) {
  Arc arc(4 * per_side, 0, 1);
  Vec2 const corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (int i = 0; i < 4 * per_side; ++i) {
    double const part = static_cast<double>(i % per_side) / per_side;
    Vec2 const from = corners[i / per_side], to = corners[(i / per_side + 1) % 4];
    arc.nodes.row(i).head<2>() = ((1 - part) * from + part * to).transpose();
  }
  arc.chain.closed = true;
  return arc;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("facets are ordered into chains, mid nodes between their ends, loops closed") {
    mesh::Set open{{}, {{{4, 7}}, {{2, 4}}, {{9, 2}}}};
    auto const line = chains_of(open, "s");
    REQUIRE(line.size() == 1);
    CHECK(line[0].nodes == Indices{9, 2, 4, 7});
    CHECK_FALSE(line[0].closed);
    auto const quadratic = chains_of({{}, {{{3, 5, 4}}, {{1, 3, 2}}}}, "s");
    REQUIRE(quadratic.size() == 1);
    CHECK(quadratic[0].nodes == Indices{1, 2, 3, 4, 5});
    auto const several = chains_of({{}, {{{0, 1}}, {{5, 6}}, {{6, 7}}, {{7, 5}}}}, "s");
    REQUIRE(several.size() == 2);
    CHECK_FALSE(several[0].closed);
    CHECK(several[1].closed);
    CHECK(several[1].nodes.size() == 3);
  }

  TEST_CASE("sets of nodes and branching surfaces are refused by name") {
    CHECK_THROWS_WITH_AS(static_cast<void>(chains_of({{1, 2}, {}}, "plate.low")),
                         doctest::Contains("\"plate.low\" has no facets"), core::InputError);
    CHECK_THROWS_WITH_AS(static_cast<void>(chains_of({{}, {{{1, 2}}, {{1, 3}}}}, "fork")),
                         doctest::Contains("two facets leave node 1"), core::InputError);
  }

  TEST_CASE("the curve passes through its nodes and turns smoothly there, wherever they have moved") {
    for (auto const& arc : {Arc(9, 0.1, 2.8), Arc(3, 0.1, 1.2), Arc(4, 0.3, 1.5), circle(10)}) {
      auto const curve = arc.curve();
      auto const& segments = curve.segments();
      for (auto const& x : {flat(arc.nodes), shaken(flat(arc.nodes), 0.05)})
        for (int s = 0; s < static_cast<int>(segments.size()); ++s) {
          Index const from = arc.chain.nodes[ix(s)];
          Index const to = arc.chain.nodes[ix(s + 1) % arc.chain.nodes.size()];
          CHECK((curve.evaluate({s, 0}, x).by_xi[0] - Vec2(x[ix(2 * from)], x[ix(2 * from + 1)])).norm() <
                1e-14);
          CHECK((curve.evaluate({s, 1}, x).by_xi[0] - Vec2(x[ix(2 * to)], x[ix(2 * to + 1)])).norm() < 1e-14);
          int const next = segments[ix(s)].next;
          if (next >= 0)
            CHECK((direction(curve, {s, 1}, x) - direction(curve, {next, 0}, x)).norm() < 1e-13);
        }
      CHECK((segments.back().next == 0) == arc.chain.closed);
      CHECK((segments.front().previous >= 0) == arc.chain.closed);
    }
  }

  TEST_CASE("shape functions sum to one and their derivatives to zero") {
    auto const arc = Arc(7, 0, 2);
    auto const curve = arc.curve();
    for (int s = 0; s < 6; ++s)
      for (double const xi : {0.0, 0.3, 1.0}) {
        auto const N = curve.shape({s, xi});
        CHECK(N[0].sum() == doctest::Approx(1));
        for (std::size_t d = 1; d < 4; ++d)
          CHECK(std::abs(N[d].sum()) < 1e-12);
      }
  }

  TEST_CASE("on a circle the distance converges at order 4, the normal at 3, the curvature at 2") {
    auto const coarse = circle_errors(24), fine = circle_errors(48);
    std::array<double, 3> const least{3.7, 2.7, 1.7};
    for (std::size_t k = 0; k < 3; ++k) {
      CAPTURE(k);
      CHECK(std::log2(coarse[k] / fine[k]) > least[k]);
    }
    CHECK(fine[0] < 1e-5);
  }

  TEST_CASE("a polyline runs straight between its nodes, corners break a spline") {
    auto const arc = Arc(5, 0, 2);
    auto const line = arc.curve(Smoothing::polyline);
    auto const x = flat(arc.nodes);
    Vec2 const middle = 0.5 * (arc.nodes.row(1) + arc.nodes.row(2)).transpose();
    CHECK((line.evaluate({1, 0.5}, x).by_xi[0] - middle).norm() < 1e-15);
    CHECK(line.evaluate({1, 0.5}, x).by_xi[2].norm() == 0);

    auto const box = square(4);
    auto const curve = box.curve();
    CHECK(curve.segments().size() == 16);
    CHECK(curve.segment_length() == doctest::Approx(0.25));
    auto const at = flat(box.nodes);
    for (int s = 0; s < 16; ++s) // the sides stay straight up to their corners
      CHECK((direction(curve, {s, 0.0}, at) - direction(curve, {s, 1.0}, at)).norm() < 1e-12);
  }

  TEST_CASE("the foot is stationary and the same from any guess") {
    auto const arc = Arc(12, 0, pi);
    auto const curve = arc.curve();
    auto const x = shaken(flat(arc.nodes), 0.01);
    for (double const angle : {0.05, 0.4, 1.3, pi / 2, 2.9})
      for (double const radius : {0.9, 1.0, 1.1, 1.5}) {
        Vec2 const point = radius * Vec2(std::cos(angle), std::sin(angle));
        Foot const foot = curve.project(point, {}, x);
        REQUIRE(foot.found());
        auto const here = curve.evaluate(foot, x);
        CHECK(std::abs((point - here.by_xi[0]).dot(here.by_xi[1].normalized())) < 1e-11);
        for (int s = 0; s < 11; ++s) {
          Foot const again = curve.project(point, {s, 0.5}, x);
          REQUIRE(again.found());
          CHECK((curve.evaluate(again, x).by_xi[0] - here.by_xi[0]).norm() < 1e-10);
        }
      }
  }

  TEST_CASE("a point at a node finds it, and one beyond an end finds nothing") {
    auto const arc = Arc(8, 0, pi);
    auto const curve = arc.curve();
    auto const x = flat(arc.nodes);
    for (int i = 1; i < 7; ++i)
      for (double const radius : {1.0, 1.2}) {
        Vec2 const node = arc.nodes.row(i);
        Foot const foot = curve.project(radius * node, {}, x);
        REQUIRE(foot.found());
        CHECK((curve.evaluate(foot, x).by_xi[0] - node).norm() < 1e-9);
      }
    for (auto const& beyond : {Vec2(1.0, -0.3), Vec2(-1.1, -0.2)}) {
      CHECK_FALSE(curve.project(beyond, {}, x).found());
      CHECK_FALSE(curve.project(beyond, {3, 0.5}, x).found());
    }
  }

  TEST_CASE("outside a corner the vertex is the foot, beside it the side") {
    auto const box = square(4);
    auto const curve = box.curve();
    auto const x = flat(box.nodes);
    for (auto const& point : {Vec2(1.2, -0.1), Vec2(1.05, 1.2), Vec2(-0.1, -0.1)}) {
      Foot const foot = curve.project(point, {}, x);
      REQUIRE(foot.found());
      Vec2 const vertex(point.x() > 0.5 ? 1 : 0, point.y() > 0.5 ? 1 : 0);
      CHECK((curve.evaluate(foot, x).by_xi[0] - vertex).norm() < 1e-12);
    }
    Foot const side = curve.project({0.9, -0.2}, {}, x);
    CHECK((curve.evaluate(side, x).by_xi[0] - Vec2(0.9, 0)).norm() < 1e-12);
  }

  TEST_CASE("beyond a corner a point is as far off as the side it is further out of, from any guess") {
    auto const box = square(4);
    auto const curve = box.curve();
    auto const x = flat(box.nodes);
    for (auto const& point : {Vec2(1.001, -0.5), Vec2(1.5, -0.001), Vec2(1.2, -0.19)})
      for (int guess = 0; guess < curve.size(); ++guess) {
        CAPTURE(guess);
        Foot const foot = curve.project(point, {guess, 0.5}, x);
        REQUIRE(foot.found());
        auto const at = curve.evaluate(foot, x).by_xi;
        Vec2 const outward = Vec2(at[1].y(), -at[1].x()).normalized();
        CHECK(outward.dot(point - at[0]) == doctest::Approx(std::max(point.x() - 1, -point.y())));
      }
  }

  TEST_CASE("path length: additive across segments, signed, an arc's length at order 4") {
    auto const error = [](int count) {
      auto const arc = Arc(count, 0, pi);
      auto const curve = arc.curve();
      auto const x = flat(arc.nodes);
      Foot const from = curve.project({std::cos(0.8), std::sin(0.8)}, {}, x);
      Foot const to = curve.project({std::cos(2.3), std::sin(2.3)}, {}, x);
      return std::abs(curve.path_length(from, to, x) - 1.5);
    };
    CHECK(error(40) < 1e-6);
    CHECK(error(20) / error(40) > 8);

    auto const arc = Arc(10, 0, pi);
    auto const curve = arc.curve();
    auto const x = shaken(flat(arc.nodes), 0.02);
    Foot const a{1, 0.3}, b{4, 0.9}, c{7, 0.2}, d{7, 0.8};
    double const ac = curve.path_length(a, c, x);
    CHECK(ac > 0);
    CHECK(curve.path_length(a, b, x) + curve.path_length(b, c, x) == doctest::Approx(ac).epsilon(1e-6));
    CHECK(curve.path_length(c, a, x) == doctest::Approx(-ac).epsilon(1e-12));
    CHECK(curve.path_length(c, d, x) == doctest::Approx(-curve.path_length(d, c, x)).epsilon(1e-14));
    CHECK(curve.path_length(a, a, x) == 0);
    CHECK(curve.path_length({3, 1}, {4, 0}, x) == doctest::Approx(0)); // one point, two names
  }

  TEST_CASE("on a closed curve the path takes the shorter way") {
    auto const arc = circle(40);
    auto const curve = arc.curve();
    auto const x = flat(arc.nodes);
    double const step = 2 * pi / 40;
    CHECK(curve.path_length({38, 0.5}, {2, 0.5}, x) == doctest::Approx(4 * step).epsilon(1e-5));
    CHECK(curve.path_length({2, 0.5}, {38, 0.5}, x) == doctest::Approx(-4 * step).epsilon(1e-5));
  }
}
