// The law's answers at all points of a cell in one call.
#pragma once
#include <span>

#include "material/material.hpp"

namespace stiction::solid {

/// Whether the law is one of small strains, whose geometry stays that of the reference.
[[nodiscard]] bool small_strain(material::Material const& law);

/// responses[k] of strains[k]; N = 4 or 6. The tangents are filled where `wanted` says so.
template<int N>
void respond(material::Material const& law, material::Wanted wanted,
             std::span<material::Voigt<N> const> strains, std::span<material::Response<N>> responses);

} // namespace stiction::solid
