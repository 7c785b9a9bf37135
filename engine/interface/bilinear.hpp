// The bilinear cohesive zone of mixed mode: linear up to the strength, then linear down, with damage that
// stays.
#pragma once
#include <array>
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/schema.hpp"
#include "interface/bond.hpp"

namespace stiction::interface {

/// How the energies of the two modes mix.
enum class ModeMix { benzeggagh_kenane, linear };

struct Bilinear {
  double K = 0;                    ///< initial stiffness in both directions, N/m^3
  double sigma_n = 0, sigma_t = 0; ///< strengths, Pa
  double G_I = 0, G_II = 0;        ///< work of separation, J/m^2
  ModeMix mix = ModeMix::benzeggagh_kenane;
  double exponent = 2; ///< of Benzeggagh and Kenane, 1
  double beta0 = 1;
  BondFriction friction = BondFriction::full;

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<Bilinear>{"bilinear", "bilinear cohesive zone of mixed mode, damage 1 - beta stays",
                                 "Camanho and Davila 2002; Turon 2006; Benzeggagh and Kenane 1996"}
            .number("K", &Bilinear::K, "N/m^3", core::positive, Need::required, "stiffness without damage")
            .number("sigma_n", &Bilinear::sigma_n, "Pa", core::positive, Need::required, "normal strength")
            .number("sigma_t", &Bilinear::sigma_t, "Pa", core::positive, Need::required, "shear strength")
            .number("G_I", &Bilinear::G_I, "J/m^2", core::positive, Need::required,
                    "work of separation in mode I; more than sigma_n^2 / 2K")
            .number("G_II", &Bilinear::G_II, "J/m^2", core::positive, Need::required,
                    "work of separation in mode II; more than sigma_t^2 / 2K")
            .choice("mix", &Bilinear::mix, {"benzeggagh_kenane", "linear"}, Need::optional,
                    "G_I + (G_II - G_I) B^exponent, or 1 = (1 - B) G/G_I + B G/G_II; B: share of shear")
            .number("exponent", &Bilinear::exponent, "1", {1, 10, false, false}, Need::optional,
                    "exponent of mix = \"benzeggagh_kenane\"")
            .only("mix = \"benzeggagh_kenane\"",
                  [](Bilinear const& law) { return law.mix == ModeMix::benzeggagh_kenane; })
            .number("beta0", &Bilinear::beta0, "1", core::unit_interval, Need::optional,
                    "intact part at the start, less where the surfaces are apart")
            .choice("friction", &Bilinear::friction, {"full", "damage"}, Need::optional,
                    "friction coefficient mu, or mu (1 - beta)")
            .build();
    return made;
  }
  [[nodiscard]] core::Complaints check() const;
  static constexpr bool evolves = false;
  [[nodiscard]] static bool tangential() { return true; }
  [[nodiscard]] static double range() { return 0; }
  [[nodiscard]] static bool lasts() { return true; }
  [[nodiscard]] Bond initial(double gap) const;
  [[nodiscard]] Scales scales() const {
    return {G_I, sigma_n, sigma_n / K, sigma_n / (2 * G_I / sigma_n - sigma_n / K), sigma_t / K};
  }
  /// The falling branch is straight, whatever damage it starts from.
  [[nodiscard]] double steepest_fall(BondStep const& step) const {
    return step.old.beta > 0 ? scales().softening : 0;
  }
};

/// Openings at which damage begins and ends, and their derivatives by the share of shear B.
struct BilinearMode {
  double start = 0, end = 0, start_by_B = 0, end_by_B = 0; ///< m
};

/// Quadratic onset (T_n/sigma_n)^2 + (T_t/sigma_t)^2 = 1; the end from the work G(B).
[[nodiscard]] inline BilinearMode mode_of(Bilinear const& law, double B) {
  double const first_n = law.sigma_n / law.K, first_t = law.sigma_t / law.K;
  double const in_n = 1 / (first_n * first_n), in_t = 1 / (first_t * first_t);
  double const start = 1 / std::sqrt((1 - B) * in_n + B * in_t);
  double G = 0, G_by_B = 0;
  if (law.mix == ModeMix::linear) {
    G = 1 / ((1 - B) / law.G_I + B / law.G_II);
    G_by_B = -G * G * (1 / law.G_II - 1 / law.G_I);
  } else {
    G = law.G_I + (law.G_II - law.G_I) * std::pow(B, law.exponent);
    G_by_B = (law.G_II - law.G_I) * law.exponent * std::pow(B, law.exponent - 1);
  }
  BilinearMode mode;
  mode.start = start;
  mode.end = 2 * G / (law.K * start);
  mode.start_by_B = -0.5 * start * start * start * (in_t - in_n);
  mode.end_by_B = mode.end * (G_by_B / G - mode.start_by_B / start);
  return mode;
}

