// The bond of a contact point: what survives a step, what a law answers, and what all laws share.
#pragma once
#include <algorithm>
#include <cmath>
#include <string_view>

#include "interface/cone.hpp"

namespace stiction::interface {

/// The bond of one contact point: all that must survive a step.
struct Bond {
  /// 0 none .. 1 full: intensity of RCC, 1 - damage of cohesive laws, part of the work of separation that is
  /// still ahead of reversible laws.
  double beta = 0;
  Eigen::Vector2d stretch = Eigen::Vector2d::Zero(); ///< tangential displacement since it formed, m
};

/// Gap of a point that has no counterpart, with which it has nothing to bond, m.
inline constexpr double unreached = 1e100;

/// Which friction the bond leaves: all of mu, or mu (1 - beta)^p.
enum class BondFriction { full, damage };
/// Whether the bond takes damage that stays, or follows a potential.
enum class Memory { irreversible, reversible };

/// What holds for the bond during one step.
struct BondStep {
  Bond old;
  double dt = 0;       ///< s; with 0 the bond stays as it is
  bool closed = false; ///< the point touches: beta may grow when bonding = "contact"
};

/// Answer of the law at the displacement x = (x_n, slip of the step) of the step's end.
template<int D> struct Adhesion {
  double beta = 0;
  Local<D> beta_by_x = Local<D>::Zero();
  Local<D> traction = Local<D>::Zero(); ///< rtilde, Pa
  LocalMatrix<D> traction_by_x = LocalMatrix<D>::Zero();
  double friction = 1; ///< factor on mu
  Local<D> friction_by_x = Local<D>::Zero();
};

/// The numbers of a law that say what it asks of mesh, steps and bodies.
struct Scales {
  double work = 0;      ///< of separation along the normal, J/m^2
  double strength = 0;  ///< largest normal traction, Pa
  double opening = 0;   ///< up to which it is reached, or, where it is at none, that leaves 1/e of it, m
  double softening = 0; ///< steepest fall of the normal traction, N/m^3
  double along = 0;     ///< slip at the largest tangential traction, m; 0: nothing acts along the surface
};

/// What a law calls its scales in its own letters, for those who read them.
struct Wording {
  std::string_view strength = {}, opening = {}; ///< as formulas; empty: none
  std::string_view length = "E* w / sigma0^2", softening = "softening", tabor = "sigma0 / w";
  std::string_view viscosity = {}; ///< parameter that sets the time of a bond that evolves
  std::string_view time = "in which a bond forms or goes by its own rate";
  std::string_view speed = "of opening times the bonding time over u0";
  std::string_view eases = {}; ///< parameter in proportion to which its pull falls off less steeply
};

/// One step of a bond from its end: the openings (x_n, stretch) in the frame there.
struct BondMove {
  Local<3> from = Local<3>::Zero(), to = Local<3>::Zero(); ///< m
  double beta_from = 0, beta_to = 0;
  double dt = 0; ///< s; > 0
};

/// From this part of a bond on it holds its point beyond a border, and its loss there is told.
inline constexpr double lasting_beta = 0.01;

/// Below this a damaged bond counts as broken, so that its point may leave the contact problem.
inline constexpr double least_beta = 1e-16;

/// (C_n x_n^2, C_t x_t^2) gather in q; a bond that was not there at the step's start has no stretch yet.
template<int D> [[nodiscard]] Local<D> opening(Local<D> const& x, Bond const& old) {
  Local<D> d = Local<D>::Zero();
  d[0] = std::max(x[0], 0.0);
  if (old.beta > 0)
    d.template tail<D - 1>() = old.stretch.head<D - 1>() + x.template tail<D - 1>();
  return d;
}

/// Diagonal of the derivative of `opening` by x.
template<int D> [[nodiscard]] Local<D> opening_by_x(Local<D> const& x, Bond const& old) {
  Local<D> d_by_x = Local<D>::Constant(old.beta > 0 ? 1.0 : 0.0);
  d_by_x[0] = x[0] > 0 ? 1.0 : 0.0;
  return d_by_x;
}

/// The same bond with its stretch turned by an angle from t1 to t2, rad.
[[nodiscard]] inline Bond turned(Bond bond, double angle) {
  if (angle != 0)
    bond.stretch = {std::cos(angle) * bond.stretch[0] - std::sin(angle) * bond.stretch[1],
                    std::sin(angle) * bond.stretch[0] + std::cos(angle) * bond.stretch[1]};
  return bond;
}

/// The opening (x_n, stretch) of a bond after a step.
[[nodiscard]] inline Local<3> opening_of(Bond const& bond, double x_n) {
  return {std::max(x_n, 0.0), bond.stretch[0], bond.stretch[1]};
}

/// Sets the factor (1 - beta)^power on mu where the bond takes friction away, (10).
template<int D> void leave_friction(Adhesion<D>& result, BondFriction choice, double power) {
  if (choice == BondFriction::full)
    return;
  double const rest = 1 - result.beta;
  result.friction = std::pow(rest, power);
  result.friction_by_x = (-power * std::pow(rest, power - 1)) * result.beta_by_x;
}

/// A bond with the given beta and the stretch that x leaves; nothing once beta is 0.
template<int D> [[nodiscard]] Bond stretched(double beta, Bond const& old, Local<D> const& x) {
  Bond next;
  next.beta = beta;
  if (next.beta > 0)
    next.stretch.head<D - 1>() = opening<D>(x, old).template tail<D - 1>();
  return next;
}

/// Part of the initial stiffness that loading to the opening d for the first time leaves, and its gradient.
template<int D> struct Secant {
  double value = 1;
  Local<D> by_d = Local<D>::Zero();
};

/// A bond under damage 1 - beta: rtilde = - beta K d with beta = min(beta_old, secant(d)), so that it unloads
/// to the origin and never heals. K: diagonal of the stiffness, N/m^3.
template<int D>
[[nodiscard]] Adhesion<D> damaged(Local<D> const& K, Secant<D> const& secant, BondStep const& step,
                                  Local<D> const& x) {
  Local<D> const d = opening<D>(x, step.old), d_by_x = opening_by_x<D>(x, step.old);
  Local<D> const Kd = K.cwiseProduct(d);
  Adhesion<D> result;
  result.beta = std::min(step.old.beta, secant.value);
  if (result.beta < least_beta) {
    result.beta = 0;
    return result;
  }
  if (secant.value < step.old.beta)
    result.beta_by_x = secant.by_d.cwiseProduct(d_by_x);
  result.traction = -result.beta * Kd;
  result.traction_by_x = -Kd * result.beta_by_x.transpose();
  result.traction_by_x.diagonal() -= result.beta * K.cwiseProduct(d_by_x);
  return result;
}

} // namespace stiction::interface
