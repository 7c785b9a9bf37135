// One overload per probe of a half space: its columns and its sampler.
#include "scene/probes/half_space_probes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "halfspace/points.hpp"
#include "scene/probes/formula_probes.hpp"
#include "scene/probes/point_quantities.hpp"

namespace stiction::scene {

using GridModel = halfspace::Model;
using GridState = halfspace::State;

contact::Vec3 total_force(GridModel const& model, GridState const& state) {
  int const D = model.components();
  contact::Vec3 sum = contact::Vec3::Zero();
  for (Index i = 0; i < model.grid.size(); ++i)
    sum.head(D) += state.force.segment(D * i, D);
  return sum;
}

namespace {

/// Dry forces along the normal, N.
double dry_sum(GridModel const& model, GridState const& state) {
  double sum = 0;
  for (Index i = 0; i < model.grid.size(); ++i)
    sum += state.dry[model.components() * i];
  return sum;
}

struct GridContext {
  GridModel const& model;
  Columns const& series;
  std::string const& name;
  [[nodiscard]] int dim() const { return model.grid.line ? 2 : 3; }
  [[nodiscard]] char const* force_unit() const { return model.grid.line ? "N/m" : "N"; }
  [[nodiscard]] char const* area_unit() const { return model.grid.line ? "m" : "m^2"; }
  [[nodiscard]] char const* energy_unit() const { return model.grid.line ? "J/m" : "J"; }
  void column(std::string const& column, char const* unit, char const* meaning, int width = 1) const {
    series.add(name, column, unit, meaning, width);
  }
  /// Components x, y [, z] of a vector.
  void vector(char const* what, char const* unit, char const* meaning) const {
    for (int c = 0; c < dim(); ++c)
      column(std::string(what) + '_' + "xyz"[c], unit, meaning);
  }
};

/// (n, x, y) with n into the half space, as x, y, z, or x, y in plane strain.
void push_vector(GridContext const& context, contact::Vec3 const& local, std::vector<double>& row) {
  row.push_back(local[1]);
  if (context.dim() == 3)
    row.push_back(local[2]);
  row.push_back(-local[0]);
}

void add_quantities(GridContext const& context, int width) {
  for (auto const& quantity : quantities(context.dim()))
    context.column(quantity.name, quantity.unit != nullptr ? quantity.unit : context.area_unit(),
                   quantity.meaning, width);
}

HalfSpaceSampler add_of(PointProbe const& probe, GridContext const& context) {
  auto const& grid = context.model.grid;
  auto const near = [count = static_cast<int>(probe.near.size()), &probe](int c) {
    return c < count ? probe.near[static_cast<std::size_t>(c)] : 0.0;
  };
  auto const cell = [](double at, double step, Index count) {
    return std::clamp<Index>(static_cast<Index>(std::floor(at / step + 0.5 * count)), 0, count - 1);
  };
  Index const point =
      cell(near(0), grid.dx(), grid.nx) + (grid.line ? 0 : grid.nx * cell(near(1), grid.dy(), grid.ny));
  context.series.set_attribute(context.name, "X", grid.x(point));
  context.series.set_attribute(context.name, "Y", grid.y(point));
  add_quantities(context, 1);
  return [point, &model = context.model, chosen = quantities(context.dim())](GridState const& state,
                                                                             std::vector<double>& row) {
    auto const at = halfspace::contact_state(model, state, point);
    for (auto const& quantity : chosen)
      row.push_back(quantity.value(at));
  };
}

HalfSpaceSampler add_of(LineProbe const&, GridContext const& context) {
  context.column("X", "m", "reference coordinate of the points", context.model.grid.size());
  context.column("Y", "m", "reference coordinate of the points", context.model.grid.size());
  context.column("count", "1", "contact points of the pair");
  add_quantities(context, context.model.grid.size());
  return [&model = context.model, chosen = quantities(context.dim())](GridState const& state,
                                                                      std::vector<double>& row) {
    Index const n = model.grid.size();
    for (Index i = 0; i < n; ++i)
      row.push_back(model.grid.x(i));
    row.insert(row.end(), ix(n), 0.0);
    row.push_back(n);
    for (auto const& quantity : chosen)
      for (Index i = 0; i < n; ++i)
        row.push_back(quantity.value(halfspace::contact_state(model, state, i)));
  };
}

HalfSpaceSampler add_of(ContactProbe const&, GridContext const& context) {
  context.vector("force", context.force_unit(), "contact force on the half space");
  context.column("open", "1", "points that are open");
  context.column("stick", "1", "points that stick");
  context.column("slip", "1", "points that slip");
  context.column("closed_area", context.area_unit(), "area of the closed points");
  context.column("beta_max", "1", "largest bond intensity");
  context.column("beta_mean", "1", "mean bond intensity over the surface");
  context.column("bonds", "1", "points with a bond");
  context.column("pressure_max", "Pa", "largest dry pressure");
  context.column("pressure_rms", "Pa",
                 "root mean square of the dry pressure about its mean over the surface");
  context.column("adhesion_t_max", "Pa", "largest tangential adhesion");
  context.column("adhesion_n_min", "Pa", "strongest normal adhesion (negative: pulling)");
  context.column("gap_min", "m", "smallest gap");
  context.column("gap_mean", "m", "mean gap over the surface");
  return [context_dim = context.dim(), &model = context.model, &series = context.series,
          name = context.name](GridState const& state, std::vector<double>& row) {
    double counts[3] = {}, beta_max = 0, beta_sum = 0, bonds = 0, pressure = 0, along = 0, pull = 0,
           square = 0;
    Index const n = model.grid.size();
    double const mean = dry_sum(model, state) / (n * model.grid.area());
    for (Index i = 0; i < n; ++i) {
      auto const at = halfspace::contact_state(model, state, i);
      counts[static_cast<int>(at.status)] += 1;
      beta_max = std::max(beta_max, at.bond.beta);
      beta_sum += at.bond.beta;
      bonds += at.bond.beta > 0 ? 1 : 0;
      pressure = std::max(pressure, at.dry[0]);
      square += std::pow(at.dry[0] - mean, 2);
      along = std::max(along, at.adhesion.tail<2>().norm());
      pull = std::min(pull, at.adhesion[0]);
    }
    push_vector({model, series, name}, total_force(model, state), row);
    row.insert(row.end(), {counts[0], counts[1], counts[2], (counts[1] + counts[2]) * model.grid.area(),
                           beta_max, beta_sum / n, bonds, pressure, std::sqrt(square / n), along, pull,
                           state.gap.minCoeff(), state.gap.mean()});
  };
}

HalfSpaceSampler add_of(RigidProbe const&, GridContext const& context) {
  context.vector("u", "m", "displacement");
  context.vector("force", context.force_unit(), "force of the contact on it");
  return [&model = context.model, &series = context.series, name = context.name](GridState const& state,
                                                                                 std::vector<double>& row) {
    GridContext const at{model, series, name};
    push_vector(at, {-state.lift, state.along[0], state.along[1]}, row);
    push_vector(at, -total_force(model, state), row);
  };
}

HalfSpaceSampler add_of(EnergyProbe const&, GridContext const& context) {
  char const* unit = context.energy_unit();
  context.column("strain", unit, "strain energy of the half space (and of an elastic counterpart)");
  context.column("bond", unit, "bond energy, (9)");
  context.column("motion_work", unit, "work done by the counterpart's paths");
  context.column("load_work", unit, "work done by its force");
  context.column("friction_loss", unit, "dissipated by friction");
  context.column("bonding_loss", unit, "dissipated by bonding, int A b beta'^2 dt");
  context.column("scheme_loss", unit, "lost between steps: what snaps, and the rest of their trapezia");
  return [](GridState const& state, std::vector<double>& row) {
    auto const& l = state.ledger;
    row.insert(row.end(), {l.strain, l.bond, l.motion_work, l.load_work, l.friction_loss, l.bonding_loss,
                           l.scheme_loss()});
  };
}

template<class Probe>
HalfSpaceSampler add_of(Probe const&, GridContext const&) { // refused when the scene was built
  return [](GridState const&, std::vector<double>&) {};
}

} // namespace

void add_columns(Scene const& scene, Columns const& columns) {
  if (scene.formula)
    static_cast<void>(add_formula_probes(scene, columns));
  else if (scene.half_space)
    static_cast<void>(add_half_space_probes(scene, columns));
  else
    static_cast<void>(add_probes(scene, columns));
}

std::vector<HalfSpaceSampler> add_half_space_probes(Scene const& scene, Columns const& columns) {
  std::vector<HalfSpaceSampler> samplers;
  for (auto const& [name, probe] : scene.part.probes) {
    GridContext const context{*scene.half_space, columns, name};
    samplers.push_back(std::visit([&](auto const& part) { return add_of(part, context); }, probe));
  }
  return samplers;
}

} // namespace stiction::scene
