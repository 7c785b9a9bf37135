// Kinematics, elimination and solution of the contact points of one step.
#include "dynamics/contact_stage.hpp"

#include <Eigen/LU>
#include <limits>

#include "dynamics/timer.hpp"

namespace stiction::dynamics {

using contact::Foot;
using contact::PointKinematics;

ContactStage::ContactStage(Model const& model, Structure& structure)
    : model_(&model), structure_(&structure), solver_(contact::make_solver(model.solver)) {
  for (std::size_t pair = 0; pair < model.pairs.size(); ++pair) {
    auto const& described = model.pairs[pair];
    int law = -1;
    if (described.law.adhesion) {
      law = static_cast<int>(problem_.adhesions.size());
      problem_.adhesions.push_back(*described.law.adhesion);
    }
    for (Index i = 0; i < described.size(); ++i) {
      Point point;
      point.pair = static_cast<int>(pair);
      point.index = i;
      point.law = {described.areas[ix(i)], described.law.mu(), law, {}};
      points_.push_back(point);
    }
  }
}

void ContactStage::begin(State const& old, double t1, double dt) {
  old_ = &old;
  t1_ = t1;
  bonding_changed_ = false;
  for (auto& point : points_) {
    auto const& state = old.contacts[ix(point.pair)][ix(point.index)];
    point.force = point.law.area * (state.dry + state.adhesion);
    point.rho = 0;
    point.law.bond = {state.bond, dt, state.status != interface::Status::open};
    point.kinematics.foot = state.foot;
  }
}

PointKinematics ContactStage::look(Point const& point, Foot start) const {
  auto const& pair = model_->pairs[ix(point.pair)];
  Index const node = pair.secondary[ix(point.index)];
  std::span<double const> const x(positions_.data(), static_cast<std::size_t>(positions_.size()));
  if (auto const* curve = std::get_if<contact::Curve>(&pair.primary))
    return contact::kinematics(*curve, node, start, point.kinematics.foot, x);
  auto const& obstacle = std::get<MovingObstacle>(pair.primary);
  return contact::kinematics(obstacle.shape, node, start, x, obstacle.offset(t1_));
}

void ContactStage::choose_active(Point& point) const {
  auto const& pair = model_->pairs[ix(point.pair)];
  bool const held = point.law.bond.old.beta > 0 || !point.force.isZero(0);
  bool const near = point.kinematics.gap < pair.reach && point.kinematics.gap > -6 * pair.reach;
  bool const was = point.active;
  point.active = point.kinematics.found && (held || near);
  if (!point.active)
    point.force.setZero();
  if (!was)
    point.rho = 0;
}

void ContactStage::locate(Vector const& u, bool settle) {
  positions_.resize(u.size());
  for (Index i = 0; i < model_->node_count(); ++i)
    positions_.segment<2>(2 * i) = model_->reference.row(i).transpose() + u.segment<2>(2 * i);
  active_.clear();
  bonding_changed_ = false;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    auto& point = points_[k];
    point.kinematics = look(point, old_->contacts[ix(point.pair)][ix(point.index)].foot);
    choose_active(point);
    if (!point.active)
      continue;
    active_.push_back(static_cast<Index>(k));
    if (point.law.law < 0 || point.rho == 0 || settle)
      continue;
    // a point touches if its dry reaction presses; the adhesion at a closed point has no normal part
    contact::Local<2> const x(point.kinematics.gap, point.kinematics.slip);
    auto const state = contact::evaluate<2>(problem_, point.law, point.force, x, point.rho);
    bool const closed = state.status != interface::Status::open;
    bonding_changed_ = bonding_changed_ || closed != point.law.bond.closed;
    point.law.bond.closed = closed;
  }
}

void ContactStage::reaction(Vector& force) const {
  force.setZero(positions_.size());
  for (Index const k : active_) {
    auto const& kinematics = points_[ix(k)].kinematics;
    Vec2 const& p = points_[ix(k)].force;
    if (p.isZero(0))
      continue;
    for (int a = 0; a < kinematics.count; ++a)
      force.segment<2>(2 * kinematics.nodes[ix(a)]) +=
          p[0] * kinematics.normal.segment<2>(2 * a) + p[1] * kinematics.tangential.segment<2>(2 * a);
  }
}

