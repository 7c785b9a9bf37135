// The law's answers at all points of four cells in one call.
#pragma once
#include <span>

#include "core/pack.hpp"
#include "material/material.hpp"

namespace stiction::solid {

/// Whether the law is one of small strains, whose geometry stays that of the reference.
[[nodiscard]] bool small_strain(material::Material const& law);

/// The law's answer in every lane: at once where it is written for any kind of number, else one by one.
template<int N, material::Wanted wanted, class Law>
[[nodiscard]] material::Response<N, Pack> respond_in_lanes(Law const& law,
                                                           material::Voigt<N, Pack> const& strain) {
  using material::Response, material::Voigt;
  if constexpr (requires {
                  { law.template respond<N, wanted>(strain) } -> std::same_as<Response<N, Pack>>;
                })
    return law.template respond<N, wanted>(strain);
  Response<N, Pack> all;
  for (int lane = 0; lane < Pack::lanes; ++lane) {
    auto const of_lane = [lane](Pack const& x) { return x[lane]; };
    Voigt<N> const own = strain.unaryExpr(of_lane);
    auto const one = law.template respond<N, wanted>(own);
    all.energy.set(lane, one.energy);
    for (int i = 0; i < N; ++i)
      all.stress[i].set(lane, one.stress[i]);
    for (int k = 0; wanted == material::Wanted::tangent && k < N * N; ++k)
      all.tangent(k).set(lane, one.tangent(k));
  }
  return all;
}

/// responses[k] of strains[k]; N = 4 or 6. The tangents are filled where `wanted` says so.
template<int N>
void respond(material::Material const& law, material::Wanted wanted,
             std::span<material::Voigt<N, Pack> const> strains,
             std::span<material::Response<N, Pack>> responses);

} // namespace stiction::solid
