// The means over nodes and what they hand back to these.
#include "contact/mortar/node_means.hpp"

#include <algorithm>

namespace stiction::contact {

namespace {

/// Cosine between the normals, and the tangents, of nodes that may share a point.
constexpr double one_way = 0.7;

template<int D> bool same_side(PointKinematics<D> const& a, PointKinematics<D> const& b) {
  bool same = b.found;
  for (int c = 0; c < D - 1 && same; ++c)
    same = a.frame.col(c).dot(b.frame.col(c)) > one_way;
  return same;
}

} // namespace

template<int D> void NodeMeans<D>::settle() {
  for (std::size_t i = 0; i < means_.size(); ++i) {
    auto const& mean = means_[i];
    whole_[i] = seen_[i].found && std::all_of(mean.begin(), mean.end(), [&](auto const& part) {
                  return same_side(seen_[i], seen_[ix(part.point)]);
                });
  }
}

template<int D> PointKinematics<D> NodeMeans<D>::point(Index i) const {
  auto const& own = seen_[ix(i)];
  if (!whole_[ix(i)] || means_[ix(i)].size() == 1)
    return own;
  PointKinematics<D> mean;
  mean.found = true;
  mean.foot = own.foot;
  mean.frame = own.frame;
  auto& nodes = mean.nodes;
  for (auto const& part : means_[ix(i)])
    nodes.insert(nodes.end(), seen_[ix(part.point)].nodes.begin(), seen_[ix(part.point)].nodes.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  mean.count = static_cast<int>(nodes.size());
  mean.H.setZero(D, mean.unknowns());
  for (auto const& [point, weight] : means_[ix(i)]) {
    auto const& seen = seen_[ix(point)];
    mean.gap += weight * seen.gap;
    mean.slip += weight * seen.slip;
    for (int k = 0; k < seen.count; ++k) {
      auto const slot = std::lower_bound(nodes.begin(), nodes.end(), seen.nodes[ix(k)]) - nodes.begin();
      mean.H.template middleCols<D>(D * slot) += weight * seen.H.template middleCols<D>(D * k);
    }
  }
  return mean;
}

template<int D> std::vector<mesh::NodeShare> NodeMeans<D>::nodes_of(Index i) const {
  return whole_[ix(i)] ? means_[ix(i)] : std::vector<mesh::NodeShare>{{i, 1.0}};
}

template<int D> std::vector<Local<D>> NodeMeans<D>::at_nodes(std::vector<Local<D>> const& forces) const {
  std::vector<Local<D>> result(forces.size(), Local<D>::Zero());
  for (std::size_t i = 0; i < forces.size(); ++i)
    if (!whole_[i])
      result[i] += forces[i];
    else
      for (auto const& [point, weight] : means_[i])
        result[ix(point)] += weight * forces[i];
  return result;
}

template class NodeMeans<2>;
template class NodeMeans<3>;

} // namespace stiction::contact
