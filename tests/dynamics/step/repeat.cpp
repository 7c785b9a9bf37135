// A step depends on the state and the step size alone: attempts that were thrown away leave nothing behind.
#include "dynamics/space.hpp"

using namespace stiction;

namespace {

test::Input neo_hookean() {
  return test::make("material.neo_hookean",
                    {{"young", test::value(1000, "Pa")}, {"poisson", test::value(0.3)}});
}

/// A rubber foot, bonded and frictional, pressed on a floor and dragged.
test::Input dragged(test::Input scheme, bool mortar = false) {
  auto table = test::two_blocks();
  for (char const* body : {"lower", "upper"})
    test::at(table, std::string("bodies.") + body + ".material") = neo_hookean();
  test::at(table, "bodies.upper.mesh.cells") = test::values({5, 4});
  test::at(table, "pairs.joint.friction") = test::coulomb(0.3);
  test::at(table, "pairs.joint.adhesion") = test::rcc(0.1, 1e4, 0.1);
  if (mortar)
    test::at(table, "pairs.joint.discretisation") = test::text("mortar");
  test::at(table, "scheme") = std::move(scheme);
  return table;
}

test::Input cube() {
  auto table = test::cube_on_floor();
  test::at(table, "bodies.foot.material") = neo_hookean();
  test::at(table, "pairs.sole.friction") = test::coulomb(0.3);
  test::at(table, "motions") =
      test::list({test::drive("foot.top", {0, 1, 2}, {{{0, 0, 0.2}, {0, 0, 0.1}, {0, -0.1, -0.1}}})});
  return table;
}

/// A foot that falls onto an adhesive floor within its first steps.
test::Input landing() {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot.mesh.origin") = test::values({0, 0.01}, "m");
  test::at(table, "bodies.foot.velocity") = test::values({0, -1}, "m/s");
  test::at(table, "pairs.sole.adhesion") = test::rcc(0.1, 1e4, 0.1);
  test::at(table, "motions") = test::list({});
  test::at(table, "scheme") = test::make("scheme.theta_xi");
  return table;
}

std::vector<std::pair<std::string, test::Input>> scenes() {
  std::vector<std::pair<std::string, test::Input>> all;
  all.emplace_back("quasi-static", dragged(test::quasi_static()));
  all.emplace_back("default", dragged(test::make("scheme.theta_xi")));
  all.emplace_back("newmark", dragged(test::make("scheme.newmark")));
  all.emplace_back("impulses", dragged(test::make("scheme.moreau_jean")));
  all.emplace_back("mortar", dragged(test::quasi_static(), true));
  all.emplace_back("cube", cube());
  all.emplace_back("landing", landing());
  all.emplace_back("viscous", dragged(test::make("scheme.theta_xi")));
  test::at(all.back().second, "bodies.upper.damping") =
      test::make("damping.kelvin_voigt", {{"shear_viscosity", test::value(10, "Pa s")}});
  all.emplace_back("relaxing", dragged(test::make("scheme.theta_xi")));
  all.emplace_back("relaxing linear", dragged(test::quasi_static()));
  for (char const* body : {"lower", "upper"}) {
    auto const bodies = std::string("bodies.") + body;
    test::at(all.back().second, bodies + ".material") = test::linear_elastic(1000, 0.3);
    for (auto* table : {&all.back().second, &all[all.size() - 2].second})
      test::at(*table, bodies + ".relaxing") = test::list({test::make(
          "prony",
          {{"share", test::value(0.5)}, {"bulk_share", test::value(0.4)}, {"time", test::value(0.2, "s")}})});
  }
  all.emplace_back("explicit", dragged(test::make("scheme.central_difference")));
  return all;
}

bool same(Vector const& a, Vector const& b) {
  return a.size() == b.size() && (a.array() == b.array()).all();
}

bool same(dynamics::ContactState const& a, dynamics::ContactState const& b) {
  return a.foot.segment == b.foot.segment && a.foot.xi == b.foot.xi && a.foot.eta == b.foot.eta &&
         a.gap == b.gap && a.slip == b.slip && a.path == b.path && a.dry == b.dry &&
         a.adhesion == b.adhesion && a.bond.beta == b.bond.beta && a.status == b.status &&
         a.in_reach == b.in_reach && a.rate == b.rate;
}

bool same(dynamics::State const& a, dynamics::State const& b) {
  bool equal = a.t == b.t && same(a.u, b.u) && same(a.v, b.v) && same(a.a, b.a) && same(a.kick, b.kick) &&
               same(a.internal, b.internal) && same(a.reaction, b.reaction) && same(a.drive, b.drive) &&
               a.ledger.scheme_loss() == b.ledger.scheme_loss() && a.factors.size() == b.factors.size() &&
               a.critical_age == b.critical_age && a.critical_step == b.critical_step;
  equal = equal && (a.memory == nullptr) == (b.memory == nullptr);
  for (std::size_t body = 0; equal && a.memory != nullptr && body < a.memory->size(); ++body)
    equal = same((*a.memory)[body], (*b.memory)[body]);
  for (std::size_t p = 0; equal && p < a.contacts.size(); ++p)
    for (std::size_t i = 0; i < a.contacts[p].size(); ++i)
      equal = equal && same(a.contacts[p][i], b.contacts[p][i]);
  return equal;
}

} // namespace

TEST_CASE("steps are bitwise the same whatever was tried and thrown away before them") {
  for (auto const& [name, table] : scenes())
    for (std::size_t const factors : {1, 3}) {
      auto const scene = scene::build(table);
      bool const explicit_steps = name == "explicit";
      double const dt = explicit_steps ? 1e-3 : 0.05;
      dynamics::Stepper plain(*scene.model), disturbed(*scene.model);
      plain.bulk().keep_factors(factors);
      disturbed.bulk().keep_factors(factors);
      auto state = plain.initial(), before = state;
      static_cast<void>(disturbed.initial());
      for (int k = 0; k < (explicit_steps ? 130 : 16); ++k) {
        CAPTURE(name);
        CAPTURE(factors);
        CAPTURE(k);
        auto const next = plain.step(state, dt);
        REQUIRE(next.converged());
        if (k == 0 || k % 4 != 0) // the same, much longer, from an older state
          static_cast<void>(disturbed.step(k % 4 == 3 ? before : state, k % 4 == 2 ? 20 * dt : dt));
        auto const again = disturbed.step(state, dt);
        REQUIRE(again.converged());
        CHECK(again.iterations == next.iterations);
        REQUIRE(same(next.state, again.state));
        before = std::exchange(state, next.state);
      }
    }
}

TEST_CASE("a factor that serves several steps is made again at most once for what a failure overwrote") {
  auto const scene = scene::build(dragged(test::quasi_static()));
  dynamics::Stepper plain(*scene.model), disturbed(*scene.model);
  auto state = plain.initial(), other = disturbed.initial();
  long extra = 0;
  for (int k = 0; k < 16; ++k) {
    long const before = disturbed.cost().factorizations;
    static_cast<void>(disturbed.step(other, 0.05));
    extra += 1 + disturbed.cost().factorizations - before;
    state = plain.step(state, 0.05).state;
    other = disturbed.step(other, 0.05).state;
  }
  CHECK(plain.cost().factorizations < plain.cost().newton_iterations);
  CHECK(disturbed.cost().factorizations <= plain.cost().factorizations + extra);
}
