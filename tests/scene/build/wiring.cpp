// Each entry of a script's table changes the field of the model that it names, to that value, and no other.
#include <cmath>
#include <doctest/doctest.h>
#include <map>
#include <numbers>

#include "scene/scenes.hpp"

using namespace stiction;

namespace {

using Snapshot = std::map<std::string, double>;

void add_body(Snapshot& shot, scene::Scene const& scene, std::size_t b) {
  auto const& model = *scene.model;
  auto const& body = *model.bodies[b];
  auto const& name = body.name;
  auto const count = body.mesh.node_count();
  auto const nodes = model.reference.middleRows(model.first_node[b], count);
  auto const velocity = model.velocity.middleRows(model.first_node[b], count);
  shot[name + ".density"] = body.density;
  shot[name + ".material"] = static_cast<double>(body.material.index());
  shot[name + ".young"] = material::moduli(body.material).young;
  shot[name + ".poisson"] = material::moduli(body.material).poisson;
  shot[name + ".velocity.x"] = velocity.col(0).mean();
  shot[name + ".velocity.y"] = velocity.col(1).mean();
  shot[name + ".left"] = nodes.col(0).minCoeff();
  shot[name + ".right"] = nodes.col(0).maxCoeff();
  shot[name + ".bottom"] = nodes.col(1).minCoeff();
  shot[name + ".top"] = nodes.col(1).maxCoeff();
  shot[name + ".cells"] = body.mesh.cell_count();
  shot[name + ".mean"] = nodes.col(0).mean(); // of the grading
}

void add_primary(Snapshot& shot, dynamics::Model const& model, dynamics::Pair const& pair) {
  if (auto const* curve = std::get_if<contact::Curve>(&pair.primary)) {
    shot[pair.name + ".segment nodes"] = curve->segments()[1].count;
    return;
  }
  auto const& moving = model.rigids[std::get<dynamics::RigidSide>(pair.primary).body];
  shot[pair.name + ".offset.x"] = moving.offset(1).x();
  shot[pair.name + ".offset.y"] = moving.offset(1).y();
  auto const& plane = std::get<contact::RigidPlane>(moving.shape);
  shot[pair.name + ".point.y"] = plane.point.empty() ? 0 : plane.point[1];
  shot[pair.name + ".normal.x"] = plane.normal.empty() ? 0 : plane.normal[0];
}

void add_pair(Snapshot& shot, dynamics::Model const& model, dynamics::Pair const& pair) {
  auto const& name = pair.name;
  shot[name + ".points"] = pair.size();
  shot[name + ".reach"] = pair.reach;
  for (double const area : pair.areas)
    shot[name + ".area"] += area;
  shot[name + ".mu"] = pair.law.friction ? pair.law.mu() : -1;
  add_primary(shot, model, pair);
  if (!pair.law.adhesion)
    return;
  auto const& law = std::get<interface::Rcc>(*pair.law.adhesion);
  shot[name + ".w"] = law.w;
  shot[name + ".C_n"] = law.C_n;
  shot[name + ".C_t"] = law.C_t;
  shot[name + ".b"] = law.b;
  shot[name + ".beta0"] = law.beta0;
  shot[name + ".bonding"] = static_cast<double>(law.bonding);
  shot[name + ".bond friction"] = static_cast<double>(law.friction);
  shot[name + ".power"] = law.damage_power;
}

void add_numerics(Snapshot& shot, scene::Scene const& scene) {
  auto const& model = *scene.model;
  if (auto const* scheme = std::get_if<dynamics::ThetaXi>(&model.scheme)) {
    shot["theta"] = scheme->theta;
    shot["xi"] = scheme->xi;
    shot["contact weight"] = scheme->contact_weight;
    shot["contact inertia"] = static_cast<double>(scheme->contact_inertia);
  }
  std::visit(
      [&](auto const& solver) {
        shot["solver tolerance"] = solver.tolerance;
        shot["solver iterations"] = solver.iterations;
        if constexpr (requires { solver.relaxation; })
          shot["relaxation"] = solver.relaxation;
      },
      model.solver);
  shot["solver"] = static_cast<double>(model.solver.index());
  shot["force tolerance"] = model.control.force_tolerance;
  shot["iterations"] = model.control.iterations;
  auto const& schedule = scene.part.schedule;
  shot["stages"] = static_cast<double>(schedule.stages.size());
  shot["end"] = schedule.stages.back().until;
  shot["steps"] = schedule.stages.back().steps;
  shot["halvings"] = schedule.halvings;
  shot["frames"] = scene.part.output.frames;
  shot["problems"] = scene.part.output.problems_every;
}

Snapshot snapshot(test::Input const& table) {
  auto const scene = scene::build(table);
  auto const& model = *scene.model;
  Snapshot shot;
  shot["kinematics"] = static_cast<double>(model.kinematics);
  shot["gravity.x"] = model.gravity.x();
  shot["gravity.y"] = model.gravity.y();
  for (std::size_t b = 0; b < model.bodies.size(); ++b)
    add_body(shot, scene, b);
  for (auto const& pair : model.pairs)
    add_pair(shot, model, pair);
  for (std::size_t m = 0; m < model.motions.size(); ++m) {
    auto const& motion = model.motions[m];
    std::string const name = "motion " + std::to_string(m + 1);
    shot[name + " component"] = motion.component;
    shot[name + " first node"] = motion.nodes[0];
    shot[name + " value"] = motion.path.value(1.5);
  }
  add_numerics(shot, scene);
  return shot;
}

/// Two blocks on a floor with every law declared.
test::Input full_table() {
  auto table = test::two_blocks();
  test::at(table, "obstacles.floor.shape") =
      test::make("rigid.plane", {{"point", test::values({0, -1}, "m")}});
  test::at(table, "pairs.sole") = test::pair("lower.bottom", "floor");
  test::at(table, "pairs.joint.friction") = test::coulomb(0.25);
  test::at(table, "pairs.joint.adhesion") = test::rcc(20, 2e3, 0.5);
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  return table;
}

/// Mean x of the nodes of four columns between 0 and 1 m whose last is so many times wider than the first.
double graded_mean(double grading) {
  double position = 0, sum = 0, width = 1;
  for (int k = 0; k < 4; ++k, width *= std::cbrt(grading))
    sum += position += width;
  return sum / (5 * position);
}

struct Case {
  std::string path;
  test::Input input;
  Snapshot wanted; ///< all that may change
};

void check_case(Case const& changed) {
  auto table = full_table();
  auto const before = snapshot(table);
  test::at(table, changed.path) = changed.input;
  auto after = snapshot(table);
  for (auto const& [key, wanted] : changed.wanted) {
    INFO(changed.path, " to ", key);
    REQUIRE(after.contains(key));
    CHECK(after[key] == doctest::Approx(wanted).epsilon(1e-14));
    CHECK((!before.contains(key) || before.at(key) != after[key]));
  }
  for (auto const& [key, was] : before) {
    INFO(changed.path, " must leave ", key);
    if (!changed.wanted.contains(key))
      CHECK((after.contains(key) && after[key] == was));
  }
}

} // namespace

