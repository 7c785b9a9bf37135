// The search for feet: equal to a scan, near-linear in facets, blind beyond its reach; self-contact.
#include <doctest/doctest.h>

#include "contact/outlines.hpp"
#include "contact/surface/search.hpp"
#include "contact/surfaces.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// A U of arms 0.2 thick and 2 high, 0.6 apart; its arms bent by `angle` towards each other.
std::vector<double> bent(std::vector<double> x, double angle) {
  for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
    double const side = x[i] > 0.5 ? 1 : -1, height = std::max(0.0, x[i + 1] - 0.2);
    x[i] -= side * height * std::sin(angle);
    x[i + 1] -= height * (1 - std::cos(angle));
  }
  return x;
}
Arc letter_u(double size) {
  return outline({{0, 0}, {1, 0}, {1, 2.2}, {0.8, 2.2}, {0.8, 0.2}, {0.2, 0.2}, {0.2, 2.2}, {0, 2.2}}, size);
}

template<int D>
long visits_per_query(Search<D> const& search, std::vector<Vec<D>> const& points,
                      std::vector<double> const& x) {
  long visits = 0;
  for (auto const& point : points)
    CHECK(search.nearest(point, x, -1, &visits).found());
  return visits / static_cast<long>(points.size());
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("the grid visits every box within the radius once and no other") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Grid<3> grid;
    for (int const count : {500, 0, 60, 900}) { // also when built anew
      std::vector<Box<3>> boxes;
      for (int i = 0; i < count; ++i) {
        Vec3 const low(uniform(random), uniform(random), uniform(random));
        double const size = i % 50 == 0 ? 0.8 : 0.05;
        boxes.push_back({low, low + size * Vec3::Constant(1 + uniform(random)).cwiseAbs()});
      }
      grid.build(boxes);
      for (double const radius : {0.0, 0.1, 0.5, 10.0})
        for (int q = 0; q < 20; ++q) {
          Vec3 const point(uniform(random), uniform(random), uniform(random));
          std::vector<int> seen(boxes.size());
          grid.near(point, radius, [&](int i) { ++seen[ix(i)]; });
          for (std::size_t i = 0; i < boxes.size(); ++i)
            CHECK(seen[i] == (boxes[i].within(point, radius) ? 1 : 0));
        }
    }
  }

  TEST_CASE("the search starts where a scan starts, on surfaces and curves") {
    for (bool const triangles : {false, true})
      for (auto const& shell : {waves(12, triangles), ball(9, triangles), cube(5, triangles)}) {
        auto const surface = shell.surface();
        Search<3> search(surface, 0.1);
        auto const x = shell.with(Vec3::Zero());
        search.update(x);
        int near = 0;
        for (auto const& point : points_in({-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}, 700)) {
          Foot const scan = surface.nearest_start(point, x), found = search.nearest(point, x);
          bool const reached = (surface.position(scan, x) - point).norm() <= search.radius();
          near += reached ? 1 : 0;
          REQUIRE(found.found() == reached);
          if (reached)
            CHECK((surface.position(found, x) - surface.position(scan, x)).norm() < 1e-12);
        }
        CHECK(near > 40);
      }
    auto const arc = Arc(60, 0, 2.5);
    auto const curve = arc.curve();
    Search<2> search(curve, 0.1);
    auto const x = shaken(flat(arc.nodes), 0.01);
    search.update(x);
    int near = 0;
    for (auto const& at : points_in({-1.2, -1.2, 0}, {1.2, 1.2, 0}, 400)) {
      Vec2 const point = at.head<2>();
      double distance2 = 0;
      Foot const scan = curve.nearest_start(point, x), found = search.nearest(point, x);
      static_cast<void>(curve.sample(scan.segment, point, x, distance2));
      bool const reached = std::sqrt(distance2) <= search.radius();
      near += reached ? 1 : 0;
      REQUIRE(found.found() == reached);
      if (reached) {
        CHECK(found.segment == scan.segment);
        CHECK(found.xi == scan.xi);
        CHECK(curve.project(point, {}, x, &search).found() == curve.project(point, {}, x).found());
      }
    }
    CHECK(near > 40);
  }

  TEST_CASE("kinematics by the search are those by a scan, and out of reach there is nothing") {
    auto const shell = ball(10, true);
    auto const surface = shell.surface();
    Search<3> search(surface, 0.2);
    search.update(shell.with(Vec3::Zero()));
    for (auto const& at : points_in({-1, -1, -1}, {1, 1, 1}, 100)) {
      for (double const radius : {0.9, 1.0, 1.15}) {
        auto const x = shell.with(radius * at.normalized());
        auto const one = kinematics(surface, shell.free_node(), {}, {}, x);
        auto const two = kinematics(search, shell.free_node(), {}, {}, x);
        REQUIRE(two.found);
        CHECK(std::abs(two.gap - one.gap) < 1e-12);
        CHECK((two.normal() - one.normal()).norm() < 1e-9);
      }
      auto const far = shell.with((1.1 + 1.5 * search.radius()) * at.normalized());
      CHECK_FALSE(kinematics(search, shell.free_node(), {}, {}, far).found);
      Foot const old = surface.project(at.normalized(), {}, far); // a foot from before is given up too
      CHECK_FALSE(kinematics(search, shell.free_node(), {}, old, far).found);
    }
  }

  TEST_CASE("where facets are equally near the search takes the one that a scan takes") {
    for (bool const triangles : {false, true}) {
      auto const shell = sheet(4, triangles);
      auto const surface = shell.surface();
      Search<3> search(surface, 0.5);
      auto const x = shell.with(Vec3::Zero());
      search.update(x);
      for (auto const& node : shell.nodes) {
        Vec3 const above = node + 0.125 * Vec3::UnitZ();
        CHECK(search.nearest(above, x).segment == surface.nearest_start(above, x).segment);
      }
    }
  }

  TEST_CASE("a segment much longer than the others is seen from all that is within reach of it") {
    int const shorts = 100;
    Arc line(shorts + 2, 0, 1);
    for (int i = 0; i <= shorts; ++i)
      line.nodes.row(i) << -0.1 * i, 0;
    line.nodes.row(shorts + 1) << -0.1 * shorts - 10, 0;
    auto const curve = line.curve(Smoothing::polyline);
    Search<2> search(curve, 1);
    for (double const x : {-0.5, -5.0, -10.5, -15.0, -17.0, -19.5}) {
      CAPTURE(x);
      auto const all = line.with({x, 0.99});
      search.update(all);
      auto const seen = kinematics(search, line.free_node(), {}, {}, all);
      REQUIRE(seen.found);
      CHECK(seen.gap == doctest::Approx(0.99));
    }
  }

  TEST_CASE("a query looks at as many facets on a large surface as on a small one") {
    std::vector<long> visits;
    for (int const n : {22, 71, 224}) { // about 1e3 and 1e4 and 1e5 triangles
      auto const shell = waves(n, true);
      auto const surface = shell.surface();
      Search<3> search(surface, 0.5 * surface.facet_size());
      auto const x = shell.with(Vec3::Zero());
      search.update(x);
      auto points = points_in({0.1, 0.1, 0}, {0.9, 0.9, 0}, 500);
      for (auto& point : points) // close to the surface
        point.z() = 0.05 * std::sin(5 * point.x()) * std::cos(4 * point.y()) + 0.3 / n;
      visits.push_back(visits_per_query<3>(search, points, x));
    }
    for (int const count : {1000, 10000, 100000}) {
      auto const arc = circle(count);
      auto const curve = arc.curve();
      Search<2> search(curve, 0);
      auto const x = flat(arc.nodes);
      search.update(x);
      std::vector<Vec2> points;
      for (int i = 0; i < 500; ++i)
        points.emplace_back((1 + 3.0 / count) * Vec2(std::cos(i), std::sin(i)));
      visits.push_back(visits_per_query<2>(search, points, x));
    }
    for (std::size_t i = 0; i < visits.size(); ++i) {
      CAPTURE(i);
      CHECK(visits[i] > 0);
      CHECK(visits[i] < 60);
      CHECK(visits[i] <= visits[i - i % 3] + 5);
    }
  }

  TEST_CASE("a U touches itself where its arms close and nowhere before") {
    auto const arc = letter_u(0.05);
    auto const curve = arc.curve();
    auto const rest = flat(arc.nodes);
    Search<2> search(curve, 0.05);
    search.allow_self(rest);
    auto const least = [&](double angle, int& found) {
      auto const x = bent(rest, angle);
      search.update(x);
      double gap = 1;
      for (Index const node : arc.chain.nodes) {
        auto const k = kinematics(search, node, {}, {}, x);
        if (!k.found)
          continue;
        ++found;
        gap = std::min(gap, k.gap);
        Vec2 const foot = curve.evaluate(k.foot, x).by_xi[0];
        CHECK((x[2 * ix(node)] - 0.5) * (foot.x() - 0.5) < 0); // on the other arm
        for (int i = 1; i < k.count; ++i)
          CHECK(k.nodes[ix(i)] != node);
      }
      return gap;
    };
    int apart = 0, close = 0, through = 0;
    CHECK(least(0.0, apart) == 1);
    CHECK(apart == 0);
    double const tip = 0.3 / 2; // each arm's tip is 2 m above where it bends, half of the 0.6 apart to go
    CHECK(least(std::asin(tip) - 0.01, close) == doctest::Approx(0.04).epsilon(0.3));
    CHECK(close > 4);
    CHECK(least(std::asin(tip) + 0.005, through) == doctest::Approx(-0.02).epsilon(0.3));
    CHECK(through >= close);
  }

  TEST_CASE("a straight bar and a ring find nothing of themselves, however thin") {
    for (double const thickness : {0.01, 0.05, 0.1, 0.3}) {
      auto const bar = outline({{0, 0}, {2, 0}, {2, thickness}, {0, thickness}}, 0.05);
      auto const curve = bar.curve();
      for (auto const& x : {flat(bar.nodes), shaken(flat(bar.nodes), 0.1 * std::min(thickness, 0.05))}) {
        Search<2> search(curve, 0.5);
        search.allow_self(flat(bar.nodes));
        search.update(x);
        for (Index const node : bar.chain.nodes)
          CHECK_FALSE(kinematics(search, node, {}, {}, x).found);
      }
    }
    auto const ring = circle(80);
    auto const curve = ring.curve();
    Search<2> search(curve, 0.5);
    search.allow_self(flat(ring.nodes));
    search.update(flat(ring.nodes));
    for (Index const node : ring.chain.nodes)
      CHECK_FALSE(kinematics(search, node, {}, {}, flat(ring.nodes)).found);
  }

  TEST_CASE("a foot on the other arm is kept while it is allowed, and given up for none when it is not") {
    auto const arc = letter_u(0.05);
    auto const curve = arc.curve();
    auto const rest = flat(arc.nodes), x = bent(rest, std::asin(0.15) - 0.005);
    Search<2> search(curve, 0.05);
    search.allow_self(rest);
    search.update(x);
    int kept = 0;
    for (Index const node : arc.chain.nodes) {
      auto const k = kinematics(search, node, {}, {}, x);
      if (!k.found)
        continue;
      ++kept;
      auto const again = kinematics(search, node, k.foot, k.foot, x);
      CHECK(again.foot.segment == k.foot.segment);
      CHECK(std::abs(again.slip[0]) < 1e-12);
      auto const misled =
          kinematics(search, node, {}, {(k.foot.segment + curve.size() / 2) % curve.size(), 0.5}, x);
      CHECK(misled.gap == doctest::Approx(k.gap));
    }
    CHECK(kept > 4);
  }
}
