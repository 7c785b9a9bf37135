// The interface of one pair: friction and, where declared, adhesion. A new law is one header and one word
// here.
#pragma once
#include <algorithm>
#include <optional>
#include <variant>

#include "interface/attraction.hpp"
#include "interface/bilinear.hpp"
#include "interface/coulomb.hpp"
#include "interface/dugdale.hpp"
#include "interface/exponential.hpp"
#include "interface/owed.hpp"
#include "interface/potential.hpp"
#include "interface/pressure_friction.hpp"
#include "interface/rcc.hpp"
#include "interface/static_kinetic.hpp"
#include "interface/tresca.hpp"
#include "interface/velocity_friction.hpp"

namespace stiction::interface {

using FrictionLaw = std::variant<Coulomb, Tresca, PressureFriction, VelocityFriction, StaticKinetic>;
using AdhesionLaw = std::variant<Rcc, Bilinear, Exponential, Dugdale, Potential, Attraction>;
static_assert(core::every<FrictionLaw, owed::OfFriction>);
static_assert(core::every<AdhesionLaw, owed::OfAdhesion>);

struct Law {
  std::optional<FrictionLaw> friction; ///< none: frictionless
  std::optional<AdhesionLaw> adhesion; ///< none: dry contact, no bond state
  /// The coefficient of a step that a point starts from this status; where it follows pressure or speed, that
  /// at none of either.
  [[nodiscard]] double mu(Status last = Status::open) const {
    return friction ? std::visit([&](auto const& law) { return law.mu_from(last); }, *friction) : 0.0;
  }
  /// Does the coefficient follow pressure or speed within a step?
  [[nodiscard]] bool mu_follows() const {
    return friction && std::visit([](auto const& law) { return law.follows; }, *friction);
  }
  /// Does anything act along the surface?
  [[nodiscard]] bool tangential() const {
    return mu() > 0 || mu(Status::slip) > 0 || mu_follows() ||
           (adhesion && std::visit([](auto const& law) { return law.tangential(); }, *adhesion));
  }
  /// How far an open point without bond feels the adhesion, m.
  [[nodiscard]] double range() const {
    return adhesion ? std::visit([](auto const& law) { return law.range(); }, *adhesion) : 0.0;
  }
  /// Does a bond hold its point in the contact problem at any distance?
  [[nodiscard]] bool lasts() const {
    return adhesion && std::visit([](auto const& law) { return law.lasts(); }, *adhesion);
  }
};

/// None of both, or of one kind with the same parameters.
template<class Choice>
[[nodiscard]] bool alike(std::optional<Choice> const& a, std::optional<Choice> const& b) {
  auto const same = [&]<class Kind>(Kind const& one) {
    auto const& other = std::get<Kind>(*b);
    return std::ranges::all_of(Kind::schema().parameters, [&](core::Parameter const& p) {
      return p.get && p.get(&one) == p.get(&other);
    });
  };
  return a && b ? a->index() == b->index() && std::visit(same, *a) : !a && !b;
}

[[nodiscard]] inline bool alike(Law const& a, Law const& b) {
  return alike(a.friction, b.friction) && alike(a.adhesion, b.adhesion);
}

// What each law defines for itself, dispatched; D = 1, 2, 3.

template<int D> [[nodiscard]] Coefficient<D> coefficient(FrictionLaw const& friction, Sliding<D> const& at);
template<int D>
[[nodiscard]] Adhesion<D> adhere(AdhesionLaw const& adhesion, BondStep const& step, Local<D> const& x);
template<int D>
[[nodiscard]] Bond advance(AdhesionLaw const& adhesion, BondStep const& step, Local<D> const& x);
/// What the step dissipates by bonding, viscosity and damage, J/m^2.
template<int D>
[[nodiscard]] double dissipation(AdhesionLaw const& adhesion, BondStep const& step, Local<D> const& x);
/// The same where the step began at this gap, m: of a bond that follows its opening what its traction does on
/// the straight way and does not store, also where the mode changes on it; to 1e-10 of what the law takes.
template<int D>
[[nodiscard]] double dissipation(AdhesionLaw const& adhesion, BondStep const& step, double gap,
                                 Local<D> const& x);
/// What the bond stores, zero when it is gone, J/m^2.
[[nodiscard]] double bond_energy(AdhesionLaw const& adhesion, Bond const& bond, double x_n);
/// The bond at the start of a point with this gap.
[[nodiscard]] Bond initial_bond(AdhesionLaw const& adhesion, double gap);
[[nodiscard]] Scales scales(AdhesionLaw const& adhesion);
/// Steepest fall of the normal traction with the opening that a bond without shear has in this step, N/m^3.
[[nodiscard]] double steepest_fall(AdhesionLaw const& adhesion, BondStep const& step);
/// Most by which the coefficient falls per slip within a step of dt, 1/m; 0 where it does not.
[[nodiscard]] inline double steepest_fall(FrictionLaw const& friction, double dt) {
  return std::visit([&](auto const& law) { return law.steepest_fall(dt); }, friction);
}
/// Does beta obey a rate in time, which a step integrates by implicit Euler?
[[nodiscard]] bool evolves(AdhesionLaw const& adhesion);
/// Does it pull with the same traction up to its range?
[[nodiscard]] bool constant_traction(AdhesionLaw const& adhesion);
/// s in which a bond that evolves forms or goes by its own rate; 0: it follows its opening at once.
[[nodiscard]] double bond_time(AdhesionLaw const& adhesion);
/// May the beta of a bond that evolves grow?
[[nodiscard]] bool grows(AdhesionLaw const& adhesion);
/// Work of the traction of a bond that follows its opening, along the straight way between two displacements
/// of the step, to 1e-10 of what the law takes; however far they are apart. J/m^2
[[nodiscard]] double work_along(AdhesionLaw const& adhesion, BondStep const& step, Local<3> const& from,
                                Local<3> const& to);
/// What implicit Euler loses in a step of a bond that evolves beside the trapezium of its pull, J/m^2.
[[nodiscard]] double integration_loss(AdhesionLaw const& adhesion, BondMove const& move);
/// What a bond that evolves dissipates in a step, J/m^2.
[[nodiscard]] double dissipation(AdhesionLaw const& adhesion, BondMove const& move);
[[nodiscard]] Wording wording(AdhesionLaw const& adhesion);

} // namespace stiction::interface
