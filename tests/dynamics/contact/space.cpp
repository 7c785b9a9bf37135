// Whole scenes in space: patch tests, sliding, slices against the plane, moved observers.
#include "dynamics/space.hpp"

using namespace stiction;
using test::Vec3;

namespace {

/// Largest deviation of the recovered stress from sigma_zz = `axial`, all else zero, Pa.
double deviation(scene::Scene const& scene, test::State const& state, double axial) {
  auto const& model = *scene.model;
  double worst = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    auto const first = ix(3 * model.first_node[b]), count = ix(3 * model.first_node[b + 1]) - first;
    Matrix stress = model.cells[b].stress({state.u.data() + first, count}).cauchy;
    stress.col(2).array() -= axial;
    worst = std::max(worst, stress.cwiseAbs().maxCoeff());
  }
  return worst;
}

/// Two boxes one above the other, the upper one `over`, E = 1000 Pa; the top sinks by 0.01 m in a second and
/// goes sideways in the next.
test::Input stack(test::Box const& over, double poisson = 0) {
  auto table = test::space();
  test::at(table, "bodies.lower") =
      test::box({{0, 0, -1}, {1, 1, 1}, {3, 3, 2}}, test::linear_elastic(1000, poisson));
  test::at(table, "bodies.upper") = test::box(over, test::linear_elastic(1000, poisson));
  test::at(table, "pairs.joint") = test::pair("upper.bottom", "lower.top");
  test::at(table, "motions") =
      test::list({test::fix_in("lower.bottom", "xyz"),
                  test::drive("upper.top", {0, 1, 2}, {{{0, 0, 0.04}, {0, 0, -0.03}, {0, -0.01, -0.01}}})});
  return table;
}

/// A cube that rests on the floor in equilibrium and is set sliding at 1 m/s.
struct Slide {
  double stop_time = 0; ///< the step's end after which the centre of mass stands still
  Vec3 way, speed;      ///< of the centre of mass
};
Slide slide(Vec3 const& velocity, double mu, double dt, int steps) {
  double const gravity = 10, young = 1e7;
  auto table = test::cube_on_floor();
  test::at(table, "bodies.foot.material") = test::linear_elastic(young, 0);
  test::at(table, "bodies.foot.velocity") = test::values(test::numbers(velocity), "m/s");
  test::at(table, "gravity") = test::values({0, 0, -gravity}, "m/s^2");
  test::at(table, "pairs.sole.friction") = test::coulomb(mu);
  test::at(table, "scheme") = test::theta_xi(1, 1);
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto start = stepper.initial();
  for (Index i = 0; i < scene.model->node_count(); ++i) { // a column under its own weight
    double const z = scene.model->reference(i, 2);
    start.u[3 * i + 2] = -gravity / young * (z - z * z / 2);
  }
  Slide result;
  auto const end = test::march(stepper, start, dt, steps, [&](test::State const&, test::State const& state) {
    if (test::mass_mean(scene, stepper, state.v).norm() > 1e-2)
      result.stop_time = state.t;
  });
  result.way = test::mass_mean(scene, stepper, end.u - start.u);
  result.speed = test::mass_mean(scene, stepper, end.v);
  return result;
}

/// Largest difference between the displacements of a slice in space, held in z, and of its plane section.
double slice_difference(scene::Scene const& plane, Vector const& u2, scene::Scene const& slice,
                        Vector const& u3) {
  double worst = 0;
  for (Index i = 0; i < slice.model->node_count(); ++i) {
    Index twin = 0;
    for (Index j = 0; j < plane.model->node_count(); ++j)
      if ((plane.model->reference.row(j) - slice.model->reference.row(i).head<2>()).norm() <
          (plane.model->reference.row(twin) - slice.model->reference.row(i).head<2>()).norm())
        twin = j;
    worst = std::max(worst, (u2.segment<2>(2 * twin) - u3.segment<2>(3 * i)).lpNorm<Eigen::Infinity>());
    worst = std::max(worst, std::abs(u3[3 * i + 2]));
  }
  return worst;
}

