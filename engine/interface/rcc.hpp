// The RCC law of Raous, Cangemi and Cocou: adhesion of intensity beta, its growth and its loss.
#pragma once
#include "core/reader.hpp"
#include "interface/bond.hpp"

namespace stiction::interface {

/// When beta may grow.
enum class Bonding { contact, proximity, never };

struct Rcc {
  double w = 0;    ///< decohesion energy, J/m^2
  double C_n = 0;  ///< normal stiffness at beta = 1, N/m^3
  double C_t = 0;  ///< tangential stiffness at beta = 1, N/m^3; along t1 where C_t2 differs
  double C_t2 = 0; ///< along t2, N/m^3; only in three dimensions
  double b = 0;    ///< viscosity of the bond, N s/m
  double beta0 = 0;
  Bonding bonding = Bonding::contact;
  BondFriction friction = BondFriction::full;
  double damage_power = 1;

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<Rcc>{"rcc", "adhesion of bond intensity beta coupled to friction",
                            "(9)-(13), physics.md 2"}
            .number("w", &Rcc::w, "J/m^2", core::non_negative, Need::required, "decohesion energy")
            .number("C_n", &Rcc::C_n, "N/m^3", core::non_negative, Need::required,
                    "normal stiffness at beta = 1")
            .number("C_t", &Rcc::C_t, "N/m^3", core::non_negative, Need::required,
                    "tangential stiffness at beta = 1; in 3D along the pair's direction")
            .number("C_t2", &Rcc::C_t2, "N/m^3", core::non_negative, Need::optional,
                    "tangential stiffness across the pair's direction (3D); default: C_t")
            .number("b", &Rcc::b, "N s/m", core::non_negative, Need::required,
                    "viscosity of the bond; 0 is the rate-independent limit")
            .number(
                "beta0", &Rcc::beta0, "1", core::unit_interval, Need::optional,
                "bond intensity at the start, less where the surfaces are farther apart than sqrt(w / C_n): "
                "w / (C_n gap^2), which that gap leaves of it in the end")
            .choice("bonding", &Rcc::bonding, {"contact", "proximity", "never"}, Need::optional,
                    "beta grows where closed, everywhere by (13), or nowhere")
            .choice("friction", &Rcc::friction, {"full", "damage"}, Need::optional,
                    "friction coefficient mu, or mu (1 - beta)^damage_power as (10)")
            .number("damage_power", &Rcc::damage_power, "1", {1, 10, false, false}, Need::optional,
                    "exponent p of friction = \"damage\"")
            .only("friction = \"damage\"",
                  [](Rcc const& law) { return law.friction == BondFriction::damage; })
            .build();
    return made;
  }
  /// Openings sqrt(w / C_n) up to which bonds grow in a gap: farther, 1/800 of the work is left to do.
  static constexpr double felt = 20;
  /// Does a step to this gap, m, leave a torn bond? Lifted beyond that way, with less than it leaves at rest;
  /// and from there, with no stretch, until the point touches. What slides away in contact is not torn, nor
  /// is what forms there, whatever rounding leaves of its gap.
  [[nodiscard]] bool tears(BondStep const& step, double gap, double beta) const {
    constexpr double left = 1 / (felt * felt);
    bool const was = step.old.beta < left && step.old.stretch.isZero(0);
    return !step.closed && gap > 0 && beta < left && (was || C_n * gap * gap > felt * felt * w);
  }
  static constexpr bool evolves = true;
  static constexpr Wording wording{
      "sqrt(w C_n)",
      "sqrt(w / C_n)",
      "E* / C_n",
      "3 C_n",
      "/ u0",
      "b",
      "b / w, from no bond to a full one in contact",
      "V b / (w u0): the bond's viscosity raises the peak by 1 % at 0.1, by 11 % at 1"};
  void read_nested(core::Reader const& reader) {
    if (!reader.has("C_t2"))
      C_t2 = C_t;
  }
  /// Does anything of the bond act along the surface?
  [[nodiscard]] bool tangential() const { return C_t > 0 || C_t2 > 0 || friction == BondFriction::damage; }
  /// How far an open point without bond feels the law, m.
  [[nodiscard]] double range() const {
    return bonding == Bonding::proximity && w > 0 && C_n > 0 ? felt * std::sqrt(w / C_n) : 0;
  }
  /// Does a bond hold its point in the contact problem at any distance?
  [[nodiscard]] static bool lasts() { return true; }
  /// Across a gap the bond of which it would be left at rest: (13) stands still at w = C_n x_n^2 beta.
  [[nodiscard]] Bond initial(double gap) const {
    if (gap >= unreached)
      return {0, {0, 0}};
    double const pull = C_n * gap * gap; // over beta, J/m^2
    return {gap > 0 && w > 0 && pull > w ? std::min(beta0, w / pull) : beta0, {0, 0}};
  }
  [[nodiscard]] Scales scales() const {
    return {w, std::sqrt(w * C_n), std::sqrt(w / C_n), 3 * C_n, C_t > 0 ? std::sqrt(w / C_t) : 0};
  }
  /// s in which a bond forms in contact; 0: it follows its opening at once.
  [[nodiscard]] double time() const { return b > 0 ? b / w : 0; }
  /// May beta grow?
  [[nodiscard]] bool grows() const { return bonding != Bonding::never; }
  /// Largest beta that the step may reach.
  [[nodiscard]] double largest_beta(BondStep const& step) const {
    bool const may_grow = bonding == Bonding::proximity || (bonding == Bonding::contact && step.closed);
    return may_grow ? 1 : step.old.beta;
  }
  /// With beta = N / (b + s), s = dt C_n x^2, the slope of C_n x beta^2 is - C_n N^2 (3 s - b) / (b + s)^3,
  /// and steepest at s = b or where beta leaves its largest value B: 3 C_n B^2 for b = 0.
  [[nodiscard]] double steepest_fall(BondStep const& step) const {
    double const N = b * step.old.beta + step.dt * w, B = largest_beta(step);
    if (!(N > 0 && B > 0))
      return 0;
    double const s = std::max(b, N / B - b);
    return C_n * N * N * (3 * s - b) / std::pow(b + s, 3);
  }
};

