// Nodes of the bodies: of contact surfaces, of unknowns as multigrid has them, what grips them, words for
// cells.
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

std::vector<bool> contact_nodes(Model const& model) {
  std::vector<bool> touched(ix(model.node_count()), false);
  for (auto const& pair : model.pairs) {
    for (Index const node : pair.nodes())
      touched[ix(node)] = true;
    if (auto const* curve = std::get_if<contact::Curve>(&pair.primary))
      for (auto const& segment : curve->segments())
        for (int k = 0; k < segment.count; ++k)
          touched[ix(segment.nodes[ix(k)])] = true;
    if (auto const* surface = std::get_if<contact::Surface>(&pair.primary))
      for (Index const node : surface->nodes())
        touched[ix(node)] = true;
    if (auto const* surface = std::get_if<contact::CellSurface>(&pair.primary))
      for (Index const node : surface->nodes())
        touched[ix(node)] = true;
  }
  for (auto const& rigid : model.rigids)
    if (rigid.free())
      touched[ix(rigid.node)] = touched[ix(rigid.node + 1)] = true;
  return touched;
}

namespace {
/// One share a node, to each of its components.
void add_at(std::span<Index const> nodes, Vector const& shares, int dim, Eigen::Ref<Vector> to) {
  for (std::size_t a = 0; a < nodes.size(); ++a)
    to.segment(dim * nodes[a], dim).array() += shares[static_cast<Eigen::Index>(a)];
}
} // namespace

/// Lumped in proportion to the diagonal of each cell, so that no node's share is negative.
void BulkSystem::gather_grip(Model const& model) {
  grip_.setZero(model.dofs());
  for (std::size_t b = 0; b < model.cells.size(); ++b) {
    auto const& body = *model.bodies[b];
    double const diagonal =
        (body.mesh.nodes.colwise().maxCoeff() - body.mesh.nodes.colwise().minCoeff()).squaredNorm();
    double const per_mass = material::moduli(body.material).young / (diagonal * body.density);
    Index const first = dim_ * model.first_node[b];
    model.cells[b].each_mass([&](std::span<Index const> nodes, Dense const& m) {
      add_at(nodes, per_mass * m.sum() / m.trace() * m.diagonal(), dim_, grip_.tail(grip_.size() - first));
    });
  }
  for (Index dof = 0; dof < model.dofs(); ++dof)
    if (unknown_of(dof) < 0)
      grip_[dof] = 0;
}

} // namespace stiction::dynamics