/// What a plane scene and its slice have in common: a pair "joint", the law, a dynamic scheme.
void join(test::Input& table, std::string const& secondary, std::string const& primary, double bond) {
  test::at(table, "pairs.joint") = test::pair(secondary, primary);
  test::at(table, "pairs.joint.smoothing") = test::text("polyline");
  test::at(table, "pairs.joint.reach") = test::value(0.1, "m");
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  if (bond > 0)
    test::at(table, "pairs.joint.adhesion") = test::rcc(bond, 100 * bond, 5 * bond);
  test::at(table, "scheme") = test::theta_xi(0.7, 0.6);
  test::at(table, "schedule") = test::schedule({{2, 1}});
}

constexpr double depth = 0.4; ///< of slices, m

/// A foot of the plane and the same as a slice, both above y = 0 and pressed and dragged by their tops. In
/// the slice the tops of the plane are called "back", the bottoms "front".
struct Twins {
  test::Input plane = test::make("scene"), slice = test::make("scene");
  Twins() {
    auto const material = test::linear_elastic(1000, 0.3);
    test::at(plane, "bodies.foot") = test::block({{0.2, 0}, {0.5, 1}, {3, 4}}, material);
    test::at(slice, "bodies.foot") = test::box({{0.2, 0, 0}, {0.5, 1, depth}, {3, 4, 1}}, material);
    test::at(slice, "kinematics") = test::text("three_dimensional");
    std::vector<double> const times{0, 1, 2}, x{0, 0, 0.1}, y{0, -0.02, -0.02};
    test::at(plane, "motions") = test::list({test::drive("foot.top", times, x, y)});
    test::at(slice, "motions") =
        test::list({test::drive("foot.back", times, {{x, y, {}}}), test::fix_in("foot.all", "z")});
  }
  void move(test::Input const& in_plane) {
    std::get<core::List>(test::at(plane, "motions").value).push_back(in_plane);
    std::get<core::List>(test::at(slice, "motions").value).push_back(in_plane);
  }
  /// Marches both and compares displacements and forces.
  void compare() const {
    auto const two = scene::build(plane), three = scene::build(slice);
    for (auto const* scene : {&two, &three})
      scene->model->control.force_tolerance = 1e-11;
    dynamics::Stepper a(*two.model), b(*three.model);
    auto const u = test::march(a, a.initial(), 0.1, 20), v = test::march(b, b.initial(), 0.1, 20);
    CHECK(slice_difference(two, u.u, three, v.u) < 1e-8);
    Vec3 const force = test::contact_on(two, u);
    CHECK(force.y() > 1);
    CHECK(force.x() < -0.1);
    CHECK((force * depth - test::contact_on(three, v)).norm() < 1e-6 * force.norm());
    CHECK(v.ledger.friction_loss == doctest::Approx(depth * u.ledger.friction_loss).epsilon(1e-6));
    CHECK(v.ledger.bonding_loss == doctest::Approx(depth * u.ledger.bonding_loss).epsilon(1e-6));
    CHECK(v.ledger.bond == doctest::Approx(depth * u.ledger.bond).epsilon(1e-6));
    CHECK(v.ledger.motion_work == doctest::Approx(depth * u.ledger.motion_work).epsilon(1e-6));
    CHECK(u.ledger.friction_loss > 1e-4);
  }
};

test::Input orthotropic() {
  auto law = test::rcc(0.1, 100, 1);
  test::at(law, "C_t2") = test::value(30, "N/m^3");
  return law;
}

/// Turns a scene of driven planes about the origin. Every motion must come as x, y and z of one set.
void turn(dynamics::Model& model, Eigen::Matrix3d const& R) {
  model.reference *= R.transpose();
  model.velocity *= R.transpose();
  model.gravity = (R * model.gravity).eval();
  model.cells.clear();
  for (auto& body : model.bodies) {
    body->mesh.nodes *= R.transpose();
    model.cells.emplace_back(*body, model.kinematics);
  }
  for (auto& rigid : model.rigids) {
    auto& plane = std::get<contact::RigidPlane>(rigid.shape);
    plane.normal = test::numbers(R * Vec3(0, 0, 1));
    plane.point = test::numbers(R * Vec3(0, 0, -1));
  }
  for (auto& pair : model.pairs)
    if (auto* side = std::get_if<dynamics::RigidSide>(&pair.primary))
      side->direction = (R * side->direction).eval();
  for (std::size_t m = 0; m < model.motions.size(); m += 3)
    for (std::size_t k = 0; k < model.motions[m].path.values.size(); ++k) {
      Vec3 v;
      for (int c = 0; c < 3; ++c)
        v[c] = model.motions[m + ix(c)].path.values[k];
      v = (R * v).eval();
      for (int c = 0; c < 3; ++c)
        model.motions[m + ix(c)].path.values[k] = v[c];
    }
}

