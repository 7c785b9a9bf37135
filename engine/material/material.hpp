// The list of bulk laws: a new one is one header and one word here.
#pragma once
#include <variant>

#include "material/arruda_boyce.hpp"
#include "material/blatz_ko.hpp"
#include "material/linear_elastic.hpp"
#include "material/mooney_rivlin.hpp"
#include "material/neo_hookean.hpp"
#include "material/ogden.hpp"
#include "material/owed.hpp"
#include "material/st_venant_kirchhoff.hpp"
#include "material/yeoh.hpp"

namespace stiction::material {

using Material = std::variant<LinearElastic, StVenantKirchhoff, NeoHookean, BlatzKo, MooneyRivlin, Yeoh,
                              ArrudaBoyce, Ogden>;
static_assert(core::every<Material, owed::OfBulkLaw>);

[[nodiscard]] inline Moduli moduli(Material const& material) {
  return std::visit([](auto const& law) { return law.moduli(); }, material);
}
/// Are the law's forces linear in the displacement?
[[nodiscard]] inline bool linear(Material const& material) {
  return std::visit([](auto const& law) { return law.linear; }, material);
}

} // namespace stiction::material
