// Prescribed forces of a scene as nodal forces: tractions integrated over facets, forces at points.
#include <fmt/format.h>

#include "mesh/topology/traction.hpp"
#include "scene/build/builder.hpp"

namespace stiction::scene {

void Builder::add_loads() {
  for (std::size_t k = 0; k < scene_.part.loads.size(); ++k)
    std::visit([&](auto const& part) { add_load({fmt::format("loads[{}]", k + 1)}, part); },
               scene_.part.loads[k]);
}

/// One model load per component with values; `shares`: force per unit value, [nodes].
void Builder::add_components(Where const& where, LoadPath const& load, Vector const& shares) {
  auto& model = *scene_.model;
  check_no_z({where[0], "z"}, load.z);
  check_path_end(where, load.times);
  check_components(where, load);
  int component = 0;
  for (auto const* values : {&load.x, &load.y, &load.z}) {
    if (!values->empty() && component < model.dim()) {
      dynamics::Load made{Vector::Zero(model.dofs()), path(load.times, *values)};
      for (Index node = 0; node < shares.size(); ++node)
        made.force[model.dim() * node + component] = shares[node];
      model.loads.push_back(std::move(made));
    }
    ++component;
  }
}

void Builder::add_load(Where const& where, TractionPart const& part) {
  auto const& model = *scene_.model;
  auto const set = surface({where[0], "set"}, part.set);
  if (!set)
    return;
  std::size_t body = 0;
  while (scene_.bodies[body] != part.set.substr(0, part.set.find('.')))
    ++body;
  auto const& mesh = model.bodies[body]->mesh;
  Index const first = model.first_node[body];
  bool const revolved = model.kinematics == solid::Kinematics::axisymmetric;
  Vector shares = Vector::Zero(model.node_count());
  for (auto const& facet : mesh.sets.find(part.set.substr(part.set.find('.') + 1))->second.facets) {
    Vector const integrals = mesh::shape_integrals(mesh.nodes, facet, revolved);
    for (std::size_t i = 0; i < facet.nodes.size(); ++i)
      shares[first + facet.nodes[i]] += integrals[static_cast<Eigen::Index>(i)];
  }
  add_components(where, part, shares);
}

void Builder::add_load(Where const& where, PointForcePart const& part) {
  auto const nodes = resolve({where[0], "set"}, part.set);
  check_size({where[0], "near"}, part.near);
  if (!nodes)
    return;
  Vector shares = Vector::Zero(scene_.model->node_count());
  shares[scene_.nearest(*nodes, part.near)] = 1;
  add_components(where, part, shares);
}

} // namespace stiction::scene
