// Stiffness of all samples of a mortar pair over the nodes that they touch.
#include "contact/mortar/mortar.hpp"

namespace stiction::contact {

template<int D> Local<D> Mortar<D>::force_on(std::size_t s, std::vector<Local<D>> const& forces) const {
  Local<D> sum = Local<D>::Zero();
  int const facet = samples_[s].facet;
  if (!pairings_[s].found())
    return sum;
  for (int k = 0; k < secondary_->facet(facet).corners(); ++k)
    if (auto const p = ix(point_of(facet, k)); points_[p].kinematics.found)
      sum += hat_area(s, k) / points_[p].share * forces[p];
  return sum;
}

/// What one sample adds: over its nodes, and by the averaged normals at its facet's corners.
template<int D>
SampleStiffness<D> Mortar<D>::stiffness_of(std::size_t s, Local<D> const& force, Positions x) const {
  auto const& sample = samples_[s];
  if (!obstacle_)
    return sample_stiffness(faced(x), sample, pairings_[s], force);
  Vec<D> const at = secondary_->positions<D>(sample.facet, x) * sample.shape.N;
  auto const seen = against_obstacle(sample, pairings_[s].foot, x);
  Indices nodes;
  Dense const E = spread(sample, seen, nodes);
  return {E.transpose() * geometric_stiffness(obstacle_of(sample), seen, {at.data(), ix(D)}, force) * E, {}};
}

/// by_fans [D nodes, D fans] times the derivative of the averaged normals by the nodes of their facets.
template<int D> void Mortar<D>::add_by_fans(Dense const& by_fans, Slots& slot, Dense& K, Positions x) const {
  for (std::size_t f = 0; f < normals_.unit.size(); ++f) {
    auto const by_unit = by_fans.middleCols<D>(D * static_cast<Index>(f));
    if (by_unit.isZero(0))
      continue;
    for (auto const& [node, by] : secondary_->turn_of_fan(normals_, static_cast<Index>(f), x))
      K.middleCols<D>(D * slot(node)) += by_unit * by;
  }
}

/// The nodes of samples that bear a force and of the facets around them.
template<int D> Slots Mortar<D>::touched(std::vector<std::size_t> const& samples, Positions x) const {
  Slots slot(x.size() / D);
  for (std::size_t const s : samples) {
    for (Index const node : rows(s, x).nodes)
      slot(node);
    if (obstacle_)
      continue;
    auto const& facet = secondary_->facet(samples_[s].facet);
    for (int k = 0; k < facet.corners(); ++k)
      for (auto const& part : secondary_->fans()[ix(facet.fan[ix(k)])])
        for (int i = 0; i < secondary_->facet(part.facet).count(); ++i)
          slot(secondary_->facet(part.facet).nodes[ix(i)]);
  }
  return slot;
}

template<int D> NodalStiffness Mortar<D>::stiffness(std::vector<Local<D>> const& forces, Positions x) const {
  std::vector<std::size_t> pressed;
  for (std::size_t s = 0; s < samples_.size(); ++s)
    if (!force_on(s, forces).isZero(0))
      pressed.push_back(s);
  auto slot = touched(pressed, x);
  auto const n = D * static_cast<Index>(slot.nodes().size());
  Dense K = Dense::Zero(n, n), by_fans = Dense::Zero(n, D * static_cast<Index>(normals_.unit.size()));
  for (std::size_t const s : pressed) {
    auto const part = stiffness_of(s, force_on(s, forces), x);
    auto const nodes = rows(s, x).nodes;
    auto const& facet = secondary_->facet(samples_[s].facet);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Index const row = D * slot(nodes[i]), from = D * static_cast<Index>(i);
      for (std::size_t j = 0; j < nodes.size(); ++j)
        K.block<D, D>(row, D * slot(nodes[j])) +=
            part.by_nodes.template block<D, D>(from, D * static_cast<Index>(j));
      for (int c = 0; c < facet.corners() && !obstacle_; ++c)
        by_fans.block<D, D>(row, D * facet.fan[ix(c)]) += part.by_normals.template block<D, D>(from, D * c);
    }
  }
  add_by_fans(by_fans, slot, K, x);
  return {slot.nodes(), std::move(K)};
}

template NodalStiffness Mortar<2>::stiffness(std::vector<Local<2>> const&, Positions) const;
template NodalStiffness Mortar<3>::stiffness(std::vector<Local<3>> const&, Positions) const;

} // namespace stiction::contact
