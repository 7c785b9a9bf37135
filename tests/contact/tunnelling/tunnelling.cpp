// Nodes that go through a surface within a step, beside it, along it, and out of it.
#include <doctest/doctest.h>

#include "contact/surfaces.hpp"
#include "contact/tunnelling/tunnelling.hpp"

using namespace stiction;
using namespace stiction::contact;

namespace {

/// A panel at rest or moved, and a node that goes from one position to another. [D nodes]
template<int D> bool goes_through(Panel<D> const& panel, std::vector<double> from, std::vector<double> to) {
  std::vector<Panel<D>> const panels{panel};
  return SweptPanels<D>(panels, {from, to}).passed_by(D);
}

/// The segment (0, 0) to (2, 0), its body above; the node goes from a to b.
bool through_segment(Vec2 a, Vec2 b, Vec2 shift = Vec2::Zero()) {
  return goes_through<2>({0, 1}, {0, 0, 2, 0, a.x(), a.y()},
                         {shift.x(), shift.y(), 2 + shift.x(), shift.y(), b.x(), b.y()});
}

/// The triangle (0, 0), (1, 0), (0, 1) at z = 0, its body below.
bool through_triangle(Vec3 a, Vec3 b) {
  std::vector<double> from{0, 0, 0, 1, 0, 0, 0, 1, 0}, to = from;
  from.insert(from.end(), a.data(), a.data() + 3);
  to.insert(to.end(), b.data(), b.data() + 3);
  return goes_through<3>({0, 1, 2}, from, to);
}

} // namespace

TEST_SUITE("contact") {
  TEST_CASE("a node that goes straight through a segment from outside has passed it") {
    CHECK(through_segment({1, -3}, {1.5, 4}));
    CHECK(through_segment({1, 0}, {1, 0.5})); // it was on it
    CHECK_FALSE(through_segment({1, 3}, {1, -4}));
    CHECK_FALSE(through_segment({1, -3}, {1, -1}));
    CHECK_FALSE(through_segment({3, -1}, {3, 1}));
    CHECK_FALSE(through_segment({1, 0}, {1.5, 0}));
  }
  TEST_CASE("where a depth is asked for, the node must come to it before it leaves the panel sideways") {
    auto const deep = [](Vec2 to, double depth) {
      std::vector<Panel<2>> const panels{{0, 1}};
      std::vector<double> const from{0, 0, 2, 0, 1, -1}, there{0, 0, 2, 0, to.x(), to.y()};
      return SweptPanels<2>(panels, {from, there}).passed_by(2, depth);
    };
    CHECK(deep({1.5, 1}, 0.9));
    CHECK_FALSE(deep({1.5, 1}, 1.1));
    CHECK(deep({3, 2}, 0.4)); // over the segment's end it is 0.5 behind it
    CHECK_FALSE(deep({3, 2}, 0.6));
  }
  TEST_CASE("what counts is how node and segment move to each other") {
    CHECK(through_segment({1, -1}, {1, -1}, {0, -5}));
    CHECK_FALSE(through_segment({1, -1}, {1, 4}, {0, 5}));
    CHECK_FALSE(through_segment({1, -1}, {1, 1}, {30, 0})); // it is gone when the node gets there
    CHECK(through_segment({1, -1}, {31, 1}, {30, 0}));
  }
  TEST_CASE("a node that goes straight through a triangle from outside has passed it") {
    CHECK(through_triangle({0.2, 0.2, 5}, {0.3, 0.3, -1}));
    CHECK_FALSE(through_triangle({0.2, 0.2, -5}, {0.3, 0.3, 1}));
    CHECK_FALSE(through_triangle({0.9, 0.9, 5}, {0.9, 0.9, -1}));
    CHECK_FALSE(through_triangle({0.2, 0.2, 5}, {0.2, 0.2, 1e-3}));
  }
  TEST_CASE("a node does not pass panels of its own, and all lengths serve") {
    std::vector<Panel<2>> const panels{{0, 1}};
    std::vector<double> const rest{0, 0, 2, 0}, moved{0, 0, 2, 3};
    CHECK_FALSE(SweptPanels<2>(panels, {rest, moved}).passed_by(1));
    for (double const size : {1e-12, 1e12}) {
      std::vector<double> const from{0, 0, 2 * size, 0, size, -size}, to{0, 0, 2 * size, 0, size, size};
      CHECK(SweptPanels<2>(panels, {from, to}).passed_by(2));
    }
  }
  TEST_CASE("how many panels a node looks at does not grow with their number") {
    std::vector<long> visits;
    for (int const n : {22, 71, 224}) { // about 1e3, 1e4 and 1e5 triangles
      auto const shell = test::sheet(n, true);
      auto const surface = shell.surface();
      auto const panels = panels_of(surface);
      auto const from = shell.with({0.503, 0.497, 1.0 / n}), to = shell.with({0.503, 0.497, -1.0 / n});
      SweptPanels<3> const swept(panels, {from, to});
      long count = 0;
      CHECK(swept.passed_by(shell.free_node(), 0, &count));
      CHECK_FALSE(swept.passed_by(shell.free_node(), 2.0 / n));
      visits.push_back(count);
    }
    CHECK(visits[0] < 50);
    CHECK(visits[2] <= visits[0] + 10);
  }
}
