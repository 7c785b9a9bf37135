// Activation of contact points and their state within and after a step.
#include "dynamics/contact/contact_points.hpp"

#include <algorithm>
#include <limits>

#include "contact/tunnelling/obstacle_tunnelling.hpp"
#include "core/threads.hpp"
#include "dynamics/contact/settle_bond.hpp"
#include "dynamics/model/contact_level.hpp"
#include "dynamics/model/rigid_load.hpp"

namespace stiction::dynamics {

namespace {
constexpr Index few = 64;           // points that one thread does best
constexpr double same_place = 1e-9; // of a pair's reach
constexpr int most_lost = 1;        // times in a step that a point's counterpart may turn up again

/// Do bonds and coefficients of both start the step alike, stretches to `off`, m?
bool same_past(contact::ProblemPoint const& a, contact::ProblemPoint const& b, double off) {
  return a.mu == b.mu && a.bond.old.beta == b.bond.old.beta &&
         (a.bond.old.stretch - b.bond.old.stretch).norm() <= off;
}

} // namespace

template<int D, int C>
ContactPoints<D, C>::ContactPoints(Model const& model, contact::Problem& problem)
    : model_(&model), problem_(&problem), weights_(weights(model.scheme)), geometry_(model), twins_(model) {
  for (std::size_t pair = 0; pair < model.pairs.size(); ++pair) {
    auto const& described = model.pairs[pair];
    int adhesion = -1, friction = -1;
    if (described.law.adhesion) {
      adhesion = static_cast<int>(problem.adhesions.size());
      problem.adhesions.push_back(*described.law.adhesion);
    }
    if (described.law.mu_follows()) {
      friction = static_cast<int>(problem.frictions.size());
      problem.frictions.push_back(*described.law.friction);
    }
    for (Index i = 0; i < described.size(); ++i) {
      auto& point = points_.emplace_back();
      point.id = {static_cast<int>(pair), i};
      point.data = {described.areas[ix(i)], described.law.mu(), adhesion, {}, friction, Vec3::Zero()};
    }
  }
}

template<int D, int C> void ContactPoints<D, C>::begin(State const& old, double t1, double dt) {
  old_ = &old;
  bonding_changed_ = false;
  geometry_.begin(old, t1);
  for (auto& point : points_) {
    ContactState const& state = before(point);
    point.data.area = geometry_.mortar_area(point.id).value_or(own_area(point));
    point.force = point.data.area * (state.dry + state.adhesion).template head<C>();
    point.rho = 0;
    point.data.bond = {state.bond, dt, state.status != interface::Status::open};
    point.data.mu = pair_of(point).law.mu(state.status);
    point.kinematics.foot = state.foot;
    point.apart = false;
    point.lost = 0;
    if (weights_.velocity_level())
      limit_rates(point, dt);
  }
}

template<int D, int C> void ContactPoints<D, C>::follow(ContactPoints const& lead) {
  for (std::size_t k = 0; k < points_.size(); ++k) {
    points_[k].force = lead.points_[k].force;
    points_[k].data.bond.closed = lead.points_[k].data.bond.closed;
    points_[k].kinematics.foot = lead.points_[k].kinematics.foot;
    points_[k].apart = !lead.points_[k].kinematics.found && !geometry_.shared(points_[k].id.pair);
  }
}

/// A point whose gap does not close is left to its bond, if it has one or is within a law's range.
template<int D, int C> void ContactPoints<D, C>::limit_rates(Point& point, double dt) const {
  auto const condition = rate_condition(before(point), weights_, dt);
  double const reach = pair_of(point).reach;
  point.waits = condition.arrest > 1e-6 * reach;
  point.data.shift = condition.shift;
  if (!point.waits)
    return;
  // the cone never closes; farther off it would only spoil the rounding that solvers allow for
  point.data.shift[0] = -10 * contact::most_depth * reach;
  if (!(before(point).bond.beta > 0 || pair_of(point).law.range() > 0))
    point.force.setZero();
}

template<int D, int C> template<class Act> void ContactPoints<D, C>::each_point(Act const& act) {
  core::each_piece(static_cast<Index>(points_.size()), few, [&](Index first, Index last) {
    std::for_each(points_.begin() + first, points_.begin() + last, act);
  });
}

template<int D, int C> void ContactPoints<D, C>::locate(Vector const& u, bool settle) {
  geometry_.locate(u);
  each_point([&](Point const& point) { geometry_.see(point.id, point.kinematics.foot); });
  geometry_.settle();
  each_point([&](Point& point) {
    bool const had = point.kinematics.found && point.rho > 0;
    point.kinematics =
        point.apart ? contact::PointKinematics<D>{} : geometry_.kinematics(point.id, point.kinematics.foot);
    // past a border where it is pressed, back within it where not: no state would hold
    if (had && !point.kinematics.found && !geometry_.shared(point.id.pair))
      point.apart = ++point.lost > most_lost;
    if (C == 3 && point.data.adhesion >= 0) // between material points of both sides
      point.data.bond.old = interface::turned(before(point).bond, point.kinematics.spin);
  });
  pair_twins();
  each_point([&](Point& point) { choose_active(point); });
  active_.clear();
  bonding_changed_ = false;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    auto& point = points_[k];
    if (!point.active)
      continue;
    active_.push_back(static_cast<Index>(k));
    if (!settle)
      settle_closing(point);
  }
}

