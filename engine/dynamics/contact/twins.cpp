// Which nodes move as one, by the constraints, and points on them.
#include "dynamics/contact/twins.hpp"

#include <map>

namespace stiction::dynamics {

namespace {

constexpr double same_rows = 1e-9;

/// The node that every component of this one follows as it is; itself: none.
Index followed(std::vector<Link const*> const& link_of, Index node, int dim) {
  Index other = -1;
  for (int c = 0; c < dim; ++c) {
    auto const* link = link_of[ix(dim * node + c)];
    if (link == nullptr || link->masters.size() != 1 || link->masters[0].second != 1 ||
        link->masters[0].first % dim != c || (c > 0 && link->masters[0].first / dim != other))
      return node;
    other = link->masters[0].first / dim;
  }
  return other;
}

} // namespace

Twins::Twins(Model const& model) {
  if (model.links.empty())
    return;
  std::vector<Link const*> link_of(ix(model.dofs()), nullptr);
  for (auto const& link : model.links)
    link_of[ix(link.dof)] = &link;
  moves_as_.resize(ix(model.node_count()));
  for (Index node = 0; node < model.node_count(); ++node)
    moves_as_[ix(node)] = followed(link_of, node, model.dim());
  Index start = 0;
  for (auto const& pair : model.pairs) {
    std::map<Index, Index> first;
    for (Index i = 0; i < pair.size() && !pair.shared(); ++i)
      if (auto const [at, fresh] = first.try_emplace(moves_as_[ix(pair.secondary[ix(i)])], start + i); !fresh)
        all_.push_back({at->second, start + i});
    start += pair.size();
  }
}

template<int D>
bool Twins::alike(contact::PointKinematics<D> const& a, contact::PointKinematics<D> const& b,
                  double off) const {
  if (!a.found || !b.found || a.count != b.count || std::abs(a.gap - b.gap) > off ||
      (a.slip - b.slip).norm() > off)
    return false;
  for (int k = 0; k < a.count; ++k)
    if (moves_as_[ix(a.nodes[ix(k)])] != moves_as_[ix(b.nodes[ix(k)])])
      return false;
  auto const rows = a.H.leftCols(a.unknowns());
  return (rows - b.H.leftCols(b.unknowns())).norm() <= same_rows * rows.norm();
}

template bool Twins::alike(contact::PointKinematics<2> const&, contact::PointKinematics<2> const&,
                           double) const;
template bool Twins::alike(contact::PointKinematics<3> const&, contact::PointKinematics<3> const&,
                           double) const;

} // namespace stiction::dynamics
