// The loss of every scheme by its own formulas, and the ledger closed with it.
#include "dynamics/all_schemes.hpp"

#include <numbers>

using namespace stiction;
using test::SchemeSample;

namespace {

struct Setup {
  test::Input material = test::linear_elastic(1, 0);
  bool contact = false;
  double viscosity = 0; ///< Pa s
};

/// A bar of four cells, E = rho = 1, whose left end is driven back and forth; it meets a wall near its right
/// end and rubs there, since the wall slides.
scene::Scene driven_bar(SchemeSample const& sample, Setup const& setup) {
  auto table = test::make("scene");
  test::at(table, "bodies.bar") = test::block({{0, 0}, {1, 0.25}, {4, 1}}, setup.material);
  if (setup.viscosity > 0)
    test::at(table, "bodies.bar.damping") =
        test::make("damping.kelvin_voigt", {{"shear_viscosity", test::value(setup.viscosity, "Pa s")}});
  test::at(table, "obstacles.wall.shape") =
      test::make("rigid.plane", {{"point", test::values({setup.contact ? 1.02 : 10, 0}, "m")},
                                 {"normal", test::values({-1, 0})}});
  test::at(table, "obstacles.wall.times") = test::values({0, 10}, "s");
  test::at(table, "obstacles.wall.y") = test::values({0, 1}, "m");
  test::at(table, "pairs.end") = test::pair("bar.right", "wall");
  test::at(table, "pairs.end.friction") = test::coulomb(0.3);
  test::at(table, "motions") =
      test::list({test::drive("bar.left", {0, 0.5, 1.5, 3}, {0, 0.05, -0.03, 0.1}, {0, 0, 0, 0})});
  test::at(table, "schedule") = test::schedule({{1, 1}});
  test::at(table, "scheme") = sample.table;
  auto made = scene::build(table);
  made.model->control.force_tolerance = 1e-13;
  made.model->audited = true;
  for (Index i = 0; i < made.model->node_count(); ++i)
    made.model->velocity(i, 0) = 0.1 + 0.1 * std::sin(std::numbers::pi / 2 * made.model->reference(i, 0));
  return made;
}

test::Input rubber() {
  return test::make("material.neo_hookean", {{"young", test::value(1, "Pa")}, {"poisson", test::value(0.2)}});
}

struct Open {
  double most = 0, term = 0, lost = 0; ///< left open, largest term, largest predicted loss, J/m
};

Open swung(scene::Scene const& scene, int steps, double time) {
  dynamics::Stepper stepper(*scene.model);
  Open open;
  test::march(
      stepper, stepper.initial(), time / steps, steps, [&](test::State const&, test::State const& state) {
        auto const& l = state.ledger;
        open.most = std::max(open.most, std::abs(l.unaccounted()));
        open.term = std::max({open.term, l.kinetic, l.strain, std::abs(l.motion_work), l.friction_loss});
        open.lost = std::max(open.lost, std::abs(l.predicted.sum()));
      });
  return open;
}

/// Loss of kinetic and strain energy over a step without contact, from the state's own rates and the
/// coefficients of the sample: what the papers' formulas come to.
double quadratic_loss(SchemeSample const& s, test::Stepper& stepper, test::State const& old,
                      test::State const& next) {
  double const dt = next.t - old.t;
  Vector const d = next.u - old.u, dv = next.v - old.v;
  Vector Mdv, Kd;
  stepper.bulk().mass().times(dv, Mdv);
  static_cast<void>(stepper.bulk().internal_force(d, Kd));
  if (s.theta > 0)
    return (s.theta - 0.5) * dv.dot(Mdv) + (s.xi - 0.5) * d.dot(Kd);
  Vector const da = next.a - old.a;
  Vector Mda;
  stepper.bulk().mass().times(da, Mda);
  return dt * (s.beta - 0.5 * s.gamma) * da.dot(Mdv) + (0.5 - s.alpha_f) * d.dot(Kd) -
         (s.alpha_m + s.gamma - 1) * d.dot(Mda);
}

} // namespace