TEST_CASE("entries of bodies reach the model") {
  using test::value, test::values;
  std::vector<Case> const cases = {
      {"bodies.lower.density", value(7, "kg/m^3"), {{"lower.density", 7}}},
      {"bodies.upper.density", value(2, "g/cm^3"), {{"upper.density", 2000}}},
      {"bodies.upper.velocity",
       values({3, -4}, "mm/s"),
       {{"upper.velocity.x", 3e-3}, {"upper.velocity.y", -4e-3}}},
      {"bodies.lower.material.young", value(3, "kPa"), {{"lower.young", 3000}}},
      {"bodies.upper.material.poisson", value(0.3), {{"upper.poisson", 0.3}}},
      {"bodies.upper.material",
       test::make("material.blatz_ko", {{"shear_modulus", value(2, "Pa")}}),
       {{"upper.material", 3}, {"upper.young", 5}, {"upper.poisson", 0.25}}},
      {"bodies.upper.mesh.size", values({1, 2}, "m"), {{"upper.top", 2}}},
      {"bodies.upper.mesh.cells",
       values({4, 3}),
       {{"upper.cells", 12}, {"motion 3 first node", 40}, {"motion 4 first node", 40}}},
      {"bodies.upper.mesh.grading", values({4, 1}), {{"upper.mean", graded_mean(4)}}},
      {"gravity", values({1, -9.81}, "m/s^2"), {{"gravity.x", 1}, {"gravity.y", -9.81}}},
      {"kinematics",
       test::text("axisymmetric"),
       {{"kinematics", 1}, {"joint.area", std::numbers::pi}, {"sole.area", std::numbers::pi}}},
  };
  for (auto const& changed : cases)
    check_case(changed);
}

TEST_CASE("entries of pairs and laws reach the model") {
  using test::text, test::value, test::values;
  for (auto const& changed : std::vector<Case>{
           {"pairs.joint.friction.mu", value(0.7), {{"joint.mu", 0.7}}},
           {"pairs.sole.friction", test::coulomb(0.7), {{"sole.mu", 0.7}}},
           {"pairs.joint.reach", value(20, "mm"), {{"joint.reach", 0.02}}},
           {"pairs.sole.reach", value(20, "mm"), {{"sole.reach", 0.02}}},
           {"pairs.joint.smoothing", text("polyline"), {{"joint.segment nodes", 2}}},
           {"pairs.joint.adhesion.w", value(3, "J/m^2"), {{"joint.w", 3}}},
           {"pairs.joint.adhesion.C_n", value(5, "N/m^3"), {{"joint.C_n", 5}}},
           {"pairs.joint.adhesion.C_t", value(6, "N/m^3"), {{"joint.C_t", 6}}},
           {"pairs.joint.adhesion.b", value(7, "N s/m"), {{"joint.b", 7}}},
           {"pairs.joint.adhesion.beta0", value(0.5), {{"joint.beta0", 0.5}}},
           {"pairs.joint.adhesion.bonding",
            text("proximity"),
            {{"joint.bonding", 1}, {"joint.reach", 20 * std::sqrt(20 / 2e3)}}},
           {"pairs.joint.adhesion.friction", text("damage"), {{"joint.bond friction", 1}}},
           {"pairs.joint.adhesion.damage_power", value(2), {{"joint.power", 2}}},
           {"obstacles.floor.shape.point", values({0, -1.5}, "m"), {{"sole.point.y", -1.5}}},
           {"obstacles.floor.shape.normal", values({0.1, 1}), {{"sole.normal.x", 0.1}}},
       })
    check_case(changed);
}

