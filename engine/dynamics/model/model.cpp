// Cells of shared bodies, unknowns of free rigid ones.
#include "dynamics/model/model.hpp"

#include <cmath>

namespace stiction::dynamics {

solid::Cells cells_of(Model const& model, std::size_t body) {
  if (!model.share)
    return {*model.bodies[body], model.kinematics};
  return {*model.bodies[body], model.kinematics,
          [&](std::span<Index const> nodes) { return model.share->part(nodes, model.first_node[body]); }};
}

Vector arms(Model const& model) {
  Vector all;
  for (auto const& rigid : model.rigids)
    if (rigid.free() && rigid.inertia > 0) {
      if (all.size() == 0)
        all.setOnes(model.dofs());
      all.segment(model.dim() * (rigid.node + 1), model.dim())
          .setConstant(std::sqrt(rigid.inertia / rigid.mass));
    }
  return all;
}

void add_unknowns(Model& model, RigidBody& rigid, Vec3 const& velocity, Vec3 const& spin) {
  int const dim = model.dim();
  rigid.node = model.node_count();
  Index const count = rigid.node + 2;
  model.reference.conservativeResize(count, dim);
  model.velocity.conservativeResize(count, dim);
  model.reference.row(rigid.node) = rigid.pivot.head(dim).transpose();
  model.reference.row(rigid.node + 1).setZero();
  model.velocity.row(rigid.node) = velocity.head(dim).transpose();
  if (dim == 3)
    model.velocity.row(rigid.node + 1) = spin.transpose();
  else
    model.velocity.row(rigid.node + 1) << spin.z(), 0;
  for (int c = 0; c < dim; ++c)
    if (rigid.inertia == 0 || (dim == 2 && c == 1))
      model.motions.push_back({{rigid.node + 1}, c, {}});
}

} // namespace stiction::dynamics
