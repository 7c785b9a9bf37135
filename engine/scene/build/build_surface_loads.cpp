// Loads of a scene that follow a surface.
#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>

#include "dynamics/bulk/surface_loads.hpp"
#include "scene/build/builder.hpp"
#include "solid/facets.hpp"

namespace stiction::scene {

namespace {

/// Pressure per part of a cavity's volume that lacks, over Young's modulus.
constexpr double volume_held = 1e6;

/// Corners of a facet's sides that no other facet of the surface has: where it is open.
std::set<Index> rim_of(std::vector<mesh::Facet> const& facets, int dim) {
  std::map<Indices, int> sides;
  for (auto const& facet : facets) {
    auto const corners = dim == 2 ? 2 : facet.nodes.size() % 4 == 0 ? 4 : 3;
    for (int k = 0; k < corners; ++k) {
      Indices side{facet.nodes[static_cast<std::size_t>(k)]};
      if (dim == 3)
        side.push_back(facet.nodes[static_cast<std::size_t>((k + 1) % corners)]);
      std::ranges::sort(side);
      ++sides[side];
    }
  }
  std::set<Index> rim;
  for (auto const& [side, count] : sides)
    if (count == 1)
      rim.insert(side.begin(), side.end());
  return rim;
}

double size_of(dynamics::Model const& model) {
  return model.reference.colwise().norm().maxCoeff();
}

bool on_seal(dynamics::Model const& model, dynamics::Gas const& gas, Index node) {
  Vector const off = model.reference.row(node).transpose() - gas.centre.head(model.dim());
  return gas.seal && std::abs(off.dot(gas.seal->normal.head(model.dim()))) < 1e-9 * size_of(model);
}

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

/// A wall may end where a motion keeps its end in a plane of symmetry, on the axis, or where it is held: then
/// the rest of the cavity, a cone up to the centre, stays as it is.
void Builder::check_cavity(Where const& where, dynamics::Gas const& gas) {
  auto const& model = *scene_.model;
  bool const revolved = model.kinematics == solid::Kinematics::axisymmetric;
  std::set<std::pair<Index, int>> held;
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      held.insert({node, motion.component});
  double const size = size_of(model);
  auto const kept = [&](Index node) {
    int components = 0;
    bool in_plane = revolved && model.reference(node, 0) == 0;
    for (int c = 0; c < model.dim(); ++c) {
      bool const there = revolved ? c == 1 : std::abs(model.reference(node, c) - gas.centre[c]) < 1e-9 * size;
      bool const driven = held.contains({node, c});
      components += driven ? 1 : 0;
      in_plane = in_plane || (there && driven);
    }
    return in_plane || components == model.dim() || on_seal(model, gas, node);
  };
  for (Index const node : rim_of(gas.facets, model.dim()))
    if (!kept(node)) {
      std::vector<double> at;
      at.reserve(3);
      for (int c = 0; c < model.dim(); ++c)
        at.push_back(model.reference(node, c));
      return complain(
          where, fmt::format("\"{}\" is no cavity: it is open at ({:.4g}) m; name all of its wall, or let "
                             "that end at planes of symmetry through `centre` that motions keep it in, where "
                             "motions hold it altogether, or on its `seal`",
                             gas.set, fmt::join(at, ", ")));
    }
}

/// What of the wall's end is on the seal, but not on the axis.
void Builder::add_seal(Where const& where, GasPart const& part, dynamics::Gas& gas) {
  auto const& model = *scene_.model;
  check_size({where[0], "seal"}, part.seal);
  if (vec(part.seal).isZero(0))
    return complain({where[0], "seal"}, "is no direction; give numbers that are not all 0");
  gas.seal = dynamics::Seal{{}, vec(part.seal).normalized(), part.leaks_at};
  bool const revolved = model.kinematics == solid::Kinematics::axisymmetric;
  for (Index const node : rim_of(gas.facets, model.dim()))
    if (on_seal(model, gas, node) && !(revolved && model.reference(node, 0) == 0))
      gas.seal->rim.push_back(node);
  if (gas.seal->rim.empty())
    complain({where[0], "seal"},
             fmt::format("has no end of \"{}\" on it; give the normal of the plane through "
                         "`centre` that the wall stands on",
                         part.set));
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
    return complain({where[0], "set"},
                    fmt::format("\"{}\" encloses no cavity: its volume is {:.3g}; name the wall of a cavity, "
                                "closed, or ending at planes of symmetry through `centre`, or at the axis",
                                part.set, gas.volume));
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
