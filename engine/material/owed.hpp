// What a bulk law owes.
#pragma once
#include "core/owed.hpp"
#include "material/response.hpp"

namespace stiction::material::owed {

template<class Law>
concept Geometry = requires {
  typename std::bool_constant<Law::small_strain>;
};

template<class Law>
concept Linearity = requires {
  typename std::bool_constant<Law::linear>;
  requires !Law::linear || Law::small_strain;
};

template<class Law, int N, Wanted wanted>
concept Responds = requires(Law const& law, Voigt<N> const& strain) {
  { law.template respond<N, wanted>(strain) } -> std::same_as<Response<N>>;
};
template<class Law>
concept Answers = Responds<Law, 4, Wanted::stress> && Responds<Law, 4, Wanted::tangent> &&
    Responds<Law, 6, Wanted::stress> && Responds<Law, 6, Wanted::tangent>;

template<class Law>
concept Rest = requires(Law const& law) {
  { law.moduli() } -> std::same_as<Moduli>;
};

/// It may have besides, as all that is read by a schema: `check()` and `read_nested()` (core/reader.hpp).
template<class Law>
concept BulkLaw = core::Described<Law> && Geometry<Law> && Linearity<Law> && Answers<Law> && Rest<Law>;

template<class Law> struct OfBulkLaw {
  static_assert(core::Described<Law>,
                "a bulk law lacks `static core::Schema const& schema()`: its name, meaning and parameters");
  static_assert(Geometry<Law>,
                "a bulk law lacks `static constexpr bool small_strain`: is its strain sym(F) - I at the "
                "geometry of the reference, and not Green's?");
  static_assert(Linearity<Law>,
                "a bulk law lacks `static constexpr bool linear`: are its forces linear in the displacement, "
                "as those of small strains alone can be?");
  static_assert(Answers<Law>, "a bulk law lacks `template<int N, Wanted> Response<N> respond(Voigt<N> const& "
                              "strain) const`: energy, stress and tangent, for N = 4 and 6");
  static_assert(Rest<Law>, "a bulk law lacks `Moduli moduli() const`: Young's modulus and Poisson's ratio of "
                           "its tangent at rest");
  static constexpr bool given = BulkLaw<Law>;
};

} // namespace stiction::material::owed
