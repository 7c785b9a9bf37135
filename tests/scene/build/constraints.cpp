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

TEST_CASE("constraints that cannot be are refused with the place, the reason and the remedy") {
  CHECK(test::complaints(held(test::periodic("foot.left", "foot.right"))).empty());
  check(held(test::roller("foot.leff", {1, 1})), "did you mean \"foot.left\"");
  check(held(test::roller("foot.left", {0, 0})), "is no direction");
  check(held(test::roller("foot.left", {1, 0, 0})), "give 2 numbers");
  check(held(test::periodic("foot.left", "foot.all")), "give both sides the same division");
  check(held(test::periodic("foot.left", "foot.left")), "give both sides the same division");
  check(held(test::periodic("foot.left", "foot.bottom")), "has no node at");
  check(held(test::roller("foot.left", {1, 1})), "contact is at it");
  auto table = held(test::roller("foot.top", {1, 1}));
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 1}, {0, 0.1}, {0, 0.1}), test::fix("foot.left", true, false)});
  check(table, "as motions do not let it be");
  table = held(test::periodic("foot.left", "foot.right"));
  test::at(table, "scheme") = test::make("scheme.central_difference");
  check(table, "are explicit");
  test::at(table, "scheme") = test::make("scheme.newmark");
  check(table, "keep accelerations");
}
