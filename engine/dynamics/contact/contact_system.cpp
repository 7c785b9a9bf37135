// Kinematics and forces of the contact points of one step.
#include "dynamics/contact/contact_system.hpp"

#include <algorithm>
#include <limits>

#include "contact/mortar/node_means.hpp"
#include "dynamics/bulk/timer.hpp"
#include "dynamics/contact/bond_grip.hpp"
#include "dynamics/contact/condensation.hpp"
#include "dynamics/contact/settle_bond.hpp"
#include "dynamics/contact/sharp_solver.hpp"
#include "dynamics/contact/step_point.hpp"
#include "dynamics/contact/twin_points.hpp"
#include "dynamics/model/contact_level.hpp"
#include "dynamics/model/poses.hpp"
#include "dynamics/model/rigid_load.hpp"

namespace stiction::dynamics {

namespace {

using contact::Foot;
using contact::Local;
using contact::PointKinematics;

/// Components C of forces in D dimensions: C = D, or 1 where nothing acts along the surface.
template<int D, int C> class System : public ContactSystem {
public:
  System(Model const& model, BulkSystem const& structure);
  void begin(State const& old, double t1, double dt, bool turning) override;
  [[nodiscard]] bool turned() const override { return turned_; }
  void locate(Vector const& u, bool settle) override;
  void each_point(Visit const& visit) const override {
    for (auto const& point : points_)
      visit({point.pair, point.index}, point.kinematics.nodes, point.kinematics.H);
  }
  void reaction(Vector& force, int pair) const override;
  [[nodiscard]] bool solve(linear::BulkFactor& bulk, Vector const& y, double weight, Vector& c,
                           Cost& cost) override;
  [[nodiscard]] double residual() const override;
  [[nodiscard]] double force_scale() const override;
  void finish(State const& old, double dt, State& next) const override;
  [[nodiscard]] contact::Problem const& problem() const override { return problem_; }
  [[nodiscard]] Vector const& forces() const override { return forces_; }
  [[nodiscard]] PointId point_of(Index row) const override {
    auto const& point = points_[ix(rows_[ix(row)])];
    return {point.pair, point.index};
  }

private:
  using Deformable = typename contact::Search<D>::Primary;
  using Point = StepPoint<D, C>;
  [[nodiscard]] PointKinematics<D> kinematics_of(Point const& point, Foot start) const;
  [[nodiscard]] PointKinematics<D> node_kinematics(Point const& point, Foot start) const;
  void see_all_nodes();
  [[nodiscard]] contact::PosedObstacle<D> posed(RigidSide const& side) const;
  void add_search(Pair const& pair);
  void add_means(Pair const& pair);
  template<class Act> void each_mortar(Act const& act);
  void add_stiffness(Pair const& pair, PointKinematics<D> const& kinematics, Local<D> const& force);
  void add_shared_stiffness(std::size_t pair);
  [[nodiscard]] Indices const& unknowns_of(Indices const& nodes);
  [[nodiscard]] double search_radius(std::size_t pair) const;
  void place_nodes(Vector const& u);
  void place_rigid_bodies(Vector const& u);
  [[nodiscard]] bool beneath(Point const& point) const;
  void choose_active(Point& point) const;
  void limit_rates(Point& point, ContactState const& old, double dt) const;
  void gather(linear::BulkFactor const& bulk);
  [[nodiscard]] Vector pose_problem(linear::BulkFactor& bulk, Vector const& y, double weight);

  [[nodiscard]] std::span<double const> positions() const {
    return {positions_.data(), static_cast<std::size_t>(positions_.size())};
  }

  Model const* model_;
  BulkSystem const* bulk_;
  StepWeights weights_;
  std::unique_ptr<contact::Solver> solver_;
  std::vector<Point> points_;
  std::vector<Index> active_;                               ///< into points_
  Vector positions_, moved_;                                ///< moved_: within the step
  std::vector<contact::Pose<D>> poses_;                     ///< [rigids]
  std::vector<std::optional<contact::Search<D>>> searches_; ///< [pairs]; none against rigid bodies
  std::vector<std::optional<contact::Mortar<D>>> mortars_;  ///< [pairs]; none for node to segment
  std::vector<std::optional<contact::NodeMeans<D>>> means_; ///< [pairs]; none where each node is a point
  State const* old_ = nullptr;
  double t1_ = 0;
  bool bonding_changed_ = false;
  bool turning_ = true, turned_ = false; ///< may problems know that normals turn; has one known it
  Indices unknowns_;                     ///< trailing unknowns of one point
  Condensation condensation_;
  contact::Problem problem_;
  Indices rows_;  ///< into points_, behind the problem's rows
  Vector forces_; ///< that the solver left
};

template<int D, int C>
System<D, C>::System(Model const& model, BulkSystem const& structure)
    : model_(&model), bulk_(&structure), weights_(weights(model.scheme)), solver_(sharp_solver(model)),
      poses_(model.rigids.size()) {
  for (std::size_t pair = 0; pair < model.pairs.size(); ++pair) {
    auto const& described = model.pairs[pair];
    add_search(described);
    add_means(described);
    int law = -1, friction = -1;
    if (described.law.adhesion) {
      law = static_cast<int>(problem_.adhesions.size());
      problem_.adhesions.push_back(*described.law.adhesion);
    }
    if (described.law.mu_follows()) {
      friction = static_cast<int>(problem_.frictions.size());
      problem_.frictions.push_back(*described.law.friction);
    }
    for (Index i = 0; i < described.size(); ++i) {
      Point point;
      point.pair = static_cast<int>(pair);
      point.index = i;
      point.data = {described.areas[ix(i)], described.law.mu(), law, {}, friction, Vec3::Zero()};
      points_.push_back(point);
    }
  }
}

template<int D, int C> void System<D, C>::add_search(Pair const& pair) {
  auto& search = searches_.emplace_back();
  auto const* primary = std::get_if<Deformable>(&pair.primary);
  if (primary == nullptr)
    return;
  search.emplace(*primary, 6 * pair.reach); // as deep as choose_active looks
  if constexpr (D == 2)
    if (pair.self)
      search->allow_self({model_->reference.data(), ix(model_->dofs())});
}

template<int D, int C> void System<D, C>::add_means(Pair const& pair) {
  auto& mortar = mortars_.emplace_back();
  auto& means = means_.emplace_back();
  if (!pair.means.empty())
    means.emplace(pair.means);
  bool const around = model_->kinematics == solid::Kinematics::axisymmetric;
  if (pair.mortar)
    mortar.emplace(*pair.mortar, std::get_if<contact::CellSurface>(&pair.primary),
                   contact::MortarSettings{pair.secondary, pair.reach, around});
}

/// Calls act(mortar, obstacle) for every mortar pair; obstacle: where it is, null if the primary is a body.
template<int D, int C> template<class Act> void System<D, C>::each_mortar(Act const& act) {
  for (std::size_t p = 0; p < mortars_.size(); ++p) {
    if (!mortars_[p])
      continue;
    auto const* side = std::get_if<RigidSide>(&model_->pairs[p].primary);
    auto const obstacle = side != nullptr ? posed(*side) : contact::PosedObstacle<D>{};
    act(*mortars_[p], side != nullptr ? &obstacle : nullptr);
  }
}

template<int D, int C> void System<D, C>::begin(State const& old, double t1, double dt, bool turning) {
  old_ = &old;
  t1_ = old.t;
  bonding_changed_ = false;
  turning_ = turning;
  turned_ = false;
  place_nodes(old.u);
  place_rigid_bodies(old.u);
  t1_ = t1;
  each_mortar([&](auto& mortar, auto const* obstacle) { mortar.begin(positions(), obstacle); });
  for (auto& search : searches_)
    if (search)
      search->update(positions());
  for (auto& point : points_) {
    ContactState const& state = old.contacts[ix(point.pair)][ix(point.index)];
    if (auto const& mortar = mortars_[ix(point.pair)])
      point.data.area = mortar->area(point.index);
    point.force = point.data.area * (state.dry + state.adhesion).template head<C>();
    point.rho = 0;
    point.data.bond = {state.bond, dt, state.status != interface::Status::open};
    point.data.mu = model_->pairs[ix(point.pair)].law.mu(state.status);
    point.kinematics.foot = state.foot;
    if (weights_.velocity_level())
      limit_rates(point, state, dt);
  }
}

/// A point whose gap does not close is left to its bond, if it has one.
template<int D, int C>
void System<D, C>::limit_rates(Point& point, ContactState const& old, double dt) const {
  auto const condition = rate_condition(old, weights_, dt);
  double const reach = model_->pairs[ix(point.pair)].reach;
  point.waits = condition.arrest > 1e-6 * reach;
  point.data.shift = condition.shift;
  if (!point.waits)
    return;
  point.data.shift[0] = -1e6 * reach; // the cone never closes
  if (!(old.bond.beta > 0))
    point.force.setZero();
}

template<int D, int C> void System<D, C>::place_rigid_bodies(Vector const& u) {
  for (std::size_t r = 0; r < poses_.size(); ++r)
    poses_[r] = pose_of<D>(*model_, r, t1_, u, *old_);
}

template<int D, int C> contact::PosedObstacle<D> System<D, C>::posed(RigidSide const& side) const {
  return {&model_->rigids[side.body].shape, poses_[side.body], side.direction};
}

template<int D, int C> PointKinematics<D> System<D, C>::kinematics_of(Point const& point, Foot start) const {
  if (auto const& mortar = mortars_[ix(point.pair)])
    return mortar->point(point.index);
  if (auto const& means = means_[ix(point.pair)])
    return means->point(point.index);
  return node_kinematics(point, start);
}

template<int D, int C>
PointKinematics<D> System<D, C>::node_kinematics(Point const& point, Foot start) const {
  auto const& pair = model_->pairs[ix(point.pair)];
  Index const node = pair.secondary[ix(point.index)];
  Foot const guess = point.kinematics.foot;
  if (auto const& search = searches_[ix(point.pair)])
    return contact::kinematics(*search, node, start, guess, positions());
  return contact::kinematics(posed(std::get<RigidSide>(pair.primary)), node, start, guess, positions());
}

/// What all nodes see, before any point takes its mean of it.
template<int D, int C> void System<D, C>::see_all_nodes() {
  for (auto const& point : points_)
    if (auto& means = means_[ix(point.pair)])
      means->seen()[ix(point.index)] =
          node_kinematics(point, old_->contacts[ix(point.pair)][ix(point.index)].foot);
  for (auto& means : means_)
    if (means)
      means->settle();
}

/// Has the point come in past a border of the surface, well beneath it? Then it is in the counterpart's side,
/// which is no part of the pair: nothing holds it until it is out.
template<int D, int C> bool System<D, C>::beneath(Point const& point) const {
  auto const& kinematics = point.kinematics;
  auto const& pair = model_->pairs[ix(point.pair)];
  if (!searches_[ix(point.pair)] || mortars_[ix(point.pair)] || !kinematics.found || !(kinematics.gap < 0))
    return false;
  ContactState const& old = old_->contacts[ix(point.pair)][ix(point.index)];
  if (old.foot.found())
    return old.beneath;
  double before = kinematics.gap;
  for (int a = 0; a < kinematics.count; ++a)
    before -= kinematics.H.template block<1, D>(0, D * a).dot(moved_.segment<D>(D * kinematics.nodes[ix(a)]));
  return before < -0.2 * pair.reach;
}

template<int D, int C> void System<D, C>::choose_active(Point& point) const {
  auto const& pair = model_->pairs[ix(point.pair)];
  bool const bonded = point.data.bond.old.beta > 0 && pair.law.lasts();
  bool const held = bonded || !point.force.isZero(0);
  double const gap = point.kinematics.gap;
  // what lay deeper than that before the step is on the far side of a body, not in contact with this one
  double const old_gap = old_->contacts[ix(point.pair)][ix(point.index)].gap;
  bool const near =
      gap < pair.reach && std::max(gap, old_gap) > -6 * pair.reach && !point.waits && !beneath(point);
  bool const was = point.active;
  point.active = point.kinematics.found && (held || near);
  if (!point.active)
    point.force.setZero();
  if (!was)
    point.rho = 0;
}

template<int D, int C> void System<D, C>::place_nodes(Vector const& u) {
  positions_ = Eigen::Map<Vector const>(model_->reference.data(), model_->dofs()) + u;
}

template<int D, int C> void System<D, C>::locate(Vector const& u, bool settle) {
  place_nodes(u);
  moved_ = u - old_->u;
  place_rigid_bodies(u);
  each_mortar([&](auto& mortar, auto const* obstacle) { mortar.locate(positions(), obstacle); });
  see_all_nodes();
  active_.clear();
  bonding_changed_ = false;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    auto& point = points_[k];
    point.kinematics = kinematics_of(point, old_->contacts[ix(point.pair)][ix(point.index)].foot);
    choose_active(point);
    if (!point.active)
      continue;
    active_.push_back(static_cast<Index>(k));
    if (point.data.adhesion < 0 || point.rho == 0 || settle)
      continue;
    // a point touches if its dry reaction presses; the adhesion at a closed point has no normal part
    auto const state = contact::evaluate<C>(problem_, point.data, point.force, point.x(), point.rho);
    bool const closed = state.status != interface::Status::open;
    bonding_changed_ = bonding_changed_ || closed != point.data.bond.closed;
    point.data.bond.closed = closed;
  }
}

template<int D, int C> void System<D, C>::reaction(Vector& force, int pair) const {
  force.setZero(positions_.size());
  for (Index const k : active_) {
    auto const& kinematics = points_[ix(k)].kinematics;
    auto const& p = points_[ix(k)].force;
    if (p.isZero(0) || (pair >= 0 && points_[ix(k)].pair != pair))
      continue;
    for (int a = 0; a < kinematics.count; ++a)
      force.segment<D>(D * kinematics.nodes[ix(a)]) +=
          kinematics.H.template block<C, D>(0, D * a).transpose() * p;
  }
}

template<int D, int C> double System<D, C>::residual() const {
  if (bonding_changed_)
    return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (Index const k : active_) {
    auto const& point = points_[ix(k)];
    auto const x = point.x();
    if (point.rho == 0) { // no problem has seen this point
      if (x[0] < std::max(point.data.shift[0], model_->pairs[ix(point.pair)].law.range()) ||
          point.data.bond.old.beta > 0)
        return std::numeric_limits<double>::infinity();
      continue;
    }
    auto const state = contact::evaluate<C>(problem_, point.data, point.force, x, point.rho);
    largest = std::max(largest, state.residual.norm());
  }
  return largest;
}

template<int D, int C> double System<D, C>::force_scale() const {
  double largest = 0;
  for (Index const k : active_)
    largest = std::max(largest, points_[ix(k)].force.norm());
  return largest;
}

/// Bodies that are unstable by themselves, as a long film that is pressed a little along, are held by their
/// bonds.
template<int D, int C> void System<D, C>::gather(linear::BulkFactor const& bulk) {
  condensation_.clear();
  for (Index const k : active_) {
    auto const& point = points_[ix(k)];
    auto const& kinematics = point.kinematics;
    condensation_.add_point(unknowns_of(kinematics.nodes), kinematics.H.template topRows<C>());
    if (turning_ && !mortars_[ix(point.pair)] && !means_[ix(point.pair)])
      add_stiffness(model_->pairs[ix(point.pair)], kinematics, full<D>(point.force));
    if (model_->held_by_bonds || bulk.hold() > 0)
      condensation_.add_stiffness(
          unknowns_of(kinematics.nodes),
          bond_grip(model_->pairs[ix(point.pair)].law, point.data, {kinematics.gap, kinematics.H}));
  }
  for (std::size_t p = 0; p < mortars_.size(); ++p)
    if (turning_ && (mortars_[p] || means_[p]))
      add_shared_stiffness(p);
}

/// Of a force on one node.
template<int D, int C>
void System<D, C>::add_stiffness(Pair const& pair, PointKinematics<D> const& kinematics,
                                 Local<D> const& force) {
  if (force.isZero(0))
    return;
  auto const& unknowns = unknowns_of(kinematics.nodes);
  if (auto const* surface = std::get_if<Deformable>(&pair.primary))
    condensation_.add_stiffness(unknowns, geometric_stiffness(*surface, kinematics, positions(), force));
  else
    condensation_.add_stiffness(unknowns, geometric_stiffness(posed(std::get<RigidSide>(pair.primary)),
                                                              kinematics, positions(), force));
}

/// Of all points of the pair at once, since neighbours share their samples or nodes.
template<int D, int C> void System<D, C>::add_shared_stiffness(std::size_t pair) {
  std::vector<Local<D>> forces(ix(model_->pairs[pair].size()), Local<D>::Zero());
  for (Index const k : active_)
    if (auto const& point = points_[ix(k)]; ix(point.pair) == pair)
      forces[ix(point.index)] = full<D>(point.force);
  if (auto const& mortar = mortars_[pair]) {
    auto const [nodes, K] = mortar->stiffness(forces, positions());
    return condensation_.add_stiffness(unknowns_of(nodes), K);
  }
  auto const on_nodes = means_[pair]->at_nodes(forces);
  for (std::size_t i = 0; i < on_nodes.size(); ++i)
    add_stiffness(model_->pairs[pair], means_[pair]->seen()[i], on_nodes[i]);
}

template<int D, int C> Indices const& System<D, C>::unknowns_of(Indices const& nodes) {
  unknowns_.assign(D * nodes.size(), -1);
  for (std::size_t a = 0; a < unknowns_.size(); ++a)
    if (Index const u = bulk_->unknown_of(D * nodes[a / D] + static_cast<Index>(a % D)); u >= 0)
      unknowns_[a] = u - bulk_->first_contact_unknown();
  return unknowns_;
}

/// The linear problem of the present kinematics; returns the present forces.
template<int D, int C>
Vector System<D, C>::pose_problem(linear::BulkFactor& bulk, Vector const& y, double weight) {
  gather(bulk);
  problem_.dim = C;
  problem_.points.clear();
  condensation_.eliminate(bulk, y, weight, problem_.W.entries(), problem_.free);
  // there might be no answer; with inertia a shorter step has one
  if (turning_ && !weights_.inertia && !condensation_.stable()) {
    turning_ = false;
    return pose_problem(bulk, y, weight);
  }
  turned_ = turned_ || (turning_ && condensation_.turns());
  Vector guess(C * static_cast<Index>(active_.size()));
  problem_.start.setZero(guess.size());
  for (std::size_t row = 0; row < active_.size(); ++row) {
    auto& point = points_[ix(active_[row])];
    auto const first = C * static_cast<Index>(row);
    problem_.free.segment<C>(first) += point.x();
    problem_.points.push_back(point.data);
    guess.segment<C>(first) = point.force;
    problem_.start[first] = old_->contacts[ix(point.pair)][ix(point.index)].gap;
    if (model_->pairs[ix(point.pair)].self)
      separate_twins<C>(problem_, first, point.force);
  }
  return guess;
}

template<int D, int C>
bool System<D, C>::solve(linear::BulkFactor& bulk, Vector const& y, double weight, Vector& c, Cost& cost) {
  Timer const timer(cost.contact);
  c.setZero(bulk.surface());
  problem_.points.clear();
  if (active_.empty() && bulk.hold() == 0)
    return true;
  Vector const guess = pose_problem(bulk, y, weight);
  cost.add(bulk.spent());
  ++cost.contact_problems;
  auto solution = solve_problem(*solver_, problem_, guess, cost);
  rows_ = active_;
  forces_ = std::move(solution.force);
  if (!solution.converged)
    return false;
  for (std::size_t row = 0; row < active_.size(); ++row) {
    auto& point = points_[ix(active_[row])];
    point.force = forces_.segment<C>(C * static_cast<Index>(row));
    point.rho = contact::natural_scale(problem_, static_cast<Index>(row));
  }
  condensation_.push(forces_, weight, c);
  return true;
}

template<int D, int C> void System<D, C>::finish(State const& old, double, State& next) const {
  if constexpr (D == 3)
    for (std::size_t r = 0; r < poses_.size(); ++r)
      next.turned[r] = poses_[r].rotation;
  next.on_rigid.assign(poses_.size(), {});
  for (auto const& point : points_) {
    ContactState const& before = old.contacts[ix(point.pair)][ix(point.index)];
    ContactState& after = next.contacts[ix(point.pair)][ix(point.index)];
    after = {};
    after.area = point.data.area;
    if (!point.kinematics.found) {
      after.gap = search_radius(ix(point.pair));
      continue;
    }
    after.foot = point.kinematics.foot;
    after.gap = point.kinematics.gap;
    after.in_reach = point.active;
    after.beneath = beneath(point);
    if (weights_.velocity_level())
      set_rates(model_->pairs[ix(point.pair)], *model_, point.kinematics, next, after);
    if (!point.active)
      continue;
    if (auto const* side = std::get_if<RigidSide>(&model_->pairs[ix(point.pair)].primary))
      add_load<D>(point.kinematics, full<D>(point.force), positions(), model_->first_node.back(),
                  next.on_rigid[side->body]);
    after.slip.head<D - 1>() = point.kinematics.slip;
    after.path = before.path + after.slip;
    auto const x = point.x();
    after.dry.head<C>() = point.force / point.data.area;
    if (point.data.adhesion >= 0)
      settle_bond<C>(problem_.adhesions[ix(point.data.adhesion)], point.data, x, after, next.ledger);
    if (point.rho > 0)
      after.status = contact::evaluate<C>(problem_, point.data, point.force, x, point.rho).status;
  }
}

template<int D, int C> double System<D, C>::search_radius(std::size_t pair) const {
  double const searched = searches_[pair] ? searches_[pair]->radius() : 0;
  return mortars_[pair] ? mortars_[pair]->radius() : searched;
}

} // namespace

int contact_components(Model const& model) {
  auto const along = [](Pair const& pair) { return pair.law.tangential(); };
  return std::ranges::any_of(model.pairs, along) ? model.dim() : 1;
}

template<int D> std::unique_ptr<ContactSystem> make_in(Model const& model, BulkSystem const& structure) {
  if (contact_components(model) > 1)
    return std::make_unique<System<D, D>>(model, structure);
  return std::make_unique<System<D, 1>>(model, structure);
}

std::unique_ptr<ContactSystem> make_contact_system(Model const& model, BulkSystem const& structure) {
  return model.dim() == 2 ? make_in<2>(model, structure) : make_in<3>(model, structure);
}

} // namespace stiction::dynamics