/// Of twins that are alike the first has the area and the reaction of all.
template<int D, int C> void ContactPoints<D, C>::pair_twins() {
  for (auto const& [first, second] : twins_.all()) {
    points_[ix(first)].data.area = own_area(points_[ix(first)]);
    points_[ix(second)].lead = -1;
  }
  for (auto const& [first, second] : twins_.all()) {
    auto &lead = points_[ix(first)], &point = points_[ix(second)];
    double const off = same_place * pair_of(point).reach;
    if (point.lead >= 0 || lead.lead >= 0 || lead.waits != point.waits ||
        !same_past(lead.data, point.data, off) || !twins_.alike(lead.kinematics, point.kinematics, off))
      continue;
    point.lead = first;
    lead.data.area += own_area(point);
    lead.force += point.force;
    point.force.setZero();
  }
}

template<int D, int C> void ContactPoints<D, C>::choose_active(Point& point) const {
  auto const& pair = pair_of(point);
  bool const bonded = point.data.bond.old.beta > 0 && pair.law.lasts();
  bool const held = bonded || !point.force.isZero(0);
  double const gap = point.kinematics.gap;
  // what lay deeper than that before the step is on the far side of a body, not in contact with this one
  double const deepest = std::max(gap, before(point).gap);
  bool const near = gap < pair.reach && deepest > -contact::most_depth * pair.reach &&
                    !(point.waits && pair.law.range() == 0) && !geometry_.beneath(point.id, point.kinematics);
  bool const was = point.active;
  point.active = point.kinematics.found && point.lead < 0 && (held || near);
  if (!point.active)
    point.force.setZero();
  if (!was)
    point.rho = 0;
}

/// A point touches if its dry reaction presses; the adhesion at a closed point has no normal part. Laws whose
/// bonds follow their opening do not ask.
template<int D, int C> void ContactPoints<D, C>::settle_closing(Point& point) {
  if (point.data.adhesion < 0 || point.rho == 0 ||
      !interface::evolves(problem_->adhesions[ix(point.data.adhesion)]))
    return;
  auto const state = contact::evaluate<C>(*problem_, point.data, point.force, point.x(), point.rho);
  bool const closed = state.status != interface::Status::open;
  bonding_changed_ = bonding_changed_ || closed != point.data.bond.closed;
  point.data.bond.closed = closed;
}

template<int D, int C>
void ContactPoints<D, C>::add_force(Point const& point, contact::Local<C> const& p, Vector& force) const {
  auto const& kinematics = point.kinematics;
  for (int a = 0; a < kinematics.count; ++a)
    force.segment<D>(D * kinematics.nodes[ix(a)]) +=
        kinematics.H.template block<C, D>(0, D * a).transpose() * p;
}

template<int D, int C> void ContactPoints<D, C>::reaction(Vector& force, int pair) const {
  force.setZero(static_cast<Index>(geometry_.positions().size()));
  for (Index const k : active_)
    if (auto const& point = points_[ix(k)]; !point.force.isZero(0) && (pair < 0 || point.id.pair == pair))
      add_force(point, point.force, force);
  for (auto const& [first, second] : twins_.all())
    if (auto const& lead = points_[ix(first)], &point = points_[ix(second)];
        pair >= 0 && point.lead == first && lead.id.pair != point.id.pair) {
      if (lead.id.pair == pair)
        add_force(lead, -part_of(point, lead), force);
      else if (point.id.pair == pair)
        add_force(point, part_of(point, lead), force);
    }
}

/// What a point bears of the force of its lead.
template<int D, int C>
contact::Local<C> ContactPoints<D, C>::part_of(Point const& point, Point const& lead) const {
  return own_area(point) / lead.data.area * lead.force;
}

template<int D, int C> void ContactPoints<D, C>::take(Vector const& forces) {
  for (std::size_t row = 0; row < active_.size(); ++row) {
    auto& point = points_[ix(active_[row])];
    point.force = forces.segment<C>(C * static_cast<Index>(row));
    point.rho = contact::natural_scale(*problem_, static_cast<Index>(row));
  }
}

