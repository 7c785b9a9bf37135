// What a scene does not declare costs nothing and changes nothing: components per point, mass, damping.
#include "dynamics/space.hpp"

using namespace stiction;

namespace {

/// The scene marched with one component per contact point as it stands, and with all components, which a
/// friction of 1e-300 asks for; both must agree.
void compare(test::Input const& table, int all_components, int steps) {
  auto full_table = table;
  test::at(full_table, "pairs.joint.friction") = test::coulomb(1e-300);
  auto const lean = scene::build(table), full = scene::build(full_table);
  for (auto const* scene : {&lean, &full})
    scene->model->control.force_tolerance = 1e-9;
  dynamics::Stepper one(*lean.model), all(*full.model);
  auto const a = test::march(one, one.initial(), 2.0 / steps, steps);
  auto const b = test::march(all, all.initial(), 2.0 / steps, steps);
  CHECK(one.contact().problem().dim == 1);
  CHECK(all.contact().problem().dim == all_components);
  CHECK(one.contact().problem().W.rows() == one.contact().problem().size());
  CHECK(all.contact().problem().W.rows() == all_components * all.contact().problem().size());
  double const force = test::contact_on(lean, a).norm();
  CHECK(force > 0.1);
  CHECK(test::largest(a.u - b.u) < 1e-9);
  CHECK(test::largest(a.reaction - b.reaction) < 1e-7 * force);
  CHECK(a.ledger.bond == doctest::Approx(b.ledger.bond).epsilon(1e-8));
  CHECK(a.ledger.bonding_loss == doctest::Approx(b.ledger.bonding_loss).epsilon(1e-8));
  CHECK(a.ledger.strain == doctest::Approx(b.ledger.strain).epsilon(1e-8));
  double moved = 0;
  for (std::size_t i = 0; i < a.contacts[0].size(); ++i) {
    auto const &x = a.contacts[0][i], &y = b.contacts[0][i];
    CHECK(x.gap == doctest::Approx(y.gap).epsilon(1e-8));
    CHECK((x.path - y.path).norm() < 1e-9); // slip is followed though nothing resists it
    CHECK(x.bond.beta == doctest::Approx(y.bond.beta).epsilon(1e-9));
    CHECK((x.dry - y.dry).norm() < 1e-6 * force);
    CHECK(x.dry.tail<2>().isZero(0));
    CHECK((x.status == interface::Status::open) == (y.status == interface::Status::open));
    moved = std::max(moved, x.path.norm());
  }
  CHECK(moved > 0.01);
}

/// Two blocks, the upper one narrower; in the plane, or cubes in space.
test::Input narrow_on_wide(bool in_space) {
  auto const material =
      test::make("material.neo_hookean", {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
  auto table = in_space ? test::space() : test::two_blocks();
  if (in_space) {
    test::at(table, "bodies.lower") = test::box({{0, 0, -1}, {1, 1, 1}, {3, 3, 2}}, material);
    test::at(table, "bodies.upper") = test::box({{0.1, 0.2, 0}, {0.7, 0.6, 1}, {2, 2, 2}}, material);
    test::at(table, "motions") =
        test::list({test::fix_in("lower.bottom", "xyz"),
                    test::drive("upper.top", {0, 1, 2}, {{{0, 0, 0.05}, {0, 0, 0.02}, {0, -0.03, -0.02}}})});
  } else {
    test::at(table, "bodies.lower.material") = material;
    test::at(table, "bodies.upper") = test::block({{0.12, 0}, {0.7, 1}, {3, 4}}, material);
  }
  test::at(table, "pairs.joint") = test::pair("upper.bottom", "lower.top");
  return table;
}

test::Input normal_only() {
  auto law = test::rcc(0.5, 200, 1);
  test::at(law, "C_t") = test::value(0, "N/m^3");
  return law;
}

} // namespace

TEST_CASE("one component per point does what all components do where nothing acts along the surface") {
  for (bool const in_space : {false, true})
    for (bool const dynamic : {false, true}) {
      auto table = narrow_on_wide(in_space);
      if (dynamic)
        test::at(table, "scheme") = test::theta_xi(0.6, 0.6);
      CAPTURE(in_space);
      CAPTURE(dynamic);
      compare(table, in_space ? 3 : 2, 20);
      test::at(table, "pairs.joint.adhesion") = normal_only();
      compare(table, in_space ? 3 : 2, 20);
    }
}

TEST_CASE("one component per point pulls a normal bond open as all components do") {
  for (bool const in_space : {false, true}) {
    auto table = narrow_on_wide(in_space);
    test::at(table, "pairs.joint.adhesion") = normal_only();
    test::at(table, "pairs.joint.adhesion.beta0") = test::value(1);
    std::vector<double> const lift{0, 0.02, 0.04};
    test::at(table, "motions[2]") =
        in_space ? test::drive("upper.top", {0, 1, 2}, {{{0, 0, 0.05}, {0, 0, 0.02}, lift}})
                 : test::drive("upper.top", {0, 1, 2}, {0, 0, 0.05}, lift);
    compare(table, in_space ? 3 : 2, 20);
  }
}

TEST_CASE("all contact solvers answer problems of one component") {
  auto table = narrow_on_wide(true);
  test::at(table, "pairs.joint.adhesion") = normal_only();
  std::vector<Vector> answers;
  for (contact::SolverChoice const& solver :
       {contact::SolverChoice(contact::BipotentialNewton{}),
        contact::SolverChoice(contact::BipotentialUzawa{}), contact::SolverChoice(contact::GaussSeidel{})}) {
    auto const scene = scene::build(table);
    scene.model->solver = solver;
    dynamics::Stepper stepper(*scene.model);
    answers.push_back(test::march(stepper, stepper.initial(), 0.2, 5).u);
  }
  CHECK(test::largest(answers[1] - answers[0]) < 1e-6);
  CHECK(test::largest(answers[2] - answers[0]) < 1e-6);
}

TEST_CASE("a quasi-static scene without loads holds no mass and one without damping no viscous forces") {
  auto table = narrow_on_wide(true);
  auto const still = scene::build(table);
  dynamics::Stepper lean(*still.model);
  CHECK(lean.bulk().mass().values.empty());
  CHECK_FALSE(lean.bulk().damped());
  auto const state = test::march(lean, lean.initial(), 0.1, 2);
  CHECK(state.damping.size() == 0);
  CHECK(state.ledger.kinetic == 0);
  test::at(table, "scheme") = test::theta_xi(1, 1);
  auto const moving = scene::build(table);
  dynamics::Stepper stepper(*moving.model);
  CHECK_FALSE(stepper.bulk().mass().values.empty());
  CHECK(test::march(stepper, stepper.initial(), 0.1, 2).damping.size() == 0);
  test::at(table, "bodies.upper.damping") =
      test::make("damping.kelvin_voigt", {{"shear_viscosity", test::value(3, "Pa s")}});
  auto const viscous = scene::build(table);
  dynamics::Stepper damped(*viscous.model);
  CHECK(damped.bulk().damped());
  CHECK(test::march(damped, damped.initial(), 0.1, 2).damping.size() == viscous.model->dofs());
}
