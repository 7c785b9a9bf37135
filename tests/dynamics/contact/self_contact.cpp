// A body that touches itself: the arms of a U squeezed together and let go.
#include <numbers>

#include "dynamics/space.hpp"

using namespace stiction;
using test::Vec2;

namespace {

constexpr double arm = 1.5, radius = 0.3, thick = 0.2, squeeze = 0.32; // m; radius: of the U inside

/// Where the strip's point (s, y) goes: down the left arm, around, up the right one, its top inside.
Vec2 bent(double s, double y) {
  double const half = std::numbers::pi * radius, out = radius + thick - y;
  if (s < arm)
    return {-out, arm - s};
  if (s > arm + half)
    return {out, s - arm - half};
  double const angle = std::numbers::pi + (s - arm) / radius;
  return {out * std::cos(angle), out * std::sin(angle)};
}

/// A strip bent without stress into a U; its inside touches itself. The outsides of its arms near their tips
/// go by `squeeze` towards each other in the first second and back in the next: x and y of the left, then of
/// the right are the motions.
scene::Scene letter_u() {
  double const length = 2 * arm + std::numbers::pi * radius;
  auto table = test::make("scene");
  auto const rubber =
      test::make("material.neo_hookean", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
  test::at(table, "bodies.u") = test::block({{0, 0}, {length, thick}, {60, 3}}, rubber);
  test::at(table, "pairs.inside") = test::pair("u.top", "u.top");
  test::at(table, "scheme") = test::quasi_static();
  test::at(table, "motions") = test::list({test::drive("u.left", {0, 1, 2}, {0, squeeze, 0}, {0, 0, 0}),
                                           test::drive("u.right", {0, 1, 2}, {0, -squeeze, 0}, {0, 0, 0})});
  test::at(table, "schedule") = test::schedule({{2, 1}});
  auto scene = scene::build(table);
  auto& model = *scene.model;
  for (Index i = 0; i < model.node_count(); ++i)
    model.reference.row(i) = bent(model.reference(i, 0), model.reference(i, 1)).transpose();
  model.bodies[0]->mesh.nodes = model.reference;
  model.cells.clear();
  model.cells.emplace_back(*model.bodies[0], model.kinematics);
  for (std::size_t side : {0U, 1U}) {
    Indices grip;
    for (Index i = 0; i < model.node_count(); ++i)
      if (model.reference(i, 1) > arm - 0.4 &&
          model.reference(i, 0) * (side == 0 ? -1 : 1) > radius + 0.99 * thick)
        grip.push_back(i);
    model.motions[2 * side].nodes = model.motions[2 * side + 1].nodes = grip;
  }
  auto& pair = model.pairs[0];
  pair.primary = contact::Curve({{pair.secondary, false}}, model.reference, contact::Smoothing::spline);
  return scene;
}

} // namespace

TEST_CASE("the arms of a U squeezed together touch and balance and do not go through each other") {
  auto const scene = letter_u();
  REQUIRE(scene.model->pairs[0].self);
  dynamics::Stepper stepper(*scene.model);
  double first = 0;
  auto const closed =
      test::march(stepper, stepper.initial(), 0.05, 20, [&](test::State const&, test::State const& after) {
        if (first == 0 && !after.reaction.isZero(0))
          first = squeeze * after.t;
      });
  CHECK(first > 0.25); // the arms are 0.3 m from their middle
  CHECK(first < 0.32);
  double reacted = 0;
  Vec2 sum = Vec2::Zero();
  for (Index i = 0; i < scene.model->node_count(); ++i) {
    sum += closed.reaction.segment<2>(2 * i);
    reacted += closed.reaction.segment<2>(2 * i).norm();
  }
  CHECK(reacted > 1);
  CHECK(sum.norm() < 1e-12 * reacted);
  int touching = 0;
  for (auto const& point : closed.contacts[0]) {
    if (point.foot.found())
      CHECK(point.gap > -1e-8);
    touching += point.status != interface::Status::open ? 1 : 0;
  }
  CHECK(touching >= 2);
  auto const left = test::sum_over(scene, closed.drive, scene.model->motions[0].nodes),
             right = test::sum_over(scene, closed.drive, scene.model->motions[2].nodes);
  CHECK((left + right).norm() < 1e-5 * left.norm());
  CHECK(left.x() > 0);

  auto const open = test::march(stepper, closed, 0.05, 20);
  CHECK(open.reaction.isZero(0));
  for (auto const& point : open.contacts[0])
    CHECK(point.status == interface::Status::open);
  CHECK(test::largest(open.u) < 1e-6);
}
