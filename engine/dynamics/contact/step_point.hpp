// A contact point within a step.
#pragma once
#include "contact/problem/problem.hpp"
#include "dynamics/contact/contact_system.hpp"

namespace stiction::dynamics {

/// Components C of forces in D dimensions: C = D, or 1 where nothing acts along the surface.
template<int D, int C> struct StepPoint {
  PointId id;
  contact::PointKinematics<D> kinematics;
  contact::Local<C> force = contact::Local<C>::Zero(); ///< p = A r, N
  double rho = 0;                                      ///< of the last problem, N/m; 0 before
  contact::ProblemPoint data;                          ///< area, mu, bond
  bool active = false;
  bool waits = false; ///< at the velocity level: its gap will not close in this step
  Index lead = -1;    ///< the point that acts for this one too, see Twins; -1: none
  bool apart = false; ///< there is no counterpart to look for in this step
  int lost = 0;       ///< times that it lost its counterpart in this step
  [[nodiscard]] contact::Local<C> x() const {
    contact::Local<C> x;
    x[0] = kinematics.gap;
    x.template tail<C - 1>() = kinematics.slip.template head<C - 1>();
    return x;
  }
};

/// With what does not act along the surface.
template<int D, int C> [[nodiscard]] contact::Local<D> full(Eigen::Matrix<double, C, 1> const& force) {
  contact::Local<D> all = contact::Local<D>::Zero();
  all.template head<C>() = force;
  return all;
}

} // namespace stiction::dynamics
