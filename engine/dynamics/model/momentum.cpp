// Sums of nodal forces and moments.
#include "dynamics/model/momentum.hpp"

#include <Eigen/Geometry>

namespace stiction::dynamics {

namespace {

Vec3 at_one(Vector const& nodal, int dim, Index node) {
  Vec3 v = Vec3::Zero();
  v.head(dim) = nodal.segment(dim * node, dim);
  return v;
}

/// After the bodies' nodes each free rigid body has that of its pivot, then that of its turn.
bool turns(Model const& model, Index node) {
  return node >= model.first_node.back() && (node - model.first_node.back()) % 2 == 1;
}

Screw at_node(Model const& model, Vector const& u, Vector const& nodal, Index node) {
  int const dim = model.dim();
  Vec3 const value = at_one(nodal, dim, node);
  if (turns(model, node))
    return {Vec3::Zero(), dim == 2 ? Vec3(0, 0, value.x()) : value};
  Vec3 position = at_one(u, dim, node);
  position.head(dim) += model.reference.row(node).transpose();
  return {value, position.cross(value)};
}

} // namespace

Screw resultant(Model const& model, Vector const& u, Vector const& nodal, Index first, Index last) {
  Screw sum;
  for (Index node = first; node < last; ++node)
    sum += at_node(model, u, nodal, node);
  return sum;
}

PairScrew resultants(Model const& model, Pair const& pair, Vector const& u, Vector const& nodal) {
  PairScrew sums;
  for (Index const node : pair.nodes())
    sums.secondary += at_node(model, u, nodal, node);
  sums.primary = resultant(model, u, nodal, 0, model.node_count());
  sums.primary += -1 * sums.secondary;
  return sums;
}

} // namespace stiction::dynamics