TEST_CASE("every linear scheme loses what its quadratic formula says, and predicts it") {
  for (auto const& sample : test::scheme_samples()) {
    if (!sample.closed_rates)
      continue;
    INFO(sample.label);
    auto const scene = driven_bar(sample, {});
    for (auto& motion : scene.model->motions)
      motion.path = {};
    scene.model->velocity.setZero();
    for (Index i = 0; i < scene.model->node_count(); ++i)
      scene.model->velocity(i, 0) = std::sin(std::numbers::pi / 2 * scene.model->reference(i, 0));
    dynamics::Stepper stepper(*scene.model);
    auto const start = stepper.initial();
    double lost = 0;
    auto const end =
        test::march(stepper, start, 0.15, 30, [&](test::State const& old, test::State const& next) {
          lost += quadratic_loss(sample, stepper, old, next);
        });
    CHECK(start.ledger.start > 0.05);
    CHECK(std::abs(end.ledger.scheme_loss() - lost) < 1e-10 * start.ledger.start);
    CHECK(std::abs(end.ledger.predicted.sum() - lost) < 1e-10 * start.ledger.start);
  }
}

TEST_CASE("every scheme: the ledger of a driven bar that hits and rubs a sliding wall closes to rounding") {
  for (auto const& sample : test::scheme_samples()) {
    INFO(sample.label);
    auto const open = swung(driven_bar(sample, {test::linear_elastic(1, 0), true}), 100, 2.5);
    CHECK(open.lost > 1e-4 * open.term);
    CHECK(open.most < 1e-9 * open.term);
  }
}

TEST_CASE(
    "every scheme: the ledger of a bar whose end is led along the wall that it hits closes to rounding") {
  for (auto const& sample : test::scheme_samples()) {
    INFO(sample.label);
    auto const scene = driven_bar(sample, {test::linear_elastic(1, 0), true});
    auto& model = *scene.model;
    auto const led = test::nodes_of(scene, "bar.right");
    model.motions.push_back({led, 1, {{0, 3}, {0, -0.03}}});
    for (Index const node : led)
      model.velocity(node, 1) = -0.01;
    auto const open = swung(scene, 100, 2.5);
    CHECK(open.most < 1e-9 * open.term);
  }
}

TEST_CASE("every scheme: the ledger of a bar whose load comes and goes closes to rounding") {
  for (auto const& sample : test::scheme_samples()) {
    INFO(sample.label);
    auto const scene = driven_bar(sample, {});
    auto& model = *scene.model;
    Vector force = Vector::Zero(model.dofs());
    for (Index const node : test::nodes_of(scene, "bar.right"))
      force[2 * node] = 1;
    model.loads.push_back({force, {{0, 0.7, 1.5, 3}, {0, 0.02, -0.01, 0.03}}});
    dynamics::Stepper stepper(model);
    auto const end = test::march(stepper, stepper.initial(), 0.025, 100);
    auto const& l = end.ledger;
    double const term = std::max({l.kinetic, l.strain, std::abs(l.motion_work)});
    CHECK(std::abs(l.load_work) > 1e-3 * term);
    CHECK(std::abs(l.unaccounted()) < 1e-9 * term);
  }
}

TEST_CASE("every scheme: what the ledger of a rubber bar leaves open is of sixth order") {
  for (auto const& sample : test::scheme_samples()) {
    if (sample.order == 0) // nothing strains it
      continue;
    INFO(sample.label);
    std::array<double, 3> open{};
    for (std::size_t k = 0; k < 3; ++k) {
      auto const swing = swung(driven_bar(sample, {rubber()}), 40 << k, 1.5);
      open[k] = swing.most / swing.term;
    }
    INFO(open[0] << " " << open[1] << " " << open[2]);
    CHECK(open[0] < 1e-9);
    CHECK((open[1] < 1e-12 || std::log2(open[0] / open[1]) > 5.5));
  }
}

