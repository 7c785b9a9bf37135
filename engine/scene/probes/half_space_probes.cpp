// One overload per probe of a half space: its columns and its sampler.
#include "scene/probes/half_space_probes.hpp"

#include <algorithm>
#include <cmath>

#include "halfspace/points.hpp"
#include "scene/probes/formula_probes.hpp"
#include "scene/probes/grid_columns.hpp"

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

/// (n, x, y) with n into the half space, as x, y, z, or x, y in plane strain.
void push_vector(halfspace::Grid const& grid, contact::Vec3 const& local, std::vector<double>& row) {
  row.push_back(local[1]);
  if (!grid.line)
    row.push_back(local[2]);
  row.push_back(-local[0]);
}

HalfSpaceSampler add_of(PointProbe const& probe, GridContext const& context) {
  Index const point = add_point(probe, context);
  return [&model = context.model, point](GridState const& state, std::vector<double>& row) {
    push_point(
        model.grid, [&](Index i) { return halfspace::contact_state(model, state, i); }, point, row);
  };
}

HalfSpaceSampler add_of(LineProbe const&, GridContext const& context) {
  add_line(context);
  return [&model = context.model](GridState const& state, std::vector<double>& row) {
    push_line(
        model.grid, [&](Index i) { return halfspace::contact_state(model, state, i); }, row);
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
  context.column("adhesion_n", context.force_unit(), "normal adhesion of all points (negative: pulling)");
  context.column("gap_min", "m", "smallest gap");
  context.column("gap_mean", "m", "mean gap over the surface");
  return [&model = context.model](GridState const& state, std::vector<double>& row) {
    double counts[3] = {}, beta_max = 0, beta_sum = 0, bonds = 0, pressure = 0, along = 0, pull = 0,
           pulls = 0, square = 0;
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
      pulls += at.adhesion[0] * model.grid.area();
    }
    push_vector(model.grid, total_force(model, state), row);
    row.insert(row.end(), {counts[0], counts[1], counts[2], (counts[1] + counts[2]) * model.grid.area(),
                           beta_max, beta_sum / n, bonds, pressure, std::sqrt(square / n), along, pull, pulls,
                           state.gap.minCoeff(), state.gap.mean()});
  };
}

HalfSpaceSampler add_of(RigidProbe const&, GridContext const& context) {
  context.vector("u", "m", "displacement");
  context.vector("force", context.force_unit(), "force of the contact on it");
  return [&model = context.model](GridState const& state, std::vector<double>& row) {
    push_vector(model.grid, {-state.lift, state.along[0], state.along[1]}, row);
    push_vector(model.grid, -total_force(model, state), row);
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
