// Ogden rubber: a sum of powers of the principal stretches.
#pragma once
#include <fmt/format.h>

#include "core/error.hpp"
#include "core/schema.hpp"
#include "material/principal.hpp"

namespace stiction::material {

/// W = sum_p mu_p/alpha_p (l1^alpha_p + l2^alpha_p + l3^alpha_p - 3) + K/2 (J - 1)^2, l_i = J^-1/3 lambda_i;
/// shear modulus at rest sum_p mu_p alpha_p / 2.
struct Ogden {
  core::Numbers mu;        ///< Pa
  core::Numbers alpha;     ///< 1, as many
  double bulk_modulus = 0; ///< Pa
  static constexpr bool small_strain = false;
  static constexpr bool linear = false;
  static constexpr std::size_t most_terms = 6;

  /// e: logarithms of the stretches.
  template<int N, Wanted wanted> [[nodiscard]] PrincipalEnergy of_stretches(Eigen::Vector3d const& e) const {
    double const K = bulk_modulus, J = std::exp(e.sum());
    Eigen::Vector3d const h = e.array() - e.mean();
    PrincipalEnergy W;
    W.energy = K / 2 * (J - 1) * (J - 1);
    W.kirchhoff.setConstant(K * J * (J - 1));
    W.tangent.setConstant(K * J * (2 * J - 1));
    W.gaps.setZero();
    for (std::size_t p = 0; p < mu.size(); ++p) {
      Eigen::Vector3d const x = mu[p] * (alpha[p] * h).array().exp();
      W.energy += (x.sum() - 3 * mu[p]) / alpha[p];
      W.kirchhoff.array() += x.array() - x.mean();
      if constexpr (wanted == Wanted::tangent)
        add_term<N>(alpha[p], x, e, W);
    }
    return W;
  }
  template<int N, Wanted wanted = Wanted::tangent>
  [[nodiscard]] Response<N> respond(Voigt<N> const& strain) const {
    return of_principal<N, wanted>(*this, strain);
  }
  [[nodiscard]] double shear() const {
    double twice = 0;
    for (std::size_t p = 0; p < mu.size(); ++p)
      twice += mu[p] * alpha[p];
    return twice / 2;
  }
  [[nodiscard]] Moduli moduli() const { return Moduli::from(shear(), bulk_modulus); }

  [[nodiscard]] core::Complaints check() const {
    if (mu.empty() || mu.size() > most_terms)
      return {{"", "mu", fmt::format("has {} numbers; 1 to {} are wanted", mu.size(), most_terms)}};
    if (alpha.size() != mu.size())
      return {
          {"", "alpha",
           fmt::format("has {} numbers and mu has {}; give one alpha for each mu", alpha.size(), mu.size())}};
    for (std::size_t p = 0; p < alpha.size(); ++p)
      if (alpha[p] == 0)
        return {{"", fmt::format("alpha[{}]", p + 1), "is 0; it must not be 0: drop it and its mu"}};
    if (shear() > 0)
      return {};
    return {{"", "mu",
             fmt::format(
                 "gives with alpha a shear modulus at rest, sum of mu alpha / 2, of {:g} Pa; it must be > 0 "
                 "Pa: as a rule each mu has the sign of its alpha",
                 shear())}};
  }
  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<Ogden>{
            "ogden",
            "rubber, W = sum of mu/alpha (l1^alpha + l2^alpha + l3^alpha - 3) + K/2 (J - 1)^2, "
            "l = J^-1/3 lambda",
            "Ogden 1972"}
            .numbers("mu", &Ogden::mu, "Pa", Need::required,
                     "factors, 1 to 6; the shear modulus at rest is sum of mu alpha / 2 > 0")
            .numbers("alpha", &Ogden::alpha, "1", Need::required, "exponents, one for each mu, not 0")
            .number("bulk_modulus", &Ogden::bulk_modulus, "Pa", core::positive, Need::required,
                    "bulk modulus K")
            .build();
    return made;
  }

private:
  /// Derivatives of one term; x = mu l^alpha.
  template<int N>
  static void add_term(double alpha, Eigen::Vector3d const& x, Eigen::Vector3d const& e, PrincipalEnergy& W) {
    Eigen::Vector3d const y = alpha / 3 * x;
    W.tangent.colwise() -= y;
    W.tangent.rowwise() -= y.transpose();
    W.tangent.array() += y.mean();
    W.tangent.diagonal() += 3 * y;
    for (std::size_t k = 0; k < N - 3; ++k) {
      auto const [i, j] = pairs[k];
      W.gaps[static_cast<int>(k)] += x[i] * std::expm1(alpha * (e[j] - e[i]));
    }
  }
};

} // namespace stiction::material
