// Conjugate gradients where points only yield, least residuals where they slip or soften.
#include "halfspace/krylov.hpp"

#include <Eigen/Dense>
#include <cmath>

namespace stiction::halfspace {

template<int D>
Krylov<D>::Krylov(Surface const& surface, Linearised<D> const& system, bool lifted)
    : surface_(&surface), system_(&system), lifted_(lifted), all_(surface.rows()), moved_(surface.rows()),
      some_(D * system.size()) {}

template<int D> void Krylov<D>::move(Vector const& few) {
  scatter<D>(system_->points, few, all_);
  moved_.setZero();
  surface_->add_product(all_, moved_);
}

template<int D> double Krylov<D>::normal_sum(Vector const& few) const {
  double sum = 0;
  for (Index k = 0; k < system_->size(); ++k)
    sum += few[D * k];
  return sum;
}

template<int D> void Krylov<D>::apply(Vector const& few, double lift, Vector& result) {
  move(few);
  for (Index k = 0; k < system_->size(); ++k) {
    Local<D> const own = few.segment<D>(D * k);
    Local<D> x = moved_.segment<D>(D * system_->points[ix(k)]) - system_->own * own;
    x[0] += lift;
    result.segment<D>(D * k) = own + system_->B[ix(k)] * x;
  }
}

/// (softness + W)^-1 of values where W governs, there; 0 elsewhere.
template<int D> void Krylov<D>::masked_solve(Vector const& few, Vector& result) {
  all_.setZero();
  for (Index k = 0; k < system_->size(); ++k)
    if (system_->yields[ix(k)])
      all_.segment<D>(D * system_->points[ix(k)]) = few.segment<D>(D * k);
  surface_->solve(system_->softness, all_, moved_);
  for (Index k = 0; k < system_->size(); ++k)
    if (system_->yields[ix(k)])
      result.segment<D>(D * k) = moved_.segment<D>(D * system_->points[ix(k)]);
    else
      result.segment<D>(D * k).setZero();
}

/// Within the range of B by the surface's inverse, outside it by nothing.
template<int D> void Krylov<D>::undo(Vector const& few, Vector& result) {
  LocalMatrix<D> const scale = system_->own + system_->softness * LocalMatrix<D>::Identity();
  for (Index k = 0; k < system_->size(); ++k)
    some_.segment<D>(D * k) = scale * (system_->B[ix(k)] * scale * few.segment<D>(D * k));
  Vector solved(some_.size());
  masked_solve(some_, solved);
  for (Index k = 0; k < system_->size(); ++k) {
    Local<D> const from = few.segment<D>(D * k);
    if (!system_->yields[ix(k)]) {
      result.segment<D>(D * k) = from;
      continue;
    }
    LocalMatrix<D> const range = system_->B[ix(k)] * scale;
    result.segment<D>(D * k) = from - range * from + range * solved.segment<D>(D * k);
  }
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
  };
  if (lifted_) {
    lift_force_.resize(n);
    undo_symmetric(Vector::Ones(n), lift_force_);
    lift_sum_ = lift_force_.sum();
    if (total != 0) {
      push(lift_force_);
      step_along(lift_force_, total / lift_sum_);
    }
  }
  auto const precondition = [&] {
    undo_symmetric(residual, solved);
    if (lifted_)
      solved -= solved.sum() / lift_sum_ * lift_force_;
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
  if (lifted_)
    made.lift = residual.dot(lift_force_) / lift_sum_;
  return made;
}

/// GMRES from the right, restarted.
template<int D>
Correction Krylov<D>::by_residuals(Vector const& right, double total, double part, long most) {
  constexpr Eigen::Index basis = 40;
  Index const n = D * system_->size();
  Eigen::Index const m = std::min<Eigen::Index>({basis, most, n + 1});
  Dense V(n, m + 1);
  Dense H = Dense::Zero(m + 1, m);
  Vector lifts = Vector::Zero(m + 1); // last entries of the basis
  Vector direction(n), result(n), once(n);
  if (lifted_) { // P B e, and what it adds up to
    for (Index k = 0; k < system_->size(); ++k)
      once.segment<D>(D * k) = system_->B[ix(k)].col(0);
    lift_force_.resize(n);
    undo(once, lift_force_);
    lift_sum_ = normal_sum(lift_force_);
  }
  // with a row for the sum of normal forces over the root of their number
  double const root = std::sqrt(double(std::max<Index>(1, system_->size())));
  auto const undo_all = [&](auto const& from, double last, Vector& to) {
    undo(from, to);
    if (!lifted_ || lift_sum_ == 0)
      return 0.0;
    double const lift = (normal_sum(to) - root * last) / lift_sum_;
    to -= lift * lift_force_;
    return lift;
  };
  Correction made{Vector::Zero(n), Vector::Zero(surface_->rows()), 0, 0};
  Vector residual = right;
  double last = lifted_ ? total / root : 0;
  double const start = std::hypot(residual.norm(), last);
  while (start > 0 && made.iterations < most) {
    double const norm = std::hypot(residual.norm(), last);
    if (norm <= part * start)
      break;
    V.col(0) = residual / norm;
    lifts[0] = last / norm;
    Vector g = Vector::Zero(m + 1);
    g[0] = norm;
    std::vector<Eigen::JacobiRotation<double>> turns(static_cast<std::size_t>(m));
    Eigen::Index k = 0;
    for (; k < m && made.iterations < most; ++made.iterations) {
      double const lift = undo_all(V.col(k), lifts[k], direction);
      apply(direction, lift, result);
      double row = lifted_ ? normal_sum(direction) / root : 0;
      for (Eigen::Index i = 0; i <= k; ++i) {
        H(i, k) = V.col(i).dot(result) + lifts[i] * row;
        result -= H(i, k) * V.col(i);
        row -= H(i, k) * lifts[i];
      }
      double const length = std::hypot(result.norm(), row);
      H(k + 1, k) = length;
      for (Eigen::Index i = 0; i < k; ++i)
        H.col(k).applyOnTheLeft(i, i + 1, turns[static_cast<std::size_t>(i)].adjoint());
      auto& turn = turns[static_cast<std::size_t>(k)];
      turn.makeGivens(H(k, k), H(k + 1, k));
      H.col(k).applyOnTheLeft(k, k + 1, turn.adjoint());
      g.applyOnTheLeft(k, k + 1, turn.adjoint());
      bool const over = std::abs(g[k + 1]) <= part * start || length == 0;
      if (length > 0) {
        V.col(k + 1) = result / length;
        lifts[k + 1] = row / length;
      }
      ++k;
      if (over)
        break;
    }
    Vector const y = H.topLeftCorner(k, k).triangularView<Eigen::Upper>().solve(g.head(k));
    Vector const sum = V.leftCols(k) * y;
    double const lift = undo_all(sum, lifts.head(k).dot(y), direction);
    made.force += direction;
    made.lift += lift;
    apply(direction, lift, result);
    made.motion += moved_;
    residual -= result;
    if (lifted_)
      last -= normal_sum(direction) / root;
    if (std::hypot(residual.norm(), last) > 0.9 * norm)
      break;
  }
  return made;
}

template<int D> Correction Krylov<D>::solve(Vector const& right, double total, double part, long most) {
  if (system_->size() == 0)
    return {Vector(0), Vector::Zero(surface_->rows()), 0, 0};
  if constexpr (D == 1)
    if (system_->definite)
      return by_conjugate_gradients(right, total, part, most);
  return by_residuals(right, total, part, most);
}

template class Krylov<1>;
template class Krylov<2>;
template class Krylov<3>;

} // namespace stiction::halfspace
