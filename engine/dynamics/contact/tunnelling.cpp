// Picks the points that moved far enough to have gone through something, and asks for those alone.
#include "dynamics/contact/tunnelling.hpp"

#include <algorithm>
#include <optional>

#include "contact/tunnelling/obstacle_tunnelling.hpp"
#include "dynamics/model/poses.hpp"

namespace stiction::dynamics {

namespace {

using contact::Vec;

template<int D> std::vector<contact::Panel<D>> panels_of(Pair const& pair) {
  using Deformable = std::conditional_t<D == 2, contact::Curve, contact::Surface>;
  if (auto const* surface = std::get_if<Deformable>(&pair.primary))
    return contact::panels_of(*surface);
  if (auto const* cells = std::get_if<contact::CellSurface>(&pair.primary))
    return contact::panels_of<D>(*cells);
  return {};
}

/// How the nodes of a surface moved in a step: their mean, and how far any is from it at most, m.
template<int D> struct Drift {
  Vec<D> mean = Vec<D>::Zero();
  double spread = 0;
  Drift(std::vector<contact::Panel<D>> const& panels, Vector const& step) {
    for (auto const& panel : panels)
      for (Index const node : panel)
        mean += step.segment<D>(D * node) / static_cast<double>(D * panels.size());
    for (auto const& panel : panels)
      for (Index const node : panel)
        spread = std::max(spread, (step.segment<D>(D * node) - mean).norm());
  }
};

/// Something acts on it.
bool held(ContactState const& point) {
  return point.in_reach &&
         !(point.status == interface::Status::open && (point.dry + point.adhesion).isZero(0));
}

/// Too far from the obstacle at both ends of a way of this length, m, to have been deep in it.
bool clear(ContactState const& before, ContactState const& after, double length, double depth) {
  return before.foot.found() && after.foot.found() && before.gap + after.gap - length > -2 * depth;
}

} // namespace

Tunnelling::Tunnelling(Model const& model) : model_(&model) {
  for (auto const& pair : model.pairs)
    if (model.dim() == 2)
      lines_.push_back(panels_of<2>(pair));
    else
      triangles_.push_back(panels_of<3>(pair));
}

template<int D> bool Tunnelling::passed(std::size_t pair, State const& old, State const& next) const {
  auto const& described = model_->pairs[pair];
  auto const& panels = [ this, pair ]() -> auto const& {
    if constexpr (D == 2)
      return lines_[pair];
    else
      return triangles_[pair];
  }
  ();
  if (panels.empty())
    return passed_rigid<D>(pair, old, next);
  Vector const step = next.u - old.u;
  Drift<D> const drift(panels, step);
  Vector from, to;
  auto const count = static_cast<std::size_t>(model_->dofs());
  std::optional<contact::SweptPanels<D>> swept; // of few steps
  for (std::size_t i = 0; i < described.secondary.size(); ++i) {
    Index const node = described.secondary[i];
    // contact sees whatever ends within reach of where it was, but may lose what it held, and may hold again
    // on the other side of what lay between
    auto const &before = old.contacts[pair][i], &after = next.contacts[pair][i];
    bool const far = (step.segment<D>(D * node) - drift.mean).norm() + drift.spread > described.reach;
    if (!far && (after.in_reach || !before.in_reach))
      continue;
    if (!swept) {
      from = Eigen::Map<Vector const>(model_->reference.data(), model_->dofs()) + old.u;
      to = from + step;
      swept.emplace(panels, contact::StepPath{{from.data(), count}, {to.data(), count}});
    }
    if (swept->passed_by(node, after.in_reach ? described.reach : 0))
      return true;
  }
  return false;
}

template<int D> bool Tunnelling::passed_rigid(std::size_t pair, State const& old, State const& next) const {
  auto const& described = model_->pairs[pair];
  auto const* side = std::get_if<RigidSide>(&described.primary);
  if (side == nullptr)
    return false;
  auto const& shape = model_->rigids[side->body].shape;
  auto const first = pose_of<D>(*model_, side->body, old.t, old.u, old);
  auto const last = pose_of<D>(*model_, side->body, next.t, next.u, old);
  Eigen::Map<Vector const> const reference(model_->reference.data(), model_->dofs());
  for (std::size_t i = 0; i < described.secondary.size(); ++i) {
    Index const dof = D * described.secondary[i];
    contact::Vec<D> const X = reference.segment<D>(dof);
    contact::RelativeWay<D> const way(X + old.u.segment<D>(dof), X + next.u.segment<D>(dof), first, last);
    auto const &before = old.contacts[pair][i], &after = next.contacts[pair][i];
    contact::WayEnds ends{described.reach, held(after), {}, {}};
    if (!described.shared()) { // else gap and foot are not those of the node
      if (clear(before, after, way.length(), contact::least_depth * described.reach))
        continue;
      ends.first = before.foot;
      ends.last = after.foot;
    }
    if (contact::passes<D>(shape, way, ends))
      return true;
  }
  return false;
}

std::string Tunnelling::passed(State const& old, State const& next) const {
  for (std::size_t pair = 0; pair < model_->pairs.size(); ++pair)
    if (model_->dim() == 2 ? passed<2>(pair, old, next) : passed<3>(pair, old, next))
      return model_->pairs[pair].name;
  return "";
}

} // namespace stiction::dynamics
