// Contact and rigid: columns called as those of half spaces are.
#include "scene/probes/formula_probes.hpp"

namespace stiction::scene {

namespace {

struct FormulaContext {
  Scene const& scene;
  Columns const& series;
  std::string const& name;
  [[nodiscard]] bool line() const { return scene.half_space->grid.line; }
  [[nodiscard]] formula::Gives gives() const { return scene.formula->normal->gives(); }
  void column(std::string const& column, char const* unit, char const* meaning) const {
    series.add(name, column, unit, meaning, 1);
  }
  /// Along x [and y], then along the normal.
  void vector(std::string const& what, char const* unit, char const* meaning) const {
    for (char const* axis : line() ? std::vector{"_x", "_y"} : std::vector{"_x", "_y", "_z"})
      column(what + axis, unit, meaning);
  }
};

void push(FormulaContext const& context, std::array<double, 2> const& along, std::vector<double>& row) {
  row.push_back(along[0]);
  if (!context.line())
    row.push_back(along[1]);
}

FormulaSampler add_of(ContactProbe const&, FormulaContext const& context) {
  context.vector("force", context.line() ? "N/m" : "N", "contact force on the half space");
  context.column("closed_area", context.line() ? "m" : "m^2", "area that touches");
  if (context.gives().peak)
    context.column("pressure_max", "Pa", "largest dry pressure");
  return [context](FormulaState const& state, std::vector<double>& row) {
    push(context, state.along, row);
    row.push_back(0 - state.normal.force); // no -0
    row.push_back(state.normal.area);
    if (context.gives().peak)
      row.push_back(state.normal.peak);
  };
}

FormulaSampler add_of(RigidProbe const&, FormulaContext const& context) {
  bool const depth = context.gives().depth;
  if (depth)
    context.vector("u", "m", "displacement");
  else
    context.column("u_x", "m", "displacement");
  context.vector("force", context.line() ? "N/m" : "N", "force of the contact on it");
  return [context, depth](FormulaState const& state, std::vector<double>& row) {
    push(context, state.way, row);
    if (depth)
      row.push_back(0 - state.normal.depth);
    push(context, {0 - state.along[0], 0 - state.along[1]}, row);
    row.push_back(state.normal.force);
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
    FormulaContext const context{scene, columns, name};
    samplers.push_back(std::visit([&](auto const& part) { return add_of(part, context); }, probe));
  }
  return samplers;
}

} // namespace stiction::scene
