// The quadratic energy shared by linear elasticity and St Venant-Kirchhoff.
#pragma once
#include "material/response.hpp"

namespace stiction::material {

/// W = lambda/2 tr(E)^2 + G E:E.
template<int N, class S> [[nodiscard]] Response<N, S> hooke(Moduli const& moduli, Voigt<N, S> const& strain) {
  Response<N, S> response;
  double const G = moduli.shear();
  response.tangent.setZero();
  response.tangent.template topLeftCorner<3, 3>().setConstant(moduli.lame());
  for (int i = 0; i < N; ++i)
    response.tangent(i, i) += i < 3 ? 2 * G : G;
  response.stress.noalias() = response.tangent * strain;
  response.energy = 0.5 * response.stress.dot(strain);
  return response;
}

} // namespace stiction::material
