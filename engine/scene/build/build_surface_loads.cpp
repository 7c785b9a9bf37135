// Loads of a scene that follow a surface.
#include <algorithm>
#include <fmt/format.h>

#include "dynamics/bulk/surface_loads.hpp"
#include "scene/build/builder.hpp"
#include "solid/facets.hpp"

namespace stiction::scene {

namespace {

/// Pressure per part of a cavity's volume that lacks, over Young's modulus. Every correction adds it anew:
/// the larger, the fewer are wanted, and the more the rounding of the volume makes of thin walls.
constexpr double volume_held = 1e3;

} // namespace

void Builder::add_load(Where const& where, PressurePart const& part) {
  auto& model = *scene_.model;
  check_path_end({where[0], "times"}, part.times);
  auto const set = surface({where[0], "set"}, part.set);
  if (!set)
    return;
  auto const way = path(part.times, part.pressure);
  if (part.follows) {
    model.pressures.push_back({set->facets, way});
    return;
  }
  dynamics::Load dead{Vector::Zero(model.dofs()), way};
  for (auto const& facet : set->facets) {
    Matrix x(static_cast<Eigen::Index>(facet.nodes.size()), model.dim());
    for (std::size_t i = 0; i < facet.nodes.size(); ++i)
      x.row(static_cast<Eigen::Index>(i)) = model.reference.row(facet.nodes[i]);
    Vector const normals =
        solid::facet_terms(model.kinematics, x, Point::Zero(), solid::FacetOrder::values).normals;
    for (std::size_t i = 0; i < facet.nodes.size(); ++i)
      dead.force.segment(model.dim() * facet.nodes[i], model.dim()) -=
          normals.segment(model.dim() * static_cast<Eigen::Index>(i), model.dim());
  }
  model.loads.push_back(std::move(dead));
}

void Builder::add_load(Where const& where, GasPart const& part) {
  auto& model = *scene_.model;
  check_path_end({where[0], "times"}, part.times);
  check_size({where[0], "centre"}, part.centre);
  auto const set = surface({where[0], "set"}, part.set);
  if (!set || (part.pressure.empty() && part.volume.empty()))
    return;
  dynamics::Gas gas;
  gas.set = part.set;
  gas.facets = set->facets;
  gas.nodes = set->nodes;
  gas.centre = vec(part.centre);
  gas.by_volume = !part.volume.empty();
  gas.path = path(part.times, gas.by_volume ? part.volume : part.pressure);
  gas.outside = part.outside;
  gas.exponent = part.exponent;
  if (!part.seal.empty())
    add_seal(where, part, gas);
  gas.volume = dynamics::SurfaceLoads(model).volume(gas, Vector::Zero(model.dofs()));
  if (!(gas.volume > 0))
    return complain(
        {where[0], "set"},
        fmt::format("\"{}\" encloses no cavity: its volume is {:.3g} {}; name the wall of a cavity, "
                    "closed, or ending at planes of symmetry through `centre`, or at the axis",
                    part.set, gas.volume,
                    model.kinematics == solid::Kinematics::plane_strain ? "m^2" : "m^3"));
  if (gas.by_volume && dynamics::weights(model.scheme).explicit_forces)
    complain({where[0], "volume"},
             "is kept by a pressure far stiffer than the body, which central differences "
             "cannot follow; give `pressure`, the amount of gas, or an implicit scheme");
  check_cavity({where[0], "set"}, gas);
  std::size_t body = 0;
  while (scene_.bodies[body] != part.set.substr(0, part.set.find('.')))
    ++body;
  gas.stiffness = volume_held * material::moduli(model.bodies[body]->material).young / gas.volume;
  model.gases.push_back(std::move(gas));
}

void Builder::add_load(Where const& where, SurfaceStressPart const& part) {
  if (auto const set = surface({where[0], "set"}, part.set))
    scene_.model->surface_stresses.push_back({set->facets, part.gamma});
}

} // namespace stiction::scene