TEST_CASE("an adhesion that acts from afar widens the reach of its pair") {
  auto table = test::foot_on_floor();
  double const reach = scene::build(table).model->pairs[0].reach;
  test::at(table, "pairs.sole.adhesion") =
      test::make("adhesion.potential", {{"w", test::value(1, "J/m^2")}, {"delta", test::value(reach, "m")}});
  auto const scene = scene::build(table);
  auto const& pair = scene.model->pairs[0];
  CHECK(pair.reach > reach);
  CHECK(pair.reach == doctest::Approx(pair.law.range()));
}

TEST_CASE("an obstacle's path reaches the model") {
  auto table = full_table();
  test::at(table, "obstacles.floor.times") = test::values({0, 2}, "s");
  test::at(table, "obstacles.floor.x") = test::values({0, 3}, "m");
  test::at(table, "obstacles.floor.y") = test::values({0, -5}, "m");
  auto const shot = snapshot(table);
  CHECK(shot.at("sole.offset.x") == 1.5);
  CHECK(shot.at("sole.offset.y") == -2.5);
}

TEST_CASE("entries of motions reach the model") {
  auto table = full_table();
  auto const before = snapshot(table);
  CHECK(before.at("motion 3 value") == doctest::Approx(0.05));
  CHECK(before.at("motion 4 value") == doctest::Approx(-0.01));
  check_case({"motions[2].x", test::values({0, 0, 0.3}, "m"), {{"motion 3 value", 0.15}}});
  check_case({"motions[2].y", test::values({0, 0, -0.04}, "m"), {{"motion 4 value", -0.02}}});
  check_case({"motions[2].times", test::values({0, 1, 3}, "s"), {{"motion 3 value", 0.025}}});
  test::at(table, "motions[1].x") = test::flag(false);
  test::remove(table, "motions[2].y");
  auto const fewer = snapshot(table);
  CHECK(fewer.at("motion 1 component") == 1);
  CHECK(fewer.at("motion 1 first node") == before.at("motion 2 first node"));
  CHECK(fewer.at("motion 2 component") == 0);
  CHECK(fewer.at("motion 2 first node") == before.at("motion 3 first node"));
  CHECK_FALSE(fewer.contains("motion 3 value"));
}

TEST_CASE("entries of scheme, solver, control, schedule and output reach the model") {
  using test::make, test::text, test::value;
  for (auto const& changed : std::vector<Case>{
           {"scheme.theta", value(0.75), {{"theta", 0.75}}},
           {"scheme.xi", value(0.8), {{"xi", 0.8}}},
           {"scheme.contact_weight", value(0.6), {{"contact weight", 0.6}}},
           {"scheme.contact_inertia", text("none"), {{"contact inertia", 2}}},
           {"scheme.contact_inertia", text("full"), {{"contact inertia", 0}}},
           {"solver", make("solver.newton", {{"tolerance", value(1e-7)}}), {{"solver tolerance", 1e-7}}},
           {"solver", make("solver.newton", {{"iterations", value(9)}}), {{"solver iterations", 9}}},
           {"solver",
            make("solver.uzawa", {{"relaxation", value(0.5)}, {"iterations", value(8)}}),
            {{"solver", 1}, {"relaxation", 0.5}, {"solver iterations", 8}}},
           {"solver",
            make("solver.gauss_seidel", {{"iterations", value(7)}}),
            {{"solver", 2}, {"solver iterations", 7}}},
           {"control", make("control", {{"force_tolerance", value(1e-5)}}), {{"force tolerance", 1e-5}}},
           {"control", make("control", {{"iterations", value(11)}}), {{"iterations", 11}}},
           {"schedule.halvings", value(3), {{"halvings", 3}}},
           {"schedule.stages",
            test::list({make("stage", {{"to", value(2000, "ms")}, {"steps", value(5)}})}),
            {{"stages", 1}, {"steps", 5}}},
           {"output", make("output", {{"frames", value(4)}}), {{"frames", 4}}},
           {"output", make("output", {{"problems_every", value(6)}}), {{"problems", 6}}},
       })
    check_case(changed);
}