Vector turned(Vector u, Eigen::Matrix3d const& R) {
  for (Eigen::Index i = 0; i < u.size(); i += 3)
    u.segment<3>(i) = (R * u.segment<3>(i)).eval();
  return u;
}

} // namespace

TEST_CASE("patch test in space: matching meshes carry a uniform stress whichever surface is secondary") {
  for (bool const upper_is_secondary : {true, false}) {
    auto table = stack({{0, 0, 0}, {1, 1, 1}, {3, 3, 2}});
    if (!upper_is_secondary)
      test::at(table, "pairs.joint") = test::pair("lower.top", "upper.bottom");
    CAPTURE(upper_is_secondary);
    auto const scene = scene::build(table);
    dynamics::Stepper stepper(*scene.model);
    auto const state = test::march(stepper, stepper.initial(), 0.25, 4);
    CHECK(deviation(scene, state, -5) < 5e-8);
    for (auto const& point : state.contacts[0]) {
      CHECK(point.dry[0] == doctest::Approx(5).epsilon(1e-8));
      CHECK(std::abs(point.gap) < 1e-12);
    }
    CHECK(test::drive_on(scene, state, "upper.top").z() == doctest::Approx(-5).epsilon(1e-9));
    CHECK(test::drive_on(scene, state, "lower.bottom").z() == doctest::Approx(5).epsilon(1e-9));
  }
}

TEST_CASE("forces and moments balance across surfaces in space whose nodes do not match") {
  auto table = stack({{0.12, 0.2, 0}, {0.7, 0.6, 1}, {2, 2, 2}}, 0.3);
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  test::at(table, "pairs.joint.adhesion") = orthotropic();
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const state = test::march(stepper, stepper.initial(), 0.1, 20);
  Vec3 const force = test::contact_on(scene, state);
  CHECK(force.z() > 1);
  CHECK(force.head<2>().norm() > 0.3);
  CHECK((force + test::drive_on(scene, state, "upper.top")).norm() < 1e-5 * force.norm());
  CHECK((force - test::drive_on(scene, state, "lower.bottom")).norm() < 1e-5 * force.norm());
  CHECK((force + test::sum_over(scene, state.reaction, test::nodes_of(scene, "lower.all"))).norm() <
        1e-12 * force.norm());
  CHECK(test::moment(scene, state, state.reaction).norm() < 1e-12 * force.norm());
}

TEST_CASE("a cube sliding obliquely stops after v / mu g and v^2 / 2 mu g along its first direction") {
  double const mu = 0.5, time = 0.2, distance = 0.1;
  Vec3 const direction(std::cos(0.7), -std::sin(0.7), 0);
  auto const coarse = slide(direction, mu, 4e-3, 65), fine = slide(direction, mu, 2e-3, 130);
  CHECK(std::abs(coarse.stop_time - time) < 4 * 4e-3);
  CHECK(std::abs(fine.stop_time - time) < 4 * 2e-3);
  CHECK(std::abs(coarse.way.norm() - distance) < 4e-3);
  CHECK(std::abs(fine.way.norm() - distance) < 0.65 * std::abs(coarse.way.norm() - distance));
  for (auto const& end : {coarse, fine}) {
    CHECK(end.way.cross(direction).norm() < 1e-3 * distance);
    CHECK(end.speed.norm() < 1e-4);
  }
}

