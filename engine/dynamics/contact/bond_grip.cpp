// Resistance of whole bonds by their laws.
#include "dynamics/contact/bond_grip.hpp"

namespace stiction::dynamics {

namespace {

/// An opening at which a bond is still as whole as at none, where no law has a normal slope, m.
double hardly_open(interface::AdhesionLaw const& law) {
  double const opening = interface::scales(law).opening;
  return 1e-6 * (std::isfinite(opening) && opening > 0 ? opening : 1.0);
}

} // namespace

interface::Local<3> bond_resistance(interface::AdhesionLaw const& law, interface::BondStep const& step,
                                    double gap) {
  bool const lasts = std::visit([](auto const& one) { return one.lasts(); }, law);
  interface::Local<3> x = interface::Local<3>::Zero();
  x[0] = lasts ? hardly_open(law) : std::max(gap, hardly_open(law));
  interface::BondStep unstretched = step;
  unstretched.old.stretch.setZero();
  if (!(step.old.beta > interface::least_beta))
    return interface::Local<3>::Zero();
  return interface::adhere<3>(law, unstretched, x).traction_by_x.diagonal().cwiseAbs();
}

Dense bond_grip(interface::Law const& law, contact::ProblemPoint const& point, PointRows const& rows) {
  if (!law.adhesion)
    return Dense::Zero(rows.H.cols(), rows.H.cols());
  interface::Local<3> const C = bond_resistance(*law.adhesion, point.bond, rows.gap);
  return -point.area * (rows.H.transpose() * C.head(rows.H.rows()).asDiagonal() * rows.H);
}

} // namespace stiction::dynamics
