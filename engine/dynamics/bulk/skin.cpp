// Bodies of contact cells alone, with the nodes of the whole.
#include "dynamics/bulk/skin.hpp"

#include <algorithm>

namespace stiction::dynamics {

namespace {

/// The block's cells that have a marked node; first: model number of the body's first node.
mesh::Block touched(mesh::Block const& block, Index first, std::vector<bool> const& marked) {
  mesh::Block kept{block.kind, {}};
  auto const width = static_cast<std::ptrdiff_t>(mesh::info(block.kind).nodes);
  for (auto cell = block.nodes.begin(); cell != block.nodes.end(); cell += width)
    if (std::any_of(cell, cell + width, [&](Index node) { return marked[ix(first + node)]; }))
      kept.nodes.insert(kept.nodes.end(), cell, cell + width);
  return kept;
}

} // namespace

Skin::Skin(Model const& model, std::vector<bool> const& on_surface) : model_(&model) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    auto& body = *bodies_.emplace_back(std::make_unique<solid::Body>(*model.bodies[b]));
    for (auto& block : body.mesh.blocks)
      block = touched(block, model.first_node[b], on_surface);
    cells_.emplace_back(body, model.kinematics);
  }
}

void Skin::map_entries(linear::Pattern const& pattern, Indices const& unknown_of) {
  int const dim = model_->dim();
  maps_.assign(cells_.size(), {});
  for (std::size_t b = 0; b < cells_.size(); ++b)
    cells_[b].each_cell([&](std::span<Index const> nodes) {
      Indices cell;
      for (Index const node : nodes)
        for (int c = 0; c < dim; ++c)
          cell.push_back(unknown_of[ix(dim * (model_->first_node[b] + node) + c)]);
      for (std::size_t i = 0; i < cell.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j)
          maps_[b].push_back(cell[i] >= 0 && cell[j] >= 0 ? pattern.find(cell[i], cell[j]) : -1);
    });
}

/// Calls act(body, first degree of freedom, displacements of the body).
template<class Act> void Skin::each_body(Vector const& u, Act const& act) const {
  int const dim = model_->dim();
  for (std::size_t b = 0; b < cells_.size(); ++b) {
    auto const first = ix(dim * model_->first_node[b]), count = ix(dim * model_->first_node[b + 1]) - first;
    act(b, first, std::span<double const>(u.data() + first, count));
  }
}

void Skin::internal_force(Vector const& u, Vector& force) const {
  force.setZero(u.size());
  each_body(u, [&](std::size_t b, std::size_t first, std::span<double const> own) {
    static_cast<void>(cells_[b].add_force(own, {force.data() + first, own.size()}));
  });
}

void Skin::add_stiffness(Vector const& u, double factor, std::span<double> values) const {
  each_body(u, [&](std::size_t b, std::size_t, std::span<double const> own) {
    cells_[b].add_stiffness(own, factor, maps_[b], values);
  });
}

} // namespace stiction::dynamics
