// The only place where laws are told apart: kinematics and assembly are compiled once for all of them.
#include "solid/responses.hpp"

#include "core/types.hpp"

namespace stiction::solid {

bool small_strain(material::Material const& law) {
  return std::visit([](auto const& l) { return std::decay_t<decltype(l)>::small_strain; }, law);
}

template<int N>
void respond(material::Material const& law, material::Wanted wanted,
             std::span<material::Voigt<N, Pack> const> strains,
             std::span<material::Response<N, Pack>> responses) {
  using material::Wanted;
  std::visit(
      [&](auto const& l) {
        for (std::size_t k = 0; k < strains.size(); ++k)
          if (wanted == Wanted::stress)
            responses[k] = respond_in_lanes<N, Wanted::stress>(l, strains[k]);
          else
            responses[k] = respond_in_lanes<N, Wanted::tangent>(l, strains[k]);
      },
      law);
}

template void respond<4>(material::Material const&, material::Wanted,
                         std::span<material::Voigt<4, Pack> const>, std::span<material::Response<4, Pack>>);
template void respond<6>(material::Material const&, material::Wanted,
                         std::span<material::Voigt<6, Pack> const>, std::span<material::Response<6, Pack>>);

} // namespace stiction::solid
