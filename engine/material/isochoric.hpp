// Laws of the distortion F / J^1/3 with the volume change split off: W(I1', I2') + K/2 (J - 1)^2.
#pragma once
#include "material/isotropic.hpp"

namespace stiction::material {

/// Energy of the distortion, linear in I2', and its derivatives by I1' = I3^-1/3 I1 and I2' = I3^-2/3 I2.
template<class S> struct Distortion { S energy = 0, by1 = 0, by2 = 0, by11 = 0; };

/// A law that offers `Distortion<S> distortion(I1', I2')` and `double bulk()`, as energy of I1, I2, I3.
template<class Law> struct OfDistortion {
  Law const& law;

  template<class S>
  [[nodiscard]] InvariantEnergy<S> of_invariants(S const& I1, S const& I2, S const& I3) const {
    using std::pow, std::sqrt;
    double const K = law.bulk();
    S const J = sqrt(I3), r = 1 / I3, p = pow(I3, -1.0 / 3);
    S const first = p * I1, second = p * p * I2; // I1', I2'
    auto const [energy, by1, by2, by11] = law.distortion(first, second);
    S const by11_first = by11 * first, by2_pp = by2 * p * p;
    InvariantEnergy<S> W;
    W.energy = energy + K / 2 * (J - 1) * (J - 1);
    W.first = {by1 * p, by2_pp, -r / 3 * (by1 * first + 2 * by2 * second) + K / 2 * (1 - J * r)};
    W.second[0] = by11 * p * p;
    W.second[2] = r * r * ((first * (4 * by1 + by11_first) + 10 * by2 * second) / 9 + K / 4 * J);
    W.second[4] = -r / 3 * p * (by1 + by11_first);
    W.second[5] = -2 * r / 3 * by2_pp;
    return W;
  }
};

template<int N, Wanted wanted, class Law, class S>
[[nodiscard]] Response<N, S> isochoric(Law const& law, Voigt<N, S> const& strain) {
  return isotropic<N, wanted>(OfDistortion<Law>{law}, strain);
}

} // namespace stiction::material
