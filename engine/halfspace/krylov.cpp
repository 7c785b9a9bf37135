// Conjugate gradients where points only yield, least residuals where they slip or soften.
#include "halfspace/krylov.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "linear/krylov.hpp"

namespace stiction::halfspace {

namespace {
constexpr Index least_basis = 40, most_basis = 200; // of GMRES, before it is restarted
constexpr Index basis_arrays = 30;                  // of all points, that a basis may take as numbers
constexpr double digits = 1e-5;                     // that vectors of single precision bring at a time
} // namespace

template<int D>
Krylov<D>::Krylov(Surface const& surface, Linearised<D> const& system, bool lifted, double held_lift)
    : surface_(&surface), system_(&system), lifted_(lifted), held_lift_(held_lift), all_(surface.rows()),
      moved_(surface.rows()), some_(D * system.size()) {}

template<int D> void Krylov<D>::move(Vector const& few) {
  scatter<D>(system_->points, few, all_);
  moved_.setZero();
  surface_->add_product(all_, moved_);
}

template<int D> double Krylov<D>::normal_sum(Vector const& few) const {
  return core::sum_of_pieces(system_->size(), least_points, [&](Index first, Index last) {
    double part = 0;
    for (Index k = first; k < last; ++k)
      part += few[D * k];
    return part;
  });
}

template<int D> void Krylov<D>::apply(Vector const& few, double lift, Vector& result) {
  move(few);
  each_of(system_->points, [&](Index k) {
    Local<D> const own = few.segment<D>(D * k);
    Local<D> x = moved_.segment<D>(D * system_->points[ix(k)]) - system_->own * own;
    x[0] += lift;
    result.segment<D>(D * k) = own + system_->B[ix(k)] * x;
  });
}

/// (softness + W)^-1 of values where W governs, there; 0 elsewhere.
template<int D> void Krylov<D>::masked_solve(Vector const& few, Vector& result) {
  all_.setZero();
  each_of(system_->points, [&](Index k) {
    if (system_->yields[ix(k)])
      all_.segment<D>(D * system_->points[ix(k)]) = few.segment<D>(D * k);
  });
  surface_->solve(system_->softness, all_, moved_);
  each_of(system_->points, [&](Index k) {
    if (system_->yields[ix(k)])
      result.segment<D>(D * k) = moved_.segment<D>(D * system_->points[ix(k)]);
    else
      result.segment<D>(D * k).setZero();
  });
}

/// Within the range of B by the surface's inverse, outside it by nothing.
template<int D> void Krylov<D>::undo(Vector const& few, Vector& result) {
  LocalMatrix<D> const scale = system_->own + system_->softness * LocalMatrix<D>::Identity();
  each_of(system_->points, [&](Index k) {
    some_.segment<D>(D * k) = scale * (system_->B[ix(k)] * scale * few.segment<D>(D * k));
  });
  masked_solve(some_, result);
  each_of(system_->points, [&](Index k) {
    Local<D> const from = few.segment<D>(D * k), solved = result.segment<D>(D * k);
    LocalMatrix<D> const range = system_->B[ix(k)] * scale;
    if (system_->yields[ix(k)])
      result.segment<D>(D * k) = from - range * from + range * solved;
    else
      result.segment<D>(D * k) = from;
  });
}

/// In one component: of (S + W), S = 1 / B - W_own.
template<int D> void Krylov<D>::undo_symmetric(Vector const& few, Vector& result) {
  masked_solve(few, result);
  for (Index k = 0; k < system_->size(); ++k)
    if (!system_->yields[ix(k)])
      result[k] = few[k] * system_->B[ix(k)](0, 0);
}

/// Of the symmetric (S + W) dp + e lift = r / B, sum of dp given; the lift is what the residual keeps.
template<int D>
Correction Krylov<D>::by_conjugate_gradients(Vector const& right, double total, double part, long most) {
  Index const n = system_->size();
  Correction made{Vector::Zero(n), Vector::Zero(surface_->rows()), 0, 0};
  Vector residual(n), solved(n), way(n), pushed(n);
  auto const S = [&](Index k) { return 1 / system_->B[ix(k)](0, 0) - system_->own(0, 0); };
  for (Index k = 0; k < n; ++k)
    residual[k] = right[k] / system_->B[ix(k)](0, 0);
  auto const step_along = [&](Vector const& along, double length) {
    made.force += length * along;
    made.motion += length * moved_;
    residual -= length * pushed;
  };
  auto const push = [&](Vector const& along) {
    move(along);
    for (Index k = 0; k < n; ++k)
      pushed[k] = S(k) * along[k] + moved_[system_->points[ix(k)]];
    if (held_lift_ > 0)
      pushed.array() += along.sum() / held_lift_;
  };
  if (lifted_) {
    lift_force_.resize(n);
    undo_symmetric(Vector::Ones(n), lift_force_);
    lift_sum_ = lift_force_.sum();
    if (held_lift_ > 0)
      residual.array() += total / held_lift_;
    else if (total != 0) {
      push(lift_force_);
      step_along(lift_force_, total / lift_sum_);
    }
  }
  auto const precondition = [&] {
    if (lifted_ && held_lift_ == 0) { // else what keeps of the residual would drown what is left of it
      double const more = residual.dot(lift_force_) / lift_sum_;
      made.lift += more;
      residual.array() -= more;
    }
    undo_symmetric(residual, solved);
    if (lifted_)
      solved -= solved.sum() / (held_lift_ + lift_sum_) * lift_force_;
  };
  precondition();
  way = solved;
  double weight = residual.dot(solved);
  double const start = weight;
  for (; made.iterations < most && weight > part * part * start && weight > 0; ++made.iterations) {
    push(way);
    double const bend = way.dot(pushed);
    if (!(bend > 0))
      break;
    step_along(way, weight / bend);
    precondition();
    double const next = residual.dot(solved);
    way = solved + next / weight * way;
    weight = next;
  }
  if (held_lift_ > 0)
    made.lift = (made.force.sum() - total) / held_lift_;
  return made;
}

/// What a lift of one asks for, undone, and how much of normal force that is.
template<int D> void Krylov<D>::prepare_lift() {
  Vector once(D * system_->size());
  for (Index k = 0; k < system_->size(); ++k)
    once.segment<D>(D * k) = system_->B[ix(k)].col(0);
  lift_force_.resize(once.size());
  undo(once, lift_force_);
  lift_sum_ = normal_sum(lift_force_);
}

/// As large as room allows: restarts forget the few ways in which a surface is about to snap.
template<int D> int Krylov<D>::basis() const {
  Index const vectors = basis_arrays * surface_->rows() / (D * system_->size());
  return static_cast<int>(std::clamp(vectors, least_basis, most_basis));
}

/// GMRES, restarted. If lifted, vectors end with the lift, or with the sum of normal forces over the root of
/// their number.
template<int D>
Correction Krylov<D>::by_residuals(Vector const& right, double total, double part, long most) {
  Index const n = D * system_->size();
  double const root = std::sqrt(static_cast<double>(system_->size()));
  if (lifted_)
    prepare_lift();
  Vector few, changed(lifted_ ? n : 0);
  auto const apply_all = [&](Vector const& from, Vector& to) {
    to.resize(from.size());
    if (!lifted_) {
      apply(from, 0, to);
      return;
    }
    few = from.head(n);
    apply(few, from[n], changed);
    to.head(n) = changed;
    to[n] = (normal_sum(few) - held_lift_ * from[n]) / root;
  };
  auto const undo_all = [&](Vector const& from, Vector& to) {
    to.resize(from.size());
    if (!lifted_) {
      undo(from, to);
      return;
    }
    few = from.head(n);
    undo(few, changed);
    double const stiffness = lift_sum_ + held_lift_;
    to[n] = stiffness != 0 ? (normal_sum(changed) - root * from[n]) / stiffness : 0;
    to.head(n) = changed - to[n] * lift_force_;
  };
  Correction made{Vector::Zero(n), Vector::Zero(surface_->rows()), 0, 0};
  Vector residual(n + (lifted_ ? 1 : 0)), step, answer;
  residual.head(n) = right;
  if (lifted_)
    residual[n] = total / root;
  double const start = residual.norm();
  for (double before = start; before > part * start && made.iterations < most;) {
    auto const end = linear::gmres(apply_all, undo_all, residual, step,
                                   linear::KrylovLimits<linear::ShortVectors>{
                                       std::max(part * start / before, digits), basis(), {}, true});
    made.iterations += end.iterations;
    apply_all(step, answer);
    made.force += step.head(n);
    made.lift += lifted_ ? step[n] : 0;
    made.motion += moved_;
    residual -= answer;
    double const now = residual.norm();
    if (!(now < 0.9 * before))
      break;
    before = now;
  }
  return made;
}

template<int D> Correction Krylov<D>::solve(Vector const& right, double total, double part, long most) {
  if (system_->size() == 0)
    return {Vector(0), Vector::Zero(surface_->rows()), held_lift_ > 0 ? -total / held_lift_ : 0, 0};
  if constexpr (D == 1)
    if (system_->definite)
      return by_conjugate_gradients(right, total, part, most);
  return by_residuals(right, total, part, most);
}

template class Krylov<1>;
template class Krylov<2>;
template class Krylov<3>;

} // namespace stiction::halfspace
