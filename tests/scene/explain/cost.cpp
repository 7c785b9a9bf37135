// What explain says of the cost against what runs count: sizes, fill and operations, within a factor of two.
#include <doctest/doctest.h>

#include "dynamics/bulk/bulk_choice.hpp"
#include "dynamics/space.hpp"
#include "folder.hpp"
#include "scene/explain/explain.hpp"
#include "scene/explain/fill.hpp"
#include "scene/half_spaces.hpp"
#include "scene/run/run.hpp"
#include "scene/scenes.hpp"

using namespace stiction;
using namespace stiction::test;

namespace {

double cost(scene::Explanation const& explanation, std::string const& name) {
  for (auto const& section : explanation.sections)
    if (section.title == "Cost")
      for (auto const& line : section.lines)
        if (line.name == name)
          return line.value;
  throw std::logic_error("no line " + name);
}

void check_near(double said, double counted) {
  CHECK(said > counted / 2);
  CHECK(said < counted * 2);
}

scene::RunResult run(Input const& table) {
  Folder const folder;
  scene::RunOptions options;
  options.out = folder / "case";
  options.case_id = "one";
  auto result = scene::run(table, options);
  REQUIRE(result.verdict == "finished");
  return result;
}

/// The factor of a model, and what is told of it from clusters of at most so many nodes.
void check_fill(Input const& table, Index most) {
  auto const scene = scene::build(table);
  dynamics::Stepper stepper(*scene.model);
  auto const fill = scene::fill_of(*scene.model, stepper.bulk(), most);
  auto const& factor = stepper.bulk().factor();
  CHECK(fill.unknowns == stepper.bulk().unknowns());
  CHECK(fill.surface == factor.surface());
  CHECK(fill.entries == doctest::Approx(factor.pattern().entries()).epsilon(0.1));
  check_near(fill.factor.entries, factor.effort().entries);
  check_near(fill.factor.operations, factor.effort().operations);
}

Input rubber(double young) {
  return make("material.neo_hookean", {{"young", value(young, "Pa")}, {"poisson", value(0.3)}});
}

/// A block pressed and dragged, in the plane.
Input pressed(Input material, double cells) {
  auto table = foot_on_floor();
  at(table, "bodies.foot") = block({{0, 0}, {2, 1}, {2 * cells, cells}}, std::move(material));
  return table;
}

Input slab(Input material, double cells = 5) {
  auto table = cube_on_floor();
  at(table, "bodies.foot") = box({{0, 0, 0}, {2, 2, 1}, {2 * cells, 2 * cells, cells}}, std::move(material));
  at(table, "motions") = list({drive("foot.top", {0, 1, 2}, {{{0, 0, 0.02}, {0, 0, 0}, {0, -0.02, -0.02}}})});
  at(table, "schedule") = schedule({{1, 1}, {2, 6}});
  return table;
}

Input axisymmetric(Input material) {
  auto table = pressed(std::move(material), 12);
  at(table, "kinematics") = text("axisymmetric");
  at(table, "motions") = list({drive("foot.top", {0, 1}, {}, {0, -0.02})});
  at(table, "schedule") = schedule({{1, 8}});
  return table;
}

Input with(Input table, char const* path, Input part) {
  at(table, path) = std::move(part);
  return table;
}

Input multigrid(Input table) {
  return with(std::move(table), "control", make("control", {{"bulk", text("multigrid")}}));
}

/// One linear block moved on another or flying at it, with inertia.
Input blocks(bool flying) {
  auto table = two_blocks();
  at(table, "bodies.lower") = block({{0, -1}, {2, 1}, {30, 15}}, linear_elastic(1000, 0.3));
  at(table, "bodies.upper") = block({{0.5, 0}, {1, 0.5}, {20, 10}}, linear_elastic(1000, 0.3));
  at(table, "pairs.joint.friction") = coulomb(0.3);
  at(table, "scheme") = make("scheme.theta_xi");
  if (flying) {
    at(table, "bodies.upper.velocity") = values({0.1, -0.5}, "m/s");
    at(table, "motions") = list({fix("lower.bottom")});
    at(table, "schedule") = schedule({{0.2, 40}});
  }
  return table;
}

/// Peeled off the floor by its end: it turns far before it strains.
Input strip() {
  auto table = foot_on_floor();
  at(table, "bodies.foot") = block({{0, 0}, {5, 0.1}, {50, 2}}, rubber(1000));
  at(table, "pairs.sole.adhesion") = rcc(0.1, 10, 1e-6);
  at(table, "pairs.sole.adhesion.beta0") = value(1);
  at(table, "pairs.sole.adhesion.bonding") = text("never");
  at(table, "motions") = list({fix("foot.right"), drive("foot.left", {0, 1}, {}, {0, 1.5})});
  at(table, "schedule") = schedule({{1, 60}});
  return table;
}

/// Drawn across a half disc.
Input plate_on_disc() {
  auto table = make("scene");
  at(table, "bodies.disc") = half_disc(1, 0.06, rubber(1000));
  at(table, "bodies.plate") = block({{-1, 0}, {2, 0.5}, {40, 10}}, rubber(1000));
  at(table, "pairs.joint") = pair("plate.bottom", "disc.arc");
  at(table, "pairs.joint.friction") = coulomb(0.3);
  at(table, "motions") =
      list({fix("disc.flat"), drive("plate.top", {0, 1, 2}, {0, 0, 0.1}, {0, -0.04, -0.04})});
  at(table, "scheme") = quasi_static();
  at(table, "schedule") = schedule({{1, 8}, {2, 10}});
  return table;
}

} // namespace

