// What each law defines for itself, dispatched: compiled once, since every law in every dimension takes long.
#include "interface/law.hpp"

namespace stiction::interface {

namespace {

/// `answer(law)` of a law that evolves, else `otherwise`.
template<class Answer, class Value>
Value if_evolving(AdhesionLaw const& adhesion, Answer const& answer, Value otherwise) {
  return std::visit(
      [&]<class Law>(Law const& law) {
        if constexpr (Law::evolves)
          return answer(law);
        else
          return otherwise;
      },
      adhesion);
}
} // namespace

template<int D> Coefficient<D> coefficient(FrictionLaw const& friction, Sliding<D> const& at) {
  return std::visit([&](auto const& law) { return coefficient<D>(law, at); }, friction);
}
template<int D> Adhesion<D> adhere(AdhesionLaw const& adhesion, BondStep const& step, Local<D> const& x) {
  return std::visit([&](auto const& law) { return adhere<D>(law, step, x); }, adhesion);
}
template<int D> Bond advance(AdhesionLaw const& adhesion, BondStep const& step, Local<D> const& x) {
  return std::visit([&](auto const& law) { return advance<D>(law, step, x); }, adhesion);
}
template<int D> double dissipation(AdhesionLaw const& adhesion, BondStep const& step, Local<D> const& x) {
  return std::visit([&](auto const& law) { return dissipation<D>(law, step, x); }, adhesion);
}

template Coefficient<1> coefficient(FrictionLaw const&, Sliding<1> const&);
template Coefficient<2> coefficient(FrictionLaw const&, Sliding<2> const&);
template Coefficient<3> coefficient(FrictionLaw const&, Sliding<3> const&);
template Adhesion<1> adhere(AdhesionLaw const&, BondStep const&, Local<1> const&);
template Adhesion<2> adhere(AdhesionLaw const&, BondStep const&, Local<2> const&);
template Adhesion<3> adhere(AdhesionLaw const&, BondStep const&, Local<3> const&);
template Bond advance(AdhesionLaw const&, BondStep const&, Local<1> const&);
template Bond advance(AdhesionLaw const&, BondStep const&, Local<2> const&);
template Bond advance(AdhesionLaw const&, BondStep const&, Local<3> const&);
template double dissipation(AdhesionLaw const&, BondStep const&, Local<1> const&);
template double dissipation(AdhesionLaw const&, BondStep const&, Local<2> const&);
template double dissipation(AdhesionLaw const&, BondStep const&, Local<3> const&);

double bond_energy(AdhesionLaw const& adhesion, Bond const& bond, double x_n) {
  return std::visit([&](auto const& law) { return bond_energy(law, bond, x_n); }, adhesion);
}
Bond initial_bond(AdhesionLaw const& adhesion, double gap) {
  return std::visit([&](auto const& law) { return law.initial(gap); }, adhesion);
}
Scales scales(AdhesionLaw const& adhesion) {
  return std::visit([](auto const& law) { return law.scales(); }, adhesion);
}
double steepest_fall(AdhesionLaw const& adhesion, BondStep const& step) {
  return std::visit([&](auto const& law) { return law.steepest_fall(step); }, adhesion);
}
bool evolves(AdhesionLaw const& adhesion) {
  return std::visit([](auto const& law) { return law.evolves; }, adhesion);
}

bool constant_traction(AdhesionLaw const& adhesion) {
  return std::visit(
      [](auto const& law) {
        return requires {
          law.constant_traction;
        };
      },
      adhesion);
}

double bond_time(AdhesionLaw const& adhesion) {
  return if_evolving(
      adhesion, [](auto const& law) { return law.time(); }, 0.0);
}
bool grows(AdhesionLaw const& adhesion) {
  return if_evolving(
      adhesion, [](auto const& law) { return law.grows(); }, false);
}
double integration_loss(AdhesionLaw const& adhesion, BondMove const& move) {
  return if_evolving(
      adhesion, [&](auto const& law) { return integration_loss(law, move); }, 0.0);
}
double dissipation(AdhesionLaw const& adhesion, BondMove const& move) {
  return if_evolving(
      adhesion, [&](auto const& law) { return dissipation(law, move); }, 0.0);
}
Wording wording(AdhesionLaw const& adhesion) {
  return std::visit(
      []<class Law>(Law const&) {
        if constexpr (requires { Law::wording; })
          return Law::wording;
        else
          return Wording{};
      },
      adhesion);
}

} // namespace stiction::interface
