// One overload per probe: its columns and its sampler.
#include "scene/probes/probes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "dynamics/adaptivity/point_history.hpp"
#include "scene/probes/point_quantities.hpp"

namespace stiction::scene {

using dynamics::ContactState;
using dynamics::State;

namespace {

struct Context {
  Scene const& scene;
  Columns const& series;
  std::string const& name;
  [[nodiscard]] bool plane() const { return scene.part.kinematics == solid::Kinematics::plane_strain; }
  [[nodiscard]] int dim() const { return scene.part.dim(); }
  [[nodiscard]] char const* force_unit() const { return plane() ? "N/m" : "N"; }
  [[nodiscard]] char const* area_unit() const { return plane() ? "m" : "m^2"; }
  [[nodiscard]] char const* energy_unit() const { return plane() ? "J/m" : "J"; }
  void column(std::string const& column, char const* unit, char const* meaning, int width = 1) const {
    series.add(name, column, unit, meaning, width);
  }
};

/// Name of a component: "force" with "x", "y" or "z".
std::string component(char const* name, int c) {
  return std::string(name) + '_' + "xyz"[c];
}

Sampler add(PointProbe const& probe, Context const& context) {
  auto const p = ix(context.scene.pair_index(probe.pair));
  auto const& pair = context.scene.model->pairs[p];
  Index const node = context.scene.nearest(pair.secondary, probe.near);
  auto const i = static_cast<std::size_t>(std::find(pair.secondary.begin(), pair.secondary.end(), node) -
                                          pair.secondary.begin());
  auto const chosen = quantities(context.dim());
  for (auto const& quantity : chosen)
    context.column(quantity.name, quantity.unit != nullptr ? quantity.unit : context.area_unit(),
                   quantity.meaning);
  auto const X = context.scene.model->reference.row(node);
  for (int c = 0; c < context.dim(); ++c)
    context.series.set_attribute(context.name, std::string(1, "XYZ"[c]), X[c]);
  return [p, i, chosen](State const& state, std::vector<double>& row) {
    for (auto const& quantity : chosen)
      row.push_back(quantity.value(state.contacts[p][i]));
  };
}

Sampler add(LineProbe const& probe, Context const& context) {
  auto const p = ix(context.scene.pair_index(probe.pair));
  auto const& model = *context.scene.model;
  auto const width = static_cast<int>(model.pairs[p].secondary.size());
  int const dim = context.dim();
  for (int c = 0; c < dim; ++c)
    context.column(std::string(1, "XYZ"[c]), "m", "reference coordinate of the points", width);
  context.column("count", "1", "contact points of the pair");
  auto const chosen = quantities(dim);
  for (auto const& quantity : chosen)
    context.column(quantity.name, quantity.unit != nullptr ? quantity.unit : context.area_unit(),
                   quantity.meaning, width);
  return [p, dim, chosen, &model](State const& state, std::vector<double>& row) {
    for (int c = 0; c < dim; ++c)
      for (Index const node : model.pairs[p].secondary)
        row.push_back(model.reference(node, c));
    row.push_back(static_cast<double>(model.pairs[p].size()));
    for (auto const& quantity : chosen)
      for (auto const& point : state.contacts[p])
        row.push_back(quantity.value(point));
  };
}

/// What a whole pair shows at one moment.
struct PairSummary {
  contact::Vec3 force = contact::Vec3::Zero();
  double open = 0, stick = 0, slip = 0, closed_area = 0;
  double beta_max = 0, beta_mean = 0, pressure_max = 0, adhesion_t_max = 0, adhesion_n_min = 0,
         adhesion_n = 0, gap_min = 0;
};

void add_force(Index node, Vector const& reaction, int dim, contact::Vec3& sum) {
  for (int c = 0; c < dim; ++c)
    sum[c] += reaction[dim * node + c];
}

/// Part of a pair's secondary surface: its points, and the nodes that bear their forces.
struct Patch {
  std::vector<std::size_t> points;
  Indices nodes;
};

Patch patch_of(Scene const& scene, dynamics::Pair const& pair, std::string const& set) {
  auto const wanted = set.empty() ? std::nullopt : scene.nodes_of(set);
  std::set<Index> const among = wanted ? std::set<Index>(wanted->begin(), wanted->end()) : std::set<Index>{};
  Patch patch;
  for (std::size_t i = 0; i < pair.secondary.size(); ++i)
    if (!wanted || among.contains(pair.secondary[i]))
      patch.points.push_back(i);
  for (Index const node : pair.nodes())
    if (!wanted || among.contains(node))
      patch.nodes.push_back(node);
  return patch;
}

PairSummary summarise(dynamics::Pair const& pair, Patch const& patch, std::vector<ContactState> const& points,
                      Vector const& reaction, int dim) {
  PairSummary sum;
  double area = 0, least = std::numeric_limits<double>::infinity();
  for (std::size_t const i : patch.points) {
    auto const& point = points[i];
    if (point.foot.found())
      least = std::min(least, point.gap);
    sum.gap_min = std::max(sum.gap_min, point.gap); // where no point finds a counterpart: how far was looked
    sum.beta_max = std::max(sum.beta_max, point.bond.beta);
    sum.beta_mean += pair.areas[i] * point.bond.beta;
    area += pair.areas[i];
    sum.pressure_max = std::max(sum.pressure_max, point.dry[0]);
    sum.adhesion_t_max = std::max(sum.adhesion_t_max, point.adhesion.tail<2>().norm());
    sum.adhesion_n_min = std::min(sum.adhesion_n_min, point.adhesion[0]);
    sum.adhesion_n += point.area * point.adhesion[0];
    if (!point.in_reach)
      continue;
    bool const touching = point.status != interface::Status::open;
    (point.status == interface::Status::stick ? sum.stick : touching ? sum.slip : sum.open) += 1;
    if (touching)
      sum.closed_area += point.area;
    if (!pair.shared())
      add_force(pair.secondary[i], reaction, dim, sum.force);
  }
  if (pair.shared()) // forces reach nodes that are no points, or whose points are out of reach
    for (Index const node : patch.nodes)
      add_force(node, reaction, dim, sum.force);
  sum.beta_mean /= area;
  if (std::isfinite(least))
    sum.gap_min = least;
  return sum;
}

Sampler add(ContactProbe const& probe, Context const& context) {
  auto const p = ix(context.scene.pair_index(probe.pair));
  auto const& pair = context.scene.model->pairs[p];
  char const* force = context.force_unit();
  int const dim = context.dim();
  for (int c = 0; c < dim; ++c)
    context.column(component("force", c), force, "contact force on the secondary surface");
  context.column("open", "1", "points in reach that are open");
  context.column("stick", "1", "points that stick");
  context.column("slip", "1", "points that slip");
  context.column("closed_area", context.area_unit(), "reference area of the closed points");
  context.column("beta_max", "1", "largest bond intensity");
  context.column("beta_mean", "1", "mean bond intensity over the surface");
  context.column("pressure_max", "Pa", "largest dry pressure");
  context.column("adhesion_t_max", "Pa", "largest tangential adhesion");
  context.column("adhesion_n_min", "Pa", "strongest normal adhesion (negative: pulling)");
  context.column("adhesion_n", force, "normal adhesion of all points (negative: pulling)");
  context.column("gap_min", "m", "smallest gap; the radius of the search where nothing is near");
  return [p, dim, &pair, patch = patch_of(context.scene, pair, probe.set)](State const& state,
                                                                           std::vector<double>& row) {
    auto const s = summarise(pair, patch, state.contacts[p], state.reaction_of(p), dim);
    row.insert(row.end(), s.force.data(), s.force.data() + dim);
    row.insert(row.end(), {s.open, s.stick, s.slip, s.closed_area, s.beta_max, s.beta_mean, s.pressure_max,
                           s.adhesion_t_max, s.adhesion_n_min, s.adhesion_n, s.gap_min});
  };
}

/// Names of the components of moments; none where they cancel around the axis.
std::vector<std::string> moment_names(Context const& context) {
  if (context.dim() == 3)
    return {"moment_x", "moment_y", "moment_z"};
  return context.plane() ? std::vector<std::string>{"moment"} : std::vector<std::string>{};
}

Sampler add(ForceProbe const& probe, Context const& context) {
  auto nodes = *context.scene.nodes_of(probe.set);
  if (!probe.near.empty())
    nodes = {context.scene.nearest(nodes, probe.near)};
  int const dim = context.dim();
  for (int c = 0; c < dim; ++c)
    context.column(component("force", c), context.force_unit(),
                   "force of the motion on the set over the step");
  auto const moments = moment_names(context);
  for (auto const& name : moments)
    context.column(name, context.plane() ? "N" : "N m", "moment of these forces where the step ends");
  auto const first = dim == 2 ? 2 : 0, count = static_cast<int>(moments.size());
  return [nodes, dim, first, count, about = vec(probe.about),
          &model = *context.scene.model](State const& state, std::vector<double>& row) {
    contact::Vec3 sum = contact::Vec3::Zero(), moment = contact::Vec3::Zero();
    for (Index const node : nodes) {
      contact::Vec3 force = contact::Vec3::Zero(), arm = -about;
      force.head(dim) = state.drive.segment(dim * node, dim);
      arm.head(dim) += model.reference.row(node).transpose() + state.u.segment(dim * node, dim);
      sum += force;
      moment += arm.cross(force);
    }
    row.insert(row.end(), sum.data(), sum.data() + dim);
    row.insert(row.end(), moment.data() + first, moment.data() + first + count);
  };
}

Sampler add(NodeProbe const& probe, Context const& context) {
  Index const node = context.scene.nearest(*context.scene.nodes_of(probe.set), probe.near);
  int const dim = context.dim();
  for (int c = 0; c < dim; ++c)
    context.column(component("u", c), "m", "displacement");
  for (int c = 0; c < dim; ++c)
    context.column(component("v", c), "m/s", "velocity");
  return [node, dim](State const& state, std::vector<double>& row) {
    for (auto const* values : {&state.u, &state.v})
      row.insert(row.end(), values->data() + dim * node, values->data() + dim * (node + 1));
  };
}

/// Where the pivot of an obstacle is, as a displacement, m.
contact::Vec3 shift_of(dynamics::RigidBody const& rigid, State const& state, int dim) {
  if (!rigid.free())
    return rigid.offset(state.t);
  contact::Vec3 shift = contact::Vec3::Zero();
  shift.head(dim) = state.u.segment(dim * rigid.node, dim);
  return shift;
}

double angle_of(dynamics::RigidBody const& rigid, State const& state, int dim) {
  if (!rigid.free())
    return rigid.angle.value(state.t);
  auto const turn = state.u.segment(dim * (rigid.node + 1), dim);
  return dim == 2 ? turn[0] : turn.norm();
}

/// Of every pair with the obstacle as primary, whether it has a mass or follows paths.
Sampler add(RigidProbe const& probe, Context const& context) {
  auto const& model = *context.scene.model;
  std::size_t r = 0;
  while (model.rigids[r].name != probe.obstacle)
    ++r;
  int const dim = context.dim();
  for (int c = 0; c < dim; ++c)
    context.column(component("u", c), "m", "displacement of the pivot");
  for (int c = 0; c < dim; ++c)
    context.column(component("force", c), context.force_unit(), "force of the contacts on the obstacle");
  context.column("angle", "rad", "turn about its axis (in space, of a free body: length of the turns' sum)");
  auto const moments = moment_names(context);
  for (auto const& name : moments)
    context.column(name, context.plane() ? "N" : "N m",
                   "moment of the contacts on the obstacle about its pivot, where that is now");
  auto const first = dim == 2 ? 2 : 0, count = static_cast<int>(moments.size());
  return [r, dim, first, count, &model](State const& state, std::vector<double>& row) {
    auto const& rigid = model.rigids[r];
    auto const& load = state.on_rigid[r];
    contact::Vec3 const shift = shift_of(rigid, state, dim),
                        moment = load.moment - (rigid.pivot + shift).cross(load.force);
    row.insert(row.end(), shift.data(), shift.data() + dim);
    row.insert(row.end(), load.force.data(), load.force.data() + dim);
    row.push_back(angle_of(rigid, state, dim));
    row.insert(row.end(), moment.data() + first, moment.data() + first + count);
  };
}

Sampler add_audit(Context const& context) {
  char const* unit = context.energy_unit();
  context.column("rate_loss", unit, "of scheme_loss: mean rates and forces are not those of the step");
  context.column("average_loss", unit, "of scheme_loss: averages of the internal force");
  context.column("contact_loss", unit, "of scheme_loss: pressure while the gap closes, steps of adhesion");
  context.column("turning_loss", unit, "of scheme_loss: normals that turn within a step");
  context.column("unaccounted", unit, "scheme_loss less these four");
  return [](State const& state, std::vector<double>& row) {
    auto const& p = state.ledger.predicted;
    row.insert(row.end(), {p.rates, p.averages, p.contact, p.turning, state.ledger.unaccounted()});
  };
}

Sampler add(EnergyProbe const& probe, Context const& context) {
  char const* unit = context.energy_unit();
  context.column("kinetic", unit, "kinetic energy");
  context.column("strain", unit, "strain energy");
  context.column("bond", unit, "bond energy, (9)");
  context.column("potential", unit, "potential energy of gravity");
  context.column("motion_work", unit, "work done by motions, obstacles and moving ends of springs");
  context.column("load_work", unit, "work done by prescribed forces");
  context.column("damping_loss", unit, "dissipated by the bodies' viscosity");
  bool const relaxing = std::ranges::any_of(context.scene.model->bodies,
                                            [](auto const& body) { return !body->relaxing.empty(); });
  if (relaxing)
    context.column("relaxation_loss", unit, "dissipated by networks that relax");
  context.column("stabilisation_loss", unit, "dissipated by the stabilisation of scheme.quasi_static");
  context.column("friction_loss", unit, "dissipated by friction");
  context.column("bonding_loss", unit, "dissipated by bonding, int A b beta'^2 dt");
  context.column("scheme_loss", unit, "lost by the time scheme");
  bool const springs = !context.scene.model->springs.empty();
  if (springs) {
    context.column("spring", unit, "stored in springs");
    context.column("dashpot_loss", unit, "dissipated by the dashpots of springs");
  }
  bool const surface = !context.scene.model->surface_stresses.empty();
  if (surface)
    context.column("surface", unit, "stored in surfaces by their stress");
  Sampler const more = probe.audit ? add_audit(context) : Sampler{};
  return [more, relaxing, springs, surface](State const& state, std::vector<double>& row) {
    auto const& l = state.ledger;
    row.insert(row.end(),
               {l.kinetic, l.strain, l.bond, l.potential, l.motion_work, l.load_work, l.damping_loss});
    if (relaxing)
      row.push_back(l.relaxation_loss);
    row.insert(row.end(), {l.stabilisation_loss, l.friction_loss, l.bonding_loss, l.scheme_loss()});
    if (springs)
      row.insert(row.end(), {l.spring, l.dashpot_loss});
    if (surface)
      row.push_back(l.surface);
    if (more)
      more(state, row);
  };
}

Sampler add(GasProbe const& probe, Context const& context) {
  return add_gas(probe, context.scene, context.series, context.name);
}

Sampler add(SpringProbe const& probe, Context const& context) {
  return add_spring(probe, context.scene, context.series, context.name);
}

Sampler add(MomentumProbe const& probe, Context const& context) {
  return add_momentum(probe, context.scene, context.series, context.name);
}

} // namespace

void add_step_columns(Scene const& scene, record::Series& series) {
  series.add("step", "dt", "s", "step size");
  series.add("step", "iterations", "1", "Newton iterations");
  if (!scene.part.schedule.accuracy)
    return;
  series.add("step", "error_u", "1", "estimated local error of u over the largest u so far");
  series.add("step", "error_beta", "1", "largest estimated local error of any beta");
  series.add("step", "beta_change", "1", "largest change of any beta in the step");
  series.add("step", "events", "1", "points that touch or separate, betas that reach or leave an end");
}

void add_step_error(dynamics::StepError const& error, std::vector<double>& row) {
  row.insert(row.end(),
             {error.displacement, error.bond, error.beta_change, static_cast<double>(error.events)});
}

Columns columns_of(record::Series& series) {
  return {
      [&](auto const& group, auto const& column, auto const& unit, auto const& meaning, int width) {
        series.add(group, column, unit, meaning, width);
      },
      [&](auto const& group, auto const& name, double value) { series.set_attribute(group, name, value); }};
}

std::vector<Sampler> add_probes(Scene const& scene, record::Series& series) {
  return add_probes(scene, columns_of(series));
}

std::vector<Sampler> add_probes(Scene const& scene, Columns const& series) {
  std::vector<Sampler> samplers;
  for (auto const& [name, probe] : scene.part.probes) {
    Context const context{scene, series, name};
    samplers.push_back(std::visit([&](auto const& part) { return add(part, context); }, probe));
  }
  return samplers;
}

} // namespace stiction::scene
