// Unknowns by their nodes, as multigrid has them, the rigid-body motions of these, and words for cells.
#include <fmt/format.h>

#include "dynamics/bulk/bulk_system.hpp"
#include "linear/multigrid_factor.hpp"

namespace stiction::dynamics {

bool BulkSystem::moves(Index node) const {
  return unknown_of(3 * node) >= 0 || unknown_of(3 * node + 1) >= 0 || unknown_of(3 * node + 2) >= 0;
}

/// For multigrid: nodes that have an unknown in their order, and their rigid-body motions.
linear::NodesOfUnknowns BulkSystem::nodes_of_unknowns(Model const& model) const {
  Indices nodes;
  for (Index node = 0; node < model.node_count(); ++node)
    if (moves(node))
      nodes.push_back(node);
  return {places(nodes), motions(model, nodes)};
}

/// Of the unknowns in these nodes, 3 k + component for that of the k-th.
Indices BulkSystem::places(Indices const& nodes) const {
  Indices number(unknown_of_.size() / 3), all;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    number[ix(nodes[k])] = static_cast<Index>(k);
  for (Index const dof : dof_of_)
    all.push_back(3 * number[ix(dof / 3)] + dof % 3);
  return all;
}

/// Rigid-body motions of some nodes, [3 nodes, 6].
Dense BulkSystem::motions(Model const& model, Indices const& nodes) {
  Vec3 const middle = model.reference.colwise().mean();
  double const size = (model.reference.rowwise() - middle.transpose()).cwiseAbs().maxCoeff();
  Dense all = Dense::Zero(3 * static_cast<Index>(nodes.size()), 6);
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    Vec3 const x = (model.reference.row(nodes[k]).transpose() - middle) / size;
    auto rows = all.middleRows<3>(3 * static_cast<Index>(k));
    rows.leftCols<3>().setIdentity();
    for (int axis = 0; axis < 3; ++axis)
      rows.col(3 + axis) = Vec3::Unit(axis).cross(x);
  }
  return all;
}

std::string BulkSystem::cell_words(Index cell) const {
  std::size_t body = 0;
  while (cell >= model_->cells[body].count())
    cell -= model_->cells[body++].count();
  Vector middle = Vector::Zero(dim_);
  auto const nodes = model_->cells[body].nodes_of(cell);
  for (Index const node : nodes)
    middle += model_->bodies[body]->mesh.nodes.row(node).transpose() / static_cast<double>(nodes.size());
  return fmt::format("cell {} of body {}, at ({:.4g}) m", cell + 1, model_->bodies[body]->name,
                     fmt::join(middle, ", "));
}

} // namespace stiction::dynamics
