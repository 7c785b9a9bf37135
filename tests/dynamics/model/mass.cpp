// Every treatment of the contact nodes' inertia keeps each body's mass, and makes no node's mass negative.
#include "dynamics/model/mass.hpp"

#include <doctest/doctest.h>

#include "dynamics/marching.hpp"

using namespace stiction;
using dynamics::ContactInertia;

namespace {

std::string const kinds[] = {"quad4", "quad8", "tri3", "tri6"};
constexpr ContactInertia treatments[] = {ContactInertia::full, ContactInertia::implicit,
                                         ContactInertia::none};

/// Two blocks of densities 2 and 3 that meet, under gravity.
scene::Scene blocks(std::string const& kind) {
  auto table = test::two_blocks();
  for (std::string const body : {"lower", "upper"})
    test::at(table, "bodies." + body + ".mesh.kind") = test::text(kind);
  test::at(table, "bodies.lower.density") = test::value(2, "kg/m^3");
  test::at(table, "bodies.upper.density") = test::value(3, "kg/m^3");
  test::at(table, "gravity") = test::values({0.5, -10}, "m/s^2");
  return scene::build(table);
}

std::vector<bool> surface_of(scene::Scene const& scene) {
  std::vector<bool> marked(ix(scene.model->node_count()), false);
  for (std::string const set : {"lower.top", "upper.bottom"})
    for (Index const node : test::nodes_of(scene, set))
      marked[ix(node)] = true;
  return marked;
}

/// Mass per component of the nodes of one body: 1^T M 1.
double mass_of(dynamics::Model const& model, dynamics::Mass const& mass, std::size_t body) {
  Vector ones = Vector::Zero(2 * model.node_count()), product;
  for (Index i = model.first_node[body]; i < model.first_node[body + 1]; ++i)
    ones[2 * i] = 1;
  mass.times(ones, product);
  return ones.dot(product);
}

} // namespace

TEST_CASE("each body keeps its mass and its weight whatever the inertia of contact nodes") {
  for (auto const& kind : kinds) {
    auto const scene = blocks(kind);
    for (auto const treatment : treatments) {
      CAPTURE(kind);
      CAPTURE(static_cast<int>(treatment));
      auto const mass = assemble_mass(*scene.model, surface_of(scene), treatment);
      CHECK(mass_of(*scene.model, mass, 0) == doctest::Approx(2).epsilon(1e-12));
      CHECK(mass_of(*scene.model, mass, 1) == doctest::Approx(3).epsilon(1e-12));
      test::Vec2 weight = test::Vec2::Zero();
      for (Index i = 0; i < scene.model->node_count(); ++i)
        weight += mass.dead_load.segment<2>(2 * i);
      CHECK(weight.x() == doctest::Approx(5 * 0.5));
      CHECK(weight.y() == doctest::Approx(5 * -10));
    }
  }
}

TEST_CASE("what massless nodes would carry goes to the other nodes of their own cells") {
  auto table = test::foot_on_floor();
  test::at(table, "bodies.foot") = test::block({{0, 0}, {0.5, 2}, {1, 4}}, test::linear_elastic(1, 0), 3);
  auto const scene = scene::build(table);
  std::vector<bool> bottom(ix(scene.model->node_count()), false);
  for (Index const node : test::nodes_of(scene, "foot.bottom"))
    bottom[ix(node)] = true;
  auto const mass = assemble_mass(*scene.model, bottom, ContactInertia::none);
  Vector ones = Vector::Ones(scene.model->dofs()), sums;
  mass.times(ones, sums);
  double const cell = 3 * 0.5 * 0.5; // kg/m
  for (Index i = 0; i < scene.model->node_count(); ++i) {
    double const y = scene.model->reference(i, 1);
    CAPTURE(y);
    double const cells = y < 0.1 ? 0 : y < 0.6 ? 0.75 : y < 1.9 ? 0.5 : 0.25;
    CHECK(sums[2 * i] == doctest::Approx(cells * cell).epsilon(1e-12));
  }
}

TEST_CASE("contact nodes have no inertia, or a positive one of their own") {
  for (auto const& kind : kinds) {
    auto const scene = blocks(kind);
    auto const surface = surface_of(scene);
    auto const massless = assemble_mass(*scene.model, surface, ContactInertia::none);
    auto const lumped = assemble_mass(*scene.model, surface, ContactInertia::implicit);
    CAPTURE(kind);
    auto const& pattern = lumped.pattern;
    for (Index j = 0; j < pattern.size(); ++j)
      for (Index k = pattern.columns[ix(j)]; k < pattern.columns[ix(j) + 1]; ++k) {
        Index const i = pattern.rows[ix(k)];
        if (i == j)
          CHECK(lumped.values[ix(k)] > 0);
        if (!surface[ix(i)] && !surface[ix(j)])
          continue;
        CHECK(massless.values[ix(k)] == 0);
        if (i != j)
          CHECK(lumped.values[ix(k)] == 0);
      }
  }
}

TEST_CASE("what massless contact nodes lose stays in their own cells") {
  for (auto const& kind : kinds) {
    auto const scene = blocks(kind);
    auto const& model = *scene.model;
    CAPTURE(kind);
    Vector ones = Vector::Ones(2 * model.node_count()), before, after;
    assemble_mass(model, surface_of(scene), ContactInertia::full).times(ones, before);
    assemble_mass(model, surface_of(scene), ContactInertia::none).times(ones, after);
    double next_row = 0; // of the upper block, whose four rows of cells weigh 3/4 each
    for (Index i = model.first_node[1]; i < model.first_node[2]; ++i) {
      double const y = model.reference(i, 1);
      if (y > 0.25 + 1e-9) // beyond the first row of cells
        CHECK(after[2 * i] == doctest::Approx(before[2 * i]).epsilon(1e-12));
      else
        next_row += after[2 * i];
    }
    double inside = 0; // what the second row gives to the nodes between
    for (Index i = model.first_node[1]; i < model.first_node[2]; ++i)
      if (model.reference(i, 1) > 0.25 + 1e-9)
        inside += before[2 * i];
    CHECK(next_row == doctest::Approx(3 - inside).epsilon(1e-12));
  }
}
