// The exponential cohesive law of Xu and Needleman in mixed mode, as a potential or with damage that stays.
#pragma once
#include <array>
#include <numbers>

#include "core/schema.hpp"
#include "interface/bond.hpp"

namespace stiction::interface {

struct Exponential {
  double phi_n = 0;     ///< work of normal separation, J/m^2
  double sigma_max = 0; ///< normal strength, Pa
  double delta_t = 0;   ///< slip scale, m: the shear traction peaks at delta_t / sqrt 2
  double q = 1;         ///< work of tangential over that of normal separation
  double r = 0;         ///< normal opening over delta_n after complete shear without normal traction
  Memory memory = Memory::irreversible;
  double beta0 = 1;
  BondFriction friction = BondFriction::full;

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<Exponential>{"exponential", "exponential cohesive law of mixed mode",
                                    "Xu and Needleman 1994"}
            .number("phi_n", &Exponential::phi_n, "J/m^2", core::positive, Need::required,
                    "work of normal separation; delta_n = phi_n / (e sigma_max)")
            .number("sigma_max", &Exponential::sigma_max, "Pa", core::positive, Need::required,
                    "normal strength")
            .number("delta_t", &Exponential::delta_t, "m", core::positive, Need::required,
                    "slip scale; the shear traction peaks at delta_t / sqrt 2")
            .number("q", &Exponential::q, "1", {0, 100, false, false}, Need::optional,
                    "work of tangential over that of normal separation")
            .number("r", &Exponential::r, "1", {0, 1, false, true}, Need::optional,
                    "coupling of a reversible law with q not 1: normal opening over delta_n without normal "
                    "traction after complete shear")
            .only("memory = \"reversible\" and q is not 1",
                  [](Exponential const& law) { return !law.lasts() && law.q != 1; })
            .choice(
                "memory", &Exponential::memory, {"irreversible", "reversible"}, Need::optional,
                "damage with unloading to the origin, or the potential itself; with damage both tractions "
                "soften alike, so that opening and slip at once take less work than either: with q = 1 "
                "down to 0.68 phi_n, where opening / delta_n is 1.1 slip / delta_t")
            .number("beta0", &Exponential::beta0, "1", core::unit_interval, Need::optional,
                    "intact part at the start of an irreversible law, less where the surfaces are apart")
            .only("memory = \"irreversible\"", [](Exponential const& law) { return law.lasts(); })
            .choice("friction", &Exponential::friction, {"full", "damage"}, Need::optional,
                    "friction coefficient mu, or mu (1 - beta)")
            .build();
    return made;
  }
  [[nodiscard]] double delta_n() const { return phi_n / (std::numbers::e * sigma_max); }
  static constexpr bool evolves = false;
  [[nodiscard]] bool tangential() const { return q > 0 || friction == BondFriction::damage; }
  /// Where less than 1e-11 of the strength is left.
  [[nodiscard]] double range() const { return lasts() ? 0 : 30 * delta_n(); }
  [[nodiscard]] bool lasts() const { return memory == Memory::irreversible; }
  [[nodiscard]] Bond initial(double gap) const {
    if (!lasts() && gap > range())
      return {};
    double const u = std::min(std::max(gap, 0.0) / delta_n(), 700.0), left = std::exp(-u);
    return {lasts() ? (left < least_beta ? 0 : std::min(beta0, left)) : (1 + u) * left, {0, 0}};
  }
  [[nodiscard]] Scales scales() const {
    double const steepest = phi_n / (delta_n() * delta_n()) * std::exp(-2.0); // of u exp(-u), at u = 2
    return {phi_n, sigma_max, delta_n(), steepest, q > 0 ? delta_t / std::numbers::sqrt2 : 0};
  }
  /// Of K u exp(-u): at u = 2, or where the damage goes on that there is already.
  [[nodiscard]] double steepest_fall(BondStep const& step) const {
    if (!lasts())
      return scales().softening;
    if (!(step.old.beta > 0))
      return 0;
    double const u = std::max(2.0, -std::log(step.old.beta));
    return phi_n / (delta_n() * delta_n()) * (u - 1) * std::exp(-u);
  }
};

/// Without damage: slopes of the potential at the origin, N/m^3.
template<int D> [[nodiscard]] Local<D> initial_stiffness(Exponential const& law) {
  Local<D> K = Local<D>::Constant(2 * law.q * law.phi_n / (law.delta_t * law.delta_t));
  K[0] = law.phi_n / (law.delta_n() * law.delta_n());
  return K;
}

/// Opening in the scales of the law: u = d_n / delta_n, v = |d_t|^2 / delta_t^2.
struct ScaledOpening {
  double u = 0, v = 0;
};
template<int D> [[nodiscard]] ScaledOpening scaled(Exponential const& law, Local<D> const& d) {
  return {d[0] / law.delta_n(), d.template tail<D - 1>().squaredNorm() / (law.delta_t * law.delta_t)};
}

/// exp(-u - v): in pure modes the secant of the potential; in mixed mode both tractions soften alike, so that
/// energy is never gained.
template<int D> [[nodiscard]] Secant<D> secant(Exponential const& law, Local<D> const& d) {
  auto const [u, v] = scaled<D>(law, d);
  double const value = std::exp(-u - v);
  Local<D> by_d = -2 * value / (law.delta_t * law.delta_t) * d;
  by_d[0] = -value / law.delta_n();
  return {value, by_d};
}

