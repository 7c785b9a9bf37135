// Mortar contact of bodies: uniform pressure between any two meshes, in the plane, about an axis and in
// space.
#include <doctest/doctest.h>

#include "dynamics/space.hpp"

using namespace stiction;

namespace {

using Kinds = std::pair<char const*, char const*>; ///< cells of the lower and the upper body

/// Largest deviation of the recovered stress from `axial` along the last axis, all else zero, Pa.
double deviation(scene::Scene const& scene, test::State const& state, double axial) {
  auto const& model = *scene.model;
  int const dim = model.dim();
  double worst = 0;
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    auto const first = ix(dim * model.first_node[b]), count = ix(dim * model.first_node[b + 1]) - first;
    Matrix stress = model.cells[b].stress({state.u.data() + first, count}).cauchy;
    stress.col(dim - 1).array() -= axial;
    if (model.kinematics == solid::Kinematics::plane_strain)
      stress.col(2).setZero();
    worst = std::max(worst, stress.cwiseAbs().maxCoeff());
  }
  return worst;
}

/// Two blocks with 3 and 4 cells across under the pressure 10 Pa of a lid that sinks. Poisson's ratio as
/// given; the sides are free but for what holds the middle.
test::Input stacked(Kinds kinds, double poisson, bool mortar) {
  auto table = test::make("scene");
  auto const material = test::linear_elastic(1000, poisson);
  test::at(table, "bodies.lower") = test::block({{0, -1}, {1, 1}, {3, 2}}, material);
  test::at(table, "bodies.upper") = test::block({{0, 0}, {1, 1}, {4, 2}}, material);
  test::at(table, "bodies.lower.mesh.kind") = test::text(kinds.first);
  test::at(table, "bodies.upper.mesh.kind") = test::text(kinds.second);
  test::at(table, "pairs.joint") = test::pair("upper.bottom", "lower.top");
  if (mortar)
    test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  test::at(table, "motions") =
      test::list({test::fix("lower.bottom", false, true), test::fix("lower.left", true, false),
                  test::fix("upper.left", true, false), test::drive("upper.top", {0, 1}, {}, {0, -0.01})});
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

/// The same in space, 2 cells below 3 across.
test::Input stacked_in_space(Kinds kinds, double poisson, bool mortar) {
  auto table = test::space();
  auto const material = test::linear_elastic(1000, poisson);
  test::at(table, "bodies.lower") = test::box({{0, 0, -1}, {1, 1, 1}, {2, 2, 1}}, material);
  test::at(table, "bodies.upper") = test::box({{0, 0, 0}, {1, 1, 1}, {3, 3, 1}}, material);
  test::at(table, "bodies.lower.mesh.kind") = test::text(kinds.first);
  test::at(table, "bodies.upper.mesh.kind") = test::text(kinds.second);
  test::at(table, "pairs.joint") = test::pair("upper.bottom", "lower.top");
  if (mortar)
    test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  test::at(table, "motions") = test::list({test::fix_in("lower.bottom", "z"), test::fix_in("lower.left", "x"),
                                           test::fix_in("upper.left", "x"), test::fix_in("lower.front", "y"),
                                           test::fix_in("upper.front", "y"),
                                           test::drive("upper.top", {0, 1}, {{{}, {}, {0, -0.01}}})});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  return table;
}

test::State pressed(scene::Scene const& scene) {
  scene.model->control.force_tolerance = 1e-11;
  dynamics::Stepper stepper(*scene.model);
  return test::march(stepper, stepper.initial(), 1, 1);
}

/// Largest deviation from uniform pressure, in parts of it.
double miss(test::Input const& table, double axial) {
  auto const scene = scene::build(table);
  return deviation(scene, pressed(scene), axial) / -axial;
}

} // namespace

TEST_CASE("mortar: uniform pressure passes between meshes that do not match") {
  for (Kinds const& kinds :
       std::vector<Kinds>{{"quad4", "quad4"}, {"quad8", "quad8"}, {"tri6", "quad4"}, {"tri3", "tri6"}})
    for (double const poisson : {0.0, 0.3}) {
      INFO(std::string(kinds.first), " ", std::string(kinds.second), " nu ", poisson);
      double const axial = -1000 * 0.01 / 2 / (1 - poisson * poisson);
      CHECK(miss(stacked(kinds, poisson, true), axial) < 1e-10);
      CHECK(miss(stacked(kinds, poisson, false), axial) > 0.01);
    }
}

TEST_CASE("mortar: in space uniform pressure passes between meshes that do not match") {
  for (Kinds const& kinds : std::vector<Kinds>{
           {"hex8", "hex8"}, {"hex8", "tet4"}, {"tet10", "hex8"}, {"hex20", "tet10"}, {"hex8", "hex20"}})
    for (double const poisson : {0.0, 0.3}) {
      INFO(std::string(kinds.first), " ", std::string(kinds.second), " nu ", poisson);
      double const axial = -1000 * 0.01 / 2;
      CHECK(miss(stacked_in_space(kinds, poisson, true), axial) < 1e-10);
      CHECK(miss(stacked_in_space(kinds, poisson, false), axial) > 0.005);
    }
}
