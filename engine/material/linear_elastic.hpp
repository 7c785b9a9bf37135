// Linear elasticity of small strains: the strain is sym(F) - I and geometry stays that of the reference.
#pragma once
#include "core/schema.hpp"
#include "material/hooke.hpp"

namespace stiction::material {

struct LinearElastic {
  double young = 0;   ///< Pa
  double poisson = 0; ///< 1
  static constexpr bool small_strain = true;
  static constexpr bool linear = true;

  template<int N, Wanted = Wanted::tangent, class S>
  [[nodiscard]] Response<N, S> respond(Voigt<N, S> const& strain) const {
    return hooke<N>(moduli(), strain);
  }
  /// Is it known what large strains change of a dent (scene/explain/reach)?
  [[nodiscard]] bool dent_is_measured() const { return true; }
  [[nodiscard]] Moduli moduli() const { return {young, poisson}; }

  static core::Schema const& schema() {
    using core::Need;
    static auto const made =
        core::Describe<LinearElastic>{"linear_elastic", "Hooke's law for small strains and rotations",
                                      "physics.md 4"}
            .number("young", &LinearElastic::young, "Pa", core::positive, Need::required, "Young's modulus")
            .number("poisson", &LinearElastic::poisson, "1", {-1, 0.5, true, true}, Need::required,
                    "Poisson's ratio")
            .build();
    return made;
  }
};

} // namespace stiction::material
