// The only place where laws are told apart: kinematics and assembly are compiled once for all of them.
#include "solid/responses.hpp"

#include "core/types.hpp"

namespace stiction::solid {

bool small_strain(material::Material const& law) {
  return std::visit([](auto const& l) { return std::decay_t<decltype(l)>::small_strain; }, law);
}

template<int N>
void respond(material::Material const& law, material::Wanted wanted,
             std::span<material::Voigt<N> const> strains, std::span<material::Response<N>> responses) {
  using material::Wanted;
  std::visit(
      [&](auto const& l) {
        for (std::size_t k = 0; k < strains.size(); ++k)
          if (wanted == Wanted::stress)
            responses[k] = l.template respond<N, Wanted::stress>(strains[k]);
          else
            responses[k] = l.template respond<N, Wanted::tangent>(strains[k]);
      },
      law);
}

template void respond<4>(material::Material const&, material::Wanted, std::span<material::Voigt<4> const>,
                         std::span<material::Response<4>>);
template void respond<6>(material::Material const&, material::Wanted, std::span<material::Voigt<6> const>,
                         std::span<material::Response<6>>);

} // namespace stiction::solid
