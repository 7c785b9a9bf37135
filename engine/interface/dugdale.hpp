// Dugdale's law: a constant normal traction up to a range, reversible or with damage that stays.
#pragma once
#include "core/schema.hpp"
#include "interface/bond.hpp"

namespace stiction::interface {

struct Dugdale {
  double sigma0 = 0; ///< traction, Pa
  double h0 = 0;     ///< range, m
  double ramp =
      0.05; ///< over h0: the traction rises over this opening from contact, and falls over it from h0
  Memory memory = Memory::reversible;
  double beta0 = 1;

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<Dugdale>{"dugdale", "constant normal traction up to a range; work sigma0 h0",
                                "Dugdale 1960; Maugis 1992"}
            .number("sigma0", &Dugdale::sigma0, "Pa", core::positive, Need::required, "traction")
            .number("h0", &Dugdale::h0, "m", core::positive, Need::required, "range; the work is sigma0 h0")
            .number("ramp", &Dugdale::ramp, "1", {0, 1, true, false}, Need::optional,
                    "opening over h0 along which the traction rises from contact, and falls beyond h0")
            .choice("memory", &Dugdale::memory, {"irreversible", "reversible"}, Need::optional,
                    "damage with unloading to the origin, or the same traction at every approach")
            .number("beta0", &Dugdale::beta0, "1", core::unit_interval, Need::optional,
                    "intact part at the start of an irreversible law, less where the surfaces are apart")
            .only("memory = \"irreversible\"", [](Dugdale const& law) { return law.lasts(); })
            .build();
    return made;
  }
  [[nodiscard]] double rise() const { return ramp * h0; }
  [[nodiscard]] double end() const { return h0 + rise(); }
  [[nodiscard]] double work() const { return sigma0 * h0; }
  static constexpr bool evolves = false;
  static constexpr bool constant_traction = true; ///< up to its range
  static constexpr Wording wording{.eases = "ramp"};
  [[nodiscard]] static bool tangential() { return false; }
  [[nodiscard]] double range() const { return lasts() ? 0 : end(); }
  [[nodiscard]] bool lasts() const { return memory == Memory::irreversible; }
  [[nodiscard]] Bond initial(double gap) const;
  [[nodiscard]] Scales scales() const { return {work(), sigma0, h0, sigma0 / rise(), 0}; }
  [[nodiscard]] double steepest_fall(BondStep const& step) const {
    return !lasts() || step.old.beta > 0 ? scales().softening : 0;
  }
};

/// Traction at the opening d >= 0 by the undamaged law, its slope, and the work up to there.
struct DugdaleAt {
  double traction = 0, slope = 0, work = 0; ///< Pa, N/m^3, J/m^2
};
[[nodiscard]] inline DugdaleAt envelope(Dugdale const& law, double d) {
  double const s = law.sigma0, a = law.rise();
  if (d <= a)
    return {s * d / a, s / a, 0.5 * s * d * d / a};
  if (d <= law.h0)
    return {s, 0, s * (d - 0.5 * a)};
  double const left = law.end() - d;
  if (left <= 0)
    return {0, 0, law.work()};
  return {s * left / a, -s / a, law.work() - 0.5 * s * left * left / a};
}

/// Opening at which damage has left this beta.
[[nodiscard]] inline double largest_opening(Dugdale const& law, double beta) {
  return beta * law.h0 >= law.rise() ? law.rise() / beta : law.end() / (1 + beta);
}

template<int D> [[nodiscard]] Secant<D> secant(Dugdale const& law, double d) {
  if (d <= law.rise())
    return {};
  auto const at = envelope(law, d);
  double const stiffness = law.sigma0 / law.rise();
  Local<D> by_d = Local<D>::Zero();
  by_d[0] = (at.slope - at.traction / d) / (stiffness * d);
  return {at.traction / (stiffness * d), by_d};
}

template<int D>
[[nodiscard]] Adhesion<D> adhere(Dugdale const& law, BondStep const& step, Local<D> const& x) {
  double const d = std::max(x[0], 0.0);
  if (law.lasts()) {
    Local<D> K = Local<D>::Zero();
    K[0] = law.sigma0 / law.rise();
    return damaged<D>(K, secant<D>(law, d), step, x);
  }
  auto const at = envelope(law, d);
  Adhesion<D> result;
  result.beta = 1 - at.work / law.work();
  result.traction[0] = -at.traction;
  if (x[0] > 0) {
    result.beta_by_x[0] = -at.traction / law.work();
    result.traction_by_x(0, 0) = -at.slope;
  }
  return result;
}

template<int D> [[nodiscard]] Bond advance(Dugdale const& law, BondStep const& step, Local<D> const& x) {
  return {adhere<D>(law, step, x).beta, {0, 0}};
}

inline Bond Dugdale::initial(double gap) const {
  double const d = std::max(gap, 0.0);
  return {lasts() ? std::min(beta0, secant<1>(*this, d).value) : 1 - envelope(*this, d).work / work(),
          {0, 0}};
}

/// Zero where nothing is left, J/m^2.
[[nodiscard]] inline double bond_energy(Dugdale const& law, Bond const& bond, double x_n) {
  double const d = std::max(x_n, 0.0);
  if (law.lasts())
    return 0.5 * bond.beta * law.sigma0 / law.rise() * d * d;
  return bond.beta > 0 ? envelope(law, d).work - law.work() : 0;
}

/// What damage takes as it grows, J/m^2: the work up to the largest opening less what unloading gives back.
template<int D>
[[nodiscard]] double dissipation(Dugdale const& law, BondStep const& step, Local<D> const& x) {
  double const beta = law.lasts() ? adhere<D>(law, step, x).beta : step.old.beta;
  if (beta >= step.old.beta)
    return 0;
  auto const taken = [&](double left) {
    double const d = largest_opening(law, left);
    auto const at = envelope(law, d);
    return at.work - 0.5 * at.traction * d;
  };
  return taken(beta) - taken(step.old.beta);
}

} // namespace stiction::interface
