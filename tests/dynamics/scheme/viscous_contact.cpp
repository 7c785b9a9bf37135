// Viscous bodies with contact nodes that have rates of their own: the tangent is that of the balance.
#include "dynamics/space.hpp"

using namespace stiction;

namespace {

test::Input viscous(double shear, double bulk) {
  return test::make("damping.kelvin_voigt", {{"shear_viscosity", test::value(shear, "Pa s")},
                                             {"bulk_viscosity", test::value(bulk, "Pa s")}});
}

std::vector<test::Input> schemes() {
  std::vector<test::Input> all;
  for (char const* inertia : {"full", "implicit", "none"}) {
    for (auto const& [theta, xi] : {std::pair{0.5, 0.5}, {0.5, 1.0}, {0.7, 0.6}, {1.0, 1.0}}) {
      all.push_back(test::theta_xi(theta, xi));
      test::at(all.back(), "contact_inertia") = test::text(inertia);
    }
    for (char const* name : {"newmark", "generalised_alpha", "hht"})
      all.push_back(test::make(std::string("scheme.") + name, {{"contact_inertia", test::text(inertia)}}));
  }
  all.push_back(test::make("scheme.moreau_jean"));
  return all;
}

/// A viscous body that flies towards a floor out of reach; nothing in it is nonlinear.
test::Input flying(std::string const& kind) {
  bool const in_space = kind == "hex8";
  auto const material = test::linear_elastic(1000, 0.3);
  auto table = in_space ? test::space() : test::make("scene");
  test::at(table, "bodies.foot") = in_space ? test::box({{0, 0, 9}, {1, 1, 1}, {2, 2, 2}}, material)
                                            : test::block({{0, 9}, {1, 1}, {3, 2}}, material);
  if (!in_space)
    test::at(table, "bodies.foot.mesh.kind") = test::text(kind);
  test::at(table, "obstacles.floor") = test::floor();
  test::at(table, "pairs.sole") = test::pair("foot.bottom", "floor");
  test::at(table, "schedule") = test::schedule({{1, 10}});
  return table;
}

/// Largest number of iterations of a step.
int most_iterations(scene::Scene const& scene, double dt, int steps) {
  dynamics::Stepper stepper(*scene.model);
  auto state = stepper.initial();
  int most = 0;
  for (int k = 0; k < steps; ++k) {
    auto outcome = stepper.step(state, dt);
    INFO("step ", k + 1, ": ", outcome.reason);
    REQUIRE(outcome.converged());
    most = std::max(most, outcome.iterations);
    state = std::move(outcome.state);
  }
  return most;
}

/// A viscous foot on a floor that rises against it: frictional, bonded.
test::Input pressed(bool in_space, test::Input const& material, double shear) {
  auto table = in_space ? test::cube_on_floor() : test::foot_on_floor();
  test::at(table, "bodies.foot.material") = material;
  test::at(table, "bodies.foot.damping") = viscous(shear, 0.5 * shear);
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "obstacles.floor.times") = test::values({0, 2}, "s");
  test::at(table, "obstacles.floor.x") = test::values({0, 0.04}, "m");
  test::at(table, in_space ? "obstacles.floor.z" : "obstacles.floor.y") = test::values({0, 0.1}, "m");
  test::at(table, "motions") =
      test::list({in_space ? test::fix_in("foot.top", "xyz") : test::fix("foot.top")});
  return table;
}

test::Input neo_hookean() {
  return test::make("material.neo_hookean",
                    {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
}

} // namespace

TEST_CASE("a viscous linear body takes one iteration whatever the scheme and the inertia of contact nodes") {
  for (std::string const kind : {"quad4", "quad8", "hex8"})
    for (auto const& scheme : schemes())
      for (auto const& [shear, bulk] : {std::pair{3.0, 0.0}, {0.0, 300.0}, {1e5, 1e3}}) {
        auto table = flying(kind);
        test::at(table, "scheme") = scheme;
        test::at(table, "bodies.foot.damping") = viscous(shear, bulk);
        auto const scene = scene::build(table);
        auto& model = *scene.model;
        CAPTURE(kind);
        CAPTURE(scheme.tag);
        CAPTURE(shear);
        for (Index i = 0; i < model.velocity.rows(); ++i)
          for (int c = 0; c < model.dim(); ++c)
            model.velocity(i, c) = 1e-3 * std::sin(7.0 * i + 3.0 * c);
        model.control.force_tolerance = 1e-9;
        model.control.iterations = 1;
        dynamics::Stepper stepper(model);
        auto state = stepper.initial();
        for (int k = 0; k < 3; ++k) {
          auto const outcome = stepper.step(state, 0.01);
          INFO(outcome.reason);
          // the ledger may refuse the step of a stiff viscosity, but it was made, from the rates and from
          // rest
          bool const refused = outcome.verdict == dynamics::StepVerdict::unstable;
          CHECK((outcome.converged() || refused));
          CHECK(outcome.iterations == (refused ? 2 : 1));
          state = outcome.state;
        }
      }
}

TEST_CASE("viscous feet on a rising floor take few iterations with all rates of contact nodes") {
  for (bool const in_space : {false, true})
    for (char const* inertia : {"full", "implicit", "none"})
      for (double const shear : {1.0, 1e2, 1e4}) {
        auto table = pressed(in_space, test::linear_elastic(1000, 0.2), shear);
        test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
        test::at(table, "scheme.contact_inertia") = test::text(inertia);
        CAPTURE(in_space);
        CAPTURE(inertia);
        CAPTURE(shear);
        auto const scene = scene::build(table);
        scene.model->control.force_tolerance = 1e-9;
        CHECK(most_iterations(scene, 0.05, 20) <= 4);
      }
}

TEST_CASE("of finite strain the tangent leaves out what goes with the strain of one step") {
  for (char const* inertia : {"full", "implicit", "none"})
    for (double const dt : {0.05, 0.0125}) {
      auto table = pressed(false, neo_hookean(), 1e4);
      test::at(table, "scheme") = test::theta_xi(0.5, 0.5);
      test::at(table, "scheme.contact_inertia") = test::text(inertia);
      auto const scene = scene::build(table);
      CAPTURE(inertia);
      CAPTURE(dt);
      auto& control = scene.model->control;
      control.force_tolerance = 1e-14;
      std::vector<double> left;
      for (control.iterations = 2; control.iterations <= 4; ++control.iterations) {
        dynamics::Stepper stepper(*scene.model);
        left.push_back(stepper.step(stepper.initial(), dt).out_of_balance);
      }
      for (std::size_t k = 1; k < left.size(); ++k)
        CHECK(left[k] < std::max((dt > 0.02 ? 0.02 : 0.005) * left[k - 1], 1e-12));
    }
}
