// The columns of a gas probe.
#include "dynamics/bulk/surface_loads.hpp"
#include "scene/probes/probes.hpp"

namespace stiction::scene {

Sampler add_gas(GasProbe const& probe, Scene const& scene, Columns const& series, std::string const& name) {
  auto const& model = *scene.model;
  std::size_t k = 0;
  while (model.gases[k].set != probe.set)
    ++k;
  bool const plane = scene.part.kinematics == solid::Kinematics::plane_strain;
  series.add(name, "pressure", "Pa", "of the gas, over the pressure outside", 1);
  series.add(name, "volume", plane ? "m^2" : "m^3", "of the cavity", 1);
  bool const sealed = model.gases[k].seal.has_value();
  if (sealed)
    series.add(name, "leaking", "1", "1 once the wall has left its seal", 1);
  return [k, &model, sealed](dynamics::State const& state, std::vector<double>& row) {
    row.push_back(state.gas[k].pressure);
    row.push_back(dynamics::SurfaceLoads(model).volume(model.gases[k], state.u));
    if (sealed)
      row.push_back(state.gas[k].leaking ? 1 : 0);
  };
}

} // namespace stiction::scene
