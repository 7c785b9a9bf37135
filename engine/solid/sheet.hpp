// Plane stress: the strain across a sheet that leaves no stress there, and what is left of the tangent.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "solid/responses.hpp"

namespace stiction::solid {

inline constexpr int most_points = 27; ///< of quadrature, in a cell

/// Fills strains[k][2], E_33, so that S_33 = 0 at every point, by Newton's method; 1 in the lanes where it
/// was found, else 0. It starts where a law of this Poisson's ratio at rest would be: C_33 = det(C)^(-nu / (1
/// - nu)) of the plane, exact at nu = 1/2. Takes ln(C_33) by at most 1 at a time, so that C_33 stays > 0.
class AcrossSheet {
public:
  using Voigt = material::Voigt<4, Pack>;
  using Response = material::Response<4, Pack>;

  AcrossSheet(material::Material const& law, bool finite) : law_(law), finite_(finite) {
    double const nu = material::moduli(law).poisson;
    exponent_ = -nu / (1 - nu);
  }

  [[nodiscard]] Pack solve(std::span<Voigt> strains, std::span<Response> responses) const {
    for (Voigt& strain : strains)
      strain[2] = first(strain);
    std::array<Pack, most_points> settled; // a lane's answer is its own, whatever the others take
    settled.fill(0);
    Pack found = 0;
    for (int k = 0; k < most_changes && !all(found); ++k) {
      respond<4>(law_, material::Wanted::tangent, strains, responses);
      found = 1;
      for (std::size_t q = 0; q < strains.size(); ++q) {
        change(strains[q], responses[q], settled[q]);
        found = where_positive(settled[q], found);
      }
    }
    return found;
  }

  /// Takes the component across out of stress and tangent: dS = (D - D_3 D_3^T / D_33) dE at S_33 = 0.
  static void condense(material::Wanted wanted, std::span<Response> responses) {
    for (Response& response : responses) {
      response.stress[2] = 0;
      if (wanted == material::Wanted::stress)
        continue;
      Voigt const across = response.tangent.col(2);
      response.tangent -= across * across.transpose() / across[2];
      response.tangent.col(2).setZero();
      response.tangent.row(2).setZero();
    }
  }

private:
  static constexpr int most_changes = 60;
  static constexpr double near = 1e-9; ///< the last change of ln(C_33), which leaves its square

  [[nodiscard]] static bool all(Pack const& flags) {
    return flags[0] > 0 && flags[1] > 0 && flags[2] > 0 && flags[3] > 0;
  }
  [[nodiscard]] Pack first(Voigt const& E) const {
    if (!finite_)
      return exponent_ * (E[0] + E[1]);
    Pack const plane = (1 + 2 * E[0]) * (1 + 2 * E[1]) - E[3] * E[3];
    return 0.5 * (pow(plane, exponent_) - 1);
  }
  /// Changes E_33 towards S_33 = 0 in lanes that are not settled; 1 there where that was the last time.
  void change(Voigt& strain, Response const& response, Pack& settled) const {
    for (int lane = 0; lane < Pack::lanes; ++lane) {
      if (settled[lane] > 0)
        continue;
      double const C = finite_ ? 1 + 2 * strain[2][lane] : 1, S = response.stress[2][lane],
                   D = response.tangent(2, 2)[lane];
      double const by_log = D > 0 ? -2 * S / (D * C) : (S > 0 ? -1 : 1); // of ln C_33
      strain[2].set(lane, finite_ ? 0.5 * (C * std::exp(std::clamp(by_log, -1.0, 1.0)) - 1)
                                  : strain[2][lane] + 0.5 * by_log);
      settled.set(lane, std::abs(by_log) < near && D > 0 ? 1 : 0);
    }
  }

  material::Material const& law_;
  bool finite_;
  double exponent_ = 0;
};

} // namespace stiction::solid
