// Positions, poses, searches, mortar samples and means of all pairs.
#include "dynamics/contact/contact_geometry.hpp"

#include "contact/tunnelling/obstacle_tunnelling.hpp"
#include "dynamics/model/poses.hpp"

namespace stiction::dynamics {

using contact::Foot;
using contact::Local;
using contact::PointKinematics;
using contact::Rows;

namespace {
constexpr double rounding_of_rows = 1e-12; ///< of rows of nodes against bodies, whose entries are about 1
constexpr double felt_by_newton = 1e-3;    ///< the same elsewhere: with less W stays symmetric
} // namespace

template<int D>
ContactGeometry<D>::ContactGeometry(Model const& model)
    : model_(&model), poses_(model.rigids.size()), normals_(model.pairs.size()) {
  for (auto const& pair : model.pairs) {
    add_search(pair);
    add_means(pair);
  }
}

template<int D> void ContactGeometry<D>::add_search(Pair const& pair) {
  auto& search = searches_.emplace_back();
  auto const* primary = std::get_if<Deformable>(&pair.primary);
  if (primary == nullptr)
    return;
  search.emplace(*primary, contact::most_depth * pair.reach);
  if (!pair.self)
    return;
  std::vector<bool> guided(ix(model_->node_count()), false);
  for (auto const& motion : model_->motions)
    for (Index const node : motion.nodes)
      guided[ix(node)] = true;
  search->allow_self({model_->reference.data(), ix(model_->dofs())}, guided);
}

template<int D> void ContactGeometry<D>::add_means(Pair const& pair) {
  auto& mortar = mortars_.emplace_back();
  auto& means = means_.emplace_back();
  if (!pair.means.empty())
    means.emplace(pair.means);
  bool const around = model_->kinematics == solid::Kinematics::axisymmetric;
  if (pair.mortar)
    mortar.emplace(
        *pair.mortar, std::get_if<contact::CellSurface>(&pair.primary),
        contact::MortarSettings{pair.secondary, pair.reach, around, pair.law.adhesion.has_value()});
}

/// Calls act(mortar, obstacle, pair) for every mortar pair; obstacle: where it is, null if the primary is a
/// body.
template<int D> template<class Act> void ContactGeometry<D>::each_mortar(Act const& act) {
  for (std::size_t p = 0; p < mortars_.size(); ++p) {
    if (!mortars_[p])
      continue;
    auto const* side = std::get_if<RigidSide>(&model_->pairs[p].primary);
    auto const obstacle = side != nullptr ? posed(*side) : contact::PosedObstacle<D>{};
    act(*mortars_[p], side != nullptr ? &obstacle : nullptr, p);
  }
}

template<int D> void ContactGeometry<D>::begin(State const& old, double t1) {
  old_ = &old;
  t1_ = t1;
  take_positions(old.u, old.t);
  for (std::size_t pair = 0; D == 3 && pair < normals_.size(); ++pair)
    normals_[pair].assign(model_->pairs[pair].size(), {});
  each_mortar([&](auto& mortar, auto const* obstacle, std::size_t pair) {
    mortar.begin(positions(), obstacle, obstacle != nullptr ? tangents(pair) : std::vector<contact::Vec3>{});
  });
  for (auto& search : searches_)
    if (search)
      search->update(positions());
}

template<int D> void ContactGeometry<D>::take_positions(Vector const& u, double t) {
  positions_ = Eigen::Map<Vector const>(model_->reference.data(), model_->dofs()) + u;
  for (std::size_t r = 0; r < poses_.size(); ++r)
    poses_[r] = pose_of<D>(*model_, r, t, u, *old_);
}

template<int D> void ContactGeometry<D>::locate(Vector const& u) {
  take_positions(u, t1_);
  moved_ = u - old_->u;
  each_mortar([&](auto& mortar, auto const* obstacle, std::size_t) { mortar.locate(positions(), obstacle); });
}

template<int D> contact::PosedObstacle<D> ContactGeometry<D>::posed(RigidSide const& side) const {
  return {&model_->rigids[side.body].shape, poses_[side.body], side.direction};
}

/// With the tangent that the point had at the step's start.
template<int D>
contact::PosedObstacle<D> ContactGeometry<D>::posed(RigidSide const& side, PointId point) const {
  auto obstacle = posed(side);
  if (auto const& tangent = old_->contacts[ix(point.pair)][ix(point.index)].tangent; !tangent.isZero(0))
    obstacle.direction = tangent;
  return obstacle;
}

template<int D> std::vector<contact::Vec3> ContactGeometry<D>::tangents(std::size_t pair) const {
  auto const& side = std::get<RigidSide>(model_->pairs[pair].primary);
  std::vector<contact::Vec3> all(ix(model_->pairs[pair].size()));
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = posed(side, {static_cast<int>(pair), static_cast<Index>(i)}).direction;
  return all;
}

template<int D> void ContactGeometry<D>::see(PointId point, Foot guess) {
  if (auto& means = means_[ix(point.pair)])
    means->seen()[ix(point.index)] = of_node(point, guess);
}

template<int D> void ContactGeometry<D>::settle() {
  for (auto& means : means_)
    if (means)
      means->settle();
}

template<int D> PointKinematics<D> ContactGeometry<D>::kinematics(PointId point, Foot guess) const {
  if (auto const& mortar = mortars_[ix(point.pair)])
    return mortar->point(point.index);
  if (auto const& means = means_[ix(point.pair)])
    return means->point(point.index);
  return of_node(point, guess);
}

template<int D> PointKinematics<D> ContactGeometry<D>::of_node(PointId point, Foot guess) const {
  auto const& pair = model_->pairs[ix(point.pair)];
  Index const node = pair.secondary[ix(point.index)];
  if (auto const& search = searches_[ix(point.pair)])
    return contact::kinematics(*search, node, start(point), guess, positions());
  return contact::kinematics(posed(std::get<RigidSide>(pair.primary), point), node, start(point), guess,
                             positions());
}

/// With the normal of an obstacle in space, looked up once a step.
template<int D> contact::Start ContactGeometry<D>::start(PointId point) const {
  auto const& pair = model_->pairs[ix(point.pair)];
  auto const& old = old_->contacts[ix(point.pair)][ix(point.index)];
  contact::Start start = old.foot;
  if (old.foot.found() && pair.law.lasts() && old.bond.beta >= interface::lasting_beta)
    start.overhang = contact::Overhang::bonded;
  auto const* side = std::get_if<RigidSide>(&pair.primary);
  if (D == 2 || side == nullptr)
    return start;
  auto& normal = normals_[ix(point.pair)][ix(point.index)];
  if (!normal)
    normal = contact::normal_at(model_->rigids[side->body].shape, start.foot);
  start.normal = normal;
  return start;
}

template<int D> bool ContactGeometry<D>::beneath(PointId point, PointKinematics<D> const& now) const {
  if (mortars_[ix(point.pair)] || !now.found || !(now.gap < 0))
    return false;
  ContactState const& old = old_->contacts[ix(point.pair)][ix(point.index)];
  if (old.foot.found())
    return old.beneath;
  double before = now.gap;
  for (int a = 0; a < now.count; ++a)
    before -= now.H.template block<1, D>(0, D * a).dot(moved_.segment<D>(D * now.nodes[ix(a)]));
  return before < -contact::most_overlap * model_->pairs[ix(point.pair)].reach;
}

template<int D> std::optional<double> ContactGeometry<D>::mortar_area(PointId point) const {
  auto const& mortar = mortars_[ix(point.pair)];
  return mortar ? std::optional(mortar->area(point.index)) : std::nullopt;
}

template<int D> double ContactGeometry<D>::search_radius(int pair) const {
  double const searched = searches_[ix(pair)] ? searches_[ix(pair)]->radius() : 0;
  return mortars_[ix(pair)] ? mortars_[ix(pair)]->radius() : searched;
}

template<int D>
void ContactGeometry<D>::stiffness(PointId node, PointKinematics<D> const& now, Local<D> const& force,
                                   Add const& add) const {
  if (force.isZero(0))
    return;
  auto const& primary = model_->pairs[ix(node.pair)].primary;
  if (auto const* surface = std::get_if<Deformable>(&primary))
    add(now.nodes, geometric_stiffness(*surface, now, positions(), force));
  else
    add(now.nodes, geometric_stiffness(posed(std::get<RigidSide>(primary), node), now, positions(), force));
}

template<int D>
void ContactGeometry<D>::change(PointId point, PointKinematics<D> const& now, Add const& add) const {
  if (auto const& mortar = mortars_[ix(point.pair)]) {
    auto const [nodes, beyond] = mortar->change(point.index, positions());
    if (beyond.size() > 0 && beyond.cwiseAbs().maxCoeff() > felt_by_newton)
      add(nodes, beyond);
    return;
  }
  auto const& means = means_[ix(point.pair)];
  if (!means)
    return change_of_node(point, now, 1, add);
  for (auto const& [index, weight] : means->nodes_of(point.index))
    change_of_node({point.pair, static_cast<int>(index)}, means->seen()[ix(index)], weight, add);
}

/// weight: of the node in its point.
template<int D>
void ContactGeometry<D>::change_of_node(PointId node, PointKinematics<D> const& now, double weight,
                                        Add const& add) const {
  if constexpr (D == 3) {
    auto const& primary = model_->pairs[ix(node.pair)].primary;
    if (auto const* side = std::get_if<RigidSide>(&primary)) {
      Rows<3> const beyond = motion_rows(posed(*side, node), now, start(node), positions()) - now.H;
      if (beyond.cwiseAbs().maxCoeff() > felt_by_newton)
        add(now.nodes, weight * beyond);
      return;
    }
    auto rows = motion_rows(std::get<Deformable>(primary), now, start(node).foot, positions());
    rows.by_x.leftCols(now.unknowns()) -= now.H;
    if (rows.by_x.cwiseAbs().maxCoeff() > rounding_of_rows)
      add(rows.nodes, weight * rows.by_x);
  }
}

template<int D>
void ContactGeometry<D>::shared_stiffness(int pair, std::vector<Local<D>> const& forces,
                                          Add const& add) const {
  if (auto const& mortar = mortars_[ix(pair)]) {
    auto const [nodes, K] = mortar->stiffness(forces, positions());
    return add(nodes, K);
  }
  auto const& means = *means_[ix(pair)];
  auto const on_nodes = means.at_nodes(forces);
  for (std::size_t i = 0; i < on_nodes.size(); ++i)
    stiffness({pair, static_cast<Index>(i)}, means.seen()[i], on_nodes[i], add);
}

template class ContactGeometry<2>;
template class ContactGeometry<3>;

} // namespace stiction::dynamics
