// What interface laws owe: friction, and adhesion with what a bond that has a rate of its own owes besides.
#pragma once
#include "core/owed.hpp"
#include "interface/bond.hpp"
#include "interface/friction.hpp"

namespace stiction::interface::owed {

template<class Law>
concept Following = requires {
  typename std::bool_constant<Law::follows>;
};

template<class Law>
concept Start = requires(Law const& law, Status last) {
  { law.mu_from(last) } -> std::same_as<double>;
};

template<class Law>
concept Weakening = requires(Law const& law, double dt) {
  { law.steepest_fall(dt) } -> std::same_as<double>;
};

template<class Law, int D>
concept HasCoefficient = requires(Law const& law, Sliding<D> const& at) {
  { coefficient<D>(law, at) } -> std::same_as<Coefficient<D>>;
};
template<class Law>
concept Slides = HasCoefficient<Law, 1> && HasCoefficient<Law, 2> && HasCoefficient<Law, 3>;

template<class Law>
concept FrictionLaw = core::Described<Law> && Following<Law> && Start<Law> && Weakening<Law> && Slides<Law>;

template<class Law> struct OfFriction {
  static_assert(core::Described<Law>, "a friction law lacks `static core::Schema const& schema()`: its name, "
                                      "meaning and parameters");
  static_assert(Following<Law>, "a friction law lacks `static constexpr bool follows`: does its coefficient "
                                "follow pressure or slip within a step?");
  static_assert(Start<Law>,
                "a friction law lacks `double mu_from(Status last) const`: its coefficient at the "
                "start of a step, at no pressure and speed");
  static_assert(Weakening<Law>,
                "a friction law lacks `double steepest_fall(double dt) const`: the most by which its "
                "coefficient falls per slip within a step, 1/m; 0: never");
  static_assert(Slides<Law>, "a friction law lacks `template<int D> Coefficient<D> coefficient(Law const&, "
                             "Sliding<D> const&)`: mu and its derivatives, for D = 1, 2, 3");
  static constexpr bool given = FrictionLaw<Law>;
};

template<class Law>
concept Sides = requires(Law const& law) {
  { law.tangential() } -> std::same_as<bool>;
};
template<class Law>
concept Range = requires(Law const& law) {
  { law.range() } -> std::same_as<double>;
};
template<class Law>
concept Lasting = requires(Law const& law) {
  { law.lasts() } -> std::same_as<bool>;
};
template<class Law>
concept Beginning = requires(Law const& law, double gap) {
  { law.initial(gap) } -> std::same_as<Bond>;
};
template<class Law>
concept Scaled = requires(Law const& law) {
  { law.scales() } -> std::same_as<Scales>;
};
template<class Law>
concept Falling = requires(Law const& law, BondStep const& step) {
  { law.steepest_fall(step) } -> std::same_as<double>;
};

template<class Law, int D>
concept HasTraction = requires(Law const& law, BondStep const& step, Local<D> const& x) {
  { adhere<D>(law, step, x) } -> std::same_as<Adhesion<D>>;
};
template<class Law>
concept Pulls = HasTraction<Law, 1> && HasTraction<Law, 2> && HasTraction<Law, 3>;

template<class Law, int D>
concept HasNext = requires(Law const& law, BondStep const& step, Local<D> const& x) {
  { advance<D>(law, step, x) } -> std::same_as<Bond>;
};
template<class Law>
concept Advances = HasNext<Law, 1> && HasNext<Law, 2> && HasNext<Law, 3>;

template<class Law, int D>
concept HasLoss = requires(Law const& law, BondStep const& step, Local<D> const& x) {
  { dissipation<D>(law, step, x) } -> std::same_as<double>;
};
template<class Law>
concept Loses = HasLoss<Law, 1> && HasLoss<Law, 2> && HasLoss<Law, 3>;

template<class Law>
concept Stores = requires(Law const& law, Bond const& bond, double x_n) {
  { bond_energy(law, bond, x_n) } -> std::same_as<double>;
};
template<class Law>
concept Evolution = requires {
  typename std::bool_constant<Law::evolves>;
};

/// Whose beta obeys a rate that the step integrates by implicit Euler.
template<class Law>
concept Evolving = Evolution<Law> && Law::evolves;
template<class Law>
concept Timed = !Evolving<Law> || requires(Law const& law) {
  { law.time() } -> std::same_as<double>;
  { law.grows() } -> std::same_as<bool>;
};
template<class Law>
concept Audited = !Evolving<Law> || requires(Law const& law, BondMove const& move) {
  { integration_loss(law, move) } -> std::same_as<double>;
};
template<class Law>
concept Spending = !Evolving<Law> || requires(Law const& law, BondMove const& move) {
  { dissipation(law, move) } -> std::same_as<double>;
};

template<class Law>
concept Laid = core::Described<Law> && Sides<Law> && Range<Law> && Lasting<Law> && Beginning<Law> &&
    Scaled<Law> && Falling<Law>;
/// It may have besides `static constexpr Wording wording`, and what every part may that is read by a schema
/// (core/reader.hpp).
template<class Law>
concept AdhesionLaw = Laid<Law> && Pulls<Law> && Advances<Law> && Loses<Law> && Stores<Law> &&
    Evolution<Law> && Timed<Law> && Audited<Law> && Spending<Law>;

template<class Law> struct OfAdhesion {
  static_assert(core::Described<Law>,
                "an adhesion law lacks `static core::Schema const& schema()`: its name, "
                "meaning and parameters");
  static_assert(Sides<Law>, "an adhesion law lacks `bool tangential() const`: does anything of the bond act "
                            "along the surface?");
  static_assert(Range<Law>,
                "an adhesion law lacks `double range() const`: how far an open point without bond "
                "feels it, m");
  static_assert(Lasting<Law>, "an adhesion law lacks `bool lasts() const`: does a bond hold its point in the "
                              "contact problem at any distance?");
  static_assert(Beginning<Law>,
                "an adhesion law lacks `Bond initial(double gap) const`: the bond at the start "
                "of a point with this gap");
  static_assert(Scaled<Law>, "an adhesion law lacks `Scales scales() const`: its work, strength and lengths");
  static_assert(Falling<Law>, "an adhesion law lacks `double steepest_fall(BondStep const&) const`: of the "
                              "normal traction with the opening in this step, N/m^3");
  static_assert(Pulls<Law>, "an adhesion law lacks `template<int D> Adhesion<D> adhere(Law const&, BondStep "
                            "const&, Local<D> const& x)`: traction, beta and derivatives, for D = 1, 2, 3");
  static_assert(Advances<Law>, "an adhesion law lacks `template<int D> Bond advance(Law const&, BondStep "
                               "const&, Local<D> const& x)`: the bond after the step, for D = 1, 2, 3");
  static_assert(Loses<Law>, "an adhesion law lacks `template<int D> double dissipation(Law const&, BondStep "
                            "const&, Local<D> const& x)`: of the step, J/m^2, for D = 1, 2, 3");
  static_assert(Stores<Law>,
                "an adhesion law lacks `double bond_energy(Law const&, Bond const&, double x_n)`: "
                "what the bond stores, J/m^2");
  static_assert(Evolution<Law>, "an adhesion law lacks `static constexpr bool evolves`: does its beta obey a "
                                "rate that a step integrates by implicit Euler?");
  static_assert(Timed<Law>,
                "an adhesion law that evolves lacks `double time() const`, s, in which a bond forms "
                "or goes, or `bool grows() const`: may it form?");
  static_assert(Audited<Law>,
                "an adhesion law that evolves lacks `double integration_loss(Law const&, BondMove "
                "const&)`: what implicit Euler loses in a step, J/m^2");
  static_assert(Spending<Law>, "an adhesion law that evolves lacks `double dissipation(Law const&, BondMove "
                               "const&)`: of a step that ends with this beta, J/m^2");
  static constexpr bool given = AdhesionLaw<Law>;
};

} // namespace stiction::interface::owed