TEST_CASE("the fill of a factor is told from its graph, or from clusters of it") {
  for (Index const most : {100000, 400}) {
    CAPTURE(most);
    check_fill(pressed(rubber(1000), 30), most);
    check_fill(axisymmetric(rubber(1000)), most);
    check_fill(slab(rubber(1000), 9), most);
    check_fill(multigrid(slab(rubber(1000), 9)), most);
    check_fill(plate_on_disc(), most);
  }
}

TEST_CASE("multigrid is taken from a size on that follows the law, and who cannot have it is told why") {
  auto const taken = [](Input const& table) { return dynamics::by_multigrid(*scene::build(table).model); };
  auto const linear = slab(linear_elastic(1000, 0.3), 11); // 17 457 unknowns
  CHECK(taken(linear));
  CHECK_FALSE(taken(slab(linear_elastic(1000, 0.45), 11)));
  CHECK_FALSE(taken(slab(rubber(1000), 11)));
  CHECK_FALSE(taken(with(linear, "pairs.sole.adhesion", rcc(0.5, 1000, 40))));
  CHECK_FALSE(taken(slab(linear_elastic(1000, 0.3), 10)));
  CHECK(taken(slab(linear_elastic(1000, 0.47), 16)));
  CHECK_FALSE(taken(slab(linear_elastic(1000, 0.49), 16))); // on graded meshes it may not come to an end
  auto const told = [](Input const& table) {
    std::string words;
    for (auto const& section : scene::explain(table).sections)
      for (auto const& line : section.lines)
        if (line.name == "multigrid")
          words += line.words + ": " + line.meaning;
    return words;
  };
  CHECK(told(linear).find("not taken") == std::string::npos);
  CHECK(told(with(linear, "solver", make("solver.uzawa")))
            .find("not taken: it would be quicker for bodies of "
                  "this size, but the contact solver is not "
                  "newton") != std::string::npos);
}

TEST_CASE("the operations of a run are told before it") {
  struct Known {
    std::string name;
    Input table;
  };
  auto const bonds = rcc(0.5, 1000, 40);
  for (auto const& [name, table] :
       {Known{"plane, linear", pressed(linear_elastic(1000, 0.3), 10)},
        Known{"plane, finite strain", pressed(rubber(1000), 10)},
        Known{"plane, friction", with(pressed(rubber(1000), 10), "pairs.sole.friction", coulomb(0.3))},
        Known{"plane, many rows",
              with(pressed(linear_elastic(1000, 0.3), 30), "pairs.sole.friction", coulomb(0.3))},
        Known{"plane, bonds", with(pressed(linear_elastic(1000, 0.3), 16), "pairs.sole.adhesion", bonds)},
        Known{"section", axisymmetric(rubber(1000))},
        Known{"section, bonds", with(axisymmetric(rubber(1000)), "pairs.sole.adhesion", bonds)},
        Known{"space", slab(linear_elastic(1000, 0.3))},
        Known{"space, friction", with(slab(linear_elastic(1000, 0.3)), "pairs.sole.friction", coulomb(0.3))},
        Known{"space, finite strain, friction",
              with(slab(rubber(1000)), "pairs.sole.friction", coulomb(0.3))},
        Known{"space, bonds", with(slab(linear_elastic(1000, 0.3)), "pairs.sole.adhesion", bonds)},
        Known{"space, multigrid", multigrid(slab(linear_elastic(1000, 0.3)))},
        Known{"space, multigrid, finite strain, friction",
              multigrid(with(slab(rubber(1000), 8), "pairs.sole.friction", coulomb(0.3)))},
        Known{"two bodies", plate_on_disc()}, Known{"two linear bodies, moved", blocks(false)},
        Known{"two linear bodies, in flight", blocks(true)}, Known{"strip, bonds", strip()}}) {
    CAPTURE(name);
    auto const said = scene::explain(table);
    auto const counted = run(table);
    CHECK(cost(said, "unknowns") == counted.counters.at("unknowns"));
    CHECK(cost(said, "contact unknowns") == counted.counters.at("contact_unknowns"));
    check_near(cost(said, "operations"), counted.counters.at("work"));
  }
}

TEST_CASE("the operations of a half space are told before its run") {
  auto const on_grid = [](Input table, std::vector<double> const& points, char const* boundary) {
    at(table, "bodies.base.points") = values(points);
    at(table, "bodies.base.boundary") = text(boundary);
    at(table, "schedule") = schedule({{1, 4}});
    return table;
  };
  struct Known {
    std::string name;
    Input table;
  };
  auto const space = half_space_scene(), line = half_line_scene();
  auto const pull = make("adhesion.potential", {{"w", value(0.02, "J/m^2")}, {"delta", value(1e-3, "m")}});
  for (auto const& [name, table] :
       {Known{"space", on_grid(space, {48, 48}, "free")},
        Known{"space, periodic", on_grid(space, {96, 96}, "periodic")},
        Known{"space, friction",
              with(on_grid(space, {40, 40}, "free"), "pairs.joint.friction", coulomb(0.3))},
        Known{"space, adhesion", with(on_grid(space, {80, 80}, "free"), "pairs.joint.adhesion", pull)},
        Known{"line", on_grid(line, {200}, "free")},
        Known{"line, friction", with(on_grid(line, {100}, "free"), "pairs.joint.friction", coulomb(0.3))}}) {
    CAPTURE(name);
    check_near(cost(scene::explain(table), "operations"), run(table).counters.at("work"));
  }
}
