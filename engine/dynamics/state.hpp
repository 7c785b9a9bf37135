// All that must survive a step.
#pragma once
#include <vector>

#include "contact/kinematics.hpp"
#include "interface/rcc.hpp"

namespace stiction::dynamics {

/// One contact point at the end of a step.
struct ContactState {
  contact::Foot foot;                                 ///< counterpart, the origin of the next step's slip
  double gap = 0;                                     ///< x_n, m
  double slip = 0;                                    ///< slip increment of the last step, m
  double path = 0;                                    ///< signed slip since the start, m
  Eigen::Vector2d dry = Eigen::Vector2d::Zero();      ///< rbar (n, t), Pa
  Eigen::Vector2d adhesion = Eigen::Vector2d::Zero(); ///< rtilde (n, t), Pa
  interface::Bond bond;
  interface::Status status = interface::Status::open;
  bool in_reach = false; ///< took part in the last step's contact problem
};

/// Cumulative energy account, J (J/m in plane strain); kinetic, strain and bond are present values.
struct Ledger {
  double kinetic = 0, strain = 0, bond = 0, potential = 0; ///< potential: of gravity
  double motion_work = 0;                                  ///< done by driven nodes and moving obstacles
  double friction_loss = 0;                                ///< dissipated by slip against rbar_t
  double bonding_loss = 0;                                 ///< int A b beta'^2 dt
  double start = 0;                                        ///< kinetic + strain + bond + potential at t = 0
  /// What the scheme itself has lost (positive) or made.
  [[nodiscard]] double scheme_loss() const {
    return start + motion_work - (kinetic + strain + bond + potential) - friction_loss - bonding_loss;
  }
};

struct State {
  double t = 0;    ///< s
  Vector u, v;     ///< [2 nodes], m and m/s
  Vector internal; ///< F_int(u), N
  Vector reaction; ///< H^T A r at the end of the step, N
  Vector drive;    ///< force of the motions over the last step, at driven unknowns, N
  std::vector<std::vector<ContactState>> contacts; ///< [pairs][points]
  Ledger ledger;
};

} // namespace stiction::dynamics