template<int D, int C> double ContactPoints<D, C>::residual() const {
  if (bonding_changed_)
    return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (Index const k : active_) {
    auto const& point = points_[ix(k)];
    auto const x = point.x();
    if (point.rho == 0) { // no problem has seen this point
      if (x[0] < std::max(point.data.shift[0], pair_of(point).law.range()) || point.data.bond.old.beta > 0)
        return std::numeric_limits<double>::infinity();
      continue;
    }
    auto const state = contact::evaluate<C>(*problem_, point.data, point.force, x, point.rho);
    largest = std::max(largest, state.residual.norm());
  }
  return largest;
}

template<int D, int C> double ContactPoints<D, C>::force_scale() const {
  double largest = 0;
  for (Index const k : active_)
    largest = std::max(largest, points_[ix(k)].force.norm());
  return largest;
}

template<int D, int C> void ContactPoints<D, C>::finish(State& next) const {
  auto const& poses = geometry_.poses();
  if constexpr (D == 3)
    for (std::size_t r = 0; r < poses.size(); ++r)
      next.turned[r] = poses[r].rotation;
  next.on_rigid.assign(poses.size(), {});
  for (auto const& point : points_) {
    ContactState& after = next.contacts[ix(point.id.pair)][ix(point.id.index)];
    after = {};
    after.area = point.data.area;
    if (!point.kinematics.found) {
      after.gap = geometry_.search_radius(point.id.pair);
      continue;
    }
    after.foot = point.kinematics.foot;
    if (auto const* side = std::get_if<RigidSide>(&pair_of(point).primary); D == 3 && side != nullptr)
      after.tangent.template head<D>() =
          poses[side->body].rotation.transpose() * point.kinematics.frame.col(1);
    after.gap = point.kinematics.gap;
    after.in_reach = point.active;
    after.beneath = geometry_.beneath(point.id, point.kinematics);
    if (weights_.velocity_level())
      set_rates(pair_of(point), *model_, point.kinematics, next, after);
    if (!point.active)
      continue;
    after.slip.template head<D - 1>() = point.kinematics.slip;
    after.path = before(point).path + after.slip;
    finish(point, after, next);
  }
  for (auto const& [first, second] : twins_.all()) {
    auto const &lead = points_[ix(first)], &point = points_[ix(second)];
    auto& of_lead = next.contacts[ix(lead.id.pair)][ix(lead.id.index)];
    auto& of_point = next.contacts[ix(point.id.pair)][ix(point.id.index)];
    of_lead.area = own_area(lead);
    if (point.lead != first)
      continue;
    auto const foot = of_point.foot;
    auto const tangent = of_point.tangent;
    of_point = of_lead;
    of_point.foot = foot;
    of_point.tangent = tangent;
    of_point.area = own_area(point);
    pass_load(lead, point, next);
  }
}

/// A part of what its lead bears is on the rigid body of a point, if that is another one.
template<int D, int C>
void ContactPoints<D, C>::pass_load(Point const& lead, Point const& point, State& next) const {
  auto const *from = std::get_if<RigidSide>(&pair_of(lead).primary),
             *to = std::get_if<RigidSide>(&pair_of(point).primary);
  if (from == nullptr || to == nullptr || from->body == to->body)
    return;
  contact::Local<D> const part = full<D>(part_of(point, lead));
  Index const rigids = model_->first_node.back();
  add_load<D>(lead.kinematics, -part, geometry_.positions(), rigids, next.on_rigid[from->body]);
  add_load<D>(point.kinematics, part, geometry_.positions(), rigids, next.on_rigid[to->body]);
}

/// What the force of an active point leaves.
template<int D, int C>
void ContactPoints<D, C>::finish(Point const& point, ContactState& after, State& next) const {
  if (auto const* side = std::get_if<RigidSide>(&pair_of(point).primary))
    add_load<D>(point.kinematics, full<D>(point.force), geometry_.positions(), model_->first_node.back(),
                next.on_rigid[side->body]);
  auto const x = point.x();
  after.spin = point.kinematics.spin;
  after.dry.template head<C>() = point.force / point.data.area;
  if (point.data.adhesion >= 0)
    settle_bond<C>(problem_->adhesions[ix(point.data.adhesion)], point.data, {before(point).gap, x}, after,
                   next.ledger);
  if (point.rho > 0)
    after.status = contact::evaluate<C>(*problem_, point.data, point.force, x, point.rho).status;
}

template class ContactPoints<2, 1>;
template class ContactPoints<2, 2>;
template class ContactPoints<3, 1>;
template class ContactPoints<3, 3>;

} // namespace stiction::dynamics
