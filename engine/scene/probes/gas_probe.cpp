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
  return [k, &model](dynamics::State const& state, std::vector<double>& row) {
    row.push_back(state.gas[k]);
    row.push_back(dynamics::SurfaceLoads(model).volume(model.gases[k], state.u));
  };
}

} // namespace stiction::scene
