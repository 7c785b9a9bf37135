// Counts from the scene's kind: what the studies of this repository take, with the sizes of this one.
#include "scene/explain/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/solvers/newton.hpp"
#include "linear/multigrid_factor.hpp"
#include "linear/sparse_factor.hpp"
#include "mesh/cells/cell.hpp"

namespace stiction::scene {

namespace {

// What the studies, proofs and peers of this repository take.
// Newton iterations and factorizations of a step: where the other side is flat, is curved, is a body, where a
// body bends.
struct Pace {
  double iterations, factorizations;
};
constexpr Pace finite_flat{3, 0.1}, finite_curved{5, 0.25}, finite_bodies{5.5, 0.4}, finite_slender{5.5, 1.1};
constexpr double slender = 0.1; // thickness over length of what bends a lot before it strains
constexpr double linear_flat = 1, linear_curved = 1.6, linear_bodies = 2; // iterations
constexpr double bearing = 0.6;         // of the points near contact: they bear forces
constexpr double plain_sweeps = 100;    // a contact problem
constexpr double newton_iterations = 3; // a contact problem
// Cycles of multigrid, an iteration of a step: for loads and for contact.
constexpr double cycles = 18, cycles_with_friction = 42;
constexpr double unknown_part = 0.3; // of a surface, near contact where its way is not known

/// That mix_sweeps takes: 34 for 243 rows, 65 for 1875.
double mixed_sweeps(double rows) {
  return 6.5 * std::pow(rows, 0.3);
}

bool plain(Facts const& facts) {
  return std::ranges::none_of(facts.pairs, [](auto const& pair) {
    return pair.pair->law.adhesion.has_value() || pair.pair->law.mu_follows();
  });
}

bool linear(Facts const& facts) {
  return std::ranges::all_of(facts.bodies, [](auto const& body) { return solid::linear(*body.body); });
}

/// Does the normal at a point turn as it slides?
bool turns(PairFacts const& pair, dynamics::Model const& model) {
  return pair.primary || !std::holds_alternative<contact::RigidPlane>(model.rigids[pair.rigid].shape);
}

bool bends(Facts const& facts) {
  return std::ranges::any_of(facts.bodies, [&](auto const& body) {
    auto const sides = body.sides.head(facts.scene->model->dim());
    return !solid::linear(*body.body) && sides.minCoeff() < slender * sides.maxCoeff();
  });
}

/// Newton iterations of a step, and factorizations where they follow the strain.
Pace pace_of(Facts const& facts) {
  auto const& model = *facts.scene->model;
  bool const bodies =
      std::ranges::any_of(facts.pairs, [](auto const& pair) { return pair.primary.has_value(); });
  bool const curved = std::ranges::any_of(facts.pairs, [&](auto const& pair) { return turns(pair, model); });
  if (dynamics::weights(model.scheme).explicit_forces)
    return {1, 0};
  if (!linear(facts))
    return bends(facts) ? finite_slender : bodies ? finite_bodies : curved ? finite_curved : finite_flat;
  return {bodies ? linear_bodies : curved ? linear_curved : linear_flat, 0};
}

/// In the whole run. A linear matrix changes with the step, where there is inertia or a stabilisation.
double factorizations_of(Facts const& facts) {
  auto const weights = dynamics::weights(facts.scene->model->scheme);
  double const held = facts.scene->model->held_by_bonds ? 2 : 1;
  if (weights.explicit_forces)
    return 1;
  if (!linear(facts))
    return held * std::max(1.0, pace_of(facts).factorizations * static_cast<double>(facts.steps));
  double sizes = 1, start = 0, last = 0;
  for (auto const& stage : facts.scene->part.schedule.stages) {
    double const dt = (stage.until - start) / stage.steps;
    sizes += start > 0 && std::abs(dt - last) > 1e-12 * dt ? 1 : 0;
    start = stage.until;
    last = dt;
  }
  return held * (weights.inertia || weights.stabilisation > 0 ? sizes : 1);
}

/// Points within sqrt(R depth) of the one that is nearest, the half width that Hertz finds.
double around_nearest(dynamics::Model const& model, PairFacts const& pair,
                      std::vector<dynamics::ContactState> const& states) {
  auto const gap = [](auto const& point) {
    return point.foot.found() ? point.gap : std::numeric_limits<double>::infinity();
  };
  auto const nearest = std::ranges::min_element(states, {}, gap) - states.begin();
  auto const& nodes = pair.pair->secondary;
  auto const middle = model.reference.row(nodes[static_cast<std::size_t>(nearest)]);
  double const width = std::sqrt(pair.radius * pair.motion.depth) + pair.pair->reach;
  return static_cast<double>(std::ranges::count_if(
      nodes, [&](Index node) { return (model.reference.row(node) - middle).norm() < width; }));
}

/// That come near contact at once. Of a surface that the other side lies beneath by `depth`, about half as
/// much touches, and what is in reach of it is near. Bonds keep points.
double near(dynamics::Model const& model, PairFacts const& pair,
            std::vector<dynamics::ContactState> const& states) {
  if (pair.gap < 0 || pair.motion.unknown)
    return unknown_part * pair.pair->size();
  double const within = pair.gap + 0.5 * pair.motion.depth + pair.pair->reach;
  auto const found = static_cast<double>(std::ranges::count_if(states, [&](auto const& point) {
    return point.foot.found() && (point.gap < within || point.bond.beta > 0);
  }));
  return pair.radius > 0 ? std::max(found, around_nearest(model, pair, states)) : found;
}

/// Adds the points of one pair.
void add_points(Facts const& facts, PairFacts const& pair, double points, ContactForecast& contact) {
  auto const& model = *facts.scene->model;
  double const dim = model.dim();
  double unknowns = dim * points;
  if (pair.primary && pair.size > 0 && pair.primary_size > 0)
    unknowns += dim * std::max(1.0, points * std::pow(pair.size / pair.primary_size, dim - 1)) + dim;
  contact.points += points;
  contact.used += unknowns;
  if (turns(pair, model))
    contact.support += bearing * unknowns;
  double const moved = pair.primary ? dim * (1 + 2 * (dim - 1)) : dim - 1; // components that one row moves
  contact.elimination += 2 * moved * points * facts.components;            // for each unknown used, later
}

void add_solver(Facts const& facts, ContactForecast& contact) {
  auto const& choice = facts.scene->model->solver;
  double const r = contact.rows, square = 2 * r * r;
  bool const newton = std::holds_alternative<contact::BipotentialNewton>(choice);
  contact.sweeps = !newton || (r >= static_cast<double>(contact::many) && plain(facts));
  contact.iterations = !contact.sweeps ? newton_iterations : newton ? mixed_sweeps(r) : plain_sweeps;
  contact.operations = contact.iterations * (contact.sweeps ? square : square * (r / 3 + 3));
}

/// The columns of the compliance and the products that make a problem of them (condensation.cpp).
void add_elimination(Fill const& fill, ContactForecast& contact) {
  double const n = fill.surface, s = std::min(contact.support, n), m = contact.rows;
  contact.used = std::min(contact.used, n);
  contact.support = s;
  contact.columns = n <= linear::at_once && fill.surface_last ? n : contact.used;
  contact.column_operations = !fill.surface_last     ? 4 * fill.factor.entries * contact.columns
                              : n <= linear::at_once ? n * n * n
                                                     : 2.0 / 3 * n * n * contact.columns;
  contact.elimination *= contact.used;
  contact.elimination += contact.used * contact.used;
  contact.elimination += s * s * (2.0 / 3 * s + 2 * s + 2 * m) + 2 * m * m * s;
}

ContactForecast contact_of(Facts const& facts, dynamics::State const& start, Fill const& fill) {
  ContactForecast contact;
  for (std::size_t p = 0; p < facts.pairs.size(); ++p)
    add_points(facts, facts.pairs[p], near(*facts.scene->model, facts.pairs[p], start.contacts[p]), contact);
  contact.rows = facts.components * contact.points;
  if (contact.points == 0)
    return contact;
  if (fill.multigrid) {
    contact.iterations = facts.components > 1 ? cycles_with_friction : cycles;
    contact.operations = contact.iterations * linear::cycle_passes * 4 * fill.entries;
    return contact;
  }
  add_solver(facts, contact);
  add_elimination(fill, contact);
  return contact;
}

/// Gradients and volumes at the quadrature points, as solid::PreparedBlock keeps them, and where a cell's
/// stiffness goes, bytes.
double cell_bytes(Facts const& facts) {
  double bytes = 0;
  int const width = facts.scene->model->dim();
  for (auto const& body : facts.bodies)
    for (auto const& block : body.body->mesh.blocks) {
      auto const nodes = static_cast<double>(mesh::info(block.kind).nodes);
      auto const cells = static_cast<double>(block.nodes.size()) / nodes;
      auto const points = static_cast<double>(mesh::stiffness_rule(block.kind).weights.size());
      double const unknowns = nodes * width;
      bytes += cells * (8 * points * (width * nodes + 1) +
                        sizeof(Index) * (unknowns * (unknowns + 1) / 2 + 4 * nodes));
    }
  return bytes;
}

void add_memory(Facts const& facts, Forecast& all) {
  auto const& [fill, contact] = std::pair{all.fill, all.contact};
  double const dense = contact.used * contact.used + contact.used * contact.rows;
  double const square = contact.rows * contact.rows;
  all.base_bytes = program_bytes;
  all.cells_bytes = cell_bytes(facts) + 400 * static_cast<double>(facts.scene->model->dofs());
  all.factor_bytes = 8 * fill.factor.entries;
  all.matrix_bytes = fill.entries * (2 * sizeof(Index) + sizeof(double)) * (facts.dynamic() ? 1.5 : 1.0);
  if (fill.multigrid) { // vectors of GMRES
    all.contact_bytes = 8 * 2 * 25 * fill.unknowns;
    return;
  }
  all.contact_bytes =
      8 * (dense + (contact.sweeps ? 1.5 : 3) * square + 2 * contact.support * contact.used +
           0.5 * contact.columns * fill.surface + (fill.surface_last ? fill.surface * fill.surface : 0));
}

} // namespace

double Forecast::work() const {
  return pass.force * (iterations + steps) + pass.stiffness * factorizations +
         fill.factor.operations * factorizations + contact.column_operations * factorizations +
         4 * fill.factor.entries * iterations + contact.operations * iterations;
}

double Forecast::memory() const {
  return base_bytes + cells_bytes + factor_bytes + matrix_bytes + contact_bytes;
}

Forecast forecast(Facts const& facts, dynamics::State const& start, dynamics::BulkSystem const& bulk) {
  auto const& model = *facts.scene->model;
  Forecast all;
  all.fill = fill_of(model, bulk);
  all.pass = pass_operations(model);
  all.steps = static_cast<double>(facts.steps);
  all.iterations = all.steps * pace_of(facts).iterations;
  all.factorizations = factorizations_of(facts);
  if (dynamics::weights(model.scheme).explicit_forces)
    all.pass.stiffness = 0;
  all.contact = contact_of(facts, start, all.fill);
  add_memory(facts, all);
  return all;
}

} // namespace stiction::scene
