// Free and turning rigid bodies against closed forms: rolling, falling, resting, dragging.
#include <numbers>

#include "dynamics/model/poses.hpp"
#include "dynamics/space.hpp"

using namespace stiction;
using test::Vec3;

namespace {

constexpr double gravity = 10; // m/s^2

/// A ball or disc of 1 m radius and 1 kg, free, touching y = 0 (z = 0 in space) from above at `foot`.
test::Input roller(std::vector<double> foot, double inertia, std::vector<double> const& velocity) {
  foot.back() += 1;
  auto shape =
      test::make("rigid.sphere", {{"centre", test::values(foot, "m")}, {"radius", test::value(1, "m")}});
  return test::make("obstacle", {{"shape", std::move(shape)},
                                 {"mass", test::value(1, "kg")},
                                 {"inertia", test::value(inertia, "kg m^2")},
                                 {"velocity", test::values(velocity, "m/s")}});
}

/// A roller "ball" above a body "bed" whose top, `top`, lies at height 0 and whose bottom is held.
test::Input rolling(test::Input roller, test::Input bed, char const* top, double mu) {
  auto table = test::make("scene");
  test::at(table, "bodies.bed") = std::move(bed);
  test::at(table, "obstacles.ball") = std::move(roller);
  test::at(table, "pairs.joint") = test::pair(top, "ball");
  test::at(table, "pairs.joint.friction") = test::coulomb(mu);
  test::at(table, "motions") = test::list({test::fix("bed.bottom")});
  test::at(table, "scheme") = test::theta_xi(1, 1);
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

Vec3 part(test::State const& state, int dim, Index node, Vector test::State::*values) {
  Vec3 v = Vec3::Zero();
  v.head(dim) = (state.*values).segment(dim * node, dim);
  return v;
}

test::Input plane_bed(double young) {
  return test::block({{-0.05, -0.05}, {0.25, 0.05}, {25, 2}}, test::linear_elastic(young, 0.3), 10);
}
test::Input bed_in_space(double young) {
  return test::box({{-0.15, -0.15, -0.06}, {0.3, 0.3, 0.06}, {12, 12, 2}}, test::linear_elastic(young, 0.3),
                   10);
}

/// A disc over a stiff bed in the plane, under gravity.
test::Input disc_on_bed(double height, double speed, double mu) {
  auto table = rolling(roller({0, height}, 0.5, {speed, 0}), plane_bed(1e7), "bed.top", mu);
  test::at(table, "gravity") = test::values({0, -gravity}, "m/s^2");
  return table;
}

/// One foot of a block, held in place and pressed by its top, on a circle of 2 m below that turns by `turn`.
test::Input foot_on_wheel(double turn) {
  auto table = test::foot_on_floor();
  test::at(table, "obstacles.floor.shape") =
      test::make("rigid.circle", {{"centre", test::values({0.5, -2}, "m")}, {"radius", test::value(2, "m")}});
  test::at(table, "obstacles.floor.times") = test::values({0, 1, 2}, "s");
  test::at(table, "obstacles.floor.angle") = test::values({0, 0, turn}, "rad");
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "motions") = test::list(
      {test::fix("foot.all", true, false), test::drive("foot.top", {0, 1, 2}, {}, {0, -0.01, -0.01})});
  return table;
}

} // namespace

TEST_CASE("a disc starts with the spin that it was given") {
  auto table = disc_on_bed(0, 1, 0.3);
  test::at(table, "obstacles.ball.spin") = test::values({3}, "1/s");
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const& ball = scene.model->rigids[0];
  auto const start = stepper.initial();
  CHECK(start.v[2 * ball.node + 2] == 3);
  CHECK(start.v[2 * ball.node + 3] == 0);
  CHECK(start.ledger.kinetic == doctest::Approx(0.5 * (1 + 0.5 * 9)));
}

