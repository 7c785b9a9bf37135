// What each law defines for itself, dispatched: compiled once, since every law in every dimension takes long.
#include "interface/law.hpp"

#include <array>

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

/// Simpson's rule on halves of halves of a way, fine where the law may change: near no opening, and at kinks.
class WorkOnWay {
public:
  WorkOnWay(AdhesionLaw const& law, BondStep const& step, Local<3> const& from, Local<3> const& to)
      : law_(law), step_(step), from_(from), way_(to - from), scale_(scales(law)) {
    if (scale_.along > 0)
      scale_.opening = std::min(scale_.opening, scale_.along);
  }
  [[nodiscard]] double whole() const { return over({at(0), at(0.5), at(1)}, 60); }

private:
  struct Place {
    double part, force; ///< of the way, Pa m
    Local<3> opening;   ///< m
  };
  using Stretch = std::array<Place, 3>;
  [[nodiscard]] Place at(double part) const {
    Local<3> const x = from_ + part * way_;
    return {part, adhere<3>(law_, step_, x).traction.dot(way_), opening<3>(x, step_.old)};
  }
  [[nodiscard]] static double simpson(Stretch const& on) {
    return (on[2].part - on[0].part) / 6 * (on[0].force + 4 * on[1].force + on[2].force);
  }
  [[nodiscard]] double over(Stretch const& on, int depth) const {
    Stretch const first{on[0], at(0.5 * (on[0].part + on[1].part)), on[1]};
    Stretch const second{on[1], at(0.5 * (on[1].part + on[2].part)), on[2]};
    double const halves = simpson(first) + simpson(second), change = halves - simpson(on);
    double const length = (on[2].opening - on[0].opening).norm();
    double const least = std::min({on[0].opening.norm(), on[1].opening.norm(), on[2].opening.norm()});
    bool const seen = length <= 0.5 * scale_.opening || length <= least;
    if (depth == 0 || (seen && !(std::abs(change) > 1e-11 * scale_.work)))
      return halves + change / 15;
    return over(first, depth - 1) + over(second, depth - 1);
  }

  AdhesionLaw const& law_;
  BondStep const& step_;
  Local<3> from_, way_;
  Scales scale_;
};

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

template<int D>
double dissipation(AdhesionLaw const& adhesion, BondStep const& step, double gap, Local<D> const& x) {
  double const in_its_mode = dissipation<D>(adhesion, step, x);
  bool const opens = gap > 0 || x[0] > 0,
             shears = opening<D>(x, step.old).template tail<D - 1>().squaredNorm() > 0;
  if (!(in_its_mode > 0) || !opens || !shears || gap >= unreached || evolves(adhesion))
    return in_its_mode;
  Local<3> const from(gap, 0, 0);
  Local<3> to = Local<3>::Zero();
  to.head<D>() = x;
  double const stored =
      bond_energy(adhesion, advance<D>(adhesion, step, x), x[0]) - bond_energy(adhesion, step.old, gap);
  return std::max(0.0, -work_along(adhesion, step, from, to) - stored);
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
template double dissipation(AdhesionLaw const&, BondStep const&, double, Local<1> const&);
template double dissipation(AdhesionLaw const&, BondStep const&, double, Local<2> const&);
template double dissipation(AdhesionLaw const&, BondStep const&, double, Local<3> const&);

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
double work_along(AdhesionLaw const& adhesion, BondStep const& step, Local<3> const& from,
                  Local<3> const& to) {
  return from == to ? 0 : WorkOnWay(adhesion, step, from, to).whole();
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
