// One overload per probe: its columns and its sampler.
#include "scene/probes.hpp"

#include <algorithm>
#include <cmath>

namespace stiction::scene {

using dynamics::ContactState;
using dynamics::State;

namespace {

struct Context {
  Scene const& scene;
  record::Series& series;
  std::string const& name;
  [[nodiscard]] bool plane() const { return scene.part.kinematics == solid::Kinematics::plane_strain; }
  [[nodiscard]] char const* force_unit() const { return plane() ? "N/m" : "N"; }
  [[nodiscard]] char const* energy_unit() const { return plane() ? "J/m" : "J"; }
  void column(char const* column, char const* unit, char const* meaning, int width = 1) const {
    series.add(name, column, unit, meaning, width);
  }
};

/// One recorded quantity of a contact point.
struct PointQuantity {
  char const *name, *unit, *meaning;
  double (*value)(ContactState const&);
};

constexpr PointQuantity point_quantities[] = {
    {"gap", "m", "x_n", [](ContactState const& c) { return c.gap; }},
    {"slip", "m", "signed slip since the start", [](ContactState const& c) { return c.path; }},
    {"stretch", "m", "bond stretch x_t", [](ContactState const& c) { return c.bond.stretch[0]; }},
    {"beta", "1", "bond intensity", [](ContactState const& c) { return c.bond.beta; }},
    {"pressure", "Pa", "dry normal reaction rbar_n", [](ContactState const& c) { return c.dry[0]; }},
    {"friction", "Pa", "dry tangential reaction rbar_t", [](ContactState const& c) { return c.dry[1]; }},
    {"adhesion_n", "Pa", "normal adhesion rtilde_n", [](ContactState const& c) { return c.adhesion[0]; }},
    {"adhesion_t", "Pa", "tangential adhesion rtilde_t", [](ContactState const& c) { return c.adhesion[1]; }},
    {"status", "1", "0 open, 1 stick, 2 slip",
     [](ContactState const& c) { return static_cast<double>(c.status); }},
};

Sampler add(PointProbe const& probe, Context const& context) {
  auto const p = ix(context.scene.pair_index(probe.pair));
  auto const& pair = context.scene.model->pairs[p];
  Index const node = context.scene.nearest(pair.secondary, probe.near);
  auto const i = static_cast<std::size_t>(std::find(pair.secondary.begin(), pair.secondary.end(), node) -
                                          pair.secondary.begin());
  for (auto const& quantity : point_quantities)
    context.column(quantity.name, quantity.unit, quantity.meaning);
  auto const X = context.scene.model->reference.row(node);
  context.series.set_attribute(context.name, "X", X[0]);
  context.series.set_attribute(context.name, "Y", X[1]);
  return [p, i](State const& state, std::vector<double>& row) {
    for (auto const& quantity : point_quantities)
      row.push_back(quantity.value(state.contacts[p][i]));
  };
}

Sampler add(LineProbe const& probe, Context const& context) {
  auto const p = ix(context.scene.pair_index(probe.pair));
  auto const& model = *context.scene.model;
  auto const width = static_cast<int>(model.pairs[p].secondary.size());
  context.column("X", "m", "reference x of the points", width);
  context.column("Y", "m", "reference y of the points", width);
  for (auto const& quantity : point_quantities)
    context.column(quantity.name, quantity.unit, quantity.meaning, width);
  return [p, &model](State const& state, std::vector<double>& row) {
    for (int c = 0; c < 2; ++c)
      for (Index const node : model.pairs[p].secondary)
        row.push_back(model.reference(node, c));
    for (auto const& quantity : point_quantities)
      for (auto const& point : state.contacts[p])
        row.push_back(quantity.value(point));
  };
}

/// What a whole pair shows at one moment.
struct PairSummary {
  double force_x = 0, force_y = 0, open = 0, stick = 0, slip = 0, closed_area = 0;
  double beta_max = 0, beta_mean = 0, pressure_max = 0, adhesion_t_max = 0, adhesion_n_min = 0, gap_min = 0;
};

PairSummary summarise(dynamics::Pair const& pair, std::vector<ContactState> const& points,
                      Vector const& reaction) {
  PairSummary sum;
  double area = 0;
  sum.gap_min = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < points.size(); ++i) {
    auto const& point = points[i];
    Index const node = pair.secondary[i];
    if (point.foot.found())
      sum.gap_min = std::min(sum.gap_min, point.gap);
    sum.beta_max = std::max(sum.beta_max, point.bond.beta);
    sum.beta_mean += pair.areas[i] * point.bond.beta;
    area += pair.areas[i];
    sum.pressure_max = std::max(sum.pressure_max, point.dry[0]);
    sum.adhesion_t_max = std::max(sum.adhesion_t_max, std::abs(point.adhesion[1]));
    sum.adhesion_n_min = std::min(sum.adhesion_n_min, point.adhesion[0]);
    if (!point.in_reach)
      continue;
    bool const touching = point.status != interface::Status::open;
    (point.status == interface::Status::stick ? sum.stick : touching ? sum.slip : sum.open) += 1;
    if (touching)
      sum.closed_area += pair.areas[i];
    sum.force_x += reaction[2 * node];
    sum.force_y += reaction[2 * node + 1];
  }
  sum.beta_mean /= area;
  return sum;
}

Sampler add(ContactProbe const& probe, Context const& context) {
  auto const p = ix(context.scene.pair_index(probe.pair));
  auto const& pair = context.scene.model->pairs[p];
  char const* force = context.force_unit();
  context.column("force_x", force, "contact force on the secondary surface, x");
  context.column("force_y", force, "contact force on the secondary surface, y");
  context.column("open", "1", "points in reach that are open");
  context.column("stick", "1", "points that stick");
  context.column("slip", "1", "points that slip");
  context.column("closed_area", context.plane() ? "m" : "m^2", "reference area of the closed points");
  context.column("beta_max", "1", "largest bond intensity");
  context.column("beta_mean", "1", "mean bond intensity over the surface");
  context.column("pressure_max", "Pa", "largest dry pressure");
  context.column("adhesion_t_max", "Pa", "largest tangential adhesion");
  context.column("adhesion_n_min", "Pa", "strongest normal adhesion (negative: pulling)");
  context.column("gap_min", "m", "smallest gap");
  return [p, &pair](State const& state, std::vector<double>& row) {
    auto const s = summarise(pair, state.contacts[p], state.reaction);
    row.insert(row.end(), {s.force_x, s.force_y, s.open, s.stick, s.slip, s.closed_area, s.beta_max,
                           s.beta_mean, s.pressure_max, s.adhesion_t_max, s.adhesion_n_min, s.gap_min});
  };
}

Sampler add(ForceProbe const& probe, Context const& context) {
  auto const nodes = *context.scene.nodes_of(probe.set);
  context.column("force_x", context.force_unit(), "force of the motion on the set over the step, x");
  context.column("force_y", context.force_unit(), "force of the motion on the set over the step, y");
  return [nodes](State const& state, std::vector<double>& row) {
    contact::Vec2 sum = contact::Vec2::Zero();
    for (Index const node : nodes)
      sum += state.drive.segment<2>(2 * node);
    row.insert(row.end(), {sum.x(), sum.y()});
  };
}

Sampler add(NodeProbe const& probe, Context const& context) {
  Index const node = context.scene.nearest(*context.scene.nodes_of(probe.set), probe.near);
  context.column("u_x", "m", "displacement, x");
  context.column("u_y", "m", "displacement, y");
  context.column("v_x", "m/s", "velocity, x");
  context.column("v_y", "m/s", "velocity, y");
  return [node](State const& state, std::vector<double>& row) {
    row.insert(row.end(),
               {state.u[2 * node], state.u[2 * node + 1], state.v[2 * node], state.v[2 * node + 1]});
  };
}

Sampler add(EnergyProbe const&, Context const& context) {
  char const* unit = context.energy_unit();
  context.column("kinetic", unit, "kinetic energy");
  context.column("strain", unit, "strain energy");
  context.column("bond", unit, "bond energy, (9)");
  context.column("potential", unit, "potential energy of gravity");
  context.column("motion_work", unit, "work done by motions and obstacles");
  context.column("friction_loss", unit, "dissipated by friction");
  context.column("bonding_loss", unit, "dissipated by bonding, int A b beta'^2 dt");
  context.column("scheme_loss", unit, "lost by the time scheme");
  return [](State const& state, std::vector<double>& row) {
    auto const& l = state.ledger;
    row.insert(row.end(), {l.kinetic, l.strain, l.bond, l.potential, l.motion_work, l.friction_loss,
                           l.bonding_loss, l.scheme_loss()});
  };
}

} // namespace

std::vector<Sampler> add_probes(Scene const& scene, record::Series& series) {
  std::vector<Sampler> samplers;
  for (auto const& [name, probe] : scene.part.probes) {
    Context const context{scene, series, name};
    samplers.push_back(std::visit([&](auto const& part) { return add(part, context); }, probe));
  }
  return samplers;
}

} // namespace stiction::scene