TEST_CASE("in space a free body's turns follow each other about axes that do not turn with it") {
  auto table = rolling(roller({0, 0, 0}, 0.4, {0, 0, 0}), bed_in_space(1e5), "bed.top", 0.3);
  test::at(table, "kinematics") = test::text("three_dimensional");
  auto const scene = scene::build(table);
  auto const& model = *scene.model;
  double const right = std::numbers::pi / 2;
  dynamics::Stepper stepper(*scene.model);
  auto old = stepper.initial();
  Index const turn = 3 * (model.rigids[0].node + 1);
  auto const about = [&](Vec3 const& axis) {
    Vector u = old.u;
    u.segment<3>(turn) += right * axis;
    Eigen::Matrix3d const whole = dynamics::turn_of_free<3>(model, 0, u, old);
    old.u = u;
    old.turned[0] = whole;
    return whole;
  };
  CHECK((about(Vec3::UnitX()) * Vec3::UnitY() - Vec3::UnitZ()).norm() < 1e-14);
  CHECK((about(Vec3::UnitZ()) * Vec3::UnitY() - Vec3::UnitZ()).norm() < 1e-14); // z stays where it is
  CHECK((about(Vec3::UnitY()) * Vec3::UnitY() - Vec3::UnitX()).norm() < 1e-14);
}

TEST_CASE("a disc set sliding rolls at two thirds of its speed") {
  double const mu = 0.3, time = 1 / (3 * mu * gravity);
  auto const scene = scene::build(disc_on_bed(0, 1, mu));
  dynamics::Stepper stepper(*scene.model);
  auto const& ball = scene.model->rigids[0];
  double const dt = 1e-3;
  auto const sliding = test::march(stepper, stepper.initial(), dt, 60);
  CHECK(sliding.v[2 * ball.node] == doctest::Approx(1 - mu * gravity * 0.06).epsilon(0.02));
  auto const end = test::march(stepper, sliding, dt, static_cast<int>(1.3 * time / dt) - 60);
  Vec3 const v = part(end, 2, ball.node, &test::State::v);
  double const spin = end.v[2 * ball.node + 2];
  CHECK(v.x() == doctest::Approx(2.0 / 3).epsilon(0.01));
  CHECK(spin == doctest::Approx(-v.x()).epsilon(0.01));
  CHECK(end.ledger.friction_loss == doctest::Approx(1.0 / 6).epsilon(0.02));
  CHECK(std::abs(end.ledger.scheme_loss()) < 0.01 * end.ledger.start);
}

