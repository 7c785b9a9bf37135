// Coulomb's cone: the projection that unites separation, sticking and sliding, with its derivatives.
#pragma once
#include <Eigen/Core>
#include <cmath>

namespace stiction::interface {

/// Components of one contact point in its frame: (n [, t1 [, t2]]); D = 1 where nothing acts along the
/// surface.
template<int D> using Local = Eigen::Matrix<double, D, 1>;
template<int D> using LocalMatrix = Eigen::Matrix<double, D, D>;

enum class Status { open, stick, slip };

/// Proj(z, K_mu), its derivative by z and by mu.
template<int D> struct Projection {
  Local<D> value = Local<D>::Zero();
  LocalMatrix<D> by_z = LocalMatrix<D>::Zero();
  Local<D> by_mu = Local<D>::Zero();
  Status status = Status::open;
};

/// (29) with the sign mended: the sliding branch lands on the cone, |p_t| = mu p_n.
template<int D> [[nodiscard]] Projection<D> project(Local<D> const& z, double mu) {
  Projection<D> result;
  double const zn = z[0];
  double const zt = z.template tail<D - 1>().norm();
  if (mu * zt < -zn)
    return result;
  if (zt <= mu * zn) {
    result.value = z;
    result.by_z.setIdentity();
    result.status = D == 1 ? Status::slip : Status::stick;
    return result;
  }
  result.status = Status::slip;
  auto const tau = (z.template tail<D - 1>() / zt).eval();
  double const scale = 1 / (1 + mu * mu);
  double const pn = (zn + mu * zt) * scale;
  result.value[0] = pn;
  result.value.template tail<D - 1>() = mu * pn * tau;

  Local<D> gradient; // of p_n
  gradient[0] = scale;
  gradient.template tail<D - 1>() = mu * scale * tau;
  result.by_z.row(0) = gradient.transpose();
  result.by_z.template bottomRows<D - 1>() = mu * tau * gradient.transpose();
  if constexpr (D == 3)
    result.by_z.template bottomRightCorner<2, 2>() +=
        mu * pn / zt * (Eigen::Matrix2d::Identity() - tau * tau.transpose());

  double const pn_by_mu = scale * (zt - 2 * mu * pn);
  result.by_mu[0] = pn_by_mu;
  result.by_mu.template tail<D - 1>() = (pn + mu * pn_by_mu) * tau;
  return result;
}

} // namespace stiction::interface