TEST_CASE("a slice held in z is plane strain: sliding with adhesion over a rigid plane") {
  Twins twins;
  test::at(twins.plane, "obstacles.base") = test::floor();
  test::at(twins.slice, "obstacles.base.shape") =
      test::make("rigid.plane", {{"normal", test::values({0, 1, 0})}});
  test::at(twins.slice, "obstacles.base").tag = "obstacle";
  join(twins.plane, "foot.bottom", "base", 0.1);
  join(twins.slice, "foot.front", "base", 0.1);
  twins.compare();
}

TEST_CASE("a slice held in z is plane strain: friction over a disc that is a cylinder in space") {
  Twins twins;
  auto set = [](test::Input& table, char const* kind, std::vector<double> const& centre) {
    auto shape = test::make(kind, {{"centre", test::values(centre, "m")}, {"radius", test::value(3, "m")}});
    test::at(table, "obstacles.base") = test::make("obstacle", {{"shape", std::move(shape)}});
  };
  set(twins.plane, "rigid.circle", {0.42, -3});
  set(twins.slice, "rigid.cylinder", {0.42, -3, 0});
  join(twins.plane, "foot.bottom", "base", 0);
  join(twins.slice, "foot.front", "base", 0);
  twins.compare();
}

TEST_CASE("a slice held in z is plane strain: adhesion to the flat facets of a held body") {
  Twins twins;
  test::at(twins.plane, "bodies.base") =
      test::block({{0, -0.5}, {1, 0.5}, {4, 1}}, test::linear_elastic(1000, 0.3));
  test::at(twins.slice, "bodies.base") =
      test::box({{0, -0.5, 0}, {1, 0.5, depth}, {4, 1, 1}}, test::linear_elastic(1000, 0.3));
  twins.move(test::fix("base.all"));
  join(twins.plane, "foot.bottom", "base.top", 0.1);
  join(twins.slice, "foot.front", "base.back", 0.1);
  twins.compare();
}

TEST_CASE("a scene in space turned about any axis gives turned results") {
  auto table = stack({{0.12, 0.2, 0}, {0.7, 0.6, 1}, {2, 2, 2}});
  for (std::string const body : {"lower", "upper"})
    test::at(table, "bodies." + body + ".material") = test::make(
        "material.neo_hookean", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  test::at(table, "pairs.joint.adhesion") = orthotropic();
  test::at(table, "obstacles.floor.shape") =
      test::make("rigid.plane", {{"point", test::values({0, 0, -1}, "m")}});
  test::at(table, "obstacles.floor").tag = "obstacle";
  test::at(table, "pairs.sole") = test::pair("lower.bottom", "floor");
  test::at(table, "pairs.sole.friction") = test::coulomb(0.6);
  test::at(table, "pairs.sole.adhesion") = orthotropic();
  test::at(table, "motions") =
      test::list({test::drive("upper.top", {0, 1, 2}, {{{0, 0, 0.2}, {0, 0, -0.15}, {0, -0.02, -0.02}}})});
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "gravity") = test::values({1, 0.5, -3}, "m/s^2");
  Eigen::Matrix3d const R = Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  auto const upright = scene::build(table), tilted = scene::build(table);
  turn(*tilted.model, R);
  for (auto const* scene : {&upright, &tilted})
    scene->model->control.force_tolerance = 1e-10;
  dynamics::Stepper one(*upright.model), other(*tilted.model);
  auto const a = test::march(one, one.initial(), 0.1, 16);
  auto const b = test::march(other, other.initial(), 0.1, 16);
  CHECK(a.ledger.friction_loss > 1e-3);
  for (std::size_t p = 0; p < 2; ++p)
    CHECK(a.contacts[p][1].bond.beta > 0);
  CHECK(test::largest(turned(a.u, R) - b.u) < 1e-8);
  CHECK(test::largest(turned(a.reaction, R) - b.reaction) < 1e-5);
  CHECK(a.ledger.friction_loss == doctest::Approx(b.ledger.friction_loss).epsilon(1e-6));
  for (std::size_t i = 0; i < a.contacts[0].size(); ++i)
    CHECK((a.contacts[0][i].path - b.contacts[0][i].path).norm() < 1e-7);
}