TEST_CASE("a heavy viscous bar: the ledger closes, and no term of it is too small to be missed") {
  for (auto const& sample : test::scheme_samples()) {
    if (!sample.closed_rates)
      continue;
    INFO(sample.label);
    auto scene = driven_bar(sample, {test::linear_elastic(1, 0), true, 0.05});
    scene.model->gravity = {0.01, -0.02, 0};
    dynamics::Stepper stepper(*scene.model);
    auto const end = test::march(stepper, stepper.initial(), 0.025, 80);
    auto const& l = end.ledger;
    double const scale = l.kinetic + l.strain + std::abs(l.motion_work);
    CHECK(std::abs(l.unaccounted()) < 1e-9 * scale);
    for (double const term :
         {l.kinetic, l.strain, l.potential, l.motion_work, l.friction_loss, l.damping_loss})
      CHECK(std::abs(term) > 1e-5 * scale);
  }
}

TEST_CASE("mortar: a block rubbed off the end of another closes its ledger while the areas shrink") {
  auto table = test::two_blocks();
  test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  test::at(table, "motions") = test::list(
      {test::fix("lower.bottom"), test::drive("upper.top", {0, 1, 2}, {0, 0, 0.6}, {0, -0.01, -0.01})});
  test::at(table, "scheme") = test::make("scheme.theta_xi", test::cure("none")); // means of both ends' forces
  test::at(table, "schedule") = test::schedule({{1, 50}, {2, 200}});
  auto made = scene::build(table);
  made.model->control.force_tolerance = 1e-8;
  made.model->audited = true;
  dynamics::Stepper stepper(*made.model);
  double at_stake = 0, most = 0; // J/m: friction's part of changes of area
  auto const end = test::march(
      stepper, stepper.initial(), 0.01, 180, [&](test::State const& old, test::State const& next) {
        for (std::size_t i = 0; i < next.contacts[0].size(); ++i) {
          auto const &before = old.contacts[0][i], &after = next.contacts[0][i];
          at_stake += std::abs(0.5 * (after.area - before.area) * before.dry[1] * after.slip[0]);
        }
        most = std::max(most, std::abs(next.ledger.unaccounted()));
      });
  double const scale = end.ledger.motion_work;
  CHECK(at_stake > 1e-4 * scale);
  CHECK(most < 1e-6 * scale);
}

TEST_CASE("bonds that slide past an open end are let go, and the ledger closes") {
  auto table = test::two_blocks();
  test::at(table, "pairs.joint.adhesion") = test::rcc(1, 50, 10);
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  test::at(table, "motions") = test::list(
      {test::fix("lower.bottom"), test::drive("upper.top", {0, 1, 2}, {0, 0, 0.6}, {0, -0.01, -0.01})});
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  test::at(table, "schedule") = test::schedule({{1, 50}, {2, 200}});
  auto made = scene::build(table);
  made.model->control.force_tolerance = 1e-13;
  made.model->audited = true;
  dynamics::Stepper stepper(*made.model);
  int gone = 0;
  double held = 0, most = 0; // J/m
  auto const end = test::march(stepper, stepper.initial(), 0.01, 200,
                               [&](test::State const& old, test::State const& next) {
                                 for (std::size_t i = 0; i < next.contacts[0].size(); ++i)
                                   if (old.contacts[0][i].foot.found() && !next.contacts[0][i].foot.found()) {
                                     ++gone;
                                     held += std::abs(next.ledger.bond - old.ledger.bond);
                                   }
                                 most = std::max(most, std::abs(next.ledger.unaccounted()));
                               });
  double const scale = end.ledger.motion_work;
  CHECK(gone >= 2);
  CHECK(held > 1e-3 * scale);
  CHECK(most < 1e-9 * scale);
}
