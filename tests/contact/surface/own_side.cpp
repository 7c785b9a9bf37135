// Surfaces that touch themselves: what their nodes find, each couple once, and how much they look at.
#include <doctest/doctest.h>

#include "contact/outlines.hpp"
#include "contact/surface/search.hpp"
#include "contact/surfaces.hpp"
#include "solid/allocations.hpp"

using namespace stiction;
using namespace stiction::contact;
using namespace stiction::test;

namespace {

/// A sheet of length 2 and width 1 whose second half is folded over the first, `gap` above it; it was flat.
struct Folded {
  Shell flat;
  std::vector<double> rest, x;
  Folded(int n, bool triangles, double gap) : flat(sheet(n, triangles)) {
    flat.move([](Vec3 const& v) { return Vec3(2 * v.x(), v.y(), 0); });
    rest = flat.with(Vec3::Zero());
    Shell now = flat;
    now.move([&](Vec3 const& v) { return v.x() <= 1 ? v : Vec3(2 - v.x(), v.y(), gap); });
    x = now.with(Vec3::Zero());
  }
};

/// A U whose right leg comes nearer by so much, its bottom bulging and its inner corners opening downwards.
std::vector<double> pressed_together(std::vector<double> x, double way) {
  for (std::size_t i = 0; i + 1 < x.size(); i += 2) {
    double const X = x[i], Y = x[i + 1], side = X < 1.5 ? -1 : 1;
    double const bulge = Y == 0 ? std::sin(std::numbers::pi * X / 3) : std::sin(std::numbers::pi * (X - 1));
    bool const floor = Y == 1, corner = floor && (X == 1 || X == 2);
    x[i] -= way * std::clamp(X - 1, 0.0, 1.0) - (corner ? 0.2 * side : 0);
    x[i + 1] -= (Y <= 1 ? 0.1 * bulge : 0) + (floor ? 0.1 : 0);
  }
  return x;
}

template<int D, class Primary>
int found_of_itself(Primary const& primary, std::vector<double> const& rest, std::vector<double> const& x) {
  Search<D> search(primary, 0.5);
  search.allow_self(rest);
  search.update(x);
  int found = 0;
  for (Index node = 0; node < static_cast<Index>(x.size()) / D - 1; ++node) // the last is free
    found += kinematics(search, node, {}, {}, x).found ? 1 : 0;
  return found;
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("of two halves of a folded sheet one has the points and the other the facets") {
    for (bool const triangles : {false, true}) {
      int const n = 24;
      double const gap = 0.01;
      Folded const sheet(n, triangles, gap);
      auto const surface = sheet.flat.surface();
      Search<3> search(surface, 0.05);
      search.allow_self(sheet.rest);
      search.update(sheet.x);
      int found = 0;
      for (Index node = 0; node < sheet.flat.free_node(); ++node) {
        auto const k = kinematics(search, node, {}, {}, sheet.x);
        Vec3 const at = sheet.flat.nodes[ix(node)];
        if (!k.found)
          continue;
        ++found;
        CHECK(k.gap == doctest::Approx(gap).epsilon(1e-9));
        CHECK(at.x() > 1); // the half that comes later
        CHECK(surface.position(k.foot, sheet.rest).x() == doctest::Approx(2 - at.x()));
        for (int i = 1; i < k.count; ++i)
          CHECK(k.nodes[ix(i)] != node);
      }
      // all of a half but those at the fold, which face their own neighbours
      CHECK(found >= (n / 2 - 2) * (n + 1));
      CHECK(found <= (n / 2) * (n + 1));
    }
  }

  TEST_CASE("a sheet that is not folded, a ball and a plate find nothing of themselves") {
    auto const nothing = [](Shell const& shell) {
      auto const surface = shell.surface();
      Search<3> search(surface, 0.5);
      auto const x = shell.with(Vec3::Zero());
      search.allow_self(x);
      search.update(x);
      for (Index node = 0; node < shell.free_node(); ++node)
        CHECK_FALSE(kinematics(search, node, {}, {}, x).found);
    };
    for (bool const triangles : {false, true}) {
      nothing(waves(10, triangles));
      nothing(ball(6, triangles));
      for (double const thickness : {0.02, 0.2}) {
        auto plate = cube(6, triangles);
        nothing(plate.move([&](Vec3 const& v) { return Vec3(v.x(), v.y(), thickness * v.z()); }));
      }
    }
  }

  TEST_CASE("what is squeezed flat finds nothing of itself through its body") {
    auto const bar = outline({{0, 0}, {2, 0}, {2, 0.3}, {0, 0.3}}, 0.05);
    auto const curve = bar.curve();
    for (double const left : {0.9, 0.5, 0.3, 0.05}) {
      CAPTURE(left);
      auto flat_bar = flat(bar.nodes);
      for (std::size_t i = 1; i < flat_bar.size(); i += 2)
        flat_bar[i] *= left;
      CHECK(found_of_itself<2>(curve, flat(bar.nodes), flat_bar) == 0);
      for (bool const triangles : {false, true}) {
        auto plate = cube(8, triangles);
        plate.move([](Vec3 const& v) { return Vec3(v.x(), v.y(), 0.2 * v.z()); });
        auto const rest = plate.with(Vec3::Zero());
        auto const surface = plate.surface();
        plate.move([&](Vec3 const& v) { return Vec3(v.x(), v.y(), left * v.z()); });
        CHECK(found_of_itself<3>(surface, rest, plate.with(Vec3::Zero())) == 0);
      }
    }
  }

  TEST_CASE("the bottom of a U does not take the inner corner, along whose tangent it lies") {
    auto const u = outline({{0, 0}, {3, 0}, {3, 8.5}, {2, 8.5}, {2, 1}, {1, 1}, {1, 10}, {0, 10}}, 0.5);
    auto const curve = u.curve();
    auto const rest = flat(u.nodes);
    for (double const way : {0.0, 0.7, 0.8, 0.95}) {
      CAPTURE(way);
      auto const x = pressed_together(rest, way);
      Search<2> search(curve, 1);
      search.allow_self(rest);
      search.update(x);
      for (Index const node : u.chain.nodes)
        if (rest[2 * ix(node) + 1] < 0.5)
          CHECK_FALSE(kinematics(search, node, {}, {}, x).found);
    }
  }

  TEST_CASE("a folded sheet is looked at in n log n") {
    std::vector<long> visits;
    // where every access is watched it takes 20 times as long
    int const most = test::counts_allocations() ? 316 : 150;
    for (int const n : {32, 100, most}) { // about 1e3, 1e4 and 1e5 facets
      Folded const sheet(n, false, 0.3 / n);
      auto const surface = sheet.flat.surface();
      Search<3> search(surface, 1.0 / n);
      search.allow_self(sheet.rest);
      search.update(sheet.x);
      long count = 0;
      for (Index node = 0; node < sheet.flat.free_node(); ++node)
        static_cast<void>(
            search.nearest(Eigen::Map<Vec3 const>(&sheet.x[3 * ix(node)]), sheet.x, node, &count));
      visits.push_back(count / sheet.flat.free_node());
    }
    CHECK(visits[0] > 0);
    CHECK(visits[2] < 200);
    CHECK(visits[2] <= visits[1] + 10); // many nodes of the least sheet are near its border, and look at less
  }
}
