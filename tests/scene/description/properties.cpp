// What must hold of every scene, whatever it is made of: a few hundred drawn at random.
#include <algorithm>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>
#include <numeric>

#include "scene/random_scenes.hpp"

using namespace stiction;
using dynamics::Outcome;
using dynamics::State;
using dynamics::Stepper;

namespace {

/// States after each step; a step that fails ends the walk.
struct Walk {
  std::vector<State> states;
  std::vector<double> scales; ///< largest traction that the step's contact could feel, Pa
  Outcome last;
};

/// The yardstick of the contact solver's tolerance, and of the one here: of the step's start, too, as the
/// step's forces are made from those.
double traction_scale(Stepper const& stepper, State const& before, State const& after) {
  auto const& problem = stepper.contact().problem();
  double scale = contact::judge(problem, Vector::Zero(problem.free.size())).scale;
  for (auto const* state : {&before, &after})
    for (auto const& pair : state->contacts)
      for (auto const& point : pair)
        scale = std::max({scale, point.dry.norm(), point.adhesion.norm()});
  return scale;
}

Walk walk(scene::Scene const& scene, test::RandomScene const& drawn, double dt) {
  Stepper stepper(*scene.model);
  Walk result;
  result.states.push_back(stepper.initial());
  result.scales.push_back(0);
  for (int k = 0; k < drawn.steps; ++k) {
    result.last = stepper.step(result.states.back(), dt);
    if (!result.last.converged())
      break;
    result.last.state.t = dt * (k + 1);
    result.states.push_back(result.last.state);
    result.scales.push_back(
        traction_scale(stepper, *std::prev(result.states.end(), 2), result.states.back()));
  }
  return result;
}

/// No coefficient of the law is larger.
double largest_mu(interface::Law const& law) {
  double mu = std::max(law.mu(), law.mu(interface::Status::slip));
  if (!law.friction)
    return mu;
  if (auto const* pressure = std::get_if<interface::PressureFriction>(&*law.friction))
    return std::max({mu, pressure->mu_0, pressure->mu_inf});
  if (auto const* velocity = std::get_if<interface::VelocityFriction>(&*law.friction))
    return std::max(velocity->mu_s, velocity->mu_k);
  return mu;
}

bool finite(dynamics::Ledger const& l) {
  return std::isfinite(l.kinetic) && std::isfinite(l.strain) && std::isfinite(l.bond) &&
         std::isfinite(l.potential) && std::isfinite(l.motion_work) && std::isfinite(l.load_work) &&
         std::isfinite(l.damping_loss) && std::isfinite(l.friction_loss) && std::isfinite(l.bonding_loss) &&
         std::isfinite(l.scheme_loss());
}

/// `slack`: what pressure and friction may be off, Pa.
void check_point(dynamics::ContactState const& point, double mu, double slack) {
  CHECK(point.bond.beta >= 0);
  CHECK(point.bond.beta <= 1);
  CHECK((std::isfinite(point.gap) && point.slip.allFinite() && point.dry.allFinite() &&
         point.adhesion.allFinite()));
  CHECK(point.dry[0] >= -slack);
  CHECK(point.dry.tail<2>().norm() <= mu * point.dry[0] * (1 + 1e-9) + slack);
}

/// Between two bodies action is reaction; about an axis only along it.
void check_balance(scene::Scene const& scene, State const& state) {
  int const dim = scene.model->dim();
  Vector sum = Vector::Zero(dim);
  for (Index n = 0; n < scene.model->node_count(); ++n)
    sum += state.reaction.segment(dim * n, dim);
  if (scene.part.kinematics == solid::Kinematics::axisymmetric)
    sum[0] = 0;
  double const size = std::max(state.reaction.lpNorm<1>(), 1e-3);
  CHECK(sum.lpNorm<Eigen::Infinity>() <= 1e-9 * size);
}

/// Ten times a tolerance, Pa: the contact solver's, of the largest traction; with a bond the step's, of the
/// largest force too, since the dry part is what is left of the whole force, and the bond moves on with the
/// last correction. An explicit step has none: its bond is taken where the linear motion ends, so nothing is
/// said of it here.
double slack(scene::Scene const& scene, State const& state, std::size_t pair, double traction) {
  if (!scene.model->pairs[pair].law.adhesion)
    return 1e-9 * traction;
  if (dynamics::weights(scene.model->scheme).explicit_forces)
    return std::numeric_limits<double>::max();
  double area = 0;
  for (auto const& point : state.contacts[pair])
    area = std::max(area, point.area);
  double const borne = area > 0 ? state.internal.lpNorm<Eigen::Infinity>() / area : 0;
  return 10 * scene.model->control.force_tolerance * std::max(traction, borne);
}

void check_state(scene::Scene const& scene, State const& state, double scale) {
  CHECK((state.u.allFinite() && state.v.allFinite() && state.internal.allFinite() &&
         state.reaction.allFinite()));
  CHECK(finite(state.ledger));
  for (std::size_t p = 0; p < state.contacts.size(); ++p)
    for (auto const& point : state.contacts[p])
      check_point(point, largest_mu(scene.model->pairs[p].law), slack(scene, state, p, scale));
  if (std::ranges::find(scene.bodies, "lower") != scene.bodies.end())
    check_balance(scene, state);
}

/// Of the bottom of the upper block.
double bottom_area(scene::Scene const& scene) {
  auto const upper = std::ranges::find(scene.bodies, "upper") - scene.bodies.begin();
  auto const& nodes = scene.model->bodies[static_cast<std::size_t>(upper)]->mesh.nodes;
  double const width = nodes.col(0).maxCoeff() - nodes.col(0).minCoeff();
  switch (scene.part.kinematics) {
  case solid::Kinematics::plane_strain:
    return width;
  case solid::Kinematics::axisymmetric:
    return std::numbers::pi * width * width;
  default:
    return width * (nodes.col(1).maxCoeff() - nodes.col(1).minCoeff());
  }
}

void check_areas(scene::Scene const& scene) {
  auto const& areas = scene.model->pairs[0].areas;
  double const area = std::accumulate(areas.begin(), areas.end(), 0.0), plane = bottom_area(scene);
  if (!scene.reliefs.contains("upper")) {
    CHECK(area == doctest::Approx(plane).epsilon(1e-12));
    return;
  }
  CHECK(area >= plane * (1 - 1e-12));
  CHECK(area < 1.05 * plane); // of heights of a hundredth of it
}

/// Every number of the table in units smaller by powers of two: exact in floating point.
void rescale(core::Input& input, std::array<double, 3> const& units) {
  if (auto* quantity = std::get_if<core::Quantity>(&input.value))
    quantity->value *= std::pow(units[0], quantity->dimension.metre) *
                       std::pow(units[1], quantity->dimension.kilogram) *
                       std::pow(units[2], quantity->dimension.second);
  else if (auto* list = std::get_if<core::List>(&input.value))
    for (auto& element : *list)
      rescale(element, units);
  else if (auto* table = std::get_if<core::Table>(&input.value))
    for (auto& [name, element] : *table)
      rescale(element, units);
}

/// Of plane springs the metre of depth that their numbers are per is none of the units.
void keep_depth(core::Input& table, double length) {
  auto const& entries = std::get<core::Table>(table.value);
  if (entries.find("springs") == entries.end() || *test::at(table, "kinematics").text() != "plane_strain")
    return;
  for (auto& [key, value] : std::get<core::Table>(test::at(table, "springs.tie").value))
    if (key == "stiffness" || key == "damping")
      std::get<core::Quantity>(value.value).value /= length;
}

/// The same walk in other units is the same walk.
void check_units(test::RandomScene drawn, Walk const& known) {
  double const length = std::exp2(-10), mass = std::exp2(-20), time = std::exp2(-4);
  rescale(drawn.table, {length, mass, time});
  keep_depth(drawn.table, length);
  auto const other = walk(scene::build(drawn.table), drawn, time * drawn.dt);
  REQUIRE(other.states.size() == known.states.size());
  Vector const u = other.states.back().u / length;
  CHECK((u - known.states.back().u).lpNorm<Eigen::Infinity>() <=
        1e-6 * known.states.back().u.lpNorm<Eigen::Infinity>());
}

void check_repeats(scene::Scene const& scene, test::RandomScene const& drawn, Walk const& known) {
  auto const again = walk(scene, drawn, drawn.dt);
  REQUIRE(again.states.size() == known.states.size());
  CHECK(again.states.back().u == known.states.back().u);
  CHECK(again.states.back().v == known.states.back().v);
  CHECK(again.states.back().reaction == known.states.back().reaction);
}

} // namespace

TEST_CASE("four hundred random scenes hold what every scene must") {
  int finished = 0;
  constexpr int count = 400;
  for (unsigned seed = 1; seed <= count; ++seed) {
    auto const drawn = test::RandomScenes(seed).draw();
    INFO("seed ", seed, ": ", drawn.words);
    auto const scene = scene::build(drawn.table);
    check_areas(scene);
    auto const walked = walk(scene, drawn, drawn.dt);
    CHECK(walked.last.converged() == walked.last.reason.empty());
    for (std::size_t k = 0; k < walked.states.size(); ++k)
      check_state(scene, walked.states[k], walked.scales[k]);
    if (seed % 4 == 0)
      check_repeats(scene, drawn, walked);
    if (seed % 4 == 1)
      check_units(drawn, walked);
    finished += walked.last.converged() ? 1 : 0;
  }
  CHECK(finished >= count * 9 / 10);
}
