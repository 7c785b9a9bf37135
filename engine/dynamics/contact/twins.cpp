// Which nodes move as one, by the constraints, and points on them.
#include "dynamics/contact/twins.hpp"

#include <algorithm>
#include <map>
#include <numeric>

namespace stiction::dynamics {

namespace {

constexpr double same_rows = 1e-9;

constexpr Index by_motion = -1; ///< where a degree of freedom is one of a motion's

/// What each degree of freedom follows as it is: another, itself, or a motion.
Indices leaders(Model const& model) {
  Indices lead(ix(model.dofs()));
  std::iota(lead.begin(), lead.end(), Index{0});
  for (auto const& link : model.links)
    if (link.masters.size() == 1 && link.masters[0].second == 1)
      lead[ix(link.dof)] = link.masters[0].first;
  for (auto const& motion : model.motions)
    for (Index const node : motion.nodes)
      lead[ix(model.dim() * node + motion.component)] = by_motion;
  for (auto& one : lead)
    one = one == by_motion ? by_motion : lead[ix(one)];
  return lead;
}

struct Seen {
  Pair const* pair;
  Index point; ///< numbered through all points
};

bool may_share(Pair const& a, Pair const& b) {
  bool const rigid = std::holds_alternative<RigidSide>(a.primary);
  return rigid == std::holds_alternative<RigidSide>(b.primary) && interface::alike(a.law, b.law);
}

/// The first node that moves as each, see Twins::moves_as.
Indices groups(Model const& model) {
  auto const lead = leaders(model);
  std::map<Indices, Index> of_components;
  auto const dim = static_cast<std::ptrdiff_t>(model.dim());
  Indices first_alike;
  for (Index node = 0; node < model.node_count(); ++node) {
    auto const first = lead.begin() + dim * node;
    Indices const key(first, first + dim);
    bool const moves = std::ranges::any_of(key, [](Index one) { return one != by_motion; });
    first_alike.push_back(moves ? of_components.try_emplace(key, node).first->second : node);
  }
  return first_alike;
}

} // namespace

Twins::Twins(Model const& model) {
  if (!model.links.empty())
    moves_as_ = groups(model);
  else if (model.pairs.size() < 2)
    return;
  std::map<Index, std::vector<Seen>> of_node;
  Index count = 0;
  for (auto const& pair : model.pairs)
    for (Index i = 0; i < pair.size(); ++i, ++count) {
      if (pair.shared())
        continue;
      auto& seen = of_node[moves_as(pair.secondary[ix(i)])];
      for (auto const& [before, point] : seen)
        if (before == &pair || may_share(*before, pair))
          all_.push_back({point, count});
      seen.push_back({&pair, count});
    }
}

template<int D>
bool Twins::alike(contact::PointKinematics<D> const& a, contact::PointKinematics<D> const& b,
                  double off) const {
  if (!a.found || !b.found || a.count != b.count || std::abs(a.gap - b.gap) > off ||
      (a.slip - b.slip).norm() > off)
    return false;
  for (int k = 0; k < a.count; ++k)
    if (moves_as(a.nodes[ix(k)]) != moves_as(b.nodes[ix(k)]))
      return false;
  auto const rows = a.H.leftCols(a.unknowns());
  return (rows - b.H.leftCols(b.unknowns())).norm() <= same_rows * rows.norm();
}

template bool Twins::alike(contact::PointKinematics<2> const&, contact::PointKinematics<2> const&,
                           double) const;
template bool Twins::alike(contact::PointKinematics<3> const&, contact::PointKinematics<3> const&,
                           double) const;

} // namespace stiction::dynamics
