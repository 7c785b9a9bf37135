// What a step leaves of a bond: its traction, its state, its energy and what it lost.
#pragma once
#include "contact/problem/problem.hpp"
#include "dynamics/model/state.hpp"

namespace stiction::dynamics {

/// Of a step of a contact point: the gap that it began at and the displacement that it ends with, m.
template<int C> struct PointWay {
  double gap;
  contact::Local<C> x;
};

/// At the end of that way of a point whose total traction stands in after.dry, Pa.
template<int C>
void settle_bond(interface::AdhesionLaw const& law, contact::ProblemPoint const& point,
                 PointWay<C> const& way, ContactState& after, Ledger& ledger) {
  after.adhesion.head<C>() = interface::adhere<C>(law, point.bond, way.x).traction;
  after.dry -= after.adhesion;
  after.bond = interface::advance<C>(law, point.bond, way.x);
  ledger.bonding_loss += point.area * interface::dissipation<C>(law, point.bond, way.gap, way.x);
  ledger.bond += point.area * interface::bond_energy(law, after.bond, after.gap);
}

} // namespace stiction::dynamics
