// What constraints of a scene are refused, with the remedy.
#include <doctest/doctest.h>

#include "core/error.hpp"
#include "scene/scenes.hpp"

using namespace stiction;

namespace {

test::Input held(test::Input constraint) {
  auto table = test::foot_on_floor();
  test::at(table, "motions") = test::list({test::fix("foot.top")});
  test::at(table, "constraints") = test::list({std::move(constraint)});
  return table;
}

std::string refused(test::Input const& table) {
  try {
    static_cast<void>(scene::build(table));
  } catch (core::InputError const& error) {
    return error.what();
  }
  return "";
}

test::Input roller(std::string set, std::vector<double> const& normal) {
  return test::make("constraint.roller",
                    {{"set", test::text(std::move(set))}, {"normal", test::values(normal)}});
}
test::Input periodic(std::string set, std::string to) {
  return test::make("constraint.periodic",
                    {{"set", test::text(std::move(set))}, {"to", test::text(std::move(to))}});
}

void check(test::Input const& table, char const* said) {
  auto const text = refused(table);
  INFO(text);
  CHECK(text.find(said) != std::string::npos);
}

} // namespace

TEST_CASE("constraints that cannot be are refused with the place, the reason and the remedy") {
  CHECK(refused(held(periodic("foot.left", "foot.right"))).empty());
  check(held(roller("foot.leff", {1, 1})), "did you mean \"foot.left\"");
  check(held(roller("foot.left", {0, 0})), "is no direction");
  check(held(roller("foot.left", {1, 0, 0})), "give 2 numbers");
  check(held(periodic("foot.left", "foot.all")), "give both sides the same division");
  check(held(periodic("foot.left", "foot.left")), "give both sides the same division");
  check(held(periodic("foot.left", "foot.bottom")), "has no node at");
  check(held(roller("foot.left", {1, 1})), "contact is at it");
  auto table = held(roller("foot.top", {1, 1}));
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 1}, {0, 0.1}, {0, 0.1}), test::fix("foot.left", true, false)});
  check(table, "as motions do not let it be");
  table = held(periodic("foot.left", "foot.right"));
  test::at(table, "scheme") = test::make("scheme.central_difference");
  check(table, "are explicit");
  test::at(table, "scheme") = test::make("scheme.newmark");
  check(table, "keep accelerations");
}
