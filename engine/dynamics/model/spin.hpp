// A free rigid body that turns with an inertia tensor: Euler's equations over one step.
#pragma once
#include "dynamics/model/poses.hpp"
#include "dynamics/scheme/scheme.hpp"

namespace stiction::dynamics {

/// Momentum is what the forces change: L1 - L0 = dt M in space, L = R J R^T w. The turn d of the step, a
/// vector in space, is the same in the axes of the body; with w1' = v0 + (d - dt v0) / rate there, as the
/// scheme has it, the body ends with w1 = exp(d) w1' and L1 = exp(d) A w1', A that of the start. With rate =
/// dt / 2 this is the scheme of Simo and Wong (1991): momentum and, without forces, energy stay to rounding.
struct Spin {
  Eigen::Matrix3d inertia; ///< A, about axes in space at the step's start, kg m^2
  Vec3 rate_old;           ///< v0, rad/s
  double dt = 0, rate = 0; ///< s; rate: what d - dt v0 is divided by

  /// w1', which the step's turn has yet to carry along, rad/s.
  [[nodiscard]] Vec3 rate_before_turn(Vec3 const& d) const { return rate_old + (d - dt * rate_old) / rate; }
  /// (L1 - L0) / dt, N m.
  [[nodiscard]] Vec3 torque(Vec3 const& d) const {
    return (rotation(d) * (inertia * rate_before_turn(d)) - inertia * rate_old) / dt;
  }
  /// Of the torque by d, N m.
  [[nodiscard]] Eigen::Matrix3d stiffness(Vec3 const& d) const {
    Vec3 const L = rotation(d) * (inertia * rate_before_turn(d));
    return (rotation(d) * inertia / rate - cross_matrix(L) * left_jacobian(d)) / dt;
  }

  [[nodiscard]] static Eigen::Matrix3d cross_matrix(Vec3 const& a) {
    Eigen::Matrix3d A;
    A << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return A;
  }
  /// exp(d + e) = exp(J e) exp(d) to first order: 1 + (1 - cos a)/a^2 D + (a - sin a)/a^3 D^2, a = |d|.
  [[nodiscard]] static Eigen::Matrix3d left_jacobian(Vec3 const& d) {
    Eigen::Matrix3d const D = cross_matrix(d);
    double const a = d.norm(), half = std::sin(0.5 * a) / (a > 0 ? 0.5 * a : 1.0);
    double const first = a > 0 ? 0.5 * half * half : 0.5;
    double const second = a > 1e-2 ? (a - std::sin(a)) / (a * a * a) : (1 - a * a / 20) / 6; // to 1e-11
    return Eigen::Matrix3d::Identity() + first * D + second * D * D;
  }
};

/// Does a body turn by Spin?
[[nodiscard]] inline bool tensorial(RigidBody const& rigid) {
  return rigid.free() && !rigid.tensor.isZero(0);
}

/// About axes in space, with the body turned as in a state, kg m^2.
[[nodiscard]] inline Eigen::Matrix3d inertia_in_space(Model const& model, std::size_t r, State const& state) {
  auto const& R = state.turned[r];
  return R * model.rigids[r].tensor * R.transpose();
}

/// Of a body over a step that begins at `old`.
[[nodiscard]] inline Spin spin_of(Model const& model, std::size_t r, State const& old, double dt) {
  auto const scheme = weights(model.scheme);
  Index const first = 3 * (model.rigids[r].node + 1);
  return {inertia_in_space(model, r, old), old.v.segment<3>(first), dt,
          scheme.surface_apart() ? dt : scheme.rate * dt};
}

} // namespace stiction::dynamics
