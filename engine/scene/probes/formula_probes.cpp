// Columns called as those of half spaces are.
#include "scene/probes/formula_probes.hpp"

#include <algorithm>

#include "scene/probes/formula_points.hpp"
#include "scene/probes/grid_columns.hpp"

namespace stiction::scene {

namespace {

struct FormulaContext : GridContext {
  Scene const& scene;
  [[nodiscard]] formula::Gives gives() const { return scene.formula->normal->gives(); }
};

/// Along x [and y].
void push(halfspace::Grid const& grid, std::array<double, 2> const& along, std::vector<double>& row) {
  row.push_back(along[0]);
  if (!grid.line)
    row.push_back(along[1]);
}

FormulaSampler add_of(ContactProbe const&, FormulaContext const& context) {
  context.vector("force", context.force_unit(), "contact force on the half space");
  context.column("closed_area", context.area_unit(), "area that touches");
  bool const peak = context.gives().peak;
  if (peak)
    context.column("pressure_max", "Pa", "largest dry pressure");
  return [peak, grip = context.scene.formula->grip, &grid = context.model.grid](FormulaState const& state,
                                                                                std::vector<double>& row) {
    push(grid, state.along, row);
    row.push_back(0 - state.normal.force); // no -0
    row.push_back(state.normal.area);
    if (peak)
      row.push_back(state.normal.area > 0 ? std::max(0.0, state.normal.peak + grip) : 0);
  };
}

FormulaSampler add_of(RigidProbe const&, FormulaContext const& context) {
  bool const depth = context.gives().depth;
  if (depth)
    context.vector("u", "m", "displacement");
  else
    context.column("u_x", "m", "displacement");
  context.vector("force", context.force_unit(), "force of the contact on it");
  return [depth, &grid = context.model.grid](FormulaState const& state, std::vector<double>& row) {
    push(grid, state.way, row);
    if (depth)
      row.push_back(0 - state.normal.depth);
    push(grid, {0 - state.along[0], 0 - state.along[1]}, row);
    row.push_back(state.normal.force);
  };
}

FormulaSampler add_of(EnergyProbe const&, FormulaContext const& context) {
  char const* unit = context.energy_unit();
  context.column("strain", unit, "strain energy of the half space (and of an elastic counterpart)");
  context.column("bond", unit, "bond energy, 0 apart");
  context.column("motion_work", unit, "work done by the counterpart's path");
  context.column("load_work", unit, "work done by its force");
  context.column("scheme_loss", unit, "lost between steps: what snaps, and the rest of their trapezia");
  bool const forced = context.scene.formula->drive == formula::Drive::force;
  return [forced](FormulaState const& now, std::vector<double>& row) {
    double const strain = now.normal.strain, bond = now.normal.bond;
    row.insert(row.end(), {strain, bond, forced ? 0 : now.work, forced ? now.work : 0,
                           now.start + now.work - strain - bond});
  };
}

FormulaSampler add_of(PointProbe const& probe, FormulaContext const& context) {
  return [point = add_point(probe, context), &scene = context.scene](FormulaState const& now,
                                                                     std::vector<double>& row) {
    FormulaPoints const points(scene, now);
    push_point(
        scene.half_space->grid, [&](Index i) { return points.at(i); }, point, row);
  };
}

FormulaSampler add_of(LineProbe const&, FormulaContext const& context) {
  add_line(context);
  return [&scene = context.scene](FormulaState const& now, std::vector<double>& row) {
    FormulaPoints const points(scene, now);
    push_line(
        scene.half_space->grid, [&](Index i) { return points.at(i); }, row);
  };
}

template<class Probe>
FormulaSampler add_of(Probe const&, FormulaContext const&) { // refused when the scene was built
  return [](FormulaState const&, std::vector<double>&) {};
}

} // namespace

std::vector<FormulaSampler> add_formula_probes(Scene const& scene, Columns const& columns) {
  std::vector<FormulaSampler> samplers;
  samplers.reserve(scene.part.probes.size());
  for (auto const& [name, probe] : scene.part.probes) {
    FormulaContext const context{{*scene.half_space, columns, name}, scene};
    samplers.push_back(std::visit([&](auto const& part) { return add_of(part, context); }, probe));
  }
  return samplers;
}

} // namespace stiction::scene
