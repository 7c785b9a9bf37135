// A contact does not depend on what other surfaces there are, however the bulk's factor treats them.
#include "dynamics/space.hpp"

using namespace stiction;

namespace {

/// A slab pressed on the floor and dragged; `large`: its sides are contact surfaces as well, of a ball far
/// away.
test::Input slab(bool large) {
  auto table = test::cube_on_floor();
  test::at(table, "bodies.foot") =
      test::box({{0, 0, 0}, {3, 3, 1}, {14, 14, 4}}, test::linear_elastic(1000, 0.3));
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 1, 2}, {{{0, 0, 0.04}, {0, 0, 0.02}, {0, -0.02, -0.02}}})});
  if (!large)
    return table;
  test::at(table, "obstacles.ball") =
      test::make("obstacle", {{"shape", test::make("rigid.sphere", {{"centre", test::values({0, 0, 99}, "m")},
                                                                    {"radius", test::value(1, "m")}})}});
  for (char const* side : {"left", "right", "front", "back"})
    test::at(table, std::string("pairs.") + side) = test::pair(std::string("foot.") + side, "ball");
  return table;
}

} // namespace

TEST_CASE("a slab on the floor is where it is whether or not its sides might touch something") {
  std::vector<Vector> ends;
  std::vector<long> columns;
  for (bool const large : {false, true}) {
    CAPTURE(large);
    auto const scene = scene::build(slab(large));
    dynamics::Stepper stepper(*scene.model);
    auto const& factor = stepper.bulk().factor();
    auto const surface = static_cast<double>(factor.surface());
    CHECK((factor.surface_numbers() < surface * surface) == large); // nothing dense
    ends.push_back(test::march(stepper, stepper.initial(), 0.5, 3).u);
    columns.push_back(stepper.cost().compliance_columns / stepper.cost().factorizations);
  }
  CHECK((ends[0] - ends[1]).norm() <= 1e-9 * ends[0].norm());
  CHECK(columns[1] <= columns[0] + 24); // those of the sole alone
}
