// What Newton's method adds to its matrix where bonds alone hold a body.
#pragma once
#include "contact/problem/problem.hpp"

namespace stiction::dynamics {

/// Stiffnesses along (n, t1, t2) that a bond resists with at this gap from no stretch, N/m^3; >= 0.
[[nodiscard]] interface::Local<3> bond_resistance(interface::AdhesionLaw const& law,
                                                  interface::BondStep const& step, double gap);

/// Gap of a point and rows (n, t1 [, t2]) of its H.
struct PointRows {
  double gap;
  Dense H;
};

/// They as stiffness of the point's force, - H^T A C H, N/m. The matrix may have a part of it where the
/// bodies by themselves resist nothing that their bonds hold, as the contact problem wants a finite
/// compliance. The balance has no such term, so that this part is also what an iteration leaves of an error.
[[nodiscard]] Dense bond_grip(interface::Law const& law, contact::ProblemPoint const& point,
                              PointRows const& rows);

} // namespace stiction::dynamics
