// Momentum and the impulses that change it, of every scheme; what the default scheme does to energy.
#include "dynamics/all_schemes.hpp"
#include "dynamics/space.hpp"

using namespace stiction;
using dynamics::Screw;
using test::Vec3;

namespace {

test::Input rubber() {
  return test::make("material.neo_hookean",
                    {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
}

/// Two free rubber blocks of 1 kg/m and 2 kg/m; the left one flies at 3 m/s into the other, off its centre.
test::Input collision(test::Input scheme, char const* discretisation = "node_to_segment") {
  auto table = test::make("scene");
  test::at(table, "bodies.left") = test::block({{0, 0}, {1, 1}, {3, 3}}, rubber(), 1);
  test::at(table, "bodies.left.velocity") = test::values({3, 1}, "m/s");
  test::at(table, "bodies.right") = test::block({{1.02, 0.3}, {2, 1}, {4, 3}}, rubber(), 1);
  test::at(table, "pairs.hit") = test::pair("left.right", "right.left");
  test::at(table, "pairs.hit.discretisation") = test::text(discretisation);
  test::at(table, "pairs.hit.friction") = test::coulomb(0.3);
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "scheme") = std::move(scheme);
  return table;
}

/// The same of cubes in space.
test::Input collision_in_space(test::Input scheme) {
  auto table = test::space();
  test::at(table, "bodies.left") = test::box({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, rubber(), 1);
  test::at(table, "bodies.left.velocity") = test::values({3, 1, -0.5}, "m/s");
  test::at(table, "bodies.right") = test::box({{1.02, 0.3, -0.2}, {1, 1, 1}, {2, 2, 2}}, rubber(), 2);
  test::at(table, "pairs.hit") = test::pair("left.right", "right.left");
  test::at(table, "pairs.hit.friction") = test::coulomb(0.3);
  test::at(table, "scheme") = std::move(scheme);
  return table;
}

scene::Scene built(test::Input const& table) {
  auto made = scene::build(table);
  made.model->control.force_tolerance = 1e-9;
  made.model->tallied = made.model->audited = true;
  return made;
}

Screw whole(dynamics::Momenta const& momenta) {
  Screw sum;
  for (auto const& body : momenta.bodies)
    sum += body;
  return sum;
}

/// Change of all momentum less all impulses.
Vec3 unaccounted(dynamics::Momenta const& momenta) {
  Vec3 rest = whole(momenta).linear - momenta.start.linear - momenta.loads.linear - momenta.motions.linear;
  for (auto const& pair : momenta.pairs)
    rest -= pair.secondary.linear + pair.primary.linear;
  return rest;
}

struct Kept {
  double momentum = 0, sides = 0, spin = 0,
         impulse = 0; ///< largest misfits and the largest impulse, N s, N m s
};

Kept collided(scene::Scene const& scene, double time, int steps) {
  dynamics::Stepper stepper(*scene.model);
  Kept most;
  test::march(stepper, stepper.initial(), time / steps, steps,
              [&](test::State const&, test::State const& state) {
                auto const& all = state.momenta;
                auto const& hit = all.pairs[0];
                auto const keep = [](double& largest, double value) { largest = std::max(largest, value); };
                keep(most.momentum, unaccounted(all).norm());
                keep(most.sides, (hit.secondary.linear + hit.primary.linear).norm() +
                                     (hit.secondary.angular + hit.primary.angular).norm());
                keep(most.spin, (whole(all).angular - all.start.angular).norm());
                keep(most.impulse, hit.secondary.linear.norm());
              });
  return most;
}

/// Does every step change momentum by just the mean of its forces? Others do so over all steps together.
bool steps_alone(test::SchemeSample const& sample) {
  return (sample.closed_rates && sample.name != "generalised_alpha" && sample.name != "hht") ||
         sample.cells || (sample.massless && sample.name == "theta_xi") ||
         sample.name == "central_difference";
}

/// A bar above the floor that falls at 3 m/s; waves take 1/3 s from end to end.
scene::Scene falling_bar(test::Input scheme) {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0.5}, {0.5, 10}, {1, 20}}, test::linear_elastic(900, 0));
  test::at(table, "bodies.foot.velocity") = test::values({0, -3}, "m/s");
  test::at(table, "motions") = test::list({test::fix("foot.all", true, false)});
  test::at(table, "scheme") = std::move(scheme);
  return scene::build(table);
}

} // namespace

