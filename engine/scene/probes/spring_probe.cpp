// The columns of a spring probe.
#include "dynamics/bulk/springs.hpp"
#include "scene/probes/probes.hpp"

namespace stiction::scene {

Sampler add_spring(SpringProbe const& probe, Scene const& scene, Columns const& series,
                   std::string const& name) {
  auto const& model = *scene.model;
  std::size_t s = 0;
  while (model.springs[s].name != probe.spring)
    ++s;
  bool const plane = scene.part.kinematics == solid::Kinematics::plane_strain;
  int const dim = model.dim();
  for (int c = 0; c < dim; ++c)
    series.add(name, std::string("force_") + "xyz"[c], plane ? "N/m" : "N",
               "force of spring and dashpot on `from`; on the other end the reverse", 1);
  series.add(name, "elongation", "m",
             model.springs[s].along == dynamics::SpringAlong::axes
                 ? "length of the displacement of one end against the other"
                 : "beyond the length at which it is free of force",
             1);
  series.add(name, "energy", plane ? "J/m" : "J", "stored", 1);
  return
      [s, dim, springs = dynamics::Springs(model)](dynamics::State const& state, std::vector<double>& row) {
        auto const pull = springs.pull(s, {state.u, state.v, state.t});
        row.insert(row.end(), pull.force.data(), pull.force.data() + dim);
        row.insert(row.end(), {pull.elongation, pull.energy});
      };
}

} // namespace stiction::scene
