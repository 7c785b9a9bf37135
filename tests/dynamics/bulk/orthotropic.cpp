// A bond of two stiffnesses along the surface, dragged in any direction, against its closed form.
#include "dynamics/space.hpp"

using namespace stiction;
using test::Vec3;

namespace {

constexpr double way = 0.02; // m

struct Pull {
  Vec3 force;      ///< of the floor on the cube, N
  double bond = 0; ///< energy, J
  double beta = 0;
};

/// A cube fully bonded to the floor and dragged as a whole by `way` at `angle` from x in ten steps, its first
/// tangent at `first` from x.
Pull pull(double C_t, double C_t2, double angle, double first, double w = 100) {
  auto table = test::cube_on_floor();
  auto law = test::rcc(w, C_t, 0);
  test::at(law, "C_t2") = test::value(C_t2, "N/m^3");
  test::at(law, "beta0") = test::value(1);
  test::at(law, "bonding") = test::text("never");
  test::at(table, "pairs.sole.adhesion") = law;
  test::at(table, "pairs.sole.direction") = test::values({std::cos(first), std::sin(first), 0.3});
  test::at(table, "motions") = test::list(
      {test::drive("foot.all", {0, 2}, {{{0, way * std::cos(angle)}, {0, way * std::sin(angle)}, {}}}),
       test::fix_in("foot.top", "z")});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.2, 10);
  return {test::contact_on(scene, state), state.ledger.bond, state.contacts[0][0].bond.beta};
}

} // namespace

TEST_CASE("a bond of two stiffnesses pulls back along each of its directions by itself") {
  double const C_t = 300, C_t2 = 70, pi = 3.14159265358979;
  for (double const first : {0.0, 0.4})
    for (double const angle : {0.0, pi / 2, pi / 4, -2.0}) {
      CAPTURE(first);
      CAPTURE(angle);
      auto const pulled = pull(C_t, C_t2, angle, first);
      Vec3 const t1(std::cos(first), std::sin(first), 0), t2(-std::sin(first), std::cos(first), 0);
      Vec3 const u = way * Vec3(std::cos(angle), std::sin(angle), 0);
      Vec3 const expected = -C_t * t1.dot(u) * t1 - C_t2 * t2.dot(u) * t2; // of 1 m^2
      CHECK((pulled.force - expected).norm() < 1e-9 * expected.norm());
      CHECK(pulled.beta == 1);
      CHECK(pulled.bond == doctest::Approx(-0.5 * expected.dot(u) - 100).epsilon(1e-12));
    }
}

TEST_CASE("a bond of equal stiffnesses does not know its directions") {
  for (double const first : {0.0, 0.4, 1.1}) {
    auto const pulled = pull(300, 300, 0.9, first);
    CHECK(pulled.force.x() == doctest::Approx(-300 * way * std::cos(0.9)).epsilon(1e-9));
    CHECK(pulled.force.y() == doctest::Approx(-300 * way * std::sin(0.9)).epsilon(1e-9));
  }
}

TEST_CASE("the stiffer direction of a bond breaks first") {
  // at b = 0: beta = w / (C u^2) once that is below 1
  double const w = 0.04, C_t = 300, C_t2 = 70;
  auto const stiff = pull(C_t, C_t2, 0, 0, w), soft = pull(C_t, C_t2, 3.14159265358979 / 2, 0, w);
  double const beta = w / (C_t * way * way);
  CHECK(stiff.beta == doctest::Approx(beta).epsilon(1e-9));
  CHECK(stiff.force.x() == doctest::Approx(-C_t * way * beta * beta).epsilon(1e-9));
  CHECK(soft.beta == 1);
  CHECK(soft.force.y() == doctest::Approx(-C_t2 * way).epsilon(1e-9));
}
