// Bodies that are solved for by multigrid against those with a factor: the same forces, in about as many
// iterations.
#include <doctest/doctest.h>

#include "dynamics/space.hpp"
#include "scene/build/build.hpp"
#include "scene/scenes.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

/// A flat block that is pressed on the floor and dragged until half of its sole slips.
Input dragged(Input material, double cells, char const* bulk) {
  auto table = cube_on_floor();
  at(table, "bodies.foot") = box({{0, 0, 0}, {2, 2, 1}, {cells, cells, 3}}, std::move(material));
  at(table, "pairs.sole.friction") = make("friction.coulomb", {{"mu", value(0.3)}});
  at(table, "motions") =
      list({drive("foot.top", {0, 1, 2}, {{{0, 0, 0.012}, {0, 0, 0.004}, {0, -0.02, -0.02}}})});
  at(table, "control") = make("control", {{"bulk", text(bulk)}});
  return table;
}

struct Marched {
  Vector reaction;
  dynamics::Cost cost;
};

Marched march_eleven(Input const& table) {
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto state = march(stepper, stepper.initial(), 1, 1);
  state = march(stepper, std::move(state), 0.1, 10);
  return {state.reaction, stepper.cost()};
}

Input rubber() {
  return make("material.neo_hookean", {{"young", value(1000, "Pa")}, {"poisson", value(0.45)}});
}

} // namespace

TEST_CASE("multigrid gives the forces that a factor gives, in as many iterations") {
  for (auto const& material : {linear_elastic(1000, 0.3), linear_elastic(1000, 0.49), rubber()}) {
    auto const direct = march_eleven(dragged(material, 6, "direct")),
               multigrid = march_eleven(dragged(material, 6, "multigrid"));
    CHECK((multigrid.reaction - direct.reaction).norm() <= 1e-6 * direct.reaction.norm());
    CHECK(20 * multigrid.cost.newton_iterations <= 21 * direct.cost.newton_iterations);
  }
}

TEST_CASE("multigrid moves bodies that touch nothing as a factor does") {
  auto const moved = [](char const* bulk) {
    auto table = dragged(rubber(), 4, bulk);
    for (auto const* part : {"pairs", "obstacles"})
      remove(table, part);
    std::get<core::List>(at(table, "motions").value).push_back(fix("foot.bottom"));
    auto const scene = scene::build(table);
    dynamics::Stepper stepper(*scene.model);
    return march(stepper, stepper.initial(), 0.5, 4).u;
  };
  Vector const direct = moved("direct"), multigrid = moved("multigrid");
  CHECK((multigrid - direct).norm() <= 1e-6 * direct.norm());
}

TEST_CASE(
    "contact that is solved together with the bodies takes as many Newton iterations as by its matrix") {
  for (auto const& material : {linear_elastic(1000, 0.3), rubber()}) { // 16 points: no sweeps before
    auto const direct = march_eleven(dragged(material, 3, "direct")),
               multigrid = march_eleven(dragged(material, 3, "multigrid"));
    CHECK(direct.cost.answered[static_cast<std::size_t>(contact::Method::newton)] ==
          direct.cost.contact_problems);
    CHECK(static_cast<double>(multigrid.cost.contact_iterations) <=
          1.3 * static_cast<double>(direct.cost.contact_iterations));
  }
}
