// The problem of a step as data, its answer as a state, and the energies of both.
#include "halfspace/stepper.hpp"

#include <algorithm>
#include <utility>

#include "core/threads.hpp"

namespace stiction::halfspace {

Stepper::Stepper(Model const& model)
    : model_(&model),
      surface_(model.grid, Compliance::of(model.body, model.counterpart ? &*model.counterpart : nullptr),
               model.components()),
      solver_(surface_), problem_(surface_, model.law) {}

State Stepper::initial() const {
  Index const n = model_->grid.size();
  State state;
  state.lift = model_->force ? std::max(0.0, -model_->heights.minCoeff()) : model_->shift[2].value(0);
  state.along = {model_->shift[0].value(0), model_->shift[1].value(0)};
  state.force = state.u = state.dry = Vector::Zero(surface_.rows());
  state.gap = model_->heights.array() + state.lift;
  state.path = Vector::Zero(surface_.rows() - n);
  state.status.assign(ix(n), 0);
  if (!model_->law.adhesion)
    return state;
  state.beta.resize(n);
  state.stretch.setZero(problem_.shared.dim > 1 ? 2 * n : 0);
  for (Index i = 0; i < n; ++i) {
    auto const bond = interface::initial_bond(*model_->law.adhesion, state.gap[i]);
    state.beta[i] = bond.beta;
    state.ledger.bond +=
        model_->grid.area() * interface::bond_energy(*model_->law.adhesion, bond, state.gap[i]);
  }
  state.ledger.start = state.ledger.bond;
  return state;
}

/// Free gaps of the step's end, free slips of the step.
void Stepper::begin(State const& old, State const& next, double dt) {
  int const D = problem_.shared.dim;
  auto& free = problem_.shared.free;
  problem_.old = &old;
  problem_.dt = dt;
  for (Index i = 0; i < problem_.size(); ++i) {
    free[D * i] = model_->heights[i] + next.lift;
    for (int c = 1; c < D; ++c)
      free[D * i + c] = old.along[ix(c - 1)] - next.along[ix(c - 1)] - old.u[D * i + c];
    problem_.closed[ix(i)] = old.status_of(i) != interface::Status::open ? 1 : 0;
  }
}

namespace {

template<int D>
contact::PointState<D> state_at(Problem const& problem, Answer const& answer, Index i, double rho) {
  return contact::evaluate<D>(problem.shared, problem.point(i), answer.force.segment<D>(D * i),
                              answer.x.segment<D>(D * i), rho);
}

} // namespace

bool Stepper::closing_changed(Answer const& answer) {
  if (!problem_.adheres() || !interface::grows(problem_.adhesion()))
    return false;
  bool changed = false;
  double const rho = contact::natural_scale(problem_.shared, 0);
  contact::by_dimension(problem_.shared.dim, [&]<int D>() {
    for (Index i = 0; i < problem_.size(); ++i) {
      bool const closed = state_at<D>(problem_, answer, i, rho).status != interface::Status::open;
      changed = changed || closed != (problem_.closed[ix(i)] != 0);
      problem_.closed[ix(i)] = closed ? 1 : 0;
    }
  });
  return changed;
}

template<int D>
void Stepper::settle_point(State const& old, Answer const& answer, Index i, State& next) const {
  auto const at = state_at<D>(problem_, answer, i, contact::natural_scale(problem_.shared, 0));
  contact::Local<D> const x = answer.x.segment<D>(D * i);
  next.dry.segment<D>(D * i) = at.dry;
  next.gap[i] = x[0];
  next.status[ix(i)] = static_cast<std::uint8_t>(at.status);
  next.u[D * i] = x[0] - model_->heights[i] - next.lift;
  for (int c = 1; c < D; ++c) {
    double const moved = next.along[ix(c - 1)] - old.along[ix(c - 1)];
    next.u[D * i + c] = old.u[D * i + c] + x[c] + moved;
    next.path[(D - 1) * i + c - 1] += x[c];
    next.ledger.friction_loss -= 0.5 * (at.dry[c] + old.dry[D * i + c]) * x[c];
  }
}

template<int D> void Stepper::settle_bond(contact::Local<D> const& x, Index i, State& next) const {
  auto const& law = *model_->law.adhesion;
  auto const before = problem_.bond(i);
  auto const bond = interface::advance<D>(law, before, x);
  next.beta[i] = bond.beta;
  if (D > 1)
    next.stretch.segment<2>(2 * i) = bond.stretch;
  next.ledger.bonding_loss += problem_.area * interface::dissipation<D>(law, before, problem_.old->gap[i], x);
  next.ledger.bond += problem_.area * interface::bond_energy(law, bond, x[0]);
}

void Stepper::settle(State const& old, Answer const& answer, State& next) const {
  next.lift += answer.lift;
  next.ledger.bond = 0;
  next.gap.resize(problem_.size());
  next.status.resize(ix(problem_.size()));
  next.u.resize(answer.x.size());
  next.dry.resize(answer.x.size());
  next.path = old.path;
  next.beta.resize(old.beta.size());
  next.stretch.resize(old.stretch.size());
  contact::by_dimension(problem_.shared.dim, [&]<int D>() {
    for (Index i = 0; i < problem_.size(); ++i) {
      settle_point<D>(old, answer, i, next);
      if (model_->law.adhesion)
        settle_bond<D>(answer.x.segment<D>(D * i), i, next);
    }
  });
}

/// Works by the means of the step's forces.
void Stepper::account(State const& old, State& next) const {
  int const D = problem_.shared.dim;
  auto& ledger = next.ledger;
  ledger.strain = 0.5 * next.force.dot(next.u);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (Index i = 0; i < problem_.size(); ++i)
    mean.head(D) += 0.5 * (old.force.segment(D * i, D) + next.force.segment(D * i, D));
  (model_->force ? ledger.load_work : ledger.motion_work) -= mean[0] * (next.lift - old.lift);
  for (std::size_t c = 0; c < 2; ++c)
    ledger.motion_work += mean[static_cast<Index>(c) + 1] * (next.along[c] - old.along[c]);
}

Outcome Stepper::step(State const& old, double dt) {
  Outcome outcome;
  auto& next = outcome.state; // its arrays come when the solver has left room for them
  next.ledger = old.ledger;
  next.t = old.t + dt;
  next.lift = model_->force ? old.lift : model_->shift[2].value(next.t);
  next.along = {model_->shift[0].value(next.t), model_->shift[1].value(next.t)};
  begin(old, next, dt);
  Wanted wanted;
  wanted.tolerance = model_->tolerance;
  wanted.enough = enough_;
  if (model_->force)
    wanted.force = model_->force->value(next.t);
  Answer answer;
  Vector guess;
  long const products = surface_.products(), solutions = surface_.solutions();
  constexpr int most_closings = 30; // of what touches, with bonds that tell; then it goes back and forth
  for (int k = 0; k < most_closings; ++k) {
    answer = solver_.solve(problem_, k == 0 ? old.force : std::as_const(guess), wanted);
    outcome.iterations += answer.iterations;
    cost_.krylov += answer.krylov;
    if (!answer.converged || !closing_changed(answer))
      break;
    guess = std::move(answer.force);
    answer.converged = false;
    answer.reason = "bonds that form where points touch lift them off again";
  }
  cost_.iterations += outcome.iterations;
  cost_.products += surface_.products() - products;
  cost_.solutions += surface_.solutions() - solutions;
  outcome.converged = answer.converged;
  outcome.interrupted = answer.interrupted;
  outcome.reason = answer.reason;
  if (!answer.converged)
    return outcome;
  settle(old, answer, next);
  next.force = std::move(answer.force);
  account(old, next);
  return outcome;
}

} // namespace stiction::halfspace