TEST_CASE("a ball set sliding in space rolls at five sevenths of its speed without leaving its line") {
  double const mu = 0.3, time = 2 / (7 * mu * gravity), a = 0.4;
  auto table =
      rolling(roller({0, 0, 0}, 0.4, {std::cos(a), std::sin(a), 0}), bed_in_space(2e5), "bed.top", mu);
  test::at(table, "kinematics") = test::text("three_dimensional");
  test::at(table, "gravity") = test::values({0, 0, -gravity}, "m/s^2");
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const& ball = scene.model->rigids[0];
  double const dt = 2e-3;
  auto const end = test::march(stepper, stepper.initial(), dt, static_cast<int>(1.3 * time / dt));
  Vec3 const v = part(end, 3, ball.node, &test::State::v),
             spin = part(end, 3, ball.node + 1, &test::State::v);
  Vec3 const expected = 5.0 / 7 * Vec3(std::cos(a), std::sin(a), 0);
  CHECK((v - expected).norm() < 0.02);
  CHECK((spin - Vec3(0, 0, 1).cross(expected)).norm() < 0.02);
  CHECK(end.ledger.friction_loss == doctest::Approx(1.0 / 7).epsilon(0.03));
  CHECK(std::abs(end.ledger.scheme_loss()) < 0.02 * end.ledger.start);
  Eigen::Matrix3d const turn = end.turned[0];
  CHECK((turn * turn.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-12);
  Vec3 const angle = part(end, 3, ball.node + 1, &test::State::u);
  CHECK((turn - Eigen::AngleAxisd(angle.norm(), angle.normalized()).toRotationMatrix()).norm() < 1e-3);
}

TEST_CASE("a dropped disc takes the momentum that its weight and the reaction give") {
  auto const scene = scene::build(disc_on_bed(0.02, 0.3, 0.2));
  scene.model->control.force_tolerance = 1e-10;
  dynamics::Stepper stepper(*scene.model);
  auto const& ball = scene.model->rigids[0];
  double const dt = 1e-3;
  double worst = 0, hardest = 0, loss = -1;
  Index const first = 2 * ball.node;
  auto const end = test::march(
      stepper, stepper.initial(), dt, 100, [&](test::State const& before, test::State const& after) {
        Vec3 const reaction = test::contact_on(scene, after);
        Vec3 const gained =
            part(after, 2, ball.node, &test::State::v) - part(before, 2, ball.node, &test::State::v);
        Vec3 const force = Vec3(0, -gravity, 0) - reaction; // of 1 kg
        worst = std::max(worst, (gained / dt - force).norm());
        hardest = std::max(hardest, reaction.norm());
        double moment = 0; // on the disc about its centre
        for (Index const node : scene.model->pairs[0].secondary) {
          test::Vec2 const arm = scene.model->reference.row(node).transpose() + after.u.segment<2>(2 * node) -
                                 scene.model->reference.row(ball.node).transpose() -
                                 after.u.segment<2>(first);
          moment -= arm.x() * after.reaction[2 * node + 1] - arm.y() * after.reaction[2 * node];
        }
        double const spun = after.v[first + 2] - before.v[first + 2];
        worst = std::max(worst, std::abs(0.5 * spun / dt - moment));
        if (reaction.isZero(0) && loss < 0) // backward Euler loses m (g dt)^2 / 2 a step in free flight
          CHECK(after.ledger.scheme_loss() - before.ledger.scheme_loss() ==
                doctest::Approx(0.5 * gravity * gravity * dt * dt).epsilon(1e-4));
        else
          loss = std::max(loss, after.ledger.scheme_loss());
      });
  CHECK(hardest > 20);
  CHECK(worst < 1e-6 * hardest);
  double const before_impact = std::sqrt(2 * gravity * 0.02);
  CHECK(std::abs(end.v[first + 1]) < before_impact);
  CHECK(end.ledger.friction_loss >= 0);
  CHECK(end.ledger.scheme_loss() > 0);
  CHECK(end.ledger.start == doctest::Approx(0.5 * 0.3 * 0.3));
}

TEST_CASE("a loaded free body sinks to the depth at which a driven one meets its load") {
  double const load = 3;
  for (bool const in_space : {false, true}) {
    CAPTURE(in_space);
    auto table = in_space ? rolling(roller({0, 0, 0}, 0, {0, 0, 0}), bed_in_space(1000), "bed.top", 0)
                          : rolling(roller({0.07, 0}, 0, {0, 0}), plane_bed(1000), "bed.top", 0);
    test::remove(table, "pairs.joint.friction");
    if (in_space)
      test::at(table, "kinematics") = test::text("three_dimensional");
    char const* up = in_space ? "z" : "y";
    std::vector<double> force(in_space ? 3 : 2);
    force.back() = -load;
    auto free_table = table;
    test::at(free_table, "obstacles.ball.force") = test::values(force, "N");
    test::at(free_table, "obstacles.ball.times") = test::values({0, 1}, "s");
    test::at(free_table, "obstacles.ball.x") = test::values({0, 0}, "m"); // nothing else holds it there
    if (in_space)
      test::at(free_table, "obstacles.ball.y") = test::values({0, 0}, "m");
    auto const free = scene::build(free_table);
    dynamics::Stepper stepper(*free.model);
    auto const end = test::march(stepper, stepper.initial(), 0.2, 40);
    int const dim = free.model->dim();
    double const depth = end.u[dim * free.model->rigids[0].node + dim - 1];
    CHECK(depth < -1e-3);
    CHECK(end.v.lpNorm<Eigen::Infinity>() < 1e-6);
    CHECK(test::contact_on(free, end)[dim - 1] == doctest::Approx(-load).epsilon(1e-5));

    for (char const* key : {"mass", "inertia", "velocity"})
      test::remove(table, std::string("obstacles.ball.") + key);
    test::at(table, "obstacles.ball.times") = test::values({0, 1}, "s");
    test::at(table, std::string("obstacles.ball.") + up) = test::values({0, depth}, "m");
    test::at(table, "scheme") = test::quasi_static();
    auto const driven = scene::build(table);
    dynamics::Stepper press(*driven.model);
    auto const pressed = test::march(press, press.initial(), 0.25, 4);
    CHECK(test::contact_on(driven, pressed)[dim - 1] == doctest::Approx(-load).epsilon(1e-5));
  }
}

TEST_CASE("a turning wheel drags a held block with mu N and pays for it") {
  for (double const turn : {0.05, -0.05}) {
    auto const scene = scene::build(foot_on_wheel(turn));
    dynamics::Stepper stepper(*scene.model);
    auto const pressed = test::march(stepper, stepper.initial(), 0.25, 4);
    auto const dragged = test::march(stepper, pressed, 0.1, 10);
    double normal = 0, along = 0;
    for (std::size_t i = 0; i < dragged.contacts[0].size(); ++i) {
      normal += scene.model->pairs[0].areas[i] * dragged.contacts[0][i].dry[0];
      along += scene.model->pairs[0].areas[i] * dragged.contacts[0][i].dry[1];
    }
    CHECK(normal > 0.1);
    // the wheel's top goes to -x if it turns counter-clockwise
    CHECK(along == doctest::Approx((turn > 0 ? -0.3 : 0.3) * normal).epsilon(1e-6));
    double const loss = 0.3 * normal * 2 * std::abs(turn);
    CHECK(dragged.ledger.friction_loss == doctest::Approx(loss).epsilon(1e-3));
    CHECK(dragged.ledger.motion_work - pressed.ledger.motion_work ==
          doctest::Approx(loss * (1 - 0.5 / 10))
              .epsilon(1e-3)); // trapezia: the first of ten steps began at rest
  }
}

TEST_CASE("a wheel that turns and travels with the block on it pays for the slip alone") {
  double const turn = 0.05, way = 0.7;
  auto table = foot_on_wheel(turn);
  test::at(table, "obstacles.floor.x") = test::values({0, 0, way}, "m");
  test::at(table, "motions") = test::list({test::drive("foot.all", {0, 1, 2}, {0, 0, way}, {}),
                                           test::drive("foot.top", {0, 1, 2}, {}, {0, -0.01, -0.01})});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const pressed = test::march(stepper, stepper.initial(), 0.25, 4);
  auto const dragged = test::march(stepper, pressed, 0.1, 10);
  double const normal = test::contact_force(scene, dragged).y(), loss = 0.3 * normal * 2 * turn;
  CHECK(normal > 0.1);
  CHECK(dragged.ledger.friction_loss == doctest::Approx(loss).epsilon(1e-3));
  // the block pulls with mu N along the way, which is the wheel's to pay back
  CHECK(test::force_on(scene, dragged, "foot.all").x() == doctest::Approx(0.3 * normal).epsilon(1e-3));
  CHECK(dragged.ledger.motion_work - pressed.ledger.motion_work ==
        doctest::Approx(loss * (1 - 0.5 / 10)).epsilon(1e-3));
}

TEST_CASE("a turntable under a held cube loses mu p r per turn and area and pays the same") {
  double const turn = 0.2, mu = 0.3, press = 10;
  auto table = test::cube_on_floor();
  test::at(table, "obstacles.floor.times") = test::values({0, 1, 2}, "s");
  test::at(table, "obstacles.floor.angle") = test::values({0, 0, turn}, "rad");
  test::at(table, "obstacles.floor.pivot") = test::values({0.4, 0.3, 0}, "m");
  test::at(table, "pairs.sole.friction") = test::coulomb(mu);
  test::at(table, "motions") = test::list(
      {test::fix_in("foot.all", "xy"), test::drive("foot.top", {0, 1, 2}, {{{}, {}, {0, -0.01, -0.01}}})});
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const pressed = test::march(stepper, stepper.initial(), 0.25, 4);
  auto const turned = test::march(stepper, pressed, 0.05, 20);
  double loss = 0, torque = 0;
  for (std::size_t i = 0; i < turned.contacts[0].size(); ++i) {
    Index const node = scene.model->pairs[0].secondary[i];
    Vec3 const arm = Vec3(scene.model->reference.row(node)) - Vec3(0.4, 0.3, 0);
    loss += mu * press * scene.model->pairs[0].areas[i] * arm.head<2>().norm() * turn;
    torque += arm.cross(Vec3(turned.reaction.segment<3>(3 * node))).z();
  }
  CHECK(turned.ledger.friction_loss == doctest::Approx(loss).epsilon(1e-4));
  CHECK(turned.ledger.motion_work - pressed.ledger.motion_work ==
        doctest::Approx(loss * (1 - 0.5 / 20)).epsilon(1e-4));
  CHECK(torque == doctest::Approx(loss / turn).epsilon(1e-4));
}
