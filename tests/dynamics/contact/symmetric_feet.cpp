// Points in space whose feet lie on vertices, sides and diagonals of facets: Newton's method does not mind.
#include "dynamics/space.hpp"

using namespace stiction;

namespace {

/// A block pressed into another and pulled off, its nodes above vertices, sides, middles and diagonals of the
/// other's facets, whose surface curves as it is pressed.
test::Input pressed(std::string const& kind, bool bonded, double mu, bool sheared) {
  auto table = test::space();
  auto const rubber = [](double young) {
    return test::make("material.neo_hookean",
                      {{"young", test::value(young, "Pa")}, {"poisson", test::value(0.3)}});
  };
  test::at(table, "bodies.low") = test::box({{-1, -1, -1}, {2, 2, 1}, {4, 4, 2}}, rubber(1000));
  test::at(table, "bodies.up") = test::box({{-0.5, -0.5, 0}, {1, 1, 0.5}, {4, 4, 2}}, rubber(3000));
  for (char const* body : {"low", "up"})
    test::at(table, std::string("bodies.") + body + ".mesh.kind") = test::text(kind);
  test::at(table, "pairs.touch") = test::pair("up.bottom", "low.top");
  if (bonded)
    test::at(table, "pairs.touch.adhesion") = test::rcc(2, 2e3, 0.1);
  if (mu > 0)
    test::at(table, "pairs.touch.friction") = test::coulomb(mu);
  double const side = sheared ? 0.05 : 0;
  test::at(table, "motions") =
      test::list({test::fix_in("low.bottom", "xyz"),
                  test::drive("up.top", {0, 1, 2}, {{{0, 0, side}, {0, 0, 0.5 * side}, {0, -0.1, 0.05}}})});
  test::at(table, "schedule") = test::schedule({{1, 4}, {2, 8}});
  return table;
}

} // namespace

TEST_CASE(
    "nodes on vertices, sides and diagonals of facets take few iterations, bonded, rubbing or neither") {
  for (std::string const kind : {"hex8", "tet4"})
    for (bool const bonded : {false, true})
      for (double const mu : {0.0, 0.3})
        for (bool const sheared : {false, true}) {
          CAPTURE(kind);
          CAPTURE(bonded);
          CAPTURE(mu);
          CAPTURE(sheared);
          auto const scene = scene::build(pressed(kind, bonded, mu, sheared));
          dynamics::Stepper stepper(*scene.model);
          auto state = stepper.initial();
          for (int k = 0; k < 12; ++k) {
            auto outcome = stepper.step(state, k < 4 ? 0.25 : 0.125);
            CAPTURE(k);
            INFO(outcome.reason);
            REQUIRE(outcome.converged());
            CHECK(outcome.iterations <= (bonded ? 8 : 14)); // dry, several points let go in one step
            state = std::move(outcome.state);
          }
        }
}