TEST_CASE(
    "every scheme: a collision changes the momentum of all by nothing and of each side by its impulse") {
  for (auto const& sample : test::scheme_samples()) {
    if (sample.order == 0)
      continue;
    INFO(sample.label);
    auto const scene = built(collision(sample.table));
    dynamics::Stepper stepper(*scene.model);
    auto const start = stepper.initial();
    CHECK(start.momenta.bodies[0].linear.isApprox(Vec3(3, 1, 0), 1e-12));
    if (!sample.massless) { // which moves mass away from the surface
      CHECK(start.momenta.bodies[0].angular.isApprox(Vec3(0, 0, 0.5 - 1.5), 1e-12));
      CHECK(start.momenta.bodies[0].about({0.5, 0.5, 0}).norm() < 1e-12);
    }
    CHECK(start.momenta.bodies[1].linear.isZero(0));
    auto const kept = collided(scene, 0.16, 80);
    CHECK(kept.impulse > 0.5);
    CHECK(kept.sides < 1e-11);
    CHECK(kept.spin < 0.1);
    if (steps_alone(sample))
      CHECK(kept.momentum < 1e-8);
  }
}

TEST_CASE("mortar, and bodies in space: impulses balance in force and moment") {
  for (auto const& table : {collision(test::make("scheme.theta_xi", test::cure("cells")), "mortar"),
                            collision_in_space(test::make("scheme.theta_xi", test::cure("cells"))),
                            collision_in_space(test::make("scheme.theta_xi", test::cure("none")))}) {
    auto const kept = collided(built(table), 0.16, 80);
    CHECK(kept.impulse > 0.2);
    CHECK(kept.momentum < 1e-8);
    CHECK(kept.sides < 1e-11);
    CHECK(kept.spin < 0.1);
  }
}

TEST_CASE("weight, motions and an obstacle's impulse add up to a body's change of momentum") {
  auto table = test::foot_on_floor();
  test::at(table, "gravity") = test::values({0.5, -10}, "m/s^2");
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "motions") = test::list({test::drive("foot.top", {0, 1, 2}, {0, 0.2, 0.1}, {})});
  test::at(table, "scheme") = test::make("scheme.theta_xi", test::cure("cells"));
  auto const scene = built(table);
  dynamics::Stepper stepper(*scene.model);
  auto const end = test::march(stepper, stepper.initial(), 0.01, 50);
  auto const& all = end.momenta;
  CHECK(all.loads.linear.isApprox(0.5 * Vec3(0.5, -10, 0), 1e-12));
  CHECK(all.motions.linear.norm() > 0.01);
  CHECK(all.pairs[0].secondary.linear.y() > 1);
  CHECK(all.pairs[0].primary.linear.isZero(0));
  CHECK(unaccounted(all).norm() < 1e-8);
}

TEST_CASE("a free disc's spin and the torque that turns it") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{-1, -1}, {2, 1}, {8, 4}}, test::linear_elastic(1e6, 0.3));
  test::at(table, "obstacles.floor") =
      test::make("obstacle", {{"shape", test::make("rigid.sphere", {{"centre", test::values({0, 1}, "m")},
                                                                    {"radius", test::value(1, "m")}})},
                              {"mass", test::value(2, "kg")},
                              {"inertia", test::value(0.5, "kg m^2")},
                              {"velocity", test::values({1, -0.2}, "m/s")},
                              {"spin", test::values({3}, "rad/s")}});
  test::at(table, "pairs.sole") = test::pair("foot.top", "floor");
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "motions") = test::list({test::fix("foot.bottom")});
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  auto const scene = built(table);
  dynamics::Stepper stepper(*scene.model);
  auto const start = stepper.initial();
  auto const disc = scene.bodies.size();
  CHECK(start.momenta.bodies[disc].linear.isApprox(Vec3(2, -0.4, 0), 1e-12));
  CHECK(start.momenta.bodies[disc].about({0, 1, 0}).isApprox(Vec3(0, 0, 1.5), 1e-12));
  auto const end = test::march(stepper, start, 1e-3, 50);
  auto const& hit = end.momenta.pairs[0];
  Screw const &before = start.momenta.bodies[disc], &after = end.momenta.bodies[disc];
  CHECK(hit.primary.linear.norm() > 0.1);
  CHECK((after.linear - before.linear - hit.primary.linear).norm() < 1e-7);
  CHECK((after.angular - before.angular - hit.primary.angular).norm() < 2e-3 * before.angular.norm());
  CHECK((hit.secondary.angular + hit.primary.angular).norm() < 1e-9);
}

TEST_CASE(
    "contact cells by backward Euler: no step makes energy however long, not where contact ends either") {
  for (double const dt : {0.005, 0.03, 0.1, 0.3, 1.0, 10.0}) {
    CAPTURE(dt);
    auto const scene = falling_bar(test::make("scheme.theta_xi", test::cure("cells")));
    dynamics::Stepper stepper(*scene.model);
    bool left = false;
    double worst = 0;
    auto const end =
        test::march(stepper, stepper.initial(), dt, 60, [&](test::State const& old, test::State const& next) {
          left =
              left || (test::contact_force(scene, old).y() > 0 && test::contact_force(scene, next).y() == 0);
          worst = std::min(worst, next.ledger.scheme_loss() - old.ledger.scheme_loss());
        });
    CHECK((left || dt < 0.03));
    CHECK(worst > -1e-9 * end.ledger.start);
  }
}
