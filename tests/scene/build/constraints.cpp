// What constraints of a scene are refused, with the remedy.
#include <doctest/doctest.h>

#include "scene/complaints.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

test::Input held(test::Input constraint) {
  auto table = test::foot_on_floor();
  test::at(table, "motions") = test::list({test::fix("foot.top")});
  test::at(table, "constraints") = test::list({std::move(constraint)});
  return table;
}

void check(test::Input const& table, char const* said) {
  std::string all;
  for (auto const& one : test::complaints(table))
    all += one + '\n';
  INFO(all);
  CHECK(all.find(said) != std::string::npos);
}

} // namespace

TEST_CASE(
    "tied surfaces that do not lie on one another are refused with the place and how far they are off") {
  auto const stacked = [](double gap, double width, int cells) {
    auto table = test::two_blocks();
    test::remove(table, "pairs");
    test::at(table, "bodies.upper") =
        test::block({{0, gap}, {width, 1}, {1.0 * cells, 2}}, test::linear_elastic(1000, 0));
    test::at(table, "constraints") = test::list({test::tied("upper.bottom", "lower.top")});
    return table;
  };
  CHECK(test::complaints(stacked(0, 1, 3)).empty());
  CHECK(test::complaints(stacked(0.02, 1, 3)).empty());
  CHECK(test::complaints(stacked(0, 0.7, 3)).empty());
  check(stacked(0.04, 1, 3), "within 0.0333 m, a tenth of a facet; the nearest beyond that is 0.04 m off");
  check(stacked(0, 1.1, 3), "the facet of upper.bottom at (0.916667, 0) m faces lower.top over 72.7 %");
  auto table = stacked(0, 1, 1);
  test::at(table, "motions") =
      test::list({test::fix("lower.bottom"), test::fix("upper.left"), test::fix("upper.right", true, false)});
  check(table, "all nodes of the facet of upper.bottom at (0.5, 0) m are driven along x");
  table = stacked(0, 1, 3);
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "bodies.upper.velocity") = test::values({0, 2}, "m/s");
  check(table, "moves by 2 m/s along y against that");
  table = stacked(0, 1, 3);
  test::at(table, "obstacles.floor") = test::floor();
  test::at(table, "pairs.side") = test::pair("upper.left", "floor");
  check(table, "contact is at it");
}

TEST_CASE("constraints that cannot be are refused with the place, the reason and the remedy") {
  CHECK(test::complaints(held(test::periodic("foot.left", "foot.right"))).empty());
  check(held(test::roller("foot.leff", {1, 1})), "did you mean \"foot.left\"");
  check(held(test::roller("foot.left", {0, 0})), "is no direction");
  check(held(test::roller("foot.left", {1, 0, 0})), "give 2 numbers");
  check(held(test::periodic("foot.left", "foot.all")), "give both sides the same division");
  check(held(test::periodic("foot.left", "foot.left")), "is foot.left itself; name the opposite side");
  check(held(test::periodic("foot.left", "foot.bottom")), "has no node at");
  check(held(test::roller("foot.left", {1, 1})), "contact is at it");
  auto table = held(test::roller("foot.top", {1, 1}));
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 1}, {0, 0.1}, {0, 0.1}), test::fix("foot.left", true, false)});
  check(table, "as motions do not let it be");
  check(held(test::tied("foot.left", "foot.right")), "faces foot.right over 0 % of its area");
  check(held(test::tied("foot.left", "foot.left")), "faces foot.left over 0 % of its area");
  check(held(test::tied("foot.left", "floor")), "is an obstacle, not a set");
  check(held(test::tied("foot.left", "foot.all")), "has no facets");
  table = held(test::periodic("foot.left", "foot.right"));
  test::at(table, "scheme") = test::make("scheme.central_difference");
  check(table, "are explicit");
  test::at(table, "scheme") = test::make("scheme.newmark");
  check(table, "keep accelerations");
}