/// The work must be more than what is stored when damage begins, whatever the mode.
inline core::Complaints Bilinear::check() const {
  for (int k = 0; k <= 100; ++k) {
    double const B = 0.01 * k;
    auto const mode = mode_of(*this, B);
    if (mode.end > mode.start * (1 + 1e-12))
      continue;
    char const* key = B < 0.5 ? "G_I" : "G_II";
    return {{"", key,
             fmt::format("is too small: at a share of shear of {:g} the work of separation is {:.4g} J/m^2, "
                         "less than the {:.4g} J/m^2 stored at the strength; raise it or K, or lower the "
                         "strengths",
                         B, 0.5 * K * mode.start * mode.end, 0.5 * K * mode.start * mode.start)}};
  }
  return {};
}

/// Share of shear in |d|^2; d must not be zero.
template<int D> [[nodiscard]] double shear_share(Local<D> const& d) {
  return d.template tail<D - 1>().squaredNorm() / d.squaredNorm();
}

/// beta = start (end/l - 1) / (end - start) at the opening l = |d| between start and end.
template<int D> [[nodiscard]] Secant<D> secant(Bilinear const& law, Local<D> const& d) {
  double const l = d.norm();
  if (l == 0)
    return {};
  double const B = shear_share<D>(d);
  auto const mode = mode_of(law, B);
  if (l <= mode.start)
    return {};
  if (l >= mode.end)
    return {0, Local<D>::Zero()};
  double const width = mode.end - mode.start, left = mode.end / l - 1;
  double const by_l = -mode.start * mode.end / (l * l * width);
  double const by_start = left * mode.end / (width * width);
  double const by_end = mode.start * (1 - mode.start / l) / (width * width);
  Local<D> B_by_d = -B * d;
  B_by_d.template tail<D - 1>() += d.template tail<D - 1>();
  Local<D> const by_d =
      by_l / l * d + (by_start * mode.start_by_B + by_end * mode.end_by_B) * 2 / (l * l) * B_by_d;
  return {mode.start * left / width, by_d};
}

template<int D>
[[nodiscard]] Adhesion<D> adhere(Bilinear const& law, BondStep const& step, Local<D> const& x) {
  auto result = damaged<D>(Local<D>::Constant(law.K), secant<D>(law, opening<D>(x, step.old)), step, x);
  leave_friction(result, law.friction, 1);
  return result;
}

template<int D> [[nodiscard]] Bond advance(Bilinear const& law, BondStep const& step, Local<D> const& x) {
  return stretched<D>(adhere<D>(law, step, x).beta, step.old, x);
}

inline Bond Bilinear::initial(double gap) const {
  return {std::min(beta0, secant<1>(*this, Local<1>(std::max(gap, 0.0))).value), {0, 0}};
}

[[nodiscard]] inline double bond_energy(Bilinear const& law, Bond const& bond, double x_n) {
  return 0.5 * bond.beta * law.K * opening_of(bond, x_n).squaredNorm();
}

/// What damage takes as it grows in the mode of the step's end, J/m^2: int of K l^2 / 2 over the damage.
template<int D>
[[nodiscard]] double dissipation(Bilinear const& law, BondStep const& step, Local<D> const& x) {
  double const beta = adhere<D>(law, step, x).beta;
  if (beta >= step.old.beta)
    return 0;
  auto const mode = mode_of(law, shear_share<D>(opening<D>(x, step.old)));
  auto const taken = [&](double damage) {
    double const largest = mode.start * mode.end / (mode.end - damage * (mode.end - mode.start));
    return 0.5 * law.K * mode.start * largest * damage;
  };
  return taken(1 - beta) - taken(1 - step.old.beta);
}

} // namespace stiction::interface
