// A body that touches itself: the arms of a U squeezed together, let go, and rubbed on each other.
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

constexpr double length = 2 * arm + std::numbers::pi * radius;

/// Nodes of the strip moved to where they are in the U, and the nodes that each arm is gripped by, the left
/// one's first: its outside near the tip. `up`: the coordinate that was y of the strip.
std::array<Indices, 2> bend(scene::Scene& scene, Index up) {
  auto& model = *scene.model;
  std::array<Indices, 2> grips;
  for (Index i = 0; i < model.node_count(); ++i) {
    Vec2 const at = bent(model.reference(i, 0), model.reference(i, up));
    model.reference(i, 0) = at.x();
    model.reference(i, up) = at.y();
    if (at.y() > arm - 0.4 && std::abs(at.x()) > radius + 0.99 * thick)
      grips[at.x() < 0 ? 0 : 1].push_back(i);
  }
  model.bodies[0]->mesh.nodes = model.reference;
  model.cells.clear();
  model.cells.emplace_back(*model.bodies[0], model.kinematics);
  return grips;
}

test::Input rubber() {
  return test::make("material.neo_hookean",
                    {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
}

/// A strip bent without stress into a U; its inside touches itself. The outsides of its arms near their tips
/// go by `squeeze` towards each other in the first second and back in the next, or with friction the right
/// one down by `slid` then: x and y of the left, then of the right are the motions.
scene::Scene letter_u(double mu = 0, double slid = 0) {
  auto table = test::make("scene");
  test::at(table, "bodies.u") = test::block({{0, 0}, {length, thick}, {60, 3}}, rubber());
  test::at(table, "pairs.inside") = test::pair("u.top", "u.top");
  if (mu > 0)
    test::at(table, "pairs.inside.friction") = test::coulomb(mu);
  test::at(table, "scheme") = test::quasi_static();
  double const back = mu > 0 ? squeeze : 0;
  test::at(table, "motions") =
      test::list({test::drive("u.left", {0, 1, 2}, {0, squeeze, back}, {0, 0, 0}),
                  test::drive("u.right", {0, 1, 2}, {0, -squeeze, -back}, {0, 0, -slid})});
  test::at(table, "schedule") = test::schedule({{2, 1}});
  auto scene = scene::build(table);
  auto& model = *scene.model;
  auto const grips = bend(scene, 1);
  for (std::size_t m = 0; m < 4; ++m)
    model.motions[m].nodes = grips[m / 2];
  auto& pair = model.pairs[0];
  pair.primary = contact::Curve({{pair.secondary, false}}, model.reference, contact::Smoothing::spline);
  return scene;
}

/// The pair as one of two surfaces: points on the right arm, facets on the left one.
void split(scene::Scene& scene, std::vector<mesh::Facet>& facets) {
  auto const& at = scene.model->reference;
  auto& pair = scene.model->pairs[0];
  pair.self = false;
  std::erase_if(facets, [&](auto const& facet) {
    return std::any_of(facet.nodes.begin(), facet.nodes.end(), [&](Index n) { return at(n, 0) > -0.29; });
  });
  auto const all = std::exchange(pair.secondary, {});
  auto const areas = std::exchange(pair.areas, {});
  for (std::size_t i = 0; i < all.size(); ++i)
    if (at(all[i], 0) > 0.29) {
      pair.secondary.push_back(all[i]);
      pair.areas.push_back(areas[i]);
    }
}

/// The same in space, 0.5 m deep; the motions are x, y, z of the left arm, then of the right.
scene::Scene deep_u(double mu, bool itself = true) {
  auto table = test::space();
  test::at(table, "bodies.u") = test::box({{0, 0, 0}, {length, 0.5, thick}, {60, 3, 2}}, rubber());
  test::at(table, "pairs.inside") = test::pair("u.top", "u.top");
  if (mu > 0)
    test::at(table, "pairs.inside.friction") = test::coulomb(mu);
  test::at(table, "motions") =
      test::list({test::drive("u.left", {0, 1, 2}, {{{0, squeeze, squeeze}, {0, 0, 0}, {0, 0, 0}}}),
                  test::drive("u.right", {0, 1, 2}, {{{0, -squeeze, -squeeze}, {0, 0, 0}, {0, 0, -0.1}}})});
  auto scene = scene::build(table);
  auto& model = *scene.model;
  auto facets = model.bodies[0]->mesh.sets.at("top").facets;
  auto const grips = bend(scene, 2);
  for (std::size_t m = 0; m < 6; ++m)
    model.motions[m].nodes = grips[m / 3];
  if (!itself)
    split(scene, facets);
  model.pairs[0].primary = contact::Surface(facets, model.reference, {0, 1, 0});
  return scene;
}

/// Sum of nodal forces, and of their sizes.
struct Totals {
  contact::Vec3 sum = contact::Vec3::Zero();
  double sizes = 0;
};
Totals totals(scene::Scene const& scene, Vector const& force) {
  Totals all;
  Index const dim = scene.model->dim();
  for (Index i = 0; i < scene.model->node_count(); ++i) {
    all.sum.head(dim) += force.segment(dim * i, dim);
    all.sizes += force.segment(dim * i, dim).norm();
  }
  return all;
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
  auto const [sum, reacted] = totals(scene, closed.reaction);
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

TEST_CASE("arms of a U that rub on each other: balance, and what friction takes") {
  auto const scene = letter_u(0.3, 0.2);
  dynamics::Stepper stepper(*scene.model);
  auto const pressed = test::march(stepper, stepper.initial(), 0.05, 20);
  auto const lost = [&](int steps) { // within the second in which they rub
    auto const after = test::march(stepper, pressed, 1.0 / steps, steps);
    return after.ledger.scheme_loss() - pressed.ledger.scheme_loss();
  };
  auto const rubbed = test::march(stepper, pressed, 0.02, 50);
  double moment = 0, normal = 0, sheared = 0;
  int slipping = 0;
  for (Index i = 0; i < scene.model->node_count(); ++i) {
    Vec2 const f = rubbed.reaction.segment<2>(2 * i),
               at = scene.model->reference.row(i).transpose() + rubbed.u.segment<2>(2 * i);
    moment += at.x() * f.y() - at.y() * f.x();
    normal += std::abs(f.x());
    sheared += std::abs(f.y());
  }
  for (auto const& point : rubbed.contacts[0])
    slipping += point.status == interface::Status::slip ? 1 : 0;
  CHECK(slipping >= 2);
  CHECK(totals(scene, rubbed.reaction).sum.norm() < 1e-12 * normal);
  CHECK(std::abs(moment) < 1e-9 * normal);
  CHECK(sheared > 0.1 * normal);
  CHECK(rubbed.ledger.friction_loss > 0);
  double const coarse = lost(50), fine = lost(100);
  CHECK(fine < 0.01 * rubbed.ledger.friction_loss);
  CHECK(fine / coarse == doctest::Approx(0.5).epsilon(0.1)); // the order of the scheme
}

TEST_CASE("in space a body touches itself too, without and with friction") {
  for (double const mu : {0.0, 0.3}) {
    CAPTURE(mu);
    auto const scene = deep_u(mu);
    REQUIRE(scene.model->pairs[0].self);
    dynamics::Stepper stepper(*scene.model);
    auto const closed = test::march(stepper, stepper.initial(), 0.05, 20);
    auto const rubbed = mu > 0 ? test::march(stepper, closed, 0.05, 20) : closed;
    auto const [sum, reacted] = totals(scene, rubbed.reaction);
    CHECK(reacted > 1);
    CHECK(sum.norm() < 1e-12 * reacted);
    CHECK(test::moment(scene, rubbed, rubbed.reaction).norm() < 1e-9 * reacted);
    int touching = 0;
    for (auto const& point : rubbed.contacts[0]) {
      if (point.foot.found())
        CHECK(point.gap > -1e-8);
      touching += point.status != interface::Status::open ? 1 : 0;
    }
    CHECK(touching >= 4);
    CHECK((mu > 0) == (rubbed.ledger.friction_loss > 0));
  }
}

TEST_CASE("a surface that touches itself bears what its two parts bear on each other") {
  std::array<dynamics::State, 2> states;
  for (bool const itself : {true, false}) {
    auto const scene = deep_u(0.3, itself);
    dynamics::Stepper stepper(*scene.model);
    states[itself ? 0 : 1] = test::march(stepper, stepper.initial(), 0.05, 30);
  }
  auto const &own = states[0], &two = states[1];
  CHECK(test::largest(two.reaction) > 1);
  CHECK(test::largest(own.reaction - two.reaction) < 1e-6 * test::largest(two.reaction));
  CHECK(own.ledger.friction_loss == doctest::Approx(two.ledger.friction_loss).epsilon(1e-6));
}