double ContactStage::residual() const {
  if (bonding_changed_)
    return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (Index const k : active_) {
    auto const& point = points_[ix(k)];
    contact::Local<2> const x(point.kinematics.gap, point.kinematics.slip);
    if (point.rho == 0) { // no problem has seen this point
      if (x[0] < 0 || point.law.bond.old.beta > 0)
        return std::numeric_limits<double>::infinity();
      continue;
    }
    auto const state = contact::evaluate<2>(problem_, point.law, point.force, x, point.rho);
    largest = std::max(largest, state.residual.norm());
  }
  return largest;
}

double ContactStage::force_scale() const {
  double largest = 0;
  for (Index const k : active_)
    largest = std::max(largest, points_[ix(k)].force.norm());
  return largest;
}

void ContactStage::gather_unknowns() {
  Index const first = structure_->first_contact_unknown();
  local_of_.assign(ix(structure_->unknowns() - first), -1);
  for (Index const k : active_) {
    auto const& kinematics = points_[ix(k)].kinematics;
    for (int a = 0; a < kinematics.unknowns(); ++a)
      if (Index const u = structure_->unknown_of(2 * kinematics.nodes[ix(a / 2)] + a % 2); u >= 0)
        local_of_[ix(u - first)] = 0;
  }
  unknowns_.clear();
  for (Index u = 0; u < static_cast<Index>(local_of_.size()); ++u)
    if (local_of_[ix(u)] == 0) {
      local_of_[ix(u)] = static_cast<Index>(unknowns_.size());
      unknowns_.push_back(u);
    }
}

void ContactStage::assemble_rows() {
  auto const n = static_cast<Index>(unknowns_.size()), m = 2 * static_cast<Index>(active_.size());
  Index const first = structure_->first_contact_unknown();
  H_.setZero(m, n);
  geometric_.setZero(n, n);
  std::span<double const> const x(positions_.data(), static_cast<std::size_t>(positions_.size()));
  for (std::size_t row = 0; row < active_.size(); ++row) {
    auto const& point = points_[ix(active_[row])];
    auto const& kinematics = point.kinematics;
    std::array<Index, 10> local{};
    for (int a = 0; a < kinematics.unknowns(); ++a) {
      Index const u = structure_->unknown_of(2 * kinematics.nodes[ix(a / 2)] + a % 2);
      local[ix(a)] = u >= 0 ? local_of_[ix(u - first)] : -1;
      if (u < 0)
        continue;
      H_(2 * static_cast<Index>(row), local[ix(a)]) = kinematics.normal[a];
      H_(2 * static_cast<Index>(row) + 1, local[ix(a)]) = kinematics.tangential[a];
    }
    if (point.force.isZero(0))
      continue;
    auto const& primary = model_->pairs[ix(point.pair)].primary;
    contact::Block const K =
        std::holds_alternative<contact::Curve>(primary)
            ? contact::geometric_stiffness(std::get<contact::Curve>(primary), kinematics, x, point.force)
            : contact::geometric_stiffness(std::get<MovingObstacle>(primary).shape, kinematics, x,
                                           std::get<MovingObstacle>(primary).offset(t1_), point.force);
    for (int a = 0; a < kinematics.unknowns(); ++a)
      for (int b = 0; b < kinematics.unknowns(); ++b)
        if (local[ix(a)] >= 0 && local[ix(b)] >= 0)
          geometric_(local[ix(a)], local[ix(b)]) += K(a, b);
  }
}

