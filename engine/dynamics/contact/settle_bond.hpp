// What a step leaves of a bond: its traction, its state, its energy and what it lost.
#pragma once
#include "contact/problem/problem.hpp"
#include "dynamics/model/state.hpp"

namespace stiction::dynamics {

/// At the end of a step from this gap to the displacement x[C], m, of a point whose total traction stands in
/// after.dry, Pa.
template<int C>
void settle_bond(interface::AdhesionLaw const& law, contact::ProblemPoint const& point, double gap,
                 contact::Local<C> const& x, ContactState& after, Ledger& ledger) {
  after.adhesion.head<C>() = interface::adhere<C>(law, point.bond, x).traction;
  after.dry -= after.adhesion;
  after.bond = interface::advance<C>(law, point.bond, x);
  ledger.bonding_loss += point.area * interface::dissipation<C>(law, point.bond, gap, x);
  ledger.bond += point.area * interface::bond_energy(law, after.bond, after.gap);
}

} // namespace stiction::dynamics