/// The potential over phi_n, 0 at rest: phi = 1 + e^-u ((1 - r + u) A - (q + C u) e^-v).
[[nodiscard]] inline double potential_part(Exponential const& law, ScaledOpening const& at) {
  double const A = (1 - law.q) / (law.r - 1), C = (law.r - law.q) / (law.r - 1);
  return 1 + std::exp(-at.u) * ((1 - law.r + at.u) * A - (law.q + C * at.u) * std::exp(-at.v));
}

/// rtilde = - dphi/dd of the potential and its derivative.
template<int D>
[[nodiscard]] Adhesion<D> potential_traction(Exponential const& law, BondStep const& step,
                                             Local<D> const& x) {
  Local<D> const d = opening<D>(x, step.old), d_by_x = opening_by_x<D>(x, step.old);
  auto const [u, v] = scaled<D>(law, d);
  double const A = (1 - law.q) / (law.r - 1), C = (law.r - law.q) / (law.r - 1), r_A = law.r * A;
  double const eu = law.phi_n * std::exp(-u), ev = std::exp(-v), n = 1 / law.delta_n();
  double const t = 2 / (law.delta_t * law.delta_t);
  auto const dt = d.template tail<D - 1>();
  Adhesion<D> result;
  result.traction[0] = -eu * n * (A * (law.r - u) + (C * u - r_A) * ev);
  result.traction.template tail<D - 1>() = -eu * ev * (law.q + C * u) * t * dt;
  LocalMatrix<D> by_d;
  by_d(0, 0) = eu * n * n * (A * (law.r - u) + (C * u - r_A) * ev + A - C * ev);
  by_d.template block<1, D - 1>(0, 1) = eu * n * (C * u - r_A) * ev * t * dt.transpose();
  by_d.template block<D - 1, 1>(1, 0) = by_d.template block<1, D - 1>(0, 1).transpose();
  by_d.template bottomRightCorner<D - 1, D - 1>() =
      -eu * ev * (law.q + C * u) * t * (LocalMatrix<D - 1>::Identity() - t * dt * dt.transpose());
  result.traction_by_x = by_d * d_by_x.asDiagonal();
  result.beta = std::max((1 + u) * std::exp(-u - v), 1e-300); // in reach the origin of the stretch is kept
  result.beta_by_x.template tail<D - 1>() = -result.beta * t * dt;
  result.beta_by_x[0] = -u * std::exp(-u - v) * n;
  result.beta_by_x = result.beta_by_x.cwiseProduct(d_by_x).eval();
  return result;
}

template<int D>
[[nodiscard]] Adhesion<D> adhere(Exponential const& law, BondStep const& step, Local<D> const& x) {
  auto result = law.lasts()
                    ? damaged<D>(initial_stiffness<D>(law), secant<D>(law, opening<D>(x, step.old)), step, x)
                    : potential_traction<D>(law, step, x);
  leave_friction(result, law.friction, 1);
  return result;
}

/// Out of its range a potential forgets where the point was.
template<int D> [[nodiscard]] Bond advance(Exponential const& law, BondStep const& step, Local<D> const& x) {
  if (!law.lasts() && x[0] > law.range())
    return {};
  return stretched<D>(adhere<D>(law, step, x).beta, step.old, x);
}

/// Zero where nothing is left, J/m^2: of damage what unloading gives back, of the potential phi - phi_n.
[[nodiscard]] inline double bond_energy(Exponential const& law, Bond const& bond, double x_n) {
  Local<3> const d = opening_of(bond, x_n);
  if (law.lasts())
    return 0.5 * bond.beta * initial_stiffness<3>(law).dot(d.cwiseProduct(d));
  return bond.beta > 0 ? law.phi_n * (potential_part(law, scaled<3>(law, d)) - 1) : 0;
}

/// int of (K_n d_n^2 + K_t d_t^2) / 2 over the loss of beta along the ray to the opening of the step's end,
/// where u goes with the part y on the ray and v with y^2; Gauss' rule of five points for each unit of -ln
/// beta.
template<int D>
[[nodiscard]] double dissipation(Exponential const& law, BondStep const& step, Local<D> const& x) {
  static constexpr std::array<double, 5> points{0.046910077030668, 0.230765344947158, 0.5, 0.769234655052842,
                                                0.953089922969332};
  static constexpr std::array<double, 5> weights{0.118463442528095, 0.239314335249683, 0.284444444444444,
                                                 0.239314335249683, 0.118463442528095};
  double const beta = law.lasts() ? adhere<D>(law, step, x).beta : step.old.beta;
  if (beta >= step.old.beta)
    return 0;
  Local<D> const d = opening<D>(x, step.old);
  auto const [u, v] = scaled<D>(law, d);
  double const first = -std::log(step.old.beta);
  double const way = (beta > 0 ? -std::log(beta) : std::min(u + v, first - std::log(least_beta))) - first;
  int const panels = std::max(1, static_cast<int>(std::ceil(way)));
  double const width = way / panels;
  double sum = 0;
  for (int panel = 0; panel < panels; ++panel)
    for (std::size_t k = 0; k < points.size(); ++k) {
      double const level = first + (panel + points[k]) * width; // = y u + y^2 v
      if (level <= 0)                                           // beta rounds to 1, and v may be all there is
        continue;
      double const y = 2 * level / (u + std::sqrt(u * u + 4 * v * level));
      sum += weights[k] * y * y * std::exp(-level);
    }
  return sum * width * 0.5 * initial_stiffness<D>(law).dot(d.cwiseProduct(d));
}

} // namespace stiction::interface