void ContactStage::build_problem(Vector const& y, double weight) {
  auto const n = static_cast<Index>(unknowns_.size()), m = static_cast<Index>(H_.rows());
  Dense const& inverse = structure_->factor().trailing_inverse();
  V_.resize(n, n);
  for (Index j = 0; j < n; ++j)
    for (Index i = 0; i < n; ++i)
      V_(i, j) = inverse(unknowns_[ix(i)], unknowns_[ix(j)]);
  // (I - weight V K_geo) du = y + weight V H^T p
  right_.resize(n, m + 1);
  for (Index i = 0; i < n; ++i)
    right_(i, m) = y[unknowns_[ix(i)]];
  right_.leftCols(m).noalias() = weight * V_ * H_.transpose();
  if (!geometric_.isZero(0)) {
    reduced_.noalias() = -weight * V_ * geometric_;
    reduced_.diagonal().array() += 1;
    right_ = reduced_.partialPivLu().solve(right_);
  }
  problem_.dim = 2;
  problem_.W.noalias() = H_ * right_.leftCols(m);
  problem_.free.noalias() = H_ * right_.col(m);
  problem_.points.clear();
  for (std::size_t row = 0; row < active_.size(); ++row) {
    auto& point = points_[ix(active_[row])];
    problem_.free[2 * static_cast<Index>(row)] += point.kinematics.gap;
    problem_.free[2 * static_cast<Index>(row) + 1] += point.kinematics.slip;
    problem_.points.push_back(point.law);
  }
}

bool ContactStage::solve(Vector const& y, double weight, Vector& c, Cost& cost) {
  Timer const timer(cost.contact);
  c.setZero(structure_->unknowns() - structure_->first_contact_unknown());
  if (active_.empty())
    return true;
  gather_unknowns();
  assemble_rows();
  build_problem(y, weight);
  Vector guess(H_.rows());
  for (std::size_t row = 0; row < active_.size(); ++row)
    guess.segment<2>(2 * static_cast<Index>(row)) = points_[ix(active_[row])].force;
  auto solution = solver_->solve(problem_, guess);
  ++cost.contact_problems;
  cost.contact_iterations += solution.iterations;
  if (!solution.converged) { // the last forces may be a bad start: once more from none
    solution = solver_->solve(problem_, Vector::Zero(guess.size()));
    cost.contact_iterations += solution.iterations;
  }
  if (!solution.converged)
    return false;
  for (std::size_t row = 0; row < active_.size(); ++row) {
    auto& point = points_[ix(active_[row])];
    point.force = solution.force.segment<2>(2 * static_cast<Index>(row));
    point.rho = contact::natural_scale(problem_, static_cast<Index>(row));
  }
  auto const m = H_.rows();
  Vector const motion = right_.col(m) + right_.leftCols(m) * solution.force;
  Vector const force = weight * (geometric_ * motion + H_.transpose() * solution.force);
  for (std::size_t i = 0; i < unknowns_.size(); ++i)
    c[unknowns_[i]] = force[static_cast<Index>(i)];
  return true;
}

void ContactStage::finish(State const& old, double dt, State& next) const {
  for (auto const& point : points_) {
    auto const& before = old.contacts[ix(point.pair)][ix(point.index)];
    auto& after = next.contacts[ix(point.pair)][ix(point.index)];
    after = {};
    if (!point.kinematics.found)
      continue;
    after.foot = point.kinematics.foot;
    after.gap = point.kinematics.gap;
    after.in_reach = point.active;
    if (!point.active)
      continue;
    after.slip = point.kinematics.slip;
    after.path = before.path + after.slip;
    contact::Local<2> const x(after.gap, after.slip);
    after.dry = point.force / point.law.area;
    if (point.law.law >= 0) {
      auto const& law = problem_.adhesions[ix(point.law.law)];
      after.adhesion = interface::adhere<2>(law, point.law.bond, x).traction;
      after.dry -= after.adhesion;
      after.bond = interface::advance<2>(law, point.law.bond, x);
      double const growth = after.bond.beta - before.bond.beta;
      next.ledger.bonding_loss += point.law.area * law.b * growth * growth / dt;
      next.ledger.bond += point.law.area * interface::bond_energy(law, after.bond, after.gap);
    }
    if (point.rho > 0)
      after.status = contact::evaluate<2>(problem_, point.law, point.force, x, point.rho).status;
  }
}

} // namespace stiction::dynamics
