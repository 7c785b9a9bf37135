// Arruda-Boyce eight-chain rubber, stiffening as its chains approach their limit.
#pragma once
#include "core/schema.hpp"
#include "material/isochoric.hpp"

namespace stiction::material {

/// W = mu sum_i c_i m^(1-i) (I1'^i - 3^i) + K/2 (J - 1)^2, i = 1..5, m = lambda_m^2: five terms of the
/// inverse Langevin function (Arruda and Boyce 1993, eq. 26). It stays finite beyond the limit of the chains,
/// I1' = 3 m, but is far too soft there. `shear_modulus` is that at rest, from which mu follows.
struct ArrudaBoyce {
  double shear_modulus = 0; ///< Pa
  double lambda_m = 1;      ///< 1
  double bulk_modulus = 0;  ///< Pa
  static constexpr bool small_strain = false;
  static constexpr bool linear = false;

  /// Value / mu, and first and second derivative by I1', of the series.
  template<class S> [[nodiscard]] std::array<S, 3> series(S const& I1) const {
    static constexpr std::array<double, 5> c{1.0 / 2, 1.0 / 20, 11.0 / 1050, 19.0 / 7000, 519.0 / 673750};
    double const r = 1 / (lambda_m * lambda_m);
    S const a = I1 * r; // sum of c_i (a^i - b^i) / r
    S value = 0, slope = 0, bend = 0;
    double const b = 3 * r;
    double rest = 0;
    for (std::size_t i = c.size(); i-- > 0;) {
      bend = bend * a + 2 * slope;
      slope = slope * a + value;
      value = value * a + c[i];
      rest = rest * b + c[i];
    }
    // value = sum c_i a^(i-1), and so on: one factor a is still missing
    return {value * I1 - 3 * rest, value + a * slope, r * (2 * slope + a * bend)};
  }
  [[nodiscard]] double rubbery() const { return shear_modulus / (2 * series(3.0)[1]); } ///< mu
  template<class S> [[nodiscard]] Distortion<S> distortion(S const& I1, S const& /*I2*/) const {
    double const mu = rubbery();
    auto const [value, slope, bend] = series(I1);
    return {mu * value, mu * slope, 0, mu * bend};
  }
  [[nodiscard]] double bulk() const { return bulk_modulus; }
  template<int N, Wanted wanted = Wanted::tangent, class S>
  [[nodiscard]] Response<N, S> respond(Voigt<N, S> const& strain) const {
    return isochoric<N, wanted>(*this, strain);
  }
  [[nodiscard]] Moduli moduli() const { return Moduli::from(shear_modulus, bulk_modulus); }

  static core::Schema const& schema() {
    using core::Need;
    using Self = ArrudaBoyce;
    static auto const made =
        core::Describe<Self>{"arruda_boyce",
                             "rubber of eight chains, five terms of the inverse Langevin function",
                             "Arruda and Boyce 1993"}
            .number("shear_modulus", &Self::shear_modulus, "Pa", core::positive, Need::required,
                    "shear modulus G at rest (not mu = n k T)")
            .number("lambda_m", &Self::lambda_m, "1", {1, core::any_number.high, true, false}, Need::required,
                    "stretch at which the chains lock, sqrt(N) of N links")
            .number("bulk_modulus", &Self::bulk_modulus, "Pa", core::positive, Need::required,
                    "bulk modulus K")
            .build();
    return made;
  }
};

} // namespace stiction::material