/// Diagonal of the bond's stiffness in the contact frame, N/m^3.
template<int D> [[nodiscard]] Local<D> bond_stiffness(Rcc const& law) {
  Local<D> stiffness;
  stiffness[0] = law.C_n;
  if constexpr (D > 1)
    stiffness[1] = law.C_t;
  if constexpr (D > 2)
    stiffness[2] = law.C_t2;
  return stiffness;
}

/// Implicit Euler of (13): beta = clip((b beta_old + dt w) / (b + dt q)), unconditionally stable, b = 0
/// included.
[[nodiscard]] inline double next_beta(Rcc const& law, BondStep const& step, double q) {
  double const denominator = law.b + step.dt * q, numerator = law.b * step.old.beta + step.dt * law.w;
  double const beta =
      denominator > 0 ? std::clamp(numerator / denominator, 0.0, 1.0) : (numerator > 0 ? 1.0 : step.old.beta);
  return std::min(beta, law.largest_beta(step));
}

/// (19), (21): rtilde = - C x beta^2, with beta of the step's end.
template<int D> [[nodiscard]] Adhesion<D> adhere(Rcc const& law, BondStep const& step, Local<D> const& x) {
  Local<D> const d = opening<D>(x, step.old);
  Local<D> const stiffness = bond_stiffness<D>(law);
  Local<D> const Cd = stiffness.cwiseProduct(d);
  double const q = Cd.dot(d);
  Local<D> const d_by_x = opening_by_x<D>(x, step.old);

  Adhesion<D> result;
  result.beta = next_beta(law, step, q);
  double const free = law.b + step.dt * q;
  bool const evolves = free > 0 && result.beta > 0 && result.beta < 1 &&
                       std::abs(result.beta * free - (law.b * step.old.beta + step.dt * law.w)) <=
                           1e-12 * (law.b + step.dt * law.w);
  if (evolves)
    result.beta_by_x = (-2 * result.beta * step.dt / free) * Cd.cwiseProduct(d_by_x);
  double const beta2 = result.beta * result.beta;
  result.traction = -beta2 * Cd;
  result.traction_by_x = -2 * result.beta * Cd * result.beta_by_x.transpose();
  result.traction_by_x.diagonal() -= beta2 * stiffness.cwiseProduct(d_by_x);
  leave_friction(result, law.friction, law.damage_power);
  return result;
}

/// The bond after the step. (13) never takes all of it: torn, it is no bond to that place of the other side
/// any more, and the point may bond to another one.
template<int D> [[nodiscard]] Bond advance(Rcc const& law, BondStep const& step, Local<D> const& x) {
  auto next = stretched<D>(adhere<D>(law, step, x).beta, step.old, x);
  if (law.tears(step, x[0], next.beta))
    next.stretch.setZero();
  return next;
}

/// psi of (9), J/m^2.
[[nodiscard]] inline double bond_energy(Rcc const& law, Bond const& bond, double x_n) {
  double const open = std::max(x_n, 0.0);
  double const along = law.C_t * std::pow(bond.stretch[0], 2) + law.C_t2 * std::pow(bond.stretch[1], 2);
  return 0.5 * bond.beta * bond.beta * (law.C_n * open * open + along) - law.w * bond.beta;
}

/// What a change of beta takes, J/m^2: b beta'^2 over the step, which is (w - q beta) times the change by
/// (13); of a bond that becomes whole the latter, of which b = 0 leaves all.
[[nodiscard]] inline double dissipation(Rcc const& law, BondMove const& move) {
  double const growth = move.beta_to - move.beta_from;
  if (move.beta_to < 1 || !(growth > 0))
    return law.b * growth * growth / move.dt;
  return (law.w - bond_stiffness<3>(law).cwiseProduct(move.to).dot(move.to)) * growth;
}

/// What implicit Euler of (13) loses beside the trapezium of the pull: with x the opening and q = x.Cx, work
/// - change of psi = C x1.(b1 x1 - (b0 + b1)/2 x0)(b1 - b0) + (w - q1 b1)(b1 - b0), of which the bond's own
/// is what its change takes; the rest of the last term is what the bounds of beta set free. J/m^2
[[nodiscard]] inline double integration_loss(Rcc const& law, BondMove const& move) {
  auto const &x0 = move.from, &x1 = move.to;
  double const b0 = move.beta_from, b1 = move.beta_to;
  Local<3> const pull = bond_stiffness<3>(law).cwiseProduct(x1);
  return (pull.dot(b1 * x1 - 0.5 * (b0 + b1) * x0) + law.w - pull.dot(x1) * b1) * (b1 - b0) -
         dissipation(law, move);
}

template<int D> [[nodiscard]] double dissipation(Rcc const& law, BondStep const& step, Local<D> const& x) {
  BondMove move;
  move.to.head<D>() = opening<D>(x, step.old);
  move.beta_from = step.old.beta;
  move.beta_to = adhere<D>(law, step, x).beta;
  move.dt = step.dt;
  return dissipation(law, move);
}

} // namespace stiction::interface
